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

/// A ray that meets a triangle's plane at these weights, at this t. All is exact for multiples of ⅛ and ¼.
pub(super) fn aimed(
    weights: impl Strategy<Value = [f32; 3]> + Clone,
    t: impl Strategy<Value = f32> + Clone,
) -> impl Strategy<Value = (Ray, Triangle, [f32; 3], f32)> + Clone {
    (triangle_and_step(), weights, t).prop_map(|((triangle, direction), weights, t)| {
        let origin = blend(&triangle, weights) - t * direction;
        (Ray { origin, direction }, triangle, weights, t)
    })
}

/// A multiple of ¼ in [¼, 3]: so many steps forwards.
pub(super) fn forwards() -> impl Strategy<Value = f32> + Clone {
    (1..=12).prop_map(|quarters| quarters as f32 / 4.0)
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

/// A sphere with its centre in the cube [−`extent`, `extent`]³ and a radius of ½ to 2.
pub(super) fn sphere(extent: i32) -> impl Strategy<Value = Sphere> + Clone {
    (point3(extent), radius()).prop_map(|(center, radius)| Sphere { center, radius })
}

/// A radius: a multiple of ¼ in [½, 2].
pub(super) fn radius() -> impl Strategy<Value = f32> + Clone {
    (2..=8).prop_map(|quarters| quarters as f32 / 4.0)
}

/// An arrow within the unit ball, at most 0.87 long.
pub(super) fn within() -> impl Strategy<Value = Vec3> + Clone {
    (-2..=2, -2..=2, -2..=2).prop_map(|(x, y, z)| vec3(x as f32, y as f32, z as f32) / 4.0)
}

/// A linear colour of eighths in [0, 1]; shrinks to `simplest`, also in eighths, so that there is something to see.
pub(super) fn colour(simplest: [u8; 3]) -> impl Strategy<Value = Vec3> + Clone {
    let share = |eighths: u8| (0..=8_u8).prop_map(move |more| f32::from((eighths + more) % 9) / 8.0);
    simplest.map(share).prop_map(Vec3::from)
}

/// The two t at which a ray's line crosses a sphere, in f64, smaller first. `None` if it misses.
pub(super) fn crossings(ray: &Ray, sphere: &Sphere) -> Option<[f64; 2]> {
    let (nearest, squared) = approach(ray, sphere);
    let radius = f64::from(sphere.radius);
    let half = radius * radius - squared;
    let half = (half >= 0.0).then(|| (half / ray.direction.as_dvec3().length_squared()).sqrt())?;
    Some([nearest - half, nearest + half])
}

/// Where a ray's line is nearest to a sphere's centre, and the square of the distance there; in f64.
fn approach(ray: &Ray, sphere: &Sphere) -> (f64, f64) {
    let (e, d) = (ray.origin.as_dvec3() - sphere.center.as_dvec3(), ray.direction.as_dvec3());
    let nearest = -e.dot(d) / d.length_squared();
    (nearest, (e + nearest * d).length_squared())
}

/// Whether a ray's line clearly meets or clearly misses a sphere: it passes the centre at less than 0.95 or at more than 1.05 radii.
pub(super) fn is_clear(ray: &Ray, sphere: &Sphere) -> bool {
    let share = approach(ray, sphere).1.sqrt() / f64::from(sphere.radius);
    (share - 1.0).abs() > 0.05
}

/// How far a point is from a sphere's surface, in f64: negative inside.
pub(super) fn height(p: DVec3, sphere: &Sphere) -> f64 {
    p.distance(sphere.center.as_dvec3()) - f64::from(sphere.radius)
}

/// The point of a ray, in f64.
pub(super) fn at(ray: &Ray, t: f64) -> DVec3 {
    ray.origin.as_dvec3() + t * ray.direction.as_dvec3()
}

/// Other crossings than the one at the point itself are this far from both ends of the shadow ray, as shares of it. Of the rays
/// here that is a hundredth of a unit or more, and rounding moves a crossing by a thousandth of that.
const GAP: f64 = 0.02;

/// The point itself is crossed within this share: coordinates below 6 put it off its sphere by 4e-7, a slant of at most 81° and a
/// ray of length 1 or more make that 3e-6.
const AT_THE_POINT: f64 = 1e-5;

/// Whether nothing is close to a tie on the way from a point to a lamp, and both are outside all spheres or on them.
pub(super) fn decided(p: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let way = Ray { origin: p, direction: light - p };
    spheres.iter().all(|sphere| {
        let ends = [0.0, 1.0];
        let apart = crossings(&way, sphere).is_none_or(|crossings| {
            let [first, second] = crossings
                .map(|t| t.abs() < AT_THE_POINT || ends.iter().all(|end: &f64| (t - end).abs() > GAP));
            first && second
        });
        let outside = height(light.as_dvec3(), sphere) > 0.0 && height(p.as_dvec3(), sphere) > -AT_THE_POINT;
        apart && outside && is_clear(&way, sphere)
    })
}
