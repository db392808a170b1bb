//! Where may the rasterizer's snapping to 1/256 pixel decide what is seen?

use glam::{DMat4, DVec2, DVec3};

use crate::agreement::stage::Stage;

/// How far, in pixels, a projected vertex can be from where it belongs: half a step of 1/256 in x and in y, and as much
/// again for the rounding of both renderers' 32-bit coordinates. That rounding is about 100 · 60 · 2⁻²⁴ pixels here (60
/// pixels, coordinates 100 times the smallest depth): less than the snapping.
pub(crate) const SNAP: f64 = 2.0 * std::f64::consts::SQRT_2 / 512.0;

/// The edges of everything on the screen, those included where near and far plane cut.
pub(crate) fn edges(stage: &Stage) -> Vec<(DVec2, DVec2)> {
    let (width, height) = (stage.pipeline.width(), stage.pipeline.height());
    let clip_from_world = stage.pipeline.clip_from_world();
    let polygons = stage
        .triangles()
        .map(|name| zbuffer::project(&clip_from_world, width, height, &stage.triangle(name)));
    polygons
        .flat_map(|polygon| {
            let points: Vec<DVec2> =
                polygon.vertices().iter().map(|v| v.position.truncate().as_dvec2()).collect();
            let next = |k: usize| points[(k + 1) % points.len()];
            points.iter().enumerate().map(|(k, p)| (*p, next(k))).collect::<Vec<_>>()
        })
        .collect()
}

pub(crate) fn distance_to_edge(p: DVec2, (a, b): (DVec2, DVec2)) -> f64 {
    let along = b - a;
    let share = if along == DVec2::ZERO {
        0.0
    } else {
        ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0)
    };
    p.distance(a + share * along)
}

/// The length of the part of the edge that is on the screen.
pub(crate) fn length_on_screen(stage: &Stage, (a, b): (DVec2, DVec2)) -> f64 {
    let along = b - a;
    let size = DVec2::new(stage.pipeline.width().into(), stage.pipeline.height().into());
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        // The screen is [−½, n − ½] on both axes.
        let (low, high) = (-0.5 - a[axis], size[axis] - 0.5 - a[axis]);
        if along[axis] == 0.0 {
            if low > 0.0 || high < 0.0 {
                return 0.0;
            }
        } else {
            let (s, t) = (low / along[axis], high / along[axis]);
            enter = enter.max(s.min(t));
            leave = leave.min(s.max(t));
        }
    }
    along.length() * (leave - enter).max(0.0)
}

/// Canonical z of a triangle's plane at a point of the screen, in 64 bits; `None` if the plane is seen edge-on.
pub(crate) fn depth_at(stage: &Stage, name: (usize, usize), p: DVec2) -> Option<f64> {
    let triangle = stage.triangle(name).corners().map(|corner| corner.as_dvec3());
    let [a, b, c] =
        triangle.map(|corner| stage.pipeline.camera_from_world().as_dmat4().transform_point3(corner));
    let n = (b - a).cross(c - a);
    let (volume, size) = (stage.pipeline.volume(), (stage.pipeline.width(), stage.pipeline.height()));
    let share = |x: f64, pixels: u32| (x + 0.5) / f64::from(pixels);
    let direction = DVec3::new(
        f64::from(volume.left) + share(p.x, size.0) * f64::from(volume.right - volume.left),
        f64::from(volume.bottom) + share(p.y, size.1) * f64::from(volume.top - volume.bottom),
        f64::from(volume.near),
    );
    let t = n.dot(a) / n.dot(direction);
    let clip: DMat4 = stage.pipeline.canonical_from_camera().as_dmat4();
    t.is_finite().then(|| clip.project_point3(t * direction).z)
}

/// Whether snapping may decide which of two surfaces is nearer at `p`: an affine function through three vertices that each
/// move by at most `SNAP` changes inside the triangle by at most its slope times `SNAP`.
pub(crate) fn depths_are_close(stage: &Stage, one: (usize, usize), other: (usize, usize), p: DVec2) -> bool {
    let depth_and_slope = |name| {
        let here = depth_at(stage, name, p)?;
        let right = depth_at(stage, name, p + DVec2::X)? - here;
        let up = depth_at(stage, name, p + DVec2::Y)? - here;
        Some((here, DVec2::new(right, up).length()))
    };
    let (Some((z1, slope1)), Some((z2, slope2))) = (depth_and_slope(one), depth_and_slope(other)) else {
        return true;
    };
    // Depths are rounded to 32 bits a few times on the way, by camera coordinates 100 times the smallest depth.
    let rounding = 64.0 * f64::from(f32::EPSILON);
    (z1 - z2).abs() <= (slope1 + slope2) * SNAP + rounding
}
