//! Of what a ray meets, and of what it brings back.

use vocabulary::{Ball, Lamp, MirrorBall, TriangleHit};

use super::record;

record!(TriangleHit { t, beta, gamma });
record!(Ball { sphere, colour, exponent });
record!(Lamp { position, colour });
record!(MirrorBall { sphere, colour, mirror });
