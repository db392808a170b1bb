//! What happens one step after the other?
//!
//! - [`steps`]: the depth grids (L17), the painter's order (L13), or one of three ways to solve the 3×3 system (L51).

mod depth;
mod painter;
mod solve;

use serde::Deserialize;
use serde_json::{Map, Value as Json, json};
use sheet::Words;

use crate::story::json::{number, words};
use crate::{Look, Refusal, Stage};
pub use solve::How;

/// What is to be taken step by step.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum StepsRequest {
    /// The depth buffer of the slide, triangle by triangle (L17).
    Depth {
        /// z of the first polygon; larger is nearer.
        #[serde(default = "depth::first")]
        first: f32,
        /// z of the second polygon.
        #[serde(default = "depth::second")]
        second: f32,
        /// z of the third polygon.
        #[serde(default = "depth::third")]
        third: f32,
    },
    /// The painter's algorithm on a scene, from back to front (L13, L14).
    Painter {
        /// The scene, and from where it is seen.
        look: Look,
    },
    /// The 3×3 system of a ray and a triangle (L50, L51).
    Solve {
        /// By which of the slide's three ways.
        how: How,
        /// The picture with the pixel; the lecture's worked example without one (L54).
        look: Option<Look>,
        /// The pixel whose visible triangle is meant, j upwards; the picture's middle without one.
        pixel: Option<(u32, u32)>,
    },
}

/// The steps, as the page shows them.
///
/// # Errors
/// [`Refusal`] if a look is none, a number is out of range, or there is nothing to be taken step by step.
pub fn steps(stage: &Stage, asked: &StepsRequest) -> Result<Json, Refusal> {
    let told = match asked {
        StepsRequest::Depth { first, second, third } => depth::told([*first, *second, *third])?,
        StepsRequest::Painter { look } => painter::told(stage, look)?,
        StepsRequest::Solve { how, look, pixel } => solve::told(stage, *how, look.as_ref(), *pixel)?,
    };
    Ok(told.json())
}

/// Steps under a title.
struct Told {
    title: Words,
    steps: Vec<Step>,
}

/// What happened, and how things stand after it.
struct Step {
    words: Words,
    lines: Vec<Words>,
    drawing: Option<Drawing>,
    /// β, γ and t, where they are found.
    solution: Option<[f32; 3]>,
}

/// What a step shows beside words.
enum Drawing {
    /// The text of an SVG file.
    Lines(String),
    /// The address of a picture.
    Picture(String),
    /// A system of equations.
    Equations(Equations),
}

/// Three rows of numbers with their right-hand sides; some of them are what the step is about.
struct Equations {
    matrix: [[f32; 3]; 3],
    rhs: Option<[f32; 3]>,
    /// Row and column; column 3 is the right-hand side.
    marked: Vec<(usize, usize)>,
}

impl Told {
    fn json(&self) -> Json {
        json!({
            "title": words(&self.title),
            "steps": self.steps.iter().map(Step::json).collect::<Vec<_>>(),
        })
    }
}

impl Step {
    /// A step that is told in words alone.
    fn new(words: Words) -> Self {
        Self { words, lines: Vec::new(), drawing: None, solution: None }
    }

    /// With lines of numbers.
    fn lines(self, lines: Vec<Words>) -> Self {
        Self { lines, ..self }
    }

    /// With a drawing, a picture or equations.
    fn showing(self, drawing: Drawing) -> Self {
        Self { drawing: Some(drawing), ..self }
    }

    fn json(&self) -> Json {
        let mut told = Map::new();
        told.insert("words".to_owned(), words(&self.words));
        if !self.lines.is_empty() {
            told.insert("lines".to_owned(), self.lines.iter().map(words).collect());
        }
        if let Some(solution) = self.solution {
            told.insert("solution".to_owned(), json!(solution.map(number)));
        }
        match &self.drawing {
            None => {}
            Some(Drawing::Lines(svg)) => drop(told.insert("svg".to_owned(), json!(svg))),
            Some(Drawing::Picture(address)) => drop(told.insert("png".to_owned(), json!(address))),
            Some(Drawing::Equations(equations)) => {
                let row = |row: [f32; 3]| row.map(number);
                told.insert("matrix".to_owned(), json!(equations.matrix.map(row)));
                told.insert("rhs".to_owned(), json!(equations.rhs.map(row)));
                told.insert("marked".to_owned(), json!(equations.marked));
            }
        }
        Json::Object(told)
    }
}
