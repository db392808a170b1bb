//! The scene as euc's users write it: a pipeline with a vertex and a fragment shader, indices for vertices, pixels in
//! 32 bits as in its examples.

use euc::buffer::Buffer2d;
use euc::rasterizer::Triangles;
use euc::{Interpolate, Target};
use glam::Vec3;
use shading::Shading;
use transforms::Pipeline;
use vek::{Mat4, Rgb, Vec4};

use super::{Draws, Picture, Seen};
use crate::scenes::{self, Scene};

type V3 = vek::Vec3<f32>;

/// What both shaders read.
struct Uniforms {
    clip_from_world: Mat4<f32>,
    positions: Vec<V3>,
    normals: Vec<V3>,
    eye: V3,
}

/// Where lighting happens.
trait Mode {
    /// What goes from the corners to the pixels.
    type Varying: Clone + Interpolate;

    fn at_vertex(uniforms: &Uniforms, p_world: V3, n: V3) -> Self::Varying;

    fn in_pixel(uniforms: &Uniforms, varying: &Self::Varying) -> Rgb<f32>;
}

/// At the corners; colours are interpolated (L38).
struct Gouraud;

/// In the pixels; points and normals are interpolated (L40).
struct Phong;

impl Mode for Gouraud {
    type Varying = Rgb<f32>;

    #[inline(always)]
    fn at_vertex(uniforms: &Uniforms, p_world: V3, n: V3) -> Rgb<f32> {
        lit(p_world, n, uniforms.eye)
    }

    #[inline(always)]
    fn in_pixel(_: &Uniforms, color: &Rgb<f32>) -> Rgb<f32> {
        *color
    }
}

impl Mode for Phong {
    type Varying = (V3, V3);

    #[inline(always)]
    fn at_vertex(_: &Uniforms, p_world: V3, n: V3) -> (V3, V3) {
        (p_world, n)
    }

    #[inline(always)]
    fn in_pixel(uniforms: &Uniforms, (p_world, n): &(V3, V3)) -> Rgb<f32> {
        lit(*p_world, n.normalized(), uniforms.eye)
    }
}

/// The lighting model in vek's words: ambient, diffuse, and Blinn's highlight behind its gate.
#[inline(always)]
fn lit(p_world: V3, n: V3, eye: V3) -> Rgb<f32> {
    let diffuse = Rgb::from(scenes::DIFFUSE.to_array());
    let ambient = diffuse * Rgb::from(scenes::AMBIENT.to_array());
    let to_light = (vector(scenes::LIGHT) - p_world).normalized();
    let cosine = n.dot(to_light);
    if cosine <= 0.0 {
        return ambient;
    }
    let h = (to_light + (eye - p_world).normalized()).normalized();
    ambient + diffuse * cosine + Rgb::broadcast(scenes::SPECULAR * h.dot(n).max(0.0).powf(scenes::EXPONENT))
}

struct Shaders<M> {
    uniforms: Uniforms,
    mode: std::marker::PhantomData<M>,
}

impl<M: Mode> euc::Pipeline for Shaders<M> {
    type Vertex = u32;
    type VsOut = M::Varying;
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, index: &u32) -> ([f32; 4], M::Varying) {
        let p_world = self.uniforms.positions[*index as usize];
        let clip = self.uniforms.clip_from_world * Vec4::from_point(p_world);
        let n = self.uniforms.normals[*index as usize];
        (clip.into_array(), M::at_vertex(&self.uniforms, p_world, n))
    }

    #[inline(always)]
    fn frag(&self, varying: &M::Varying) -> u32 {
        let color = M::in_pixel(&self.uniforms, varying);
        let [r, g, b] = (color.map(|x| x.clamp(0.0, 1.0)) * 255.0).map(|x| x as u8).into_array();
        u32::from_le_bytes([b, g, r, 255])
    }
}

struct Prepared<M> {
    shaders: Shaders<M>,
    indices: Vec<u32>,
    color: Buffer2d<u32>,
    depth: Buffer2d<f32>,
}

/// The scene in euc's form.
pub(super) fn prepare(scene: &Scene, view: &Pipeline, shading: Shading) -> Box<dyn Draws> {
    match shading {
        Shading::Phong => Box::new(Prepared::<Phong>::new(scene, view)),
        _ => Box::new(Prepared::<Gouraud>::new(scene, view)),
    }
}

impl<M: Mode> Prepared<M> {
    fn new(scene: &Scene, view: &Pipeline) -> Self {
        let vectors = |list: &[Vec3]| list.iter().map(|v| vector(*v)).collect();
        let size = [view.width() as usize, view.height() as usize];
        let uniforms = Uniforms {
            clip_from_world: Mat4::from_col_arrays(scenes::opengl_clip_from_world(view).to_cols_array_2d()),
            positions: vectors(scene.mesh.positions()),
            normals: vectors(scene.normals()),
            eye: vector(view.camera().eye()),
        };
        Self {
            shaders: Shaders { uniforms, mode: std::marker::PhantomData },
            indices: scene.mesh.triangles().as_flattened().to_vec(),
            color: Buffer2d::new(size, 0),
            depth: Buffer2d::new(size, 1.0),
        }
    }
}

impl<M: Mode> Draws for Prepared<M> {
    fn name(&self) -> &'static str {
        "euc"
    }

    fn draw(&mut self) {
        self.color.clear(0);
        self.depth.clear(1.0);
        // Back faces are culled unless another type parameter says otherwise.
        euc::Pipeline::draw::<Triangles<_>, _>(
            &self.shaders,
            &self.indices,
            &mut self.color,
            Some(&mut self.depth),
        );
    }

    fn picture(&self) -> Picture {
        let seen = self.color.as_ref().iter().zip(self.depth.as_ref());
        let pixels = seen.map(|(color, z)| {
            let [b, g, r, _] = color.to_le_bytes();
            // A byte says that the number lay between it and the next one.
            let color = [r, g, b].map(|byte| (f32::from(byte) + 0.5) / 255.0);
            (*z < 1.0).then(|| Seen { color, distance: scenes::distance_from_opengl_z(*z) })
        });
        Picture { width: self.color.size()[0], pixels: pixels.collect() }
    }
}

fn vector(v: Vec3) -> V3 {
    V3::from(v.to_array())
}
