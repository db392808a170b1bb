//! Eye, window, ray, hits and shadow rays, over the picture from outside and by its own pipeline.

use glam::{Vec2, Vec3, vec2};
use raytrace::viewing_ray;
use sheet::text::decimal;
use sheet::{Ink, Letters, Sheet, Side, Words};
use transforms::Pipeline;

use super::place::{end_of_ray, ends_of_shadow_rays, room, t_of_window, window};
use crate::story::light::OnHit;
use crate::story::rays::Cast;
use crate::story::subject::Subject;

/// How much of the picture's colour stays under the lines.
const PALE: f32 = 0.62;

/// The height of small letters in pixels.
const LETTERS: f32 = 15.0;

/// Lines over a picture, in its pixels.
struct Overlay<'a> {
    sheet: Sheet,
    pipeline: &'a Pipeline,
}

/// The drawing over `picture`, which `outside` made.
pub(super) fn drawn(
    subject: &Subject,
    cast: &Cast,
    light: &OnHit,
    outside: &Pipeline,
    picture: &str,
) -> Sheet {
    let (width, height) = (outside.width() as f32, outside.height() as f32);
    let half = Vec2::splat(0.5);
    let mut sheet = Sheet::new(-half, vec2(width, height) - half, width);
    sheet.picture(picture, PALE);
    let mut overlay = Overlay { sheet, pipeline: outside };
    overlay.window(subject, cast);
    overlay.ray(subject, cast);
    overlay.shadows(subject, cast, light);
    overlay.normal(subject, cast);
    overlay.names(subject, cast);
    overlay.sheet
}

impl Overlay<'_> {
    /// Where a point of the world lands; nothing behind the eye outside.
    fn at(&self, p: Vec3) -> Option<Vec2> {
        let traced = self.pipeline.trace(p);
        traced.screen.filter(|_| traced.clip.w < 0.0).map(Vec3::truncate)
    }

    fn corners(&self, points: &[Vec3]) -> Option<Vec<Vec2>> {
        points.iter().map(|p| self.at(*p)).collect()
    }

    /// The window of the picture, with lines from the eye to its corners, and the pixel in it.
    fn window(&mut self, subject: &Subject, cast: &Cast) {
        let t = t_of_window(subject, cast);
        let corners = window(&subject.pipeline, t);
        let (Some(eye), Some(outline)) = (self.at(subject.pipeline.camera().eye()), self.corners(&corners))
        else {
            return;
        };
        for corner in &outline {
            self.sheet.line(eye, *corner, Ink::Faint.pen().fine());
        }
        self.sheet.wash(&outline, Ink::B);
        self.sheet.polygon(&outline, Ink::B.pen());
        let lowest = outline.iter().copied().min_by(|a, b| a.y.total_cmp(&b.y));
        if let (Some(lowest), true) = (lowest, t > 1.0) {
            let t = decimal(t, 1);
            let words = Words::new(
                format!("the window, drawn at t = {t} instead of 1"),
                format!("het venster, getekend bij t = {t} in plaats van 1"),
            );
            self.sheet.label_sized(lowest, Side::Below, words, Letters::Plain, Ink::B, LETTERS);
        }
        // A pixel alone would be too small to see: as large as a fortieth of the window.
        let half = (subject.pipeline.width().max(subject.pipeline.height()) as f32 / 80.0).max(0.5);
        let (i, j) = (subject.i as f32, subject.j as f32);
        let around = [(-half, -half), (half, -half), (half, half), (-half, half)]
            .map(|(x, y)| viewing_ray(&subject.pipeline, i + x, j + y).at(t));
        if let Some(around) = self.corners(&around) {
            self.sheet.wash(&around, Ink::A);
            self.sheet.polygon(&around, Ink::A.pen().fine());
        }
    }

    /// The viewing ray to its hit, and broken beyond, where it went on through what it hit.
    fn ray(&mut self, subject: &Subject, cast: &Cast) {
        let (start, end) = (cast.ray.origin, end_of_ray(subject, cast));
        let (Some(a), Some(b)) = (self.at(start), self.at(end)) else { return };
        let last = cast.met.iter().map(|met| met.t).filter(|t| *t < cast.interval.1).fold(0.0, f32::max);
        if let (Some(hit), Some(beyond)) = (&cast.hit, self.at(cast.ray.at(last)))
            && last > hit.t
        {
            self.sheet.line(b, beyond, Ink::A.pen().dashed());
        }
        if cast.hit.is_some() {
            self.sheet.line(a, b, Ink::A.pen().wide());
        } else {
            self.sheet.arrow(a, b, Ink::A.pen().wide());
        }
        for met in cast.met.iter().filter(|met| 0.0 < met.t && met.t < cast.interval.1) {
            if let Some(p) = self.at(cast.ray.at(met.t)) {
                self.sheet.speck(p, Ink::A);
            }
        }
    }

    /// Solid to a light that arrives, broken to what stops it.
    fn shadows(&mut self, subject: &Subject, cast: &Cast, light: &OnHit) {
        let ends = ends_of_shadow_rays(light, room(subject, cast));
        let mut labels: Vec<Vec2> = Vec::new();
        for (shadow, end) in light.shadows.iter().zip(ends) {
            let (Some(a), Some(b)) = (self.at(shadow.ray.origin), self.at(end)) else { continue };
            if shadow.is_lit() {
                self.sheet.arrow(a, b, Ink::C.pen());
            } else {
                self.sheet.arrow(a, b, Ink::D.pen().dashed());
            }
            let number: String = shadow.light.en.chars().filter(char::is_ascii_digit).collect();
            let (words, ink) = if shadow.is_lit() {
                (Words::new(format!("light {number}: free"), format!("licht {number}: vrij")), Ink::C)
            } else {
                (Words::new(format!("light {number}: stopped"), format!("licht {number}: gestuit")), Ink::D)
            };
            let side = if b.x < a.x { Side::Left } else { Side::Right };
            // Labels that would lie over each other stand under each other.
            let lies_over = |place: Vec2, other: &Vec2| {
                let apart = (place - *other).abs();
                apart.x < 8.0 * LETTERS && apart.y < 1.2 * LETTERS
            };
            let mut place = b;
            while labels.iter().any(|other| lies_over(place, other)) {
                place.y -= 0.5 * LETTERS;
            }
            labels.push(place);
            self.sheet.label_sized(place, side, words, Letters::Plain, ink, LETTERS);
        }
    }

    fn normal(&mut self, subject: &Subject, cast: &Cast) {
        let Some(hit) = &cast.hit else { return };
        let n = hit.normal_towards(&cast.ray);
        let tip = hit.point + 0.1 * room(subject, cast) * n;
        if let (Some(a), Some(b)) = (self.at(hit.point), self.at(tip)) {
            self.sheet.arrow(a, b, Ink::Main.pen());
            self.sheet.label_sized(b, Side::Above, "n", Letters::Vector, Ink::Main, LETTERS);
        }
    }

    fn names(&mut self, subject: &Subject, cast: &Cast) {
        let mut names = vec![(cast.ray.origin, "e", Side::Above)];
        if t_of_window(subject, cast) == 1.0 {
            names.push((cast.ray.at(1.0), "s", Side::Above));
        }
        if cast.hit.is_some() {
            names.push((end_of_ray(subject, cast), "p", Side::BelowRight));
        }
        for (p, name, side) in names {
            if let Some(p) = self.at(p) {
                self.sheet.dot(p, Ink::A);
                self.sheet.label(p, side, name, Letters::Vector, Ink::Main);
            }
        }
    }
}
