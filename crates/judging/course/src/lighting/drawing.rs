//! Balls in a counterexample's light, and directions as arrows.

use glam::{Vec2, Vec3, vec2};
use sheet::label_layout::Vector;
use sheet::{Ink, Sheet, Words};
use vocabulary::SurfacePoint;
use worker::{Plain, Value};

use crate::exercise::{Picture, Seen};
use crate::panels::{self, Subject};

/// A ball in the light of a counterexample of [`super::lambert`].
pub(super) fn lambert(seen: &Seen<'_>) -> Option<Picture> {
    let (n, l) = (direction(seen, 2)?, direction(seen, 3)?);
    ball(seen, n, l, beside(n, l), |n| with(seen, 2, n))
}

/// A ball in the light of a counterexample of [`super::ambient_and_diffuse`].
pub(super) fn ambient_and_diffuse(seen: &Seen<'_>) -> Option<Picture> {
    let (n, l) = (direction(seen, 3)?, direction(seen, 4)?);
    ball(seen, n, l, beside(n, l), |n| with(seen, 3, n))
}

/// A ball with the highlight of a counterexample of [`super::phong_highlight`], seen from its eye.
pub(super) fn phong_highlight(seen: &Seen<'_>) -> Option<Picture> {
    ball(seen, direction(seen, 2)?, direction(seen, 3)?, direction(seen, 4)?, |n| with(seen, 2, n))
}

/// A ball in the light of a counterexample of [`super::blinn_phong`], seen from its eye.
pub(super) fn blinn_phong(seen: &Seen<'_>) -> Option<Picture> {
    ball(seen, direction(seen, 3)?, direction(seen, 4)?, direction(seen, 5)?, |n| with(seen, 3, n))
}

/// A ball in all lights of a counterexample of [`super::light_all`], seen from its eye.
pub(super) fn light_all(seen: &Seen<'_>) -> Option<Picture> {
    let at = seen.argument::<SurfacePoint>(3)?;
    ball(seen, at.n, Vec3::ZERO, at.to_eye, |n| with(seen, 3, SurfacePoint { n, ..at }))
}

/// The mirror from the side: n, l, the right r and yours.
pub(super) fn reflection(seen: &Seen<'_>) -> Option<Picture> {
    let (n, l) = (direction(seen, 0)?, direction(seen, 1)?);
    let right = seen.right_as::<Vec3>()?;
    let across = (l - n.dot(l) * n).try_normalize().unwrap_or_else(|| n.any_orthonormal_vector());
    let arrows = Arrows {
        frame: [across, n],
        known: &[("n", n), ("l", l)],
        right: Some(("r", right)),
        yours: seen.given_as::<Vec3>(),
        on_a_surface: true,
        name: Words::new("the mirror from the side", "de spiegel van opzij"),
    };
    Some(arrows.picture())
}

/// The plane of e and l: both, the right h if there is one, and yours.
pub(super) fn halfway(seen: &Seen<'_>) -> Option<Picture> {
    let (e, l) = (direction(seen, 0)?, direction(seen, 1)?);
    let right = seen.right_as::<Option<Vec3>>()?;
    let across = (l - e).try_normalize().unwrap_or_else(|| e.any_orthonormal_vector());
    let up = right.unwrap_or_else(|| across.any_orthonormal_vector());
    let arrows = Arrows {
        frame: [across, up],
        known: &[("e", e), ("l", l)],
        right: right.map(|h| ("h", h)),
        yours: seen.given_as::<Option<Vec3>>().flatten(),
        on_a_surface: false,
        name: Words::new("the plane of e and l", "het vlak van e en l"),
    };
    Some(arrows.picture())
}

fn direction(seen: &Seen<'_>, at: usize) -> Option<Vec3> {
    seen.argument::<Vec3>(at)
}

/// The counterexample's arguments, one of them another.
fn with(seen: &Seen<'_>, at: usize, argument: impl Plain) -> Vec<Value> {
    let mut arguments = seen.arguments.to_vec();
    arguments[at] = argument.into_value();
    arguments
}

/// A direction from which n is seen, and l as well where they are not opposite.
fn beside(n: Vec3, l: Vec3) -> Vec3 {
    n + 0.5 * l + 0.6 * n.any_orthonormal_vector()
}

/// A ball seen from the direction `from`, each of its points asked with its own normal; n and l are marked where they face us.
fn ball(
    seen: &Seen<'_>,
    n: Vec3,
    l: Vec3,
    from: Vec3,
    arguments: impl Fn(Vec3) -> Vec<Value>,
) -> Option<Picture> {
    let w = from.try_normalize()?;
    let (u, v) = w.any_orthonormal_pair();
    let question = |place: Vec2| {
        let depth = 1.0 - place.length_squared();
        (depth > 0.0).then(|| arguments((place.x * u + place.y * v + depth.sqrt() * w).normalize()))
    };
    let mut marks = vec![(vec2(n.dot(u), n.dot(v)), "n")];
    let light = vec2(l.dot(u), l.dot(v));
    // Two letters on one place read as a third.
    marks.extend((l.dot(w) > 0.0 && light.distance(marks[0].0) > 0.2).then_some((light, "l")));
    let name = Words::new("a ball in this light", "een bol in dit licht");
    panels::draw(seen, &Subject { question: &question, marks: &marks, name })
}

/// Directions from one point, in the plane of two axes.
struct Arrows<'a> {
    /// To the right and upwards.
    frame: [Vec3; 2],
    known: &'a [(&'static str, Vec3)],
    right: Option<(&'static str, Vec3)>,
    yours: Option<Vec3>,
    on_a_surface: bool,
    name: Words,
}

impl Arrows<'_> {
    /// An arrow of yours that is this many times longer than the longest of the others is left out.
    const TOO_LONG: f32 = 3.0;

    fn picture(&self) -> Picture {
        let flat = |v: Vec3| vec2(v.dot(self.frame[0]), v.dot(self.frame[1]));
        let mut vectors: Vec<Vector> =
            self.known.iter().map(|(name, v)| Vector::new(name, flat(*v), Ink::Main)).collect();
        vectors.extend(self.right.map(|(name, v)| Vector::new(name, flat(v), Ink::C).called(name, name)));
        let longest = vectors.iter().map(|v| v.tip.length()).fold(0.0, f32::max);
        let drawable = |v: &Vec3| v.is_finite() && v.length() <= Self::TOO_LONG * longest;
        let yours = self.yours.filter(drawable);
        vectors.extend(yours.map(|v| Vector::new("yours", flat(v), Ink::A).called("yours", "van jou")));

        let mut points: Vec<Vec2> = vectors.iter().map(|v| v.tip).collect();
        points.extend([Vec2::ZERO, vec2(-longest, 0.0), vec2(longest, 0.0)]);
        let mut sheet = Sheet::around(&points, vec2(560.0, 400.0), 64.0, 0.0);
        if self.on_a_surface {
            sheet.surface(vec2(-longest, 0.0), vec2(longest, 0.0));
        }
        sheet.vectors(Vec2::ZERO, &vectors);
        sheet.lines(4.0, 20.0, self.words(yours));
        let (right, alt) = (self.right.map_or("None", |(name, _)| name), &self.name);
        let alt = Words::new(
            format!("{}: the right answer {right} and yours as arrows", alt.en),
            format!("{}: het goede antwoord {right} en dat van jou als pijlen", alt.nl),
        );
        Picture { svg: sheet.svg(&alt), text: None }
    }

    fn words(&self, drawn: Option<Vec3>) -> Vec<Words> {
        let mut words = vec![self.name.clone()];
        if self.right.is_none() {
            words.push(Words::new("right: None, nothing lies between", "goed: None, er ligt niets tussen"));
        }
        let normal = self.frame[0].cross(self.frame[1]);
        words.extend(match (drawn, self.yours) {
            (None, Some(_)) => Some(Words::new("yours cannot be drawn", "die van jou is niet te tekenen")),
            (None, None) => Some(Words::new("yours: no direction", "van jou: geen richting")),
            (Some(v), _) if v.dot(normal).abs() > 0.01 => {
                Some(Words::new("yours leaves this plane", "die van jou verlaat dit vlak"))
            }
            (Some(_), _) => None,
        });
        words
    }
}
