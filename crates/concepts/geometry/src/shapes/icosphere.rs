//! The sphere of nearly equal triangles.

use std::collections::HashMap;

use glam::DVec3;

use super::surface::{Corner, Surface};
use super::{ShapeError, pieces};
use crate::Mesh;

/// The unit sphere grown from an icosahedron: each level cuts every triangle into four and moves the new corners
/// outwards onto the sphere. Level 0 is the icosahedron.
///
/// Texture coordinates as for [`super::uv_sphere`]; a triangle that crosses the seam runs on beyond u = 1.
///
/// # Errors
/// [`ShapeError::LevelTooGreat`].
///
/// ```
/// let ball = geometry::shapes::icosphere(2)?;
/// assert_eq!((ball.len(), ball.positions().len()), (320, 162));
/// # Ok::<(), geometry::shapes::ShapeError>(())
/// ```
pub fn icosphere(level: u32) -> Result<Mesh, ShapeError> {
    pieces("icosphere", level)?;
    let (mut points, mut triangles) = icosahedron();
    for _ in 0..level {
        triangles = cut_in_four(&mut points, &triangles);
    }
    let mut sphere = Surface::default();
    points.iter().for_each(|p| sphere.point(*p, *p));
    for (k, triangle) in triangles.iter().enumerate() {
        for (u, v) in map_coordinates(triangle.map(|index| points[index as usize])) {
            sphere.texture(u, v);
        }
        let first = 3 * k as u32;
        let corner =
            |i: usize| Corner { position: triangle[i], normal: triangle[i], texture: first + i as u32 };
        sphere.triangle([corner(0), corner(1), corner(2)]);
    }
    Ok(sphere.into_mesh())
}

/// Twelve points, the corners of three golden rectangles, and the twenty faces between them.
fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points = Vec::new();
    for (short, long) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        points.push(DVec3::new(short, long, 0.0).normalize());
        points.push(DVec3::new(0.0, short, long).normalize());
        points.push(DVec3::new(long, 0.0, short).normalize());
    }
    // The triples of mutual neighbours are the faces; neighbours are the pairs with the greatest cosine, 1/√5.
    let are_neighbours = |i: usize, j: usize| points[i].dot(points[j]) > 0.4;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if are_neighbours(i, j) && are_neighbours(j, k) && are_neighbours(k, i) {
                    let is_front = points[i].dot(points[j].cross(points[k])) > 0.0;
                    let (j, k) = if is_front { (j, k) } else { (k, j) };
                    faces.push([i as u32, j as u32, k as u32]);
                }
            }
        }
    }
    (points, faces)
}

/// Each triangle becomes its three corners' and the middle one; a new corner is made once for both sides of its edge.
fn cut_in_four(points: &mut Vec<DVec3>, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut middles = HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            points.push((points[a as usize] + points[b as usize]).normalize());
            points.len() as u32 - 1
        })
    };
    let mut finer = Vec::with_capacity(4 * triangles.len());
    for &[a, b, c] in triangles {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    finer
}

/// Where the corners lie on the map: u within half a turn of the first corner's, and at a pole halfway between the others.
fn map_coordinates(corners: [DVec3; 3]) -> [(f64, f64); 3] {
    let is_pole = |p: DVec3| p.x == 0.0 && p.z == 0.0;
    let mut u = corners.map(|p| (p.x.atan2(p.z) / std::f64::consts::TAU).rem_euclid(1.0));
    let greatest = (0..3).filter(|k| !is_pole(corners[*k])).map(|k| u[k]).fold(0.0, f64::max);
    for value in &mut u {
        if greatest - *value > 0.5 {
            *value += 1.0;
        }
    }
    if let Some(pole) = (0..3).find(|k| is_pole(corners[*k])) {
        u[pole] = 0.5 * (u[(pole + 1) % 3] + u[(pole + 2) % 3]);
    }
    std::array::from_fn(|k| (u[k], 1.0 - corners[k].y.clamp(-1.0, 1.0).acos() / std::f64::consts::PI))
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn points_lie_on_the_unit_sphere() {
        for p in icosphere(4).unwrap().positions() {
            // Each coordinate is rounded by at most 2^-25; three of them move the length by at most √3 · 2^-25.
            assert!((p.as_dvec3().length() - 1.0).abs() <= 3.0_f64.sqrt() * 2.0_f64.powi(-25), "{p}");
        }
    }

    #[test]
    fn no_triangle_is_torn_across_the_map() {
        let sphere = icosphere(3).unwrap();
        for k in 0..sphere.len() {
            let [a, b, c] = sphere.corner_texture_coordinates(k).unwrap();
            let area = (b - a).perp_dot(c - a);
            assert!(0.0 < area && area < 0.1, "triangle {k}: {a} {b} {c}");
        }
        let is_pole = |p: &Vec3| p.x == 0.0 && p.z == 0.0;
        assert_eq!(sphere.positions().iter().filter(|p| is_pole(p)).count(), 2);
    }
}
