//! The box with hard edges.

use std::collections::HashMap;

use glam::{DVec3, UVec3, Vec3};

use super::surface::{Corner, Surface};
use super::{ShapeError, pieces, positive};
use crate::Mesh;

/// The box with edges of length `size`, its middle at the origin; each face is cut into 2^level × 2^level squares.
///
/// A corner has one position and three normals: the edges are hard. Each face carries the whole unit square of texture,
/// unmirrored seen from outside; on the four sides its top points up.
///
/// # Errors
/// [`ShapeError`] for a level beyond the greatest or a length that is not finite and greater than 0.
///
/// ```
/// use glam::{Vec3, vec3};
///
/// let crate_ = geometry::shapes::cuboid(vec3(1.0, 2.0, 3.0), 0)?;
/// assert_eq!(crate_.len(), 12);
/// assert_eq!(crate_.positions().len(), 8);
/// assert_eq!(crate_.aabb().max, vec3(0.5, 1.0, 1.5));
/// # Ok::<(), geometry::shapes::ShapeError>(())
/// ```
pub fn cuboid(size: Vec3, level: u32) -> Result<Mesh, ShapeError> {
    let cuts = pieces("box", level)?;
    for (what, length) in [("width (x)", size.x), ("height (y)", size.y), ("depth (z)", size.z)] {
        positive("box", what, length)?;
    }
    let mut cuboid = Surface::default();
    for row in 0..=cuts {
        for column in 0..=cuts {
            cuboid.texture(f64::from(column) / f64::from(cuts), f64::from(row) / f64::from(cuts));
        }
    }
    let mut lattice = Lattice { cuts, size: size.as_dvec3(), indices: HashMap::new() };
    for (normal, face) in FACES.iter().enumerate() {
        cuboid.normals.push(face.right.cross(face.up).as_vec3());
        let mut corner = |column: u32, row: u32| Corner {
            position: lattice.index(face, column, row, &mut cuboid.positions),
            normal: normal as u32,
            texture: row * (cuts + 1) + column,
        };
        let mut squares = Vec::new();
        for row in 0..cuts {
            for column in 0..cuts {
                let (above, right) = (row + 1, column + 1);
                squares.push([
                    corner(column, row),
                    corner(right, row),
                    corner(right, above),
                    corner(column, above),
                ]);
            }
        }
        squares.into_iter().for_each(|square| cuboid.quad(square));
    }
    Ok(cuboid.into_mesh())
}

/// A face of the box as one sees it from outside.
struct Face {
    right: DVec3,
    up: DVec3,
}

const FACES: [Face; 6] = [
    Face { right: DVec3::NEG_Z, up: DVec3::Y }, // towards +x
    Face { right: DVec3::Z, up: DVec3::Y },     // towards −x
    Face { right: DVec3::X, up: DVec3::NEG_Z }, // towards +y
    Face { right: DVec3::X, up: DVec3::Z },     // towards −y
    Face { right: DVec3::X, up: DVec3::Y },     // towards +z
    Face { right: DVec3::NEG_X, up: DVec3::Y }, // towards −z
];

/// The points on the surface of the box, known by their whole-number coordinates 0 ..= cuts, so that faces share them.
struct Lattice {
    cuts: u32,
    size: DVec3,
    indices: HashMap<UVec3, u32>,
}

impl Lattice {
    fn index(&mut self, face: &Face, column: u32, row: u32, positions: &mut Vec<Vec3>) -> u32 {
        let cuts = f64::from(self.cuts);
        // From the middle of the box to the point, in half cuts: whole numbers, hence exact.
        let across = |k: u32| 2.0 * f64::from(k) - cuts;
        let from_middle =
            cuts * face.right.cross(face.up) + across(column) * face.right + across(row) * face.up;
        let at = (0.5 * (from_middle + cuts)).as_uvec3();
        *self.indices.entry(at).or_insert_with(|| {
            positions.push((0.5 * self.size * from_middle / cuts).as_vec3());
            positions.len() as u32 - 1
        })
    }
}
