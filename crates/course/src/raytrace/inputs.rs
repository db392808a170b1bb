//! What do the laws of ray tracing try? Rays that are aimed, so that it is known what they meet, and that meet it squarely.
//!
//! Whatever decides between hit and miss lies far from its limit here: no right program is judged by how it rounds.

use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{corners, point3, weights};
use vocabulary::{Ray, Sphere, Triangle};

/// A direction of whole numbers in [−3, 3], of any length, not zero.
pub(super) fn step() -> impl Strategy<Value = Vec3> + Clone {
    (-3..=3, -3..=3, -3..=3)
        .prop_filter("no direction", |d| *d != (0, 0, 0))
        .prop_map(|(x, y, z): (i32, i32, i32)| vec3(x as f32, y as f32, z as f32))
}

/// A triangle in the cube [−3, 3]³: both edges at a at least 1 long, the sine of the angle between them at least 0.3.
pub(super) fn triangle() -> impl Strategy<Value = Triangle> + Clone {
    corners(3).prop_map(|[a, b, c]| Triangle { a, b, c }).prop_filter("a sliver", |triangle| {
        let (ab, ac) = (triangle.b - triangle.a, triangle.c - triangle.a);
        let shortest = ab.length().min(ac.length());
        shortest >= 1.0 && ab.cross(ac).length() >= 0.3 * ab.length() * ac.length()
    })
}

/// A triangle and a direction that is at least 17° away from its plane.
pub(super) fn triangle_and_step() -> impl Strategy<Value = (Triangle, Vec3)> + Clone {
    (triangle(), step()).prop_filter("grazing", |(triangle, d)| {
        let normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
        normal.dot(*d).abs() >= 0.3 * normal.length() * d.length()
    })
}

/// The point αa + βb + γc, exact for multiples of ⅛.
pub(super) fn blend(triangle: &Triangle, [alpha, beta, gamma]: [f32; 3]) -> Vec3 {
    alpha * triangle.a + beta * triangle.b + gamma * triangle.c
}

/// Barycentric weights of a point well inside: multiples of ⅛, at least ⅛.
pub(super) fn inside() -> impl Strategy<Value = [f32; 3]> + Clone {
    weights(1)
}

/// Barycentric weights of a point well outside: one of the three is negative, each as often.
pub(super) fn outside() -> impl Strategy<Value = [f32; 3]> + Clone {
    (0..3_usize, 1..=8, 1..=7).prop_map(|(negative, below, share)| {
        let below = below as f32 / 8.0;
        let share = share as f32 / 8.0 * (1.0 + below);
        let mut weights = [-below, share, 1.0 + below - share];
        weights.rotate_right(negative);
        weights
    })
}

/// A triangle, and a ray in a plane parallel to its own, or in its own. All numbers are exact: so is the determinant, 0.
pub(super) fn parallel() -> impl Strategy<Value = (Ray, Triangle)> + Clone {
    let along = (-1..=1, -1..=1).prop_filter("no direction", |d| *d != (0, 0));
    (triangle(), inside(), along, prop_oneof![Just(Vec3::ZERO), point3(3)]).prop_map(
        |(triangle, weights, (beta, gamma), away)| {
            let (ab, ac) = (triangle.b - triangle.a, triangle.c - triangle.a);
            let direction = beta as f32 * ab + gamma as f32 * ac;
            (Ray { origin: blend(&triangle, weights) + away, direction }, triangle)
        },
    )
}

/// The two t at which a ray's line crosses a sphere, in f64, smaller first. `None` if it misses.
pub(super) fn crossings(ray: &Ray, sphere: &Sphere) -> Option<[f64; 2]> {
    let (e, d) = (ray.origin.as_dvec3() - sphere.center.as_dvec3(), ray.direction.as_dvec3());
    let nearest = -e.dot(d) / d.length_squared();
    let radius = f64::from(sphere.radius);
    let half = radius * radius - (e + nearest * d).length_squared();
    let half = (half >= 0.0).then(|| (half / d.length_squared()).sqrt())?;
    Some([nearest - half, nearest + half])
}

/// The point of a ray, in f64.
pub(super) fn at(ray: &Ray, t: f64) -> DVec3 {
    ray.origin.as_dvec3() + t * ray.direction.as_dvec3()
}
