//! What is said about one triangle that the ray hit, or nearly hit?

use raytrace::triangle::{Exit, Solution};
use serde_json::{Value as Json, json};
use sheet::Words;
use sheet::text::decimal;

use crate::story::json::{number, words};
use crate::story::subject::Subject;

/// One triangle, or one exact ball, that the ray hit or nearly hit.
pub(super) struct Entry {
    /// Its place in drawing order, from 1.
    pub(super) order: usize,
    pub(super) object: usize,
    pub(super) triangle: Option<usize>,
    pub(super) solution: Solution,
    /// Where the slide's test left.
    pub(super) exit: Option<Exit>,
    /// Whether the watertight test, which decides, hits.
    pub(super) is_hit: bool,
    /// Whether it is the nearest so far.
    pub(super) nearer: bool,
    /// What was nearest before.
    pub(super) before: Option<f32>,
}

/// By how much the barycentric coordinate that misses most misses; not positive inside.
pub(super) fn outside(solution: &Solution) -> f32 {
    let weights = solution.weights().to_vec3();
    -weights.min_element()
}

impl Entry {
    /// The entry as the page shows it.
    pub(super) fn told(&self, subject: &Subject, interval: (f32, f32)) -> Json {
        let name = match self.triangle {
            Some(triangle) => subject.names.triangle(self.object, triangle),
            None => subject.names.object(self.object),
        };
        let Solution { beta, gamma, t } = self.solution;
        let weight = |x: f32| self.triangle.map(|_| number(x));
        let exit = match self.exit {
            None => "hit",
            Some(Exit::Parallel) => "parallel",
            Some(Exit::T) => "t",
            Some(Exit::Gamma) => "gamma",
            Some(Exit::Beta) => "beta",
        };
        json!({
            "order": self.order,
            "object": self.object,
            "triangle": self.triangle,
            "name": words(&name),
            "beta": weight(beta),
            "gamma": weight(gamma),
            "t": number(t),
            "inside": self.is_hit,
            "nearer": self.nearer,
            "exit": exit,
            "words": words(&self.words(interval)),
        })
    }

    fn words(&self, (t0, t1): (f32, f32)) -> Words {
        let Solution { beta, gamma, t } = self.solution;
        let n = |x: f32| decimal(x, 4);
        if !self.is_hit {
            let rule = match self.exit {
                Some(Exit::Gamma) => format!("γ = {} ∉ [0, 1]", n(gamma)),
                Some(_) => format!("β = {} ∉ [0, 1 − γ] = [0, {}]", n(beta), n(1.0 - gamma)),
                None => {
                    return Words::new(
                        "On an edge, to within rounding: the slide's test counts it, the watertight test gives it to the neighbour.",
                        "Op een rand, op afronding na: de test van de slide telt hem mee, de waterdichte test geeft hem aan de buur.",
                    );
                }
            };
            return Words::new(format!("Missed: {rule}."), format!("Gemist: {rule}."));
        }
        let words = match self.before {
            _ if t <= t0 => Words::new(
                format!("Met at t = {} ≤ {}: before the near plane, does not count.", n(t), n(t0)),
                format!("Getroffen bij t = {} ≤ {}: vóór het near-vlak, telt niet.", n(t), n(t0)),
            ),
            _ if t >= t1 => Words::new(
                format!("Met at t = {} ≥ {}: beyond the far plane, does not count.", n(t), n(t1)),
                format!("Getroffen bij t = {} ≥ {}: voorbij het far-vlak, telt niet.", n(t), n(t1)),
            ),
            None => Words::new(
                format!("Hit at t = {}: the first, kept.", n(t)),
                format!("Geraakt bij t = {}: de eerste, onthouden.", n(t)),
            ),
            Some(before) if self.nearer => Words::new(
                format!("Hit at t = {} < {}: nearer, kept.", n(t), n(before)),
                format!("Geraakt bij t = {} < {}: dichterbij, onthouden.", n(t), n(before)),
            ),
            Some(before) => Words::new(
                format!("Hit at t = {} ≥ {}: not nearer.", n(t), n(before)),
                format!("Geraakt bij t = {} ≥ {}: niet dichterbij.", n(t), n(before)),
            ),
        };
        match self.exit {
            Some(Exit::Gamma | Exit::Beta) => Words::new(
                words.en + " The slide's test, in 32 bits, misses it by rounding.",
                words.nl + " De test van de slide, in 32 bits, mist hem door afronding.",
            ),
            _ => words,
        }
    }
}
