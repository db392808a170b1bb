//! What is in a picture? Camera, lights, materials, objects and settings, as a scene file gives them.
//!
//! A [`Scene`] is plain data: it can be built, compared, written ([`Scene::to_toml`]) and read ([`Scene::from_toml`]).
//! Angles are degrees here, for this is the model of a file; [`crate::prepare()`] turns them into radians.

use std::collections::BTreeMap;

use glam::{Mat4, Vec3};
use lighting::{Light, Rgb};
use raytrace::Surface;
use shading::Shading;
use zbuffer::DepthFormat;

use crate::{Renderer, Show};

/// Everything that a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// From where and whereto the eye looks.
    pub camera: View,
    /// The colour where no object is.
    pub background: Rgb,
    /// The lights; `to_light` of a directional one may have any length but 0, [`crate::prepare()`] makes it a unit vector.
    pub lights: Vec<Light>,
    /// The surfaces by name. Only the ray tracer follows mirrors and glass (L58).
    pub materials: BTreeMap<String, Surface>,
    /// The objects, in the order of the file.
    pub objects: Vec<Object>,
    /// How to render, unless the caller wants it otherwise.
    pub settings: Settings,
}

/// The eye, where it looks, and how much it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// e: where the eye is, world space.
    pub eye: Vec3,
    /// The point it looks at, in the middle of the picture, world space.
    pub target: Vec3,
    /// Roughly upwards, world space; any length but 0, not along the gaze.
    pub up: Vec3,
    /// How much it sees.
    pub lens: Lens,
}

/// How much an eye sees: an angle or a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// A symmetric window by its vertical angle; its width follows the picture's.
    FieldOfView {
        /// The vertical field of view in degrees, between 0 and 180.
        degrees: f32,
        /// n: the w-coordinate of the near plane, negative; fitted to the objects where it is missing.
        near: Option<f32>,
        /// f: the w-coordinate of the far plane, less than `near`; fitted to the objects where it is missing.
        far: Option<f32>,
    },
    /// l, r, b, t, n, f as on the slides (L3, L7).
    Window(transforms::ViewVolume),
}

/// A shape with a material, once or several times.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// What it is.
    pub shape: Shape,
    /// The name of its material; without one, a neutral grey, or for an OBJ file the file's own materials.
    pub material: Option<String>,
    /// What is done to the shape, first to last.
    pub transforms: Vec<Transform>,
    /// Where the copies go: each list acts after `transforms`. Without one there is a single copy, and nothing more is
    /// done to it. All copies share one mesh.
    pub instances: Vec<Vec<Transform>>,
    /// For shapes without normals (polygons, many OBJ files): edges sharper than this many degrees stay hard.
    pub crease_degrees: f32,
}

/// A shape around the origin, y up.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The exact ball in the ray tracer; for the rasterizers an icosphere of this level.
    Sphere {
        /// Its radius, greater than 0.
        radius: f32,
        /// Subdivision level of the stand-in.
        level: u32,
    },
    /// A ball of triangles along meridians and parallels.
    UvSphere {
        /// Its radius, greater than 0.
        radius: f32,
        /// Subdivision level.
        level: u32,
    },
    /// A ball of nearly equal triangles.
    Icosphere {
        /// Its radius, greater than 0.
        radius: f32,
        /// Subdivision level.
        level: u32,
    },
    /// A box, `"box"` in files.
    Cuboid {
        /// The lengths of its edges, each greater than 0.
        size: Vec3,
        /// Subdivision level.
        level: u32,
    },
    /// A ring around the y axis.
    Torus {
        /// From the axis to the middle of the tube.
        major: f32,
        /// The radius of the tube, less than `major`.
        minor: f32,
        /// Subdivision level.
        level: u32,
    },
    /// A round plate in the plane y = 0, front upwards.
    Disc {
        /// Its radius, greater than 0.
        radius: f32,
        /// Subdivision level.
        level: u32,
    },
    /// The Utah teapot, foot on y = 0, 3.15 high.
    Teapot {
        /// Subdivision level.
        level: u32,
    },
    /// Flat polygons, convex or re-entrant, each of at least three corners, anticlockwise seen from the front.
    Polygons {
        /// The corners.
        polygons: Vec<Vec<Vec3>>,
    },
    /// A Wavefront OBJ file.
    Obj {
        /// Its path as written, relative to the folder of the scene file.
        path: String,
        /// Whether to move it to the origin and scale it so that its bounding box has a half diagonal of 1.
        fit: bool,
    },
}

/// One step of moving a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transform {
    /// Moves by this much.
    Translate(Vec3),
    /// Stretches along the axes; no factor is 0.
    Scale(Vec3),
    /// Turns anticlockwise about an axis through the origin, seen from the axis' tip.
    Rotate {
        /// The angle.
        degrees: f32,
        /// The axis, any length but 0.
        axis: Vec3,
    },
}

/// How to render.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Which algorithm.
    pub renderer: Renderer,
    /// Which normals and colours triangles get (L37–L40). In the ray tracer flat means one normal a triangle, and both
    /// others mean interpolated normals.
    pub shading: Shading,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// What to show.
    pub show: Show,
    /// n: colours are averages over n × n samples a pixel.
    pub samples: u32,
    /// Whether lights cast shadows (ray tracer only).
    pub shadows: bool,
    /// How many times light may be mirrored or refracted (ray tracer only).
    pub max_depth: u32,
    /// Which highlight (E4).
    pub highlight: lighting::Highlight,
    /// How finely the depth buffer tells depths apart (L20; z-buffer only).
    pub depth_bits: DepthFormat,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            renderer: Renderer::default(),
            shading: Shading::Phong,
            size: (640, 480),
            show: Show::default(),
            samples: 1,
            shadows: true,
            max_depth: 8,
            highlight: lighting::Highlight::default(),
            depth_bits: DepthFormat::F32,
        }
    }
}

impl Object {
    /// Returns one copy of a shape at the origin, with the material of this name.
    #[must_use]
    pub fn new(shape: Shape, material: &str) -> Self {
        Self {
            shape,
            material: Some(material.to_owned()),
            transforms: Vec::new(),
            instances: Vec::new(),
            crease_degrees: crate::parse::CREASE_DEGREES,
        }
    }

    /// Returns the object with these transforms, applied first to last.
    #[must_use]
    pub fn moved(self, transforms: impl Into<Vec<Transform>>) -> Self {
        Self { transforms: transforms.into(), ..self }
    }
}

impl Shape {
    /// How many triangles one copy has; `None` for an OBJ file, which has to be read first.
    #[must_use]
    pub fn triangle_count(&self) -> Option<u64> {
        // 2^level; the formulas are those of `geometry::shapes`.
        let m = |level: u32| 1_u64 << level.min(31);
        Some(match *self {
            Self::Sphere { level, .. } | Self::Icosphere { level, .. } => 20 * m(level).pow(2),
            Self::UvSphere { level, .. } => 4 * m(level) * (4 * m(level) - 2),
            Self::Cuboid { level, .. } => 12 * m(level).pow(2),
            Self::Torus { level, .. } => 64 * m(level).pow(2),
            Self::Disc { level, .. } => 6 * m(level) * (2 * m(level) - 1),
            Self::Teapot { level } => 256 * m(level).pow(2) - 16 * m(level),
            Self::Polygons { ref polygons } => {
                polygons.iter().map(|p| p.len().saturating_sub(2) as u64).sum()
            }
            Self::Obj { .. } => return None,
        })
    }
}

impl Transform {
    /// Its matrix.
    #[must_use]
    pub fn matrix(&self) -> Mat4 {
        match *self {
            Self::Translate(by) => Mat4::from_translation(by),
            Self::Scale(by) => Mat4::from_scale(by),
            Self::Rotate { degrees, axis } => {
                Mat4::from_axis_angle(axis.normalize_or(Vec3::Y), degrees.to_radians())
            }
        }
    }
}
