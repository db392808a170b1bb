//! A ball with any number of triangles: a cube's grid, blown up to a sphere, with bumps of sines.

use std::collections::HashMap;

use geometry::{Indexed, Mesh};
use glam::Vec3;

/// How far the bumps rise and sink; two waves, so that the surface stays between 0.94 and 1.06.
const AMPLITUDE: f32 = 0.03;

/// The closed mesh of 12·n² triangles, fronts outside, with smooth normals: n × n squares on each of the cube's faces,
/// two triangles a square, the corners on edges shared by the faces.
///
/// # Panics
/// If `n` is 0.
pub(crate) fn bumpy(n: u32) -> Mesh {
    assert!(n > 0, "a face needs a square");
    let mut grid = Grid { n, numbers: HashMap::new(), positions: Vec::new() };
    let mut triangles = Vec::with_capacity(12 * (n * n) as usize);
    for axis in 0..3 {
        for side in [0, n] {
            for (u, v) in (0..n).flat_map(|v| (0..n).map(move |u| (u, v))) {
                let [a, b, c, d] =
                    [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)].map(|at| grid.corner(axis, side, at));
                // Axis, u, v follow each other cyclically: anticlockwise seen from +axis, so turned round on the other
                // side.
                let square = if side == n { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
                triangles.extend(square);
            }
        }
    }
    smooth(grid.positions, triangles)
}

/// The points of a cube's surface, numbered as they are met.
struct Grid {
    n: u32,
    numbers: HashMap<[u32; 3], u32>,
    positions: Vec<Vec3>,
}

impl Grid {
    fn corner(&mut self, axis: usize, side: u32, (u, v): (u32, u32)) -> u32 {
        let mut lattice = [0; 3];
        (lattice[axis], lattice[(axis + 1) % 3], lattice[(axis + 2) % 3]) = (side, u, v);
        *self.numbers.entry(lattice).or_insert_with(|| {
            let cube = lattice.map(|x| 2.0 * x as f32 / self.n as f32 - 1.0);
            self.positions.push(with_bumps(Vec3::from_array(cube).normalize()));
            self.positions.len() as u32 - 1
        })
    }
}

/// The point of the surface in direction `d`.
fn with_bumps(d: Vec3) -> Vec3 {
    d * (1.0 + AMPLITUDE * ((9.0 * d.x + 0.5).sin() + (11.0 * d.y).sin() * (7.0 * d.z + 1.0).sin()))
}

/// With the normal of each corner: the mean of its triangles', by area.
fn smooth(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Mesh {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for corners in &triangles {
        let [a, b, c] = corners.map(|index| positions[index as usize]);
        for index in corners {
            normals[*index as usize] += (b - a).cross(c - a);
        }
    }
    let normals = Indexed { values: normals, triangles: triangles.clone() };
    let mesh = Mesh::new(positions, triangles).expect("indices of the grid");
    mesh.with_normals(normals).expect("a normal for each position")
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn the_two_meshes_have_the_numbers_of_triangles_of_the_table() {
        assert_eq!(bumpy(76).len(), 69_312);
        assert_eq!(bumpy(289).len(), 1_002_252);
    }

    #[test]
    fn the_ball_is_closed_and_shares_its_points() {
        let mesh = bumpy(7);
        // Euler: V − E + F = 2 with E = 3F/2.
        assert_eq!(mesh.positions().len(), 2 + mesh.len() / 2);
        let edges: HashSet<[u32; 2]> =
            mesh.triangles().iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]).collect();
        assert_eq!(edges.len(), 3 * mesh.len(), "no edge is used twice in one direction");
        assert!(edges.iter().all(|[a, b]| edges.contains(&[*b, *a])), "and each is used in either");
    }

    #[test]
    fn fronts_and_normals_look_outwards() {
        let mesh = bumpy(12);
        for k in 0..mesh.len() {
            let triangle = mesh.triangle(k);
            let outwards = triangle.a + triangle.b + triangle.c;
            assert!(triangle.normal().expect("no sliver").dot(outwards) > 0.0, "{k}");
            let normals = mesh.corner_normals(k).expect("normals");
            assert!(normals.iter().zip(triangle.corners()).all(|(n, p)| n.dot(p) > 0.0), "{k}");
        }
    }

    #[test]
    fn the_surface_has_bumps_and_fits_the_view() {
        let radii: Vec<f32> = bumpy(30).positions().iter().map(|p| p.length()).collect();
        let (least, most) = radii.iter().fold((f32::MAX, 0.0_f32), |(l, m), r| (l.min(*r), m.max(*r)));
        assert!(least < 0.96 && most > 1.04, "{least} … {most}");
        let distance = super::super::EYE.length();
        assert!((most / distance).asin() < 0.5 * super::super::FOV_Y.to_radians());
    }
}
