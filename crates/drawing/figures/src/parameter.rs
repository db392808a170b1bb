//! What can be changed in a figure, and between which ends?

use crate::figure::{Figure, Text};

/// A number that a figure depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The letter of the slide, or a short word: `p`, `subdivision`.
    pub name: &'static str,
    /// What it is, with its unit.
    pub label: Text,
    /// The lecture's value, or one that shows the point.
    pub default: f32,
    /// The least value.
    pub least: f32,
    /// The greatest value.
    pub greatest: f32,
    /// Whether only whole numbers make sense.
    pub whole: bool,
}

impl Parameter {
    /// Any number from `least` to `greatest`.
    #[must_use]
    pub const fn number(name: &'static str, label: Text, default: f32, least: f32, greatest: f32) -> Self {
        Self { name, label, default, least, greatest, whole: false }
    }

    /// A whole number from `least` to `greatest`.
    #[must_use]
    pub const fn count(name: &'static str, label: Text, default: f32, least: f32, greatest: f32) -> Self {
        Self { name, label, default, least, greatest, whole: true }
    }
}

/// Why a value cannot be set.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// No parameter of this name.
    #[error("{figure} has no parameter {name}; {}", listed(.known))]
    Unknown {
        /// The figure, by its stem.
        figure: String,
        /// The name that was asked for.
        name: String,
        /// The names that there are.
        known: Vec<&'static str>,
    },
    /// Below, above, or not whole where it must be; NaN too.
    #[error("{name} = {value} is out of range: it must be {} from {least} to {greatest}", kind(*.whole))]
    OutOfRange {
        /// The parameter.
        name: &'static str,
        /// The value that was asked for.
        value: f32,
        /// The least value.
        least: f32,
        /// The greatest value.
        greatest: f32,
        /// Whether it must be whole.
        whole: bool,
    },
    /// More pixels than a figure should take, or none.
    #[error(
        "{width} × {height} pixels are no size for a figure: both must be from {} to {}",
        LEAST_SIDE,
        GREATEST_SIDE
    )]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
}

/// Below this nothing can be made out.
pub const LEAST_SIDE: u32 = 16;
/// As wide as the widest projector; figures of several pictures would take minutes beyond.
pub const GREATEST_SIDE: u32 = 4096;

fn kind(whole: bool) -> &'static str {
    if whole { "a whole number" } else { "a number" }
}

fn listed(known: &[&str]) -> String {
    if known.is_empty() { "it has none".to_owned() } else { format!("it has {}", known.join(", ")) }
}

/// A value for each parameter of a figure, and the size of its pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    figure: String,
    size: (u32, u32),
    numbers: Vec<(Parameter, f32)>,
}

impl Values {
    /// The lecture's values.
    #[must_use]
    pub fn of(figure: &Figure) -> Self {
        let numbers = figure.parameters.iter().map(|parameter| (*parameter, parameter.default)).collect();
        Self { figure: figure.stem(), size: figure.size, numbers }
    }

    /// Changes one of them.
    ///
    /// # Errors
    /// [`ParameterError`] if the figure has no such parameter or the value is out of its range.
    pub fn set(&mut self, name: &str, value: f32) -> Result<(), ParameterError> {
        let Some((parameter, number)) = self.numbers.iter_mut().find(|(parameter, _)| parameter.name == name)
        else {
            let known = self.numbers.iter().map(|(parameter, _)| parameter.name).collect();
            return Err(ParameterError::Unknown {
                figure: self.figure.clone(),
                name: name.to_owned(),
                known,
            });
        };
        let Parameter { name, least, greatest, whole, .. } = *parameter;
        if !(least..=greatest).contains(&value) || (whole && value.fract() != 0.0) {
            return Err(ParameterError::OutOfRange { name, value, least, greatest, whole });
        }
        *number = value;
        Ok(())
    }

    /// Changes the size of the pictures, in pixels.
    ///
    /// # Errors
    /// [`ParameterError::Size`] below [`LEAST_SIDE`] and above [`GREATEST_SIDE`].
    pub fn set_size(&mut self, width: u32, height: u32) -> Result<(), ParameterError> {
        let possible = LEAST_SIDE..=GREATEST_SIDE;
        if !possible.contains(&width) || !possible.contains(&height) {
            return Err(ParameterError::Size { width, height });
        }
        self.size = (width, height);
        Ok(())
    }

    /// The value of a parameter.
    ///
    /// # Panics
    /// If the figure has no parameter of this name: a figure asks for its own only.
    #[must_use]
    pub fn number(&self, name: &str) -> f32 {
        let found = self.numbers.iter().find(|(parameter, _)| parameter.name == name);
        found.unwrap_or_else(|| panic!("{} has no parameter {name}", self.figure)).1
    }

    /// The value of a whole parameter that is not negative.
    ///
    /// # Panics
    /// As [`Values::number`].
    #[must_use]
    pub fn count(&self, name: &str) -> u32 {
        self.number(name) as u32
    }

    /// Width and height of each picture in pixels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// All of it in a line, the same for the same values: `640x480 p=64`.
    #[must_use]
    pub fn summary(&self) -> String {
        let (width, height) = self.size;
        let numbers = self.numbers.iter().map(|(parameter, value)| format!(" {}={value}", parameter.name));
        format!("{width}x{height}{}", numbers.collect::<String>())
    }
}
