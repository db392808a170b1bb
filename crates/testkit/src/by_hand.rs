//! Inputs that a person can check by hand: quarters, multiples of five degrees, directions from whole numbers.
//!
//! They shrink to 0, to whole numbers, to the axes; and most are exact in floating point, so that what lies on an edge lies on it.

use glam::{Vec2, Vec3, vec2, vec3};
use proptest::prelude::*;

/// A multiple of ¼ in [−`extent`, `extent`]; shrinks towards 0.
pub fn coordinate(extent: i32) -> impl Strategy<Value = f32> + Clone {
    (-4 * extent..=4 * extent).prop_map(|quarters| quarters as f32 / 4.0)
}

/// A multiple of ¼ in [`least`, `most`]; shrinks towards `least`.
pub fn between(least: i32, most: i32) -> impl Strategy<Value = f32> + Clone {
    (4 * least..=4 * most).prop_map(|quarters| quarters as f32 / 4.0)
}

/// A share, a multiple of ⅛ in [0, 1]; shrinks towards 0.
pub fn share() -> impl Strategy<Value = f32> + Clone {
    (0..=8).prop_map(|eighths| eighths as f32 / 8.0)
}

/// A point of the plane, in the square [−`extent`, `extent`]².
pub fn point2(extent: i32) -> impl Strategy<Value = Vec2> + Clone {
    (coordinate(extent), coordinate(extent)).prop_map(|(x, y)| vec2(x, y))
}

/// A point in space, in the cube [−`extent`, `extent`]³.
pub fn point3(extent: i32) -> impl Strategy<Value = Vec3> + Clone {
    (coordinate(extent), coordinate(extent), coordinate(extent)).prop_map(|(x, y, z)| vec3(x, y, z))
}

/// An angle in radians: a multiple of 5° in [−180°, 180°]; shrinks towards 0.
pub fn angle() -> impl Strategy<Value = f32> + Clone {
    (-36..=36).prop_map(|steps| (5.0 * steps as f32).to_radians())
}

/// A vector of whole numbers in [−5, 5], not zero: a direction of any length. Shrinks towards an axis.
pub fn direction() -> impl Strategy<Value = Vec3> + Clone {
    (-5..=5, -5..=5, -5..=5)
        .prop_filter("no direction", |v| *v != (0, 0, 0))
        .prop_map(|(x, y, z): (i32, i32, i32)| vec3(x as f32, y as f32, z as f32))
}

/// A unit vector along a [`direction`].
pub fn unit_vector() -> impl Strategy<Value = Vec3> + Clone {
    direction().prop_map(Vec3::normalize)
}

/// A unit vector on the side of `normal`, at most 84° from it.
pub fn unit_vector_above(normal: Vec3) -> impl Strategy<Value = Vec3> + Clone {
    unit_vector()
        .prop_map(move |v| if v.dot(normal) < 0.0 { -v } else { v })
        .prop_filter("grazing", move |v| v.dot(normal) > 0.1)
}

/// Three unit vectors at right angles, u × v = w.
pub fn axes() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    (direction(), direction()).prop_filter("parallel", |(w, up)| up.cross(*w) != Vec3::ZERO).prop_map(
        |(w, up)| {
            let u = up.cross(w).normalize();
            let w = w.normalize();
            [u, w.cross(u), w]
        },
    )
}

/// A linear colour: multiples of ⅛ in [0, 1].
pub fn colour() -> impl Strategy<Value = Vec3> + Clone {
    (share(), share(), share()).prop_map(|(r, g, b)| vec3(r, g, b))
}

/// The colour of a light, which may be brighter than white: multiples of ¼ in [0, 3].
pub fn light_colour() -> impl Strategy<Value = Vec3> + Clone {
    (between(0, 3), between(0, 3), between(0, 3)).prop_map(|(r, g, b)| vec3(r, g, b))
}

/// A normal and a direction, unit vectors, on its side or on the other; never so nearly at right angles that rounding decides
/// on which.
pub fn normal_and_direction() -> impl Strategy<Value = (Vec3, Vec3)> + Clone {
    (unit_vector(), unit_vector()).prop_filter("grazing", |(n, v)| n.dot(*v).abs() > 0.01)
}

/// A highlight's exponent p: whole and half numbers in [1, 32].
pub fn exponent() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![(1..=8).prop_map(|p| p as f32), (2..=64).prop_map(|halves| halves as f32 / 2.0)]
}

/// The corners of a triangle in space, in the cube [−`extent`, `extent`]³, with an area.
pub fn corners(extent: i32) -> impl Strategy<Value = [Vec3; 3]> + Clone {
    (point3(extent), point3(extent), point3(extent))
        .prop_map(|(a, b, c)| [a, b, c])
        .prop_filter("a sliver", |[a, b, c]| (b - a).cross(c - a).length() > 0.5)
}

/// The corners of a triangle in the plane, in the square [−`extent`, `extent`]², with an area; either way round.
pub fn corners2(extent: i32) -> impl Strategy<Value = [Vec2; 3]> + Clone {
    (point2(extent), point2(extent), point2(extent))
        .prop_map(|(a, b, c)| [a, b, c])
        .prop_filter("a sliver", |[a, b, c]| (b - a).perp_dot(c - a).abs() > 0.5)
}

/// Barycentric weights with sum 1, multiples of ⅛, none below `least` eighths.
pub fn weights(least: i32) -> impl Strategy<Value = [f32; 3]> + Clone {
    let room = 8 - 3 * least;
    (0..=room, 0..=room).prop_map(move |(x, y)| {
        // Fold the square onto the triangle below its diagonal.
        let (x, y) = if x + y > room { (room - x, room - y) } else { (x, y) };
        [8 - 2 * least - x - y, least + x, least + y].map(|eighths| eighths as f32 / 8.0)
    })
}
