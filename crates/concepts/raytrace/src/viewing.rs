//! Which ray belongs to a pixel? The one from the eye through the pixel's place in the window (L46, Fig 4.6).

use geometry::Ray;
use glam::vec2;
use transforms::{Pipeline, ViewVolume, viewport};

/// The viewing ray through the point (i, j) of the screen: p(t) = e + t(s − e), p(0) = e, p(1) = s (L46).
///
/// s = u_s u + v_s v + n w (L9). The slide gives s in *camera* coordinates, where the eye is 0; in the world, s is e plus
/// that (E13), so u_s u + v_s v + n w is s − e, the ray's direction.
///
/// The direction is **not** normalized: t = 1 is the near plane and t = f/n the far plane (E12), see
/// [`visible_interval`].
///
/// - `i`, `j`: position on the screen in pixels, j upwards; whole numbers are centres of pixels, and the screen is
///   [−½, n_x−½] × [−½, n_y−½]. Fractions are places inside a pixel.
/// - Result: world space.
///
/// ```
/// use glam::{Vec3, vec3};
/// use raytrace::viewing_ray;
/// use transforms::{Camera, Pipeline, ViewVolume};
///
/// let camera = Camera::look_at(vec3(5.0, 0.0, 4.0), vec3(5.0, 0.0, 0.0), Vec3::Y)?;
/// let volume = ViewVolume { left: -2.0, right: 2.0, bottom: -1.0, top: 3.0, near: -1.0, far: -9.0 };
/// let ray = viewing_ray(&Pipeline::new(camera, volume, 8, 4)?, 7.0, 0.0);
/// assert_eq!(ray.at(0.0), vec3(5.0, 0.0, 4.0)); // e
/// assert_eq!(ray.at(1.0), vec3(6.75, -0.5, 3.0)); // s = e + 1.75 u − 0.5 v − 1 w
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn viewing_ray(pipeline: &Pipeline, i: f32, j: f32) -> Ray {
    let (camera, volume) = (pipeline.camera(), pipeline.volume());
    let window = viewport::window_point(&volume, pipeline.width(), pipeline.height(), vec2(i, j));
    let basis = camera.basis();
    Ray::new(camera.eye(), window.x * basis.u + window.y * basis.v + volume.near * basis.w)
}

/// The t of the near plane and of the far plane on every viewing ray: 1 and f/n.
///
/// The slides search t in [0, ∞] (E12); between these two lies what the z-buffer shows too.
#[must_use]
pub fn visible_interval(volume: &ViewVolume) -> (f32, f32) {
    (1.0, volume.far / volume.near)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec3, vec3};
    use transforms::Camera;

    const VOLUME: ViewVolume =
        ViewVolume { left: -2.0, right: 4.0, bottom: -1.0, top: 3.0, near: -2.0, far: -50.0 };

    #[test]
    fn near_and_far_plane_lie_at_the_ends_of_the_visible_interval() {
        let camera = Camera::look_at(vec3(1.0, 2.0, 3.0), vec3(4.0, -1.0, 7.0), Vec3::Y).unwrap();
        let pipeline = Pipeline::new(camera, VOLUME, 12, 8).unwrap();
        let ray = viewing_ray(&pipeline, 2.25, 6.5);
        let (t0, t1) = visible_interval(&VOLUME);
        let depth = |t: f32| camera.camera_from_world().transform_point3(ray.at(t)).z;
        // A handful of roundings of numbers up to 50.
        assert!((depth(t0) + 2.0).abs() < 1e-5 && (depth(t1) + 50.0).abs() < 1e-4);
    }

    #[test]
    fn the_slides_s_is_a_point_of_the_world_only_for_an_eye_at_the_origin() {
        // E13: s without + e, for a camera that stands elsewhere.
        let camera = Camera::look_at(vec3(10.0, 0.0, 0.0), vec3(10.0, 0.0, -5.0), Vec3::Y).unwrap();
        let pipeline = Pipeline::new(camera, VOLUME, 12, 8).unwrap();
        let basis = camera.basis();
        let slide = -1.75 * basis.u - 0.75 * basis.v - 2.0 * basis.w;
        let s = viewing_ray(&pipeline, 0.0, 0.0).at(1.0);
        assert_eq!(s - slide, camera.eye());
        assert!(pipeline.trace(s).screen.unwrap().truncate().length() < 1e-4); // pixel (0, 0)
        assert!(pipeline.trace(slide).screen.unwrap().truncate().length() > 10.0);
    }
}
