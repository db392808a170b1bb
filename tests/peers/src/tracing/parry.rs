//! The mesh as parry's users trace it: a `TriMesh` and its ray casts. Of shadow rays it finds the nearest hit, too: it
//! has no query for any.

use geometry::Mesh;
use glam::Vec3;
use parry3d::math::Vector;
use parry3d::query::{Ray, RayCast};
use parry3d::shape::TriMesh;

use super::{Kind, Rays, Traces};

pub(super) struct Prepared {
    mesh: TriMesh,
    rays: Vec<Vec<Ray>>,
}

/// The points in parry's form.
pub(super) fn points(mesh: &Mesh) -> Vec<Vector> {
    mesh.positions().iter().map(|p| vector(*p)).collect()
}

/// The mesh with its hierarchy: what is measured as building.
pub(super) fn build(points: Vec<Vector>, triangles: Vec<[u32; 3]>) -> TriMesh {
    TriMesh::new(points, triangles).expect("a mesh with triangles")
}

impl Prepared {
    pub(super) fn new(mesh: &Mesh, rays: &Rays) -> Self {
        let ray = |ray: &geometry::Ray| Ray::new(vector(ray.origin), vector(ray.direction));
        Self {
            mesh: build(points(mesh), mesh.triangles().to_vec()),
            rays: Kind::ALL.map(|kind| rays.of(kind).iter().map(ray).collect()).to_vec(),
        }
    }
}

impl Traces for Prepared {
    fn name(&self) -> &'static str {
        "parry3d"
    }

    fn trace(&self, kind: Kind, t: &mut [f32]) {
        // It computes with the number, which should not be infinite.
        let farthest = kind.farthest().min(f32::MAX);
        for (ray, t) in self.rays[kind as usize].iter().zip(t) {
            *t = if kind == Kind::Shadow {
                if self.mesh.intersects_local_ray(ray, farthest) { 0.0 } else { f32::INFINITY }
            } else {
                self.mesh.cast_local_ray(ray, farthest, true).unwrap_or(f32::INFINITY)
            };
        }
    }
}

fn vector(v: Vec3) -> Vector {
    Vector::new(v.x, v.y, v.z)
}
