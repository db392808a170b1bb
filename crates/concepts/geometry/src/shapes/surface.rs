//! How is a shape put together? Corner by corner, each with its own indices.

use glam::{DVec2, DVec3, Vec2, Vec3};

use crate::{Indexed, Mesh};

/// A corner of a triangle: where it takes its position, normal and texture coordinates from.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) position: u32,
    pub(super) normal: u32,
    pub(super) texture: u32,
}

/// A mesh in the making.
#[derive(Default)]
pub(super) struct Surface {
    pub(super) positions: Vec<Vec3>,
    pub(super) normals: Vec<Vec3>,
    pub(super) texture_coordinates: Vec<Vec2>,
    triangles: Vec<[Corner; 3]>,
}

impl Surface {
    /// Adds a point and its normal under one index.
    pub(super) fn point(&mut self, p: DVec3, n: DVec3) {
        self.positions.push(p.as_vec3());
        self.normals.push(n.as_vec3());
    }

    /// Adds texture coordinates.
    pub(super) fn texture(&mut self, u: f64, v: f64) {
        self.texture_coordinates.push(DVec2::new(u, v).as_vec2());
    }

    /// Adds a triangle, corners anticlockwise; none where two corners are one point, as at a pole.
    pub(super) fn triangle(&mut self, corners: [Corner; 3]) {
        let [a, b, c] = corners.map(|corner| corner.position);
        if a != b && b != c && c != a {
            self.triangles.push(corners);
        }
    }

    /// Adds a quadrilateral as two triangles, corners anticlockwise.
    pub(super) fn quad(&mut self, [a, b, c, d]: [Corner; 4]) {
        self.triangle([a, b, c]);
        self.triangle([a, c, d]);
    }

    /// The finished mesh.
    pub(super) fn into_mesh(self) -> Mesh {
        let pick =
            |f: fn(&Corner) -> u32| self.triangles.iter().map(|t| [f(&t[0]), f(&t[1]), f(&t[2])]).collect();
        let normals = Indexed { values: self.normals, triangles: pick(|c| c.normal) };
        let texture = Indexed { values: self.texture_coordinates, triangles: pick(|c| c.texture) };
        Mesh::new(self.positions, pick(|c| c.position))
            .and_then(|mesh| mesh.with_normals(normals))
            .and_then(|mesh| mesh.with_texture_coordinates(texture))
            .expect("a built-in shape has finite numbers and indices in range")
    }
}

/// The direction at k/n of a turn around the y axis, starting at +z and going towards +x: anticlockwise from above.
pub(super) fn around_y(k: u32, n: u32) -> DVec3 {
    let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(n)).sin_cos();
    DVec3::new(sin, 0.0, cos)
}
