//! Which way does the curved surface face at a vertex of the mesh that stands for it? (L39)
//!
//! A mesh of a ball is a polyhedron; its triangles know only their own normals. The mean of the normals around a vertex
//! comes close to the normal of the ball (Fig 10.4), and Gouraud and Phong shading need no more. Read
//! [`crate::mode`] next.

mod fan;
mod vertices;

use geometry::{Indexed, Mesh};
use glam::Vec3;

use fan::Fan;
use vertices::Vertices;

/// The crease angle for meshes of unknown origin, in radians: 60°. It keeps the edges of a box (90°) hard and rounds an
/// octagonal column (45°), the lecture's example of a polygon that stands for a circle (Fig 10.4).
pub const CREASE_ANGLE: f32 = std::f32::consts::FRAC_PI_3;

/// A unit normal for each corner of each triangle: the mean of the normals of the triangles around, weighted by their
/// angles at the vertex (L39).
///
/// Weighted by angle, the normal does not depend on how a flat polygon was cut into triangles: their angles at a vertex
/// always add up to the polygon's. Counting each triangle once gives another normal for each way to cut.
///
/// **Hard edges.** Triangles that share an edge are *linked* if their normals differ by at most `crease_angle`, and
/// those that are linked directly or through others around the same vertex form a group with one normal. So the two sides
/// of a linked edge always agree; the sides of an edge that is too sharp keep normals of their own, unless a smooth way
/// leads round the vertex from one to the other. Where more than two triangles share an edge, each is compared with the
/// next about the edge. Surfaces that touch in a vertex only do not mix.
///
/// **Vertices** are told apart by their coordinates, not by their indices: files repeat positions along seams, and a seam
/// in the texture is none in the surface.
///
/// **Degenerate triangles** (no area, repeated positions) count for nothing. Their own corners take the normal of some
/// other triangle at the same place, and are zero if there is none: zero means that the corner has no normal. Where
/// the normals of a group cancel out, each triangle keeps its own.
///
/// - `crease_angle`: radians, at least 0; from π on every edge is smooth. [`CREASE_ANGLE`] suits most meshes.
/// - Result: the values are unit or zero, object space; time n log n at the worst vertex, n otherwise.
///
/// ```
/// use geometry::shapes::cuboid;
/// use glam::{Vec3, vec3};
/// use shading::{CREASE_ANGLE, vertex_normals};
///
/// let crate_ = cuboid(vec3(1.0, 2.0, 3.0), 0)?.without_normals();
/// assert_eq!(vertex_normals(&crate_, CREASE_ANGLE).values.len(), 24); // eight vertices, three sides each
/// let round = vertex_normals(&crate_, std::f32::consts::PI);
/// assert_eq!(round.values.len(), 8);
/// assert!(round.values[0].abs().abs_diff_eq(Vec3::ONE.normalize(), 1e-6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Panics
/// If `crease_angle` is negative or NaN.
#[must_use]
pub fn vertex_normals(mesh: &Mesh, crease_angle: f32) -> Indexed<Vec3> {
    assert!(crease_angle >= 0.0, "the crease angle is {crease_angle} radians: it must be at least 0");
    let least_cosine = f64::from(crease_angle).min(std::f64::consts::PI).cos();
    let vertices = Vertices::of(mesh);
    let faces: Vec<Option<Vec3>> = (0..mesh.len()).map(|k| mesh.triangle(k).normal()).collect();

    let mut normals = Indexed { values: Vec::new(), triangles: vec![[0; 3]; mesh.len()] };
    for corners in vertices.fans() {
        let fan = Fan::around(mesh, &vertices, corners, &faces);
        let groups = fan.groups(least_cosine);
        fan.append_normals(&groups, &mut normals);
        fan.append_degenerate(corners, &faces, &mut normals);
    }
    normals
}

/// The mesh with a normal at every corner: those that it has stay, those that are missing come from [`vertex_normals`].
///
/// ```
/// use geometry::shapes::icosphere;
/// use shading::{CREASE_ANGLE, with_vertex_normals};
///
/// let ball = icosphere(1)?;
/// assert_eq!(with_vertex_normals(ball.clone(), CREASE_ANGLE), ball); // nothing was missing
/// assert!(with_vertex_normals(ball.without_normals(), CREASE_ANGLE).corner_normals(7).is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Panics
/// If `crease_angle` is negative or NaN.
#[must_use]
pub fn with_vertex_normals(mesh: Mesh, crease_angle: f32) -> Mesh {
    if !mesh.is_empty() && (0..mesh.len()).all(|k| mesh.corner_normals(k).is_some()) {
        return mesh;
    }
    let computed = vertex_normals(&mesh, crease_angle);
    let complete = match mesh.normals() {
        None => computed,
        Some(given) => filled(given, computed),
    };
    mesh.with_normals(complete).expect("one finite normal for each corner")
}

/// The given normals, and the computed ones where the given are zero.
fn filled(given: &Indexed<Vec3>, computed: Indexed<Vec3>) -> Indexed<Vec3> {
    let first_computed = u32::try_from(given.values.len()).expect("a mesh indexes its normals by u32");
    let choose = |ours: u32, theirs: u32| {
        if given.values[ours as usize] == Vec3::ZERO { first_computed + theirs } else { ours }
    };
    let triangles = given.triangles.iter().zip(&computed.triangles);
    Indexed {
        triangles: triangles
            .map(|(ours, theirs)| std::array::from_fn(|k| choose(ours[k], theirs[k])))
            .collect(),
        values: given.values.iter().copied().chain(computed.values).collect(),
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::PI;

    use geometry::shapes::cuboid;
    use glam::{Vec3, vec3};

    use super::*;

    /// The three sides of a box of 1 × 2 × 3 that meet at the origin, seen from outside; each square is cut by the
    /// diagonal through the origin or by the other one.
    fn box_corner(cut_through_corner: [bool; 3]) -> Mesh {
        let (x, y, z) = (vec3(1.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0), vec3(0.0, 0.0, 3.0));
        let positions = vec![Vec3::ZERO, x, y, z, x + y, y + z, z + x];
        let squares = [[0, 2, 4, 1], [0, 3, 5, 2], [0, 1, 6, 3]];
        let cut = |([a, b, c, d], through): ([u32; 4], bool)| {
            if through { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
        };
        Mesh::new(positions, squares.into_iter().zip(cut_through_corner).flat_map(cut).collect()).unwrap()
    }

    /// The naive mean: every triangle at the vertex counts once.
    fn unweighted_normal(mesh: &Mesh, position: u32) -> Vec3 {
        let around = (0..mesh.len()).filter(|k| mesh.triangles()[*k].contains(&position));
        around.map(|k| mesh.triangle(k).normal().unwrap()).sum::<Vec3>().normalize()
    }

    fn normal_at(mesh: &Mesh, normals: &Indexed<Vec3>, position: u32) -> Vec3 {
        let corner = |k: usize| mesh.triangles()[k].iter().position(|p| *p == position).map(|at| (k, at));
        let (k, at) = (0..mesh.len()).find_map(corner).unwrap();
        normals.values[normals.triangles[k][at] as usize]
    }

    #[test]
    fn weighting_by_angle_does_not_see_how_squares_were_cut_and_counting_triangles_does() {
        let want = Vec3::NEG_ONE.normalize();
        for cut in [[false, false, false], [true, false, false], [true, false, true], [true, true, true]] {
            let mesh = box_corner(cut);
            let ours = normal_at(&mesh, &vertex_normals(&mesh, PI), 0);
            assert!(ours.abs_diff_eq(want, 1e-6), "{cut:?}: {ours}");
        }
        // One square counted twice: (−1, −1, −2) or the like instead of (−1, −1, −1), 19° off.
        let naive = unweighted_normal(&box_corner([true, false, false]), 0);
        assert!(naive.angle_between(want) > 0.3, "{naive}");
    }

    #[test]
    fn an_edge_sharper_than_the_crease_angle_stays_hard() {
        let mesh = cuboid(vec3(1.0, 2.0, 3.0), 1).unwrap().without_normals();
        let normals = vertex_normals(&mesh, CREASE_ANGLE);
        for k in 0..mesh.len() {
            let face = mesh.triangle(k).normal().unwrap();
            assert_eq!(normals.triangles[k].map(|index| normals.values[index as usize]), [face; 3]);
        }
    }

    #[test]
    fn a_seam_in_the_indices_is_none_in_the_surface() {
        // A roof whose halves do not share their positions; the edge runs along y, and one half has −0 for 0.
        let half_angle = 0.3_f32;
        let (low, wide) = (-half_angle.sin(), half_angle.cos());
        let positions = vec![
            vec3(0.0, 0.0, 0.0),
            vec3(wide, 0.0, low),
            vec3(0.0, 1.0, 0.0),
            vec3(-0.0, 0.0, 0.0),
            vec3(0.0, 1.0, -0.0),
            vec3(-wide, 0.0, low),
        ];
        let mesh = Mesh::new(positions, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        let normals = vertex_normals(&mesh, 0.7); // the roof's halves differ by 0.6
        assert_eq!(normals.triangles[0][0], normals.triangles[1][0]);
        assert_ne!(vertex_normals(&mesh, 0.5).triangles[0][0], vertex_normals(&mesh, 0.5).triangles[1][0]);
    }

    #[test]
    fn triangles_without_area_count_for_nothing_and_take_the_normal_of_others() {
        let positions = vec![Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0), vec3(9.0, 9.0, 9.0)];
        let mesh = Mesh::new(positions, vec![[0, 0, 1], [0, 1, 2], [3, 3, 3]]).unwrap();
        let normals = vertex_normals(&mesh, PI);
        let corners = |k: usize| normals.triangles[k].map(|index| normals.values[index as usize]);
        assert_eq!((corners(0), corners(1), corners(2)), ([Vec3::Z; 3], [Vec3::Z; 3], [Vec3::ZERO; 3]));
    }

    #[test]
    fn the_two_sides_of_a_sheet_do_not_cancel() {
        let positions = vec![Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)];
        let mesh = Mesh::new(positions, vec![[0, 1, 2], [0, 2, 1]]).unwrap();
        for crease_angle in [1.0, PI] {
            let normals = vertex_normals(&mesh, crease_angle);
            let corner = |k: usize| normals.values[normals.triangles[k][0] as usize];
            assert_eq!((corner(0), corner(1)), (Vec3::Z, Vec3::NEG_Z), "{crease_angle}");
        }
    }

    #[test]
    fn sheets_at_one_edge_join_with_those_that_are_next_about_it() {
        // Five sheets at the z axis whose normals point to 0°, 180°, 20°, −90° and 90°, in this order in the file: the
        // first and the third belong together, though others stand between them.
        let far_corner = |towards: f32| vec3(-towards.to_radians().sin(), towards.to_radians().cos(), 0.0);
        let sheets = [0.0, 180.0, 20.0, -90.0, 90.0];
        let positions = [Vec3::ZERO, Vec3::Z].into_iter().chain(sheets.map(far_corner)).collect();
        let mesh = Mesh::new(positions, (2..7).map(|far| [0, far, 1]).collect()).unwrap();
        let normals = vertex_normals(&mesh, 0.5);
        let index = normals.triangles.iter().map(|corners| corners[0]).collect::<Vec<_>>();
        assert_eq!(index, [0, 1, 0, 2, 3]);
        let between = 10.0_f32.to_radians();
        assert!(
            normals.values[0].abs_diff_eq(vec3(between.cos(), between.sin(), 0.0), 1e-6),
            "{}",
            normals.values[0]
        );
    }

    #[test]
    fn only_missing_normals_are_filled_in() {
        let positions = vec![Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)];
        let tilted = vec3(0.6, 0.0, 0.8);
        let given = Indexed { values: vec![tilted, Vec3::ZERO], triangles: vec![[0, 1, 0]] };
        let mesh = Mesh::new(positions, vec![[0, 1, 2]]).unwrap().with_normals(given).unwrap();
        assert_eq!(with_vertex_normals(mesh, 1.0).corner_normals(0), Some([tilted, Vec3::Z, tilted]));
    }

    #[test]
    #[should_panic(expected = "crease angle")]
    fn a_crease_angle_that_is_no_number_is_the_callers_mistake() {
        let _ = vertex_normals(&Mesh::default(), f32::NAN);
    }
}
