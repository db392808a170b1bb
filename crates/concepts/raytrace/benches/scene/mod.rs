//! The mesh and the rays that the fast search is measured with.

use std::collections::HashMap;

use geometry::{Indexed, Mesh, Ray};
use glam::{Vec3, vec3};
use raytrace::viewing_ray;
use transforms::{Camera, Pipeline, ViewVolume};

/// Where the eye is; it looks at the origin. And the light.
const EYE: Vec3 = vec3(1.2, 0.9, 2.4);
pub(crate) const LIGHT: Vec3 = vec3(-2.0, 4.0, 5.0);

/// The view of 45° from the eye.
pub(crate) fn view(width: u32, height: u32) -> Pipeline {
    let camera = Camera::look_at(EYE, Vec3::ZERO, Vec3::Y).expect("the eye is not at the origin");
    let aspect = width as f32 / height as f32;
    let volume = ViewVolume::from_fov_y(45_f32.to_radians(), aspect, -0.5, -10.0).expect("0 > near > far");
    Pipeline::new(camera, volume, width, height).expect("a screen with pixels")
}

/// A ball of 12·n² triangles with bumps and smooth normals: the grid of a cube, blown up.
pub(crate) fn bumpy(n: u32) -> Mesh {
    let (mut numbers, mut positions, mut triangles) = (HashMap::new(), Vec::new(), Vec::new());
    for (axis, side) in (0..3).flat_map(|axis| [(axis, 0), (axis, n)]) {
        for (u, v) in (0..n).flat_map(|v| (0..n).map(move |u| (u, v))) {
            let [a, b, c, d] = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)].map(|(u, v)| {
                let mut lattice = [0; 3];
                (lattice[axis], lattice[(axis + 1) % 3], lattice[(axis + 2) % 3]) = (side, u, v);
                *numbers.entry(lattice).or_insert_with(|| {
                    let cube = lattice.map(|x| 2.0 * x as f32 / n as f32 - 1.0);
                    positions.push(with_bumps(Vec3::from_array(cube).normalize()));
                    positions.len() as u32 - 1
                })
            });
            triangles.extend(if side == n { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] });
        }
    }
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for corners in &triangles {
        let [a, b, c] = corners.map(|index| positions[index as usize]);
        corners.iter().for_each(|index| normals[*index as usize] += (b - a).cross(c - a));
    }
    let normals = Indexed { values: normals, triangles: triangles.clone() };
    Mesh::new(positions, triangles).and_then(|mesh| mesh.with_normals(normals)).expect("indices of the grid")
}

fn with_bumps(d: Vec3) -> Vec3 {
    d * (1.0 + 0.03 * ((9.0 * d.x + 0.5).sin() + (11.0 * d.y).sin() * (7.0 * d.z + 1.0).sin()))
}

/// A ray for each of `side` × `side` pixels, in blocks of 4 × 2.
pub(crate) fn primary(side: u32) -> Vec<Ray> {
    let view = view(side, side);
    let blocks = (0..side).step_by(2).flat_map(|j| (0..side).step_by(4).map(move |i| (i, j)));
    let pixels = blocks.flat_map(|(i, j)| (0..8).map(move |k| (i + k % 4, j + k / 4)));
    pixels.map(|(i, j)| viewing_ray(&view, i as f32, j as f32)).collect()
}

/// Rays between points of a sphere around the mesh that have nothing to do with each other.
pub(crate) fn random(count: usize) -> Vec<Ray> {
    let mut state = 20_260_401_u64;
    // SplitMix64 (Steele, Lea and Flood, 2014).
    let mut signed = move || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 40) as f32 / 8_388_608.0 - 1.0
    };
    let mut point = move || loop {
        let p = Vec3::from_array(std::array::from_fn(|_| signed()));
        if (0.01..1.0).contains(&p.length_squared()) {
            return 1.06 * p.normalize();
        }
    };
    (0..count).map(|_| Ray::through(point(), point())).collect()
}
