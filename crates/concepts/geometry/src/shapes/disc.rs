//! The flat round plate.

use glam::DVec3;

use super::surface::{Corner, Surface, around_y};
use super::{ShapeError, pieces, positive};
use crate::Mesh;

/// The disc of radius `radius` in the plane y = 0, its front towards +y.
///
/// 6·2^level slices in 2^level rings; level 0 is a hexagon. Texture coordinates are those of a picture that lies on the
/// disc with its top towards −z: (0.5, 0.5) in the middle, (1, 0.5) at +x, (0.5, 1) at −z.
///
/// # Errors
/// [`ShapeError`] for a level beyond the greatest or a radius that is not finite and greater than 0.
///
/// ```
/// let plate = geometry::shapes::disc(1.5, 2)?;
/// assert_eq!(plate.triangle(0).normal(), Some(glam::Vec3::Y));
/// # Ok::<(), geometry::shapes::ShapeError>(())
/// ```
pub fn disc(radius: f32, level: u32) -> Result<Mesh, ShapeError> {
    let rings = pieces("disc", level)?;
    let radius = f64::from(positive("disc", "radius", radius)?);
    let slices = 6 * rings;
    let mut plate = Surface::default();
    plate.point(DVec3::ZERO, DVec3::Y);
    plate.texture(0.5, 0.5);
    for ring in 1..=rings {
        for slice in 0..slices {
            let p = f64::from(ring) / f64::from(rings) * around_y(slice, slices);
            plate.positions.push((radius * p).as_vec3());
            plate.texture(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.z);
        }
    }
    let corner = |ring: u32, slice: u32| {
        let position = if ring == 0 { 0 } else { 1 + (ring - 1) * slices + slice % slices };
        Corner { position, normal: 0, texture: position }
    };
    for ring in 0..rings {
        for slice in 0..slices {
            let (out, next) = (ring + 1, slice + 1);
            plate.quad([corner(ring, slice), corner(out, slice), corner(out, next), corner(ring, next)]);
        }
    }
    Ok(plate.into_mesh())
}
