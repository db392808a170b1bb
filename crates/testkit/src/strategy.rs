//! Inputs without symmetry: what is special happens by demand, not by accident.

use std::f32::consts::{PI, TAU};

use geometry::{Barycentric, Ray, Triangle};
use glam::{Mat3, Mat4, Quat, Vec3, vec3};
use proptest::prelude::*;
use transforms::{Basis, Camera, ViewVolume};

/// A number of [−`extent`, `extent`].
pub fn coordinate(extent: f32) -> impl Strategy<Value = f32> + Clone {
    -extent..=extent
}

/// A point of the cube [−`extent`, `extent`]³.
pub fn point(extent: f32) -> impl Strategy<Value = Vec3> + Clone {
    (coordinate(extent), coordinate(extent), coordinate(extent)).prop_map(Vec3::from)
}

/// A unit vector; all directions are equally likely.
pub fn unit_vector() -> impl Strategy<Value = Vec3> + Clone {
    // Archimedes: height on the sphere is uniform.
    (-1.0_f32..=1.0, 0.0..TAU).prop_map(|(height, turn)| {
        let radius = (1.0 - height * height).max(0.0).sqrt();
        vec3(radius * turn.cos(), radius * turn.sin(), height).normalize()
    })
}

/// A unit vector on the side of `normal`: at least `least_cosine` along it. `normal` must be a unit vector.
pub fn unit_vector_beside(normal: Vec3, least_cosine: f32) -> impl Strategy<Value = Vec3> + Clone {
    let (u, v) = normal.any_orthonormal_pair();
    (least_cosine..=1.0, 0.0..TAU).prop_map(move |(cosine, turn)| {
        let radius = (1.0 - cosine * cosine).max(0.0).sqrt();
        (radius * turn.cos() * u + radius * turn.sin() * v + cosine * normal).normalize()
    })
}

/// A rotation about any axis by any angle.
pub fn rotation() -> impl Strategy<Value = Mat3> + Clone {
    (unit_vector(), -PI..PI).prop_map(|(axis, angle)| Mat3::from_axis_angle(axis, angle))
}

/// A right-handed orthonormal basis in any position.
pub fn basis() -> impl Strategy<Value = Basis> + Clone {
    rotation().prop_map(|r| Basis { u: r.x_axis, v: r.y_axis, w: r.z_axis })
}

/// An affine map: a rotation after an uneven scale in [½, 2] after a shear, then a shift of at most `extent`.
pub fn affine(extent: f32) -> impl Strategy<Value = Mat4> + Clone {
    let scale = (0.5_f32..2.0, 0.5_f32..2.0, 0.5_f32..2.0).prop_map(Vec3::from);
    (unit_vector(), -PI..PI, scale, -1.0_f32..1.0, point(extent)).prop_map(
        |(axis, angle, scale, shear, shift)| {
            let mut sheared = Mat4::IDENTITY;
            sheared.y_axis.x = shear;
            Mat4::from_scale_rotation_translation(scale, Quat::from_axis_angle(axis, angle), shift) * sheared
        },
    )
}

/// A triangle with corners in the cube [−`extent`, `extent`]³ that is not a sliver: the sine of the angle at a is at
/// least 0.05, and no edge at a is shorter than extent / 20.
pub fn triangle(extent: f32) -> impl Strategy<Value = Triangle> + Clone {
    (point(extent), point(extent), point(extent)).prop_map(|(a, b, c)| Triangle { a, b, c }).prop_filter(
        "a sliver",
        move |t| {
            let (ab, ac) = (t.b - t.a, t.c - t.a);
            let shortest = extent / 20.0;
            ab.length() > shortest
                && ac.length() > shortest
                && t.cross().length() > 0.05 * ab.length() * ac.length()
        },
    )
}

/// Barycentric coordinates of a point strictly inside a triangle, each at least `margin` (below ⅓).
pub fn inside(margin: f32) -> impl Strategy<Value = Barycentric> + Clone {
    (0.0_f32..1.0, 0.0_f32..1.0).prop_map(move |(x, y)| {
        // Fold the unit square onto the triangle below its diagonal.
        let (x, y) = if x + y > 1.0 { (1.0 - x, 1.0 - y) } else { (x, y) };
        let room = 1.0 - 3.0 * margin;
        Barycentric::from_beta_gamma(margin + room * x, margin + room * y)
    })
}

/// A ray from the cube [−`extent`, `extent`]³ in any direction, of length between ½ and 2.
pub fn ray(extent: f32) -> impl Strategy<Value = Ray> + Clone {
    (point(extent), unit_vector(), 0.5_f32..2.0)
        .prop_map(|(origin, direction, length)| Ray::new(origin, length * direction))
}

/// A ray that starts in the cube and passes through the inside of `triangle`, at t = 1.
pub fn ray_at(triangle: Triangle, extent: f32) -> impl Strategy<Value = Ray> + Clone {
    (point(extent), inside(0.01)).prop_map(move |(from, weights)| Ray::through(from, triangle.point(weights)))
}

/// A camera somewhere in the cube [−10, 10]³ that looks anywhere, up not parallel to its gaze.
pub fn camera() -> impl Strategy<Value = Camera> + Clone {
    (point(10.0), unit_vector(), unit_vector())
        .prop_filter("up along the gaze", |(_, gaze, up)| gaze.cross(*up).length() > 0.1)
        .prop_map(|(eye, gaze, up)| Camera::look_at(eye, eye + gaze, up).expect("gaze and up are checked"))
}

/// An off-centre viewing volume, 0 > near > far.
pub fn view_volume() -> impl Strategy<Value = ViewVolume> + Clone {
    (-2.0_f32..1.0, 0.5_f32..3.0, -2.0_f32..1.0, 0.5_f32..3.0, 0.2_f32..2.0, 1.0_f32..50.0).prop_map(
        |(left, width, bottom, height, near, depth)| ViewVolume {
            left,
            right: left + width,
            bottom,
            top: bottom + height,
            near: -near,
            far: -near - depth,
        },
    )
}
