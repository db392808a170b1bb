//! Which word stands for which choice? One list of names, for scene files and the command line alike.

use std::fmt;
use std::str::FromStr;

use lighting::Highlight;
use shading::Shading;
use zbuffer::DepthFormat;

/// A choice that has a name in scene files and on the command line.
pub trait Named: Copy + PartialEq + 'static {
    /// What is being chosen, for messages: "renderer", say.
    const WHAT: &'static str;
    /// Every choice with its name, in the order in which a help text should list them.
    const ALL: &'static [(&'static str, Self)];

    /// The name of this choice.
    #[must_use]
    fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, choice)| *choice == self).map_or("?", |(name, _)| *name)
    }
}

/// The choice called `name`. It has the form that clap's `value_parser` takes.
///
/// # Errors
/// [`UnknownName`], which lists the names there are.
///
/// ```
/// use scene::{Renderer, Shading, parse_name};
/// assert_eq!(parse_name::<Renderer>("raytrace"), Ok(Renderer::Raytrace));
/// assert_eq!(
///     parse_name::<Shading>("gourand").unwrap_err().to_string(),
///     "\"gourand\" is no shading: choose flat, gouraud or phong",
/// );
/// ```
pub fn parse_name<T: Named>(name: &str) -> Result<T, UnknownName> {
    let found = T::ALL.iter().find(|(known, _)| *known == name);
    found.map(|(_, choice)| *choice).ok_or_else(|| UnknownName {
        what: T::WHAT,
        name: name.to_owned(),
        known: known_names::<T>(),
    })
}

/// A word that names none of the choices.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("\"{name}\" is no {what}: choose {known}")]
pub struct UnknownName {
    /// What was to be chosen.
    pub what: &'static str,
    /// The word.
    pub name: String,
    /// The names there are, as a sentence lists them.
    pub known: String,
}

fn known_names<T: Named>() -> String {
    let names: Vec<&str> = T::ALL.iter().map(|(name, _)| *name).collect();
    match names.as_slice() {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

/// Which algorithm makes the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Renderer {
    /// Object order with a depth buffer (L16).
    #[default]
    ZBuffer,
    /// Object order from back to front (L13).
    Painter,
    /// Image order: a ray for each pixel (L55).
    Raytrace,
}

/// Which property of the visible surface the picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Show {
    /// Its colour.
    #[default]
    Color,
    /// Its canonical depth: nearer is lighter, black is background.
    Depth,
    /// Its unit normal in world space as 0.5 n + 0.5.
    Normals,
    /// α, β, γ in its triangle as red, green, blue (L48); exact spheres have none and are grey.
    Barycentric,
    /// How many times a colour was computed for the pixel (E16).
    Overdraw,
}

impl Named for Renderer {
    const WHAT: &'static str = "renderer";
    const ALL: &'static [(&'static str, Self)] =
        &[("zbuffer", Self::ZBuffer), ("painter", Self::Painter), ("raytrace", Self::Raytrace)];
}

impl Named for Show {
    const WHAT: &'static str = "kind of picture";
    const ALL: &'static [(&'static str, Self)] = &[
        ("color", Self::Color),
        ("depth", Self::Depth),
        ("normals", Self::Normals),
        ("barycentric", Self::Barycentric),
        ("overdraw", Self::Overdraw),
    ];
}

impl Named for Highlight {
    const WHAT: &'static str = "form of highlight";
    const ALL: &'static [(&'static str, Self)] = &[("blinn", Self::Blinn), ("phong", Self::Phong)];
}

impl Named for DepthFormat {
    const WHAT: &'static str = "number of depth bits";
    const ALL: &'static [(&'static str, Self)] =
        &[("16", Self::Bits16), ("24", Self::Bits24), ("32", Self::F32)];
}

impl Named for Shading {
    const WHAT: &'static str = "shading";
    const ALL: &'static [(&'static str, Self)] =
        &[("flat", Self::Flat), ("gouraud", Self::Gouraud), ("phong", Self::Phong)];
}

impl fmt::Display for Renderer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl fmt::Display for Show {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Renderer {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        parse_name(name)
    }
}

impl FromStr for Show {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        parse_name(name)
    }
}
