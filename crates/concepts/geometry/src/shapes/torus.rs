//! The ring: a circle that goes round a circle.

use glam::DVec3;

use super::surface::{Corner, Surface, around_y};
use super::{ShapeError, pieces, positive};
use crate::Mesh;

/// The torus around the y axis: a tube of radius `minor` whose middle runs at distance `major` from the axis, in the
/// plane y = 0.
///
/// 8·2^level pieces along the tube, 4·2^level around it. u runs along the tube from +z towards +x, v around it,
/// starting at the outer equator and going up.
///
/// # Errors
/// [`ShapeError`] for a level beyond the greatest and unless 0 < `minor` < `major`: a thicker tube would pierce itself.
///
/// ```
/// let ring = geometry::shapes::torus(2.0, 0.5, 3)?;
/// assert_eq!(ring.aabb().size(), glam::vec3(5.0, 1.0, 5.0));
/// # Ok::<(), geometry::shapes::ShapeError>(())
/// ```
pub fn torus(major: f32, minor: f32, level: u32) -> Result<Mesh, ShapeError> {
    let pieces = pieces("torus", level)?;
    let (major, minor) = radii(major, minor)?;
    let (along, around) = (8 * pieces, 4 * pieces);
    let mut ring = Surface::default();
    for row in 0..around {
        let (up, out) = (std::f64::consts::TAU * f64::from(row) / f64::from(around)).sin_cos();
        for column in 0..along {
            let outward = around_y(column, along);
            let n = out * outward + up * DVec3::Y;
            ring.point(major * outward + minor * n, n);
        }
    }
    for row in 0..=around {
        for column in 0..=along {
            ring.texture(f64::from(column) / f64::from(along), f64::from(row) / f64::from(around));
        }
    }
    let corner = |row: u32, column: u32| {
        let position = row % around * along + column % along;
        Corner { position, normal: position, texture: row * (along + 1) + column }
    };
    for row in 0..around {
        for column in 0..along {
            let (above, right) = (row + 1, column + 1);
            ring.quad([corner(row, column), corner(row, right), corner(above, right), corner(above, column)]);
        }
    }
    Ok(ring.into_mesh())
}

fn radii(major: f32, minor: f32) -> Result<(f64, f64), ShapeError> {
    // Half of what `positive` allows, because the two are added.
    let major = 0.5 * positive("torus", "major", 2.0 * major)?;
    let minor = positive("torus", "minor", minor)?;
    if minor >= major {
        let (what, must_be) = ("minor", "less than major");
        return Err(ShapeError::BadSize { shape: "torus", what, must_be, value: minor });
    }
    Ok((f64::from(major), f64::from(minor)))
}
