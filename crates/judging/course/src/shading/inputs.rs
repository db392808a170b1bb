//! The normals at a triangle's corners, as inputs of laws.

use glam::Vec3;
use proptest::prelude::*;
use testkit::by_hand::unit_vector;

/// Three unit normals around a direction, each at most 49° from it: their sum cannot vanish.
pub(super) fn around(
    middle: impl Strategy<Value = Vec3> + Clone,
) -> impl Strategy<Value = [Vec3; 3]> + Clone {
    (middle, unit_vector(), unit_vector(), unit_vector())
        .prop_map(|(middle, a, b, c)| [a, b, c].map(|aside| (middle + 0.75 * aside).normalize()))
}
