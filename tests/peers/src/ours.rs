//! Our side, all of it: whoever measures another version of ours changes this file.

use std::sync::Arc;

use canvas::{Image, Rgb};
use geometry::{Mesh, Ray};
use glam::Mat4;
use raytrace::{Settings, Shape, Surface, TracedMesh, fast};
use shading::Shading;
use shading::fast::Renderer;
use transforms::Pipeline;
use zbuffer::fast::{Band, Faces, MeshInstance, NONE, Projected};

use crate::drawing::{Draws, Picture, Seen};
use crate::scenes::{self, Scene};

/// What the report says about this version.
pub(crate) const VERSION: &str = "shading::fast and raytrace::fast";

/// Ours, object by object. Memory is kept from frame to frame.
pub(crate) struct Drawing<'s> {
    scene: &'s Scene,
    view: Pipeline,
    shading: Shading,
    renderer: Renderer,
    image: Image,
}

impl<'s> Drawing<'s> {
    /// The scene, ready to be drawn.
    pub(crate) fn new(scene: &'s Scene, view: &Pipeline, shading: Shading) -> Self {
        let image = Image::new(view.width(), view.height(), Rgb::ZERO);
        Self { scene, view: *view, shading, renderer: Renderer::new(), image }
    }
}

impl Draws for Drawing<'_> {
    fn name(&self) -> &'static str {
        "ours"
    }

    fn draw(&mut self) {
        let (mesh, materials) = (&self.scene.mesh, [scenes::material()]);
        let objects = [shading::Object { mesh, world_from_object: Mat4::IDENTITY, materials: &materials }];
        let lights = scenes::lights();
        let world = shading::World {
            objects: &objects,
            lights: &lights,
            background: Rgb::ZERO,
            highlight: scenes::HIGHLIGHT,
        };
        self.renderer.render_into(&world, &self.view, self.shading, Faces::Front, &mut self.image);
    }

    /// Depths do not outlive the band of rows that they are for: those of the picture are found once more, by the same code.
    fn picture(&self) -> Picture {
        let parts = [MeshInstance { mesh: &self.scene.mesh, world_from_object: Mat4::IDENTITY }];
        let (mut projected, mut band) = (Projected::default(), Band::default());
        projected.project(&parts, &self.view, Faces::Front);
        let mut depths = Vec::with_capacity(self.image.pixels().len());
        for b in 0..projected.bands() {
            band.draw(b, &projected, &parts);
            depths.extend(band.rows().flat_map(|row| band.row(row).collect::<Vec<_>>()));
        }
        let pixels = self.image.pixels().iter().zip(depths).map(|(color, (number, z))| {
            // Canonical z is nearer when larger, OpenGL's the other way round.
            let distance = scenes::distance_from_opengl_z(-z);
            (number != NONE).then(|| Seen { color: color.to_array(), distance })
        });
        Picture { width: self.image.width() as usize, pixels: pixels.collect() }
    }
}

/// How many bytes a picture takes that is drawn: its colours, and as much as a depth buffer would take.
pub(crate) fn bytes_of_buffers(pixels: usize) -> usize {
    pixels * (size_of::<Rgb>() + size_of::<f32>())
}

/// How many rays are handed over in one call.
const AT_ONCE: usize = 1024;

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
        let mut met = [None; AT_ONCE];
        for (rays, t) in rays.chunks(AT_ONCE).zip(t.chunks_mut(AT_ONCE)) {
            let met = &mut met[..rays.len()];
            fast::nearest_each(&self.0, rays, 0.0, f32::INFINITY, met);
            t.iter_mut().zip(met).for_each(|(t, met)| *t = met.map_or(f32::INFINITY, |met| met.t));
        }
    }

    /// Whether anything is met before t = 1: 0 if so, else infinite.
    pub(crate) fn any(&self, rays: &[Ray], t: &mut [f32]) {
        let (ends, mut met) = ([1.0; AT_ONCE], [false; AT_ONCE]);
        for (rays, t) in rays.chunks(AT_ONCE).zip(t.chunks_mut(AT_ONCE)) {
            let met = &mut met[..rays.len()];
            fast::any_hit_each(&self.0, rays, 0.0, &ends[..rays.len()], met);
            t.iter_mut().zip(met).for_each(|(t, met)| *t = if *met { 0.0 } else { f32::INFINITY });
        }
    }

    /// The whole picture: a viewing ray a pixel, shadow rays, Phong shading.
    pub(crate) fn picture(&self, view: &Pipeline) -> Image {
        raytrace::render(&self.0, view, &Settings::default(), &|_| ())
    }
}
