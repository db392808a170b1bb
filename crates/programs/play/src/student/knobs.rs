//! Where do the figure's parameters stand? Those that a drawing understands move it; it has a value of its own for the others.

use std::cell::RefCell;
use std::collections::BTreeSet;

use figures::{Figure, Values};
use glam::Vec3;

/// A figure and the values of its parameters.
pub(super) struct Knobs<'a> {
    pub(super) figure: &'a Figure,
    values: &'a Values,
    /// The parameters that were asked for.
    read: RefCell<BTreeSet<&'static str>>,
}

impl<'a> Knobs<'a> {
    pub(super) fn new(figure: &'a Figure, values: &'a Values) -> Self {
        Self { figure, values, read: RefCell::default() }
    }

    /// The value of a parameter, if the figure has it.
    pub(super) fn get(&self, name: &str) -> Option<f32> {
        let parameter = self.figure.parameters.iter().find(|parameter| parameter.name == name)?;
        self.read.borrow_mut().insert(parameter.name);
        Some(self.values.number(name))
    }

    /// The figure's parameters that the drawing understands, as far as it has been drawn.
    pub(super) fn read(&self) -> Vec<&'static str> {
        self.read.borrow().iter().copied().collect()
    }

    /// The value of a parameter, or this one.
    pub(super) fn or(&self, name: &str, otherwise: f32) -> f32 {
        self.get(name).unwrap_or(otherwise)
    }

    /// The exponents of the highlights: those of the row of balls, or one. An exercise's exponent is at least 1.
    pub(super) fn exponents(&self) -> Vec<f32> {
        let p = self.or("p", 16.0);
        let factors: &[f32] = match self.figure.name {
            "exponent-strip" => &[1.0 / 64.0, 1.0 / 16.0, 0.25, 1.0, 4.0, 16.0],
            _ => &[1.0],
        };
        factors.iter().map(|factor| (factor * p).max(1.0)).collect()
    }

    /// The angle between the directions to eye and light. Where a figure says both from the normal, positive on opposite sides, it is their sum.
    pub(super) fn angle(&self) -> f32 {
        let degrees = match (self.get("light"), self.get("eye"), self.get("theta")) {
            (Some(light), Some(eye), _) => light + eye,
            (Some(light), None, _) => light,
            (None, _, Some(theta)) => theta,
            _ => 50.0,
        };
        degrees.to_radians()
    }

    /// A lamp that stands free above all spheres of a drawing, as far to a side as the figure says.
    pub(super) fn lamp(&self) -> Vec3 {
        let clamped = |name, otherwise: f32, least: f32| self.or(name, otherwise).clamp(least, 6.0);
        Vec3::new(clamped("x", -2.5, -6.0), clamped("y", 3.0, 2.6), clamped("z", 2.0, -6.0))
    }
}
