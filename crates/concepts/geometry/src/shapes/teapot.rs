//! The Utah teapot, made of curved patches.

use std::collections::HashMap;
use std::ops::Range;

use glam::DVec3;

use super::bezier::BezierPatch;
use super::surface::{Corner, Surface};
use super::teapot_patches::{PATCHES, POINTS};
use super::{ShapeError, pieces};
use crate::Mesh;

/// The Utah teapot (Newell 1975): 32 Bézier patches, each cut into 2·2^level × 2·2^level pieces.
///
/// It stands on the plane y = 0 with the y axis through the knob of its lid, in Newell's units: 3.15 high, the spout
/// towards +x (to about 3.4), the handle towards −x (to −3), 4 deep along z. Fronts are outward. The normals are those
/// of the patches. Each patch carries the whole unit square of texture.
///
/// Body with rim and bottom, lid, handle and spout are four surfaces. They are free of cracks in themselves but open:
/// there is a slit between rim and lid, handle and spout run into the body, and the spout's mouth is open. One can
/// look through the slit and the mouth at the inside, which is the back of the surface.
///
/// # Errors
/// [`ShapeError::LevelTooGreat`].
///
/// ```
/// let pot = geometry::shapes::teapot(2)?;
/// assert_eq!((pot.aabb().min.y, pot.aabb().max.y), (0.0, 3.15));
/// # Ok::<(), geometry::shapes::ShapeError>(())
/// ```
pub fn teapot(level: u32) -> Result<Mesh, ShapeError> {
    let cuts = 2 * pieces("teapot", level)?;
    let mut pot = Surface::default();
    for row in 0..=cuts {
        for column in 0..=cuts {
            pot.texture(f64::from(column) / f64::from(cuts), f64::from(row) / f64::from(cuts));
        }
    }
    for part in PARTS {
        let mut welded = HashMap::new();
        for number in part {
            add_patch(&mut pot, &mut welded, &patch(number), cuts);
        }
    }
    Ok(pot.into_mesh())
}

/// The patches of each connected surface: body with rim and bottom, handle, spout, lid.
const PARTS: [Range<usize>; 4] = [0..16, 16..20, 20..24, 24..32];

/// Patch `number` with y up.
fn patch(number: usize) -> BezierPatch {
    // A quarter turn about x takes z up to y up. It is a rotation, no mirror: left and right stay what they are.
    let y_up = |[x, y, z]: [f64; 3]| DVec3::new(x, z, -y);
    let point = |i: usize, j: usize| y_up(POINTS[usize::from(PATCHES[number][4 * i + j])]);
    BezierPatch { control: std::array::from_fn(|i| std::array::from_fn(|j| point(i, j))) }
}

/// The points that a part already has, by the bits of their coordinates. Patches that share control points on a border
/// make the same bits there, so their points are found again and no crack opens.
type Welded = HashMap<[u32; 3], u32>;

fn add_patch(pot: &mut Surface, welded: &mut Welded, patch: &BezierPatch, cuts: u32) {
    let at = |k: u32| f64::from(k) / f64::from(cuts);
    let mut grid = Vec::new();
    for row in 0..=cuts {
        for column in 0..=cuts {
            let index = add_point(pot, welded, patch, at(row), at(column));
            grid.push(Corner { position: index, normal: index, texture: row * (cuts + 1) + column });
        }
    }
    let corner = |row: u32, column: u32| grid[(row * (cuts + 1) + column) as usize];
    for row in 0..cuts {
        for column in 0..cuts {
            let (below, right) = (row + 1, column + 1);
            // Newell's patches turn ∂S/∂u × ∂S/∂v inwards, so fronts run along v first.
            pot.quad([corner(row, column), corner(row, right), corner(below, right), corner(below, column)]);
        }
    }
}

fn add_point(pot: &mut Surface, welded: &mut Welded, patch: &BezierPatch, u: f64, v: f64) -> u32 {
    let p = patch.point(u, v);
    // Adding zero turns −0 into 0: two names of one number.
    let bits = p.as_vec3().to_array().map(|x| (x + 0.0).to_bits());
    *welded.entry(bits).or_insert_with(|| {
        let inward = patch.normal(u, v).expect("no patch of the teapot lacks a surface");
        pot.point(p, -inward);
        pot.positions.len() as u32 - 1
    })
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    #[test]
    fn known_points_are_where_newell_put_them() {
        // Patch 4 is the first of the body: it starts at (1.5, 0, 2.4) and ends at (0, -2, 0.9), z up.
        assert_eq!(patch(4).point(0.0, 0.0), dvec3(1.5, 2.4, 0.0));
        assert_eq!(patch(4).point(1.0, 1.0), dvec3(0.0, 0.9, 2.0));
        // The middle of a curve is (P0 + 3 P1 + 3 P2 + P3) / 8: for the knob's profile r = (0, 0.8, 0, 0.2).
        let knob = patch(24).point(0.5, 0.0);
        assert!(
            (knob - dvec3(2.6 / 8.0, (3.15 + 3.0 * 3.15 + 3.0 * 2.85 + 2.7) / 8.0, 0.0)).length() < 1e-15
        );
    }

    #[test]
    fn spout_is_right_and_handle_left_when_z_comes_towards_the_eye() {
        let pot = teapot(2).unwrap();
        let aabb = pot.aabb();
        assert!(aabb.max.x > 3.3 && aabb.max.x < 3.6, "{aabb:?}");
        assert_eq!(aabb.min.x, -3.0);
        assert_eq!((aabb.min.z, aabb.max.z), (-2.0, 2.0));
    }

    #[test]
    fn patches_that_meet_agree_on_the_normal() {
        for part in PARTS {
            let patches: Vec<_> = part.map(patch).collect();
            let mut seen: HashMap<[u32; 3], DVec3> = HashMap::new();
            for patch in &patches {
                for (i, j) in (0..=4).flat_map(|i| (0..=4).map(move |j| (i, j))) {
                    let (u, v) = (f64::from(i) / 4.0, f64::from(j) / 4.0);
                    let n = patch.normal(u, v).unwrap();
                    let bits = patch.point(u, v).as_vec3().to_array().map(|x| (x + 0.0).to_bits());
                    let first = *seen.entry(bits).or_insert(n);
                    // The control points are decimals of two to five digits, rounded to f64: 1e-9 is generous.
                    assert!((first - n).length() < 1e-9, "{patch:?} at {u}, {v}: {first} and {n}");
                }
            }
        }
    }

    #[test]
    fn fronts_look_outward_at_the_extremes_of_every_part() {
        use glam::DVec3 as V;
        let extremes: [(usize, &[V]); 4] = [
            (0, &[V::X, V::NEG_X, V::Z, V::NEG_Z, V::NEG_Y]), // body
            (1, &[V::NEG_X, V::Z, V::NEG_Z]),                 // handle
            (2, &[V::Y, V::Z, V::NEG_Z]),                     // spout: up is its lip
            (3, &[V::Y]),                                     // lid: up is its knob
        ];
        let pot = teapot(3).unwrap();
        let normals = &pot.normals().unwrap().values;
        for (part, directions) in extremes {
            let patches: Vec<_> = PARTS[part].clone().map(patch).collect();
            let points: Vec<_> = (0..=16 * 17)
                .flat_map(|k| {
                    patches.iter().map(move |p| p.point(f64::from(k / 17) / 16.0, f64::from(k % 17) / 16.0))
                })
                .collect();
            for direction in directions {
                let extreme =
                    points.iter().max_by(|p, q| p.dot(*direction).total_cmp(&q.dot(*direction))).unwrap();
                let index = pot.positions().iter().position(|p| *p == extreme.as_vec3()).unwrap();
                // At an extreme the surface is level; the sample next to it is less than 25° away.
                let cosine = normals[index].as_dvec3().dot(*direction);
                assert!(cosine > 0.9, "part {part} towards {direction}: normal {}", normals[index]);
            }
        }
    }

    #[test]
    fn every_index_of_the_table_is_used_and_in_range() {
        let mut used = [false; 290];
        PATCHES.iter().flatten().for_each(|k| used[usize::from(*k)] = true);
        assert!(used.iter().all(|u| *u));
    }
}
