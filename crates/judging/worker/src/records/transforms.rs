//! Of where somebody stands, and how much is seen from there.

use vocabulary::{Basis, ViewVolume};

use super::record;

record!(Basis { u, v, w });
record!(ViewVolume { left, right, bottom, top, near, far });
