//! What is a figure? A function from parameters to drawings, with words around it.

use std::error::Error;

use canvas::Image;
pub use sheet::{Text, Words};

use crate::handle::{Handle, Handled};
use crate::parameter::{Parameter, Values};

/// A figure of the lecture, computed by the concept crates.
#[derive(Debug)]
pub struct Figure {
    /// The items and errors of the lecture that it shows, the main one first: `["L37", "L38"]`.
    pub numbers: &'static [&'static str],
    /// Its own name, in lower case with dashes: two figures may show one item.
    pub name: &'static str,
    /// The title of the slide, or what the slide is about where it has none.
    pub title: Text,
    /// What there is to see.
    pub caption: Text,
    /// What can be changed.
    pub parameters: &'static [Parameter],
    /// Width and height of each picture in pixels, unless another size is asked for. Diagrams have no pixels.
    pub size: (u32, u32),
    /// Draws it.
    pub draw: fn(&Values) -> Drawn,
    /// Where the handles of its drawings are, without drawing: quick enough to be asked again and again while something is
    /// dragged. The drawings have the same.
    pub handles: fn(&Values) -> Handled,
}

/// What drawing gives; an error says which values do not go together.
pub type Drawn = Result<Vec<Drawing>, Box<dyn Error + Send + Sync>>;

impl Figure {
    /// The number it is called by: `L31`.
    #[must_use]
    pub fn number(&self) -> &'static str {
        self.numbers[0]
    }

    /// What its files are called by: `L31-exponent-strip`.
    #[must_use]
    pub fn stem(&self) -> String {
        format!("{}-{}", self.number(), self.name)
    }

    /// Whether `asked` means this figure: one of its numbers, its name or its stem, in any case.
    #[must_use]
    pub fn is_called(&self, asked: &str) -> bool {
        let is = |name: &str| name.eq_ignore_ascii_case(asked);
        self.numbers.iter().any(|number| is(number)) || is(self.name) || is(&self.stem())
    }
}

/// One drawing of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// What sets it apart from the figure's other drawings: `gouraud`. Empty if it is the only one.
    pub name: String,
    /// What somebody learns from it who cannot see it.
    pub alt: Words,
    /// The drawing itself.
    pub content: Content,
    /// What can be dragged in it.
    pub handles: Vec<Handle>,
}

/// A drawing is made of pixels or of lines.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Linear RGB.
    Picture(Image),
    /// The text of an SVG file.
    Diagram(String),
}

impl Drawing {
    /// A picture.
    pub fn picture(name: impl Into<String>, alt: impl Into<Words>, image: Image) -> Self {
        Self { name: name.into(), alt: alt.into(), content: Content::Picture(image), handles: Vec::new() }
    }

    /// A diagram or a plot, as SVG.
    pub fn diagram(name: impl Into<String>, alt: impl Into<Words>, svg: String) -> Self {
        Self { name: name.into(), alt: alt.into(), content: Content::Diagram(svg), handles: Vec::new() }
    }

    /// The same with handles.
    #[must_use]
    pub fn with_handles(self, handles: Vec<Handle>) -> Self {
        Self { handles, ..self }
    }

    /// The figure's only drawing, of lines: `svg` gives it, once it knows what to say to somebody who cannot see it.
    pub(crate) fn only(alt: Words, svg: impl FnOnce(&Words) -> String) -> Self {
        let svg = svg(&alt);
        Self::diagram("", alt, svg)
    }

    /// The name of its file: `L31-exponent-strip.png`, `L37-flat-and-gouraud.gouraud.png`.
    #[must_use]
    pub fn file_name(&self, stem: &str) -> String {
        let extension = match self.content {
            Content::Picture(_) => "png",
            Content::Diagram(_) => "svg",
        };
        match self.name.as_str() {
            "" => format!("{stem}.{extension}"),
            name => format!("{stem}.{name}.{extension}"),
        }
    }
}
