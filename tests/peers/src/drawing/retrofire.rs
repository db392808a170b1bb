//! The scene as retrofire's users write it: shared vertices, a vertex and a fragment shader, a frame buffer of 32-bit
//! pixels and depths.

use glam::Vec3;
use retrofire_core::geom::Vertex;
use retrofire_core::math::{Color3f, Lerp, Mat4, ProjMat3, ProjVec3, Vary};
use retrofire_core::prelude::*;
use retrofire_core::render::{Model, Ndc, Screen, render};
use retrofire_core::util::Dims;
use retrofire_core::util::pixfmt::Xrgb8888;
use shading::Shading;
use transforms::Pipeline;

use super::{Draws, Picture, Seen};
use crate::scenes::{self, Scene};

type V3 = retrofire_core::math::Vec3<Model>;
type Point = retrofire_core::math::Point3<Model>;
type Corner = Vertex<Point, V3>;

/// What both shaders read.
#[derive(Clone, Copy)]
struct Uniforms {
    clip_from_world: ProjMat3<Model>,
    eye: Point,
    light: Point,
}

/// Where lighting happens.
trait Mode {
    /// What goes from the corners to the pixels.
    type Varying: Vary + Lerp + Clone;

    fn at_vertex(uniforms: &Uniforms, corner: &Corner) -> Self::Varying;

    fn in_pixel(uniforms: &Uniforms, varying: Self::Varying) -> Color3f;
}

/// At the corners; colours are interpolated (L38), as vectors: its type for colours is interpolated on the screen,
/// without regard to perspective (E9), and gives another picture.
struct Gouraud;

/// In the pixels; points and normals are interpolated (L40).
struct Phong;

impl Mode for Gouraud {
    type Varying = V3;

    #[inline]
    fn at_vertex(uniforms: &Uniforms, corner: &Corner) -> V3 {
        lit(uniforms, &corner.pos, &corner.attrib).0.into()
    }

    #[inline]
    fn in_pixel(_: &Uniforms, color: V3) -> Color3f {
        color.0.into()
    }
}

impl Mode for Phong {
    type Varying = (Point, V3);

    #[inline]
    fn at_vertex(_: &Uniforms, corner: &Corner) -> (Point, V3) {
        (corner.pos, corner.attrib)
    }

    #[inline]
    fn in_pixel(uniforms: &Uniforms, (p_world, n): (Point, V3)) -> Color3f {
        lit(uniforms, &p_world, &unit(n))
    }
}

/// The lighting model in retrofire's words: ambient, diffuse, and Blinn's highlight behind its gate.
#[inline]
fn lit(uniforms: &Uniforms, p_world: &Point, n: &V3) -> Color3f {
    let [diffuse, ambient] =
        [scenes::DIFFUSE, scenes::DIFFUSE * scenes::AMBIENT].map(|color: Vec3| color.to_array());
    let to_light = unit(uniforms.light - *p_world);
    let cosine = n.dot(&to_light);
    if cosine <= 0.0 {
        return ambient.into();
    }
    let h = unit(to_light + unit(uniforms.eye - *p_world));
    let gleam = scenes::SPECULAR * h.dot(n).max(0.0).powf(scenes::EXPONENT);
    let color: [f32; 3] = std::array::from_fn(|k| ambient[k] + diffuse[k] * cosine + gleam);
    color.into()
}

/// Brought to unit length by a square root. Its own `normalize` raises to the power −½, which takes longer, and takes
/// the NaN that it interpolates to in a triangle without height for a mistake of ours.
#[inline]
fn unit(v: V3) -> V3 {
    v * v.len().recip()
}

struct Shaders<M>(std::marker::PhantomData<M>);

impl<M: Mode> VertexShader<Corner, &Uniforms> for Shaders<M> {
    type Output = Vertex<ProjVec3, M::Varying>;

    #[inline]
    fn shade_vertex(&self, corner: Corner, uniforms: &Uniforms) -> Self::Output {
        vertex(uniforms.clip_from_world.apply(&corner.pos), M::at_vertex(uniforms, &corner))
    }
}

impl<M: Mode> FragmentShader<M::Varying, &Uniforms> for Shaders<M> {
    #[inline]
    fn shade_fragment(&self, fragment: Frag<M::Varying>, uniforms: &Uniforms) -> Option<Color4> {
        Some(M::in_pixel(uniforms, fragment.var).to_color4())
    }
}

type Frame = Framebuf<Colorbuf<Buf2<u32>, Xrgb8888>, Buf2<f32>>;

struct Prepared<M> {
    uniforms: Uniforms,
    triangles: Vec<Tri<usize>>,
    corners: Vec<Corner>,
    to_screen: Mat4<Ndc, Screen>,
    frame: Frame,
    mode: std::marker::PhantomData<M>,
}

/// The scene in retrofire's form.
pub(super) fn prepare(scene: &Scene, view: &Pipeline, shading: Shading) -> Box<dyn Draws> {
    match shading {
        Shading::Phong => Box::new(Prepared::<Phong>::new(scene, view)),
        _ => Box::new(Prepared::<Gouraud>::new(scene, view)),
    }
}

impl<M: Mode> Prepared<M> {
    fn new(scene: &Scene, view: &Pipeline) -> Self {
        let size = Dims(view.width(), view.height());
        let rows = scenes::opengl_clip_from_world(view).transpose().to_cols_array_2d();
        let corners = scene.mesh.positions().iter().zip(scene.normals());
        Self {
            uniforms: Uniforms {
                clip_from_world: rows.into(),
                eye: view.camera().eye().to_array().into(),
                light: scenes::LIGHT.to_array().into(),
            },
            triangles: scene.mesh.triangles().iter().map(|t| Tri(t.map(|index| index as usize))).collect(),
            corners: corners.map(|(p, n)| vertex(p.to_array().into(), n.to_array().into())).collect(),
            // Its screen's rows run down, and so does its y; with ours upwards, fronts stay anticlockwise and row j is
            // row j.
            to_screen: viewport(size.into()),
            frame: Framebuf { color_buf: Colorbuf::new(Buf2::new(size)), depth_buf: Buf2::new(size) },
            mode: std::marker::PhantomData,
        }
    }
}

impl<M: Mode> Draws for Prepared<M> {
    fn name(&self) -> &'static str {
        "retrofire"
    }

    fn draw(&mut self) {
        self.frame.color_buf.buf.fill(0);
        // It keeps 1/w: nothing is infinitely far away.
        self.frame.depth_buf.fill(0.0);
        render(
            &self.triangles,
            &self.corners,
            &Shaders::<M>(self.mode),
            &self.uniforms,
            self.to_screen,
            &mut self.frame,
            &Context::default(),
        );
    }

    fn picture(&self) -> Picture {
        let width = self.frame.depth_buf.width() as usize;
        let colors = self.frame.color_buf.buf.data().rchunks(width);
        let rows = colors.zip(self.frame.depth_buf.data().rchunks(width));
        let seen = rows.flat_map(|(colors, depths)| colors.iter().zip(depths));
        let pixels = seen.map(|(color, reciprocal)| {
            let [_, r, g, b] = color.to_be_bytes();
            // A byte says that the number lay between it and the next one, of 256.
            let color = [r, g, b].map(|byte| (f32::from(byte) + 0.5) / 256.0);
            (*reciprocal > 0.0).then(|| Seen { color, distance: reciprocal.recip() })
        });
        Picture { width, pixels: pixels.collect() }
    }
}
