//! Of what there is to draw, and of what meets it.

use vocabulary::{Barycentric, Ray, Sphere, Triangle, Triangle2};

use super::record;

record!(Triangle { a, b, c });
record!(Triangle2 { a, b, c });
record!(Barycentric { alpha, beta, gamma });
record!(Ray { origin, direction });
record!(Sphere { center, radius });
