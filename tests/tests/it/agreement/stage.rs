//! One scene, for every renderer.

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Mesh, Triangle};
use glam::Mat4;
use lighting::{Highlight, Light, Material};
use shading::{Shading, Visibility};
use transforms::Pipeline;

/// A scene in terms that both renderers understand.
#[derive(Clone, Debug)]
pub(crate) struct Stage {
    pub(crate) meshes: Vec<(Mesh, Mat4, Material)>,
    pub(crate) lights: Vec<Light>,
    pub(crate) pipeline: Pipeline,
}

pub(crate) const BACKGROUND: Rgb = Rgb::new(0.1, 0.2, 0.4);

impl Stage {
    pub(crate) fn rasterized(&self, shading: Shading, visibility: Visibility) -> shading::Frame {
        let objects: Vec<shading::Object> = self
            .meshes
            .iter()
            .map(|(mesh, world_from_object, material)| shading::Object {
                mesh,
                world_from_object: *world_from_object,
                materials: std::slice::from_ref(material),
            })
            .collect();
        let world = shading::World {
            objects: &objects,
            lights: &self.lights,
            background: BACKGROUND,
            highlight: Highlight::Blinn,
        };
        shading::render(&world, &self.pipeline, shading, visibility)
    }

    pub(crate) fn traceable(&self, interpolation: raytrace::Interpolation) -> raytrace::World {
        let objects = self.meshes.iter().map(|(mesh, world_from_object, material)| {
            let shape = raytrace::Shape::Mesh(Arc::new(raytrace::TracedMesh::new(mesh.clone())));
            raytrace::Object::new(shape, *world_from_object, vec![raytrace::Surface::opaque(*material)])
                .expect("an invertible transform")
        });
        let mut world = raytrace::World::new(objects.collect(), self.lights.clone());
        world.background = BACKGROUND;
        world.interpolation = interpolation;
        world
    }

    pub(crate) fn triangle(&self, (object, triangle): (usize, usize)) -> Triangle {
        let (mesh, world_from_object, _) = &self.meshes[object];
        let [a, b, c] = mesh.triangle(triangle).corners().map(|p| world_from_object.transform_point3(p));
        Triangle { a, b, c }
    }

    pub(crate) fn triangles(&self) -> impl Iterator<Item = (usize, usize)> {
        self.meshes
            .iter()
            .enumerate()
            .flat_map(|(object, (mesh, ..))| (0..mesh.len()).map(move |k| (object, k)))
    }
}
