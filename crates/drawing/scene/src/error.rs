//! What is wrong, where, and what would be right? [`SceneError`] is about files, [`RenderError`] about pictures.

use crate::limits::{GREATEST_COORDINATE, MOST_PAINTED, MOST_TRIANGLES};

/// A fault of a scene, OBJ or MTL file, said so that it can be mended.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {problem}\n  {remedy}", place(file, *.line, *.column))]
pub struct SceneError {
    /// The file as the user named it, or the name of a built-in scene.
    pub file: String,
    /// The line, counted from 1; `None` where the whole file is meant.
    pub line: Option<usize>,
    /// The column in characters, counted from 1; `None` where the whole line is meant.
    pub column: Option<usize>,
    /// What is wrong, with the value that was found.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The scene was changed in memory to something that its reader refuses.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An OBJ file was named after the scene was loaded.
    #[error("{path} was not loaded with the scene")]
    NotLoaded {
        /// The path as the scene has it.
        path: String,
    },
    /// An object's transforms carry it out of the range in which areas can be computed.
    #[error(
        "object {object} (counted from 0) reaches beyond {GREATEST_COORDINATE:e}: scale it down, or give its OBJ file `fit = true`"
    )]
    FarAway {
        /// Its place in the scene.
        object: usize,
    },
    /// More than [`MOST_TRIANGLES`].
    #[error("with object {object} (counted from 0) there are more than {MOST_TRIANGLES} triangles")]
    TooManyTriangles {
        /// The object that is too much.
        object: usize,
    },
    /// More than [`MOST_PAINTED`] triangles for the painter's algorithm.
    #[error(
        "the painter's algorithm compares triangles in pairs and takes at most {MOST_PAINTED}; the scene has {triangles}"
    )]
    TooManyToPaint {
        /// How many there are.
        triangles: usize,
    },
    /// Triangles that hide and pierce each other too often for the painter's algorithm.
    #[error(
        "the painter's algorithm gave up: too many triangles lie in one place or pass through each other"
    )]
    TooEntangled,
    /// A setting out of range.
    #[error("{name} is {value}; it must be from {least} to {greatest}")]
    Setting {
        /// Which one.
        name: &'static str,
        /// Its value.
        value: u32,
        /// The least that is allowed.
        least: u32,
        /// The most that is allowed.
        greatest: u32,
    },
    /// The picture, or its samples, would not fit in memory.
    #[error(
        "{width} × {height} pixels with {samples} × {samples} samples each are too many at once; at most {most}"
    )]
    TooManyPixels {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Samples along each side of a pixel.
        samples: u32,
        /// The most pixels, or samples for a rasterizer, there may be.
        most: u64,
    },
    /// Eye, target and up make no camera.
    #[error(transparent)]
    Camera(#[from] transforms::DegenerateCamera),
    /// Angle and planes make no viewing volume.
    #[error(transparent)]
    Volume(#[from] transforms::DegenerateVolume),
    /// Volume and size make no pipeline.
    #[error(transparent)]
    Pipeline(#[from] transforms::DegeneratePipeline),
    /// A shape's sizes make no surface.
    #[error(transparent)]
    Shape(#[from] geometry::shapes::ShapeError),
    /// Corners make no mesh.
    #[error(transparent)]
    Mesh(#[from] geometry::MeshError),
    /// A transform that the ray tracer cannot undo.
    #[error(transparent)]
    Object(#[from] raytrace::ObjectError),
}

fn place(file: &str, line: Option<usize>, column: Option<usize>) -> String {
    let number = |n: Option<usize>| n.map(|n| format!(":{n}")).unwrap_or_default();
    format!("{file}{}{}", number(line), number(column))
}
