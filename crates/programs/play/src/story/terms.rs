//! Which part of the colour comes from which light, and from which term of the lighting equation (L32, L34)?
//!
//! Each term is asked of the lighting model itself: once without a highlight, once without diffuse light.

use canvas::Rgb;
use lighting::{Highlight, Illumination, Light, Material, SurfacePoint, halfway, lit, reflect};
use serde_json::{Value as Json, json};
use sheet::Words;
use sheet::text::decimal;

use super::json::{number, triple, vector, words};
use super::subject::{Weighted, name_of_light};

/// All that the colour of a point is made of.
pub(super) struct Lit<'a> {
    /// The point that is seen.
    pub(super) place: SurfacePoint,
    /// How its surface is shaded.
    pub(super) mode: Words,
    /// Where the lighting model is evaluated: at one point, or at three corners.
    pub(super) points: &'a [Weighted],
    pub(super) material: &'a Material,
    pub(super) lights: &'a [Light],
    pub(super) highlight: Highlight,
    /// What of each light arrives.
    pub(super) shares: &'a [Rgb],
}

/// One term of the lighting equation.
struct Term {
    name: Words,
    formula: String,
    numbers: String,
    value: Rgb,
}

impl Term {
    fn json(&self) -> Json {
        json!({
            "name": words(&self.name),
            "formula": self.formula,
            "numbers": words(&self.numbers.as_str().into()),
            "value": vector(self.value),
        })
    }
}

impl Lit<'_> {
    /// The terms as the page shows them, and their sum.
    pub(super) fn told(&self) -> (Json, Rgb) {
        let (terms, corners) = match self.points {
            [(at, _)] => (self.terms(at), Vec::new()),
            corners => self.between(corners),
        };
        let sum = sum(&terms);
        let Material { diffuse, specular, exponent } = *self.material;
        let told = json!({
            "point": vector(self.place.p_world),
            "normal": vector(self.place.n),
            "to_eye": vector(self.place.to_eye),
            "mode": words(&self.mode),
            "material": {
                "diffuse": vector(diffuse),
                "specular": vector(specular),
                "exponent": number(exponent),
            },
            "corners": corners,
            "terms": terms.iter().map(Term::json).collect::<Vec<_>>(),
            "sum": vector(sum),
        });
        (told, sum)
    }

    /// The terms at one point.
    fn terms(&self, at: &SurfacePoint) -> Vec<Term> {
        let mut terms = vec![self.ambient(at)];
        for (k, light) in self.lights.iter().enumerate() {
            if let Some(arriving) = light.illumination(at.p_world) {
                let share = self.shares.get(k).copied().unwrap_or(Rgb::ONE);
                let arriving = Arriving { name: name_of_light(k, light), light, arriving, share };
                terms.push(self.diffuse(at, &arriving));
                terms.push(self.specular(at, &arriving));
            }
        }
        terms
    }

    fn ambient(&self, at: &SurfacePoint) -> Term {
        let only: Vec<Light> =
            self.lights.iter().filter(|light| matches!(light, Light::Ambient { .. })).copied().collect();
        Term {
            name: Words::new("ambient light", "omgevingslicht"),
            formula: "c_r c_a".to_owned(),
            numbers: format!(
                "{} · {}",
                triple(self.material.diffuse),
                triple(lighting::light::ambient(self.lights))
            ),
            value: lit(self.material, &only, self.highlight, at, |_| true),
        }
    }

    fn diffuse(&self, at: &SurfacePoint, from: &Arriving<'_>) -> Term {
        let matt = Material { specular: Rgb::ZERO, ..*self.material };
        Term {
            name: Words::new(format!("{}: diffuse", from.name.en), format!("{}: diffuus", from.name.nl)),
            formula: from.formula("c_r c_l max(0, n·l)"),
            numbers: format!(
                "{}{} · {} · max(0, {})",
                from.factor(),
                triple(self.material.diffuse),
                triple(from.arriving.color),
                decimal(at.n.dot(from.arriving.to_light), 3)
            ),
            value: self.value(&matt, at, from),
        }
    }

    fn specular(&self, at: &SurfacePoint, from: &Arriving<'_>) -> Term {
        let black = Material { diffuse: Rgb::ZERO, ..*self.material };
        let to_light = from.arriving.to_light;
        let (cosine, formula) = match self.highlight {
            Highlight::Phong => (at.to_eye.dot(reflect(at.n, to_light)), "c_s c_l max(0, e·r)^p"),
            Highlight::Blinn => {
                (halfway(at.to_eye, to_light).map_or(0.0, |h| h.dot(at.n)), "c_s c_l max(0, h·n)^p")
            }
        };
        // The gate of the lighting model: no highlight on the side that is turned away.
        let gate = if at.n.dot(to_light) > 0.0 { "" } else { "0 · " };
        Term {
            name: Words::new(format!("{}: highlight", from.name.en), format!("{}: glansplek", from.name.nl)),
            formula: from.formula(formula),
            numbers: format!(
                "{}{gate}{} · {} · max(0, {})^{}",
                from.factor(),
                triple(self.material.specular),
                triple(from.arriving.color),
                decimal(cosine, 4),
                self.material.exponent
            ),
            value: self.value(&black, at, from),
        }
    }

    /// What the lighting model makes of one light on this material.
    fn value(&self, material: &Material, at: &SurfacePoint, from: &Arriving<'_>) -> Rgb {
        from.share * lit(material, std::slice::from_ref(from.light), self.highlight, at, |_| true)
    }

    /// Gouraud shading: the colours of the corners, and how much each counts.
    fn between(&self, corners: &[Weighted]) -> (Vec<Term>, Vec<Json>) {
        const NAMES: [(&str, &str); 3] = [("α c₀", "c₀"), ("β c₁", "c₁"), ("γ c₂", "c₂")];
        let corner = |((at, weight), (formula, name)): (&Weighted, (&str, &str))| {
            let terms = self.terms(at);
            let color = sum(&terms);
            let told = json!({
                "name": name,
                "weight": number(*weight),
                "point": vector(at.p_world),
                "normal": vector(at.n),
                "color": vector(color),
                "terms": terms.iter().map(Term::json).collect::<Vec<_>>(),
            });
            let term = Term {
                name: Words::new(
                    format!("colour of the corner, {name}"),
                    format!("kleur van het hoekpunt, {name}"),
                ),
                formula: formula.to_owned(),
                numbers: format!("{} · {}", decimal(*weight, 3), triple(color)),
                value: color * *weight,
            };
            (term, told)
        };
        corners.iter().zip(NAMES).map(corner).unzip()
    }
}

/// Light that arrives at a point, and what of it nothing stops.
struct Arriving<'a> {
    name: Words,
    light: &'a Light,
    arriving: Illumination,
    share: Rgb,
}

impl Arriving<'_> {
    fn is_whole(&self) -> bool {
        self.share == Rgb::ONE
    }

    /// The formula of a term, with s for the share where not all arrives.
    fn formula(&self, whole: &str) -> String {
        if self.is_whole() { whole.to_owned() } else { format!("s {whole}") }
    }

    /// The share as it stands before the other factors.
    fn factor(&self) -> String {
        if self.is_whole() { String::new() } else { format!("{} · ", triple(self.share)) }
    }
}

fn sum(terms: &[Term]) -> Rgb {
    terms.iter().fold(Rgb::ZERO, |sum, term| sum + term.value)
}
