//! Of what a ray meets, and of what it brings back.

use vocabulary::{Ball, Lamp, MirrorBall, TriangleHit};

use super::record;

record!(TriangleHit { t, beta, gamma });
record!(Ball { sphere, color, exponent });
record!(Lamp { position, color });
record!(MirrorBall { sphere, color, mirror });
