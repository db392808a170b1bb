//! The sphere cut along its meridians and parallels, like a globe.

use glam::DVec3;

use super::surface::{Corner, Surface, around_y};
use super::{ShapeError, pieces};
use crate::Mesh;

/// The unit sphere between 4·2^level meridians and 2·2^level zones; level 0 is an octahedron.
///
/// Texture coordinates are those of a map: u runs once round the equator from +z towards +x, v from the south pole
/// (0) to the north pole (1). At a pole each triangle has the u of its middle.
///
/// # Errors
/// [`ShapeError::LevelTooGreat`].
///
/// ```
/// let globe = geometry::shapes::uv_sphere(3)?;
/// assert_eq!(globe.len(), 32 * 30);
/// # Ok::<(), geometry::shapes::ShapeError>(())
/// ```
pub fn uv_sphere(level: u32) -> Result<Mesh, ShapeError> {
    let pieces = pieces("UV sphere", level)?;
    let (slices, zones) = (4 * pieces, 2 * pieces);
    let mut sphere = Surface::default();
    add_points(&mut sphere, slices, zones);
    add_texture(&mut sphere, slices, zones);
    let corner = |row: u32, column: u32| {
        let position = match row {
            0 => 0,
            _ if row == zones => 1 + (zones - 1) * slices,
            _ => 1 + (row - 1) * slices + column % slices,
        };
        Corner { position, normal: position, texture: row * (slices + 1) + column }
    };
    for row in 0..zones {
        for column in 0..slices {
            let (below, right) = (row + 1, column + 1);
            sphere.quad([
                corner(row, column),
                corner(below, column),
                corner(below, right),
                corner(row, right),
            ]);
        }
    }
    Ok(sphere.into_mesh())
}

/// North pole, parallels from north to south, south pole. The normal of a point is the point.
fn add_points(sphere: &mut Surface, slices: u32, zones: u32) {
    sphere.point(DVec3::Y, DVec3::Y);
    for row in 1..zones {
        let (radius, height) = (std::f64::consts::PI * f64::from(row) / f64::from(zones)).sin_cos();
        for column in 0..slices {
            let p = radius * around_y(column, slices) + height * DVec3::Y;
            sphere.point(p, p);
        }
    }
    sphere.point(DVec3::NEG_Y, DVec3::NEG_Y);
}

/// One more column than there are meridians: the map's left border is also its right border.
fn add_texture(sphere: &mut Surface, slices: u32, zones: u32) {
    for row in 0..=zones {
        // The triangle in slice k touches the north pole with corner k, the south pole with corner k + 1.
        let shift = if row == 0 {
            0.5
        } else if row == zones {
            -0.5
        } else {
            0.0
        };
        for column in 0..=slices {
            let u = (f64::from(column) + shift) / f64::from(slices);
            sphere.texture(u, 1.0 - f64::from(row) / f64::from(zones));
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::vec2;

    use super::*;

    #[test]
    fn texture_runs_to_the_right_when_seen_from_outside() {
        let sphere = uv_sphere(2).unwrap();
        for k in 0..sphere.len() {
            let [a, b, c] = sphere.corner_texture_coordinates(k).unwrap();
            // The same turning sense on the map as on the sphere: not mirrored. And no triangle spans the seam.
            assert!((b - a).perp_dot(c - a) > 0.0, "triangle {k}");
            assert!((a - b).abs().max((b - c).abs()).cmple(vec2(0.25, 0.25)).all(), "triangle {k}");
        }
    }
}
