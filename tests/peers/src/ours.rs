//! Our side, all of it: whoever measures another version of ours changes this file.

use std::sync::Arc;

use canvas::{Image, Rgb};
use geometry::{Mesh, Ray};
use glam::Mat4;
use raytrace::{Settings, Shape, Surface, TracedMesh};
use shading::{Frame, Shading, Visibility};
use transforms::Pipeline;

use crate::drawing::{Draws, Picture, Seen};
use crate::scenes::{self, Scene};

/// What the report says about this version.
pub(crate) const VERSION: &str = "shading::render, raytrace::nearest and any_hit";

/// Ours, object by object.
pub(crate) struct Drawing<'s> {
    scene: &'s Scene,
    view: Pipeline,
    shading: Shading,
    frame: Option<Frame>,
}

impl<'s> Drawing<'s> {
    /// The scene, ready to be drawn.
    pub(crate) fn new(scene: &'s Scene, view: &Pipeline, shading: Shading) -> Self {
        Self { scene, view: *view, shading, frame: None }
    }
}

impl Draws for Drawing<'_> {
    fn name(&self) -> &'static str {
        "ours"
    }

    fn draw(&mut self) {
        let materials = [scenes::material()];
        let objects = [shading::Object {
            mesh: &self.scene.mesh,
            world_from_object: Mat4::IDENTITY,
            materials: &materials,
        }];
        let lights = scenes::lights();
        let world = shading::World {
            objects: &objects,
            lights: &lights,
            background: Rgb::ZERO,
            highlight: scenes::HIGHLIGHT,
        };
        self.frame = Some(shading::render(&world, &self.view, self.shading, Visibility::default()));
    }

    fn picture(&self) -> Picture {
        let frame = self.frame.as_ref().expect("a frame was drawn");
        let seen = frame.image.pixels().iter().zip(&frame.visible);
        let pixels = seen.map(|(color, visible)| {
            // Canonical z is nearer when larger, OpenGL's the other way round.
            let distance = |z: f32| scenes::distance_from_opengl_z(-z);
            visible.map(|at| Seen { color: color.to_array(), distance: distance(at.z) })
        });
        Picture { width: frame.image.width() as usize, pixels: pixels.collect() }
    }
}

/// How many bytes the buffers of a picture of ours take: the frame with all that it tells about each pixel, and the
/// depth buffer.
pub(crate) fn bytes_of_buffers(pixels: usize) -> usize {
    let of_a_pixel =
        size_of::<Rgb>() + size_of::<Option<shading::Visible>>() + size_of::<u32>() + size_of::<f32>();
    pixels * of_a_pixel
}

/// Ours, ray by ray: a mesh with its hierarchy.
pub(crate) struct Tracing(raytrace::World);

impl Tracing {
    /// Builds the hierarchy.
    pub(crate) fn build(mesh: Mesh) -> Self {
        let shape = Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
        let surface = Surface::opaque(scenes::material());
        let object = raytrace::Object::new(shape, Mat4::IDENTITY, vec![surface]).expect("the identity");
        let mut world = raytrace::World::new(vec![object], scenes::lights().to_vec());
        world.highlight = scenes::HIGHLIGHT;
        Self(world)
    }

    /// t of the nearest hit of each ray, infinite for none.
    pub(crate) fn nearest(&self, rays: &[Ray], t: &mut [f32]) {
        for (ray, t) in rays.iter().zip(t) {
            *t = raytrace::nearest(&self.0, ray, 0.0, f32::INFINITY).map_or(f32::INFINITY, |hit| hit.t);
        }
    }

    /// Whether anything is met before t = 1: 0 if so, else infinite.
    pub(crate) fn any(&self, rays: &[Ray], t: &mut [f32]) {
        for (ray, t) in rays.iter().zip(t) {
            *t = if raytrace::any_hit(&self.0, ray, 0.0, 1.0) { 0.0 } else { f32::INFINITY };
        }
    }

    /// The whole picture: a viewing ray a pixel, shadow rays, Phong shading.
    pub(crate) fn picture(&self, view: &Pipeline) -> Image {
        raytrace::render(&self.0, view, &Settings::default(), &|_| ())
    }
}
