//! Places the names of arrows so that they do not overlap: names that would overlap push each other apart.

use glam::{Vec2, vec2};

use crate::{Ink, LETTER, Letters, Pen, Sheet, Side, Text};

/// An arrow with a name.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Where it points.
    pub tip: Vec2,
    /// What it is called.
    pub name: Text,
    /// The colour of its name.
    pub ink: Ink,
    /// The line it is drawn with.
    pub pen: Pen,
}

impl Vector {
    /// In one colour.
    pub fn new(name: &'static str, tip: Vec2, ink: Ink) -> Self {
        Self { tip, name: Text { en: name, nl: name }, ink, pen: ink.pen().wide() }
    }

    /// With a name in each language.
    pub fn called(self, en: &'static str, nl: &'static str) -> Self {
        Self { name: Text { en, nl }, ..self }
    }

    /// Less important: thin and broken.
    pub fn dashed(self) -> Self {
        Self { pen: self.ink.pen().dashed(), ..self }
    }
}

/// An angle narrower than this, in radians, has no room for its mark; the number stands in the margin.
const NARROW: f32 = 0.035;
/// Nor for its letter.
const NO_ROOM: f32 = 0.13;

impl Sheet {
    /// Arrows from one point, each with its name behind its tip.
    pub fn vectors(&mut self, from: Vec2, vectors: &[Vector]) {
        let names: Vec<_> = vectors
            .iter()
            .map(|vector| {
                let away = (vector.tip - from).try_normalize().unwrap_or(Vec2::Y);
                // Half the name's width or height, whichever edge of its box the arrow meets, and a little air.
                let half = vec2(5.0 * letters(vector.name), 7.0) / away.abs().max(Vec2::splat(0.01));
                let gap = 7.0 + half.min_element();
                (vector.tip + self.units(gap) * away, vector.name, vector.ink)
            })
            .collect();
        for vector in vectors {
            self.arrow(from, vector.tip, vector.pen);
        }
        self.texts(&names);
    }

    /// Bold names around their places, pushed apart where they would overlap.
    pub fn names(&mut self, names: &[(Vec2, &'static str, Ink)]) {
        let texts: Vec<_> =
            names.iter().map(|&(p, name, ink)| (p, Text { en: name, nl: name }, ink)).collect();
        self.texts(&texts);
    }

    fn texts(&mut self, names: &[(Vec2, Text, Ink)]) {
        let mut places: Vec<Vec2> = names.iter().map(|name| name.0).collect();
        let half =
            |k: usize| self.units(1.0) * vec2(0.32 * LETTER * letters(names[k].1) + 3.0, 0.55 * LETTER);
        push_apart(&mut places, &(0..names.len()).map(half).collect::<Vec<_>>());
        for ((_, name, ink), place) in names.iter().zip(places) {
            self.label(place, Side::Middle, *name, Letters::Vector, *ink);
        }
    }

    /// The mark of the angle between two directions, with its letter.
    pub fn angle(&mut self, at: Vec2, radius: f32, [from, to]: [Vec2; 2], name: &'static str, ink: Ink) {
        let width = from.angle_to(to);
        if width.abs() > NARROW {
            self.arc(at, radius, from, to, ink.pen());
        }
        if width.abs() > NO_ROOM {
            let middle = Vec2::from_angle(from.to_angle() + 0.5 * width);
            let place = at + (radius + self.units(13.0)) * middle;
            self.label(place, Side::Middle, name, Letters::Scalar, ink);
        }
    }
}

/// The letters of the longer of the two names.
fn letters(name: Text) -> f32 {
    name.en.chars().count().max(name.nl.chars().count()) as f32
}

/// Moves boxes, given by centre and half size, until none overlap: each pair along the axis where less is missing.
fn push_apart(places: &mut [Vec2], halves: &[Vec2]) {
    /// More than a handful of names need; crowds that take longer stay a little crowded.
    const ROUNDS: usize = 60;
    for _ in 0..ROUNDS {
        for i in 0..places.len() {
            for k in i + 1..places.len() {
                let way = places[k] - places[i];
                let missing = halves[i] + halves[k] - way.abs();
                if missing.min_element() <= 0.0 {
                    continue;
                }
                let push = if missing.x < missing.y {
                    vec2(missing.x.copysign(way.x), 0.0)
                } else {
                    vec2(0.0, missing.y.copysign(way.y))
                };
                places[i] -= 0.5 * push;
                places[k] += 0.5 * push;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_on_one_place_end_up_side_by_side() {
        let mut places = [vec2(1.0, 2.0), vec2(1.0, 2.0), vec2(1.5, 2.25), vec2(9.0, 9.0)];
        let halves = [vec2(1.0, 0.5), vec2(2.0, 0.5), vec2(1.0, 0.5), Vec2::ONE];
        push_apart(&mut places, &halves);
        for (i, k) in [(0, 1), (0, 2), (1, 2)] {
            let missing = halves[i] + halves[k] - (places[k] - places[i]).abs();
            // Pushes halve what is missing, so the end is reached but for rounding.
            assert!(missing.min_element() < 1e-3, "{i} and {k}: {missing}");
        }
        assert_eq!(places[3], vec2(9.0, 9.0)); // nobody was near
    }
}
