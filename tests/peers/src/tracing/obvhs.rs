//! The mesh as obvhs' users trace it: a binary hierarchy from the medium preset, its own triangle test, and the
//! triangles in the order of the leaves, as its examples advise.

use std::time::Duration;

use geometry::Mesh;
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::ray::{Ray, RayHit};
use obvhs::triangle::Triangle;

use super::{Kind, Rays, Traces};

pub(super) struct Prepared {
    hierarchy: Bvh2,
    in_leaf_order: Vec<Triangle>,
    rays: Vec<Vec<Ray>>,
}

/// The triangles in obvhs' form.
pub(super) fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let triangle = |k| {
        let [v0, v1, v2] = mesh.triangle(k).corners().map(Vec3A::from);
        Triangle { v0, v1, v2 }
    };
    (0..mesh.len()).map(triangle).collect()
}

/// The hierarchy: what is measured as building.
pub(super) fn build(triangles: &[Triangle]) -> Bvh2 {
    build_bvh2_from_tris(triangles, BvhBuildParams::medium_build(), &mut Duration::default())
}

impl Prepared {
    pub(super) fn new(mesh: &Mesh, rays: &Rays) -> Self {
        let triangles = triangles(mesh);
        let hierarchy = build(&triangles);
        let in_leaf_order = hierarchy.primitive_indices.iter().map(|k| triangles[*k as usize]).collect();
        let ray = |kind: Kind, ray: &geometry::Ray| {
            Ray::new(ray.origin.into(), ray.direction.into(), 0.0, kind.farthest())
        };
        let rays = Kind::ALL.map(|kind| rays.of(kind).iter().map(|r| ray(kind, r)).collect()).to_vec();
        Self { hierarchy, in_leaf_order, rays }
    }
}

impl Traces for Prepared {
    fn name(&self) -> &'static str {
        "obvhs"
    }

    fn trace(&self, kind: Kind, t: &mut [f32]) {
        for (ray, t) in self.rays[kind as usize].iter().zip(t) {
            if kind == Kind::Shadow {
                let miss =
                    self.hierarchy.ray_traverse_miss(*ray, |ray, k| self.in_leaf_order[k].intersect(ray));
                *t = if miss { f32::INFINITY } else { 0.0 };
            } else {
                let mut hit = RayHit::none();
                self.hierarchy.ray_traverse(*ray, &mut hit, |ray, k| self.in_leaf_order[k].intersect(ray));
                *t = hit.t;
            }
        }
    }
}
