//! Shaded triangles, and normals that stand on them.

use glam::{Vec2, Vec3, vec2};
use sheet::label_layout::Vector;
use sheet::{Ink, Letters, Sheet, Side, Words};
use vocabulary::{Barycentric, Triangle};
use worker::{Plain, Value};

use crate::exercise::{Picture, Seen};
use crate::panels::{self, Subject};

/// The corners of the triangle that is shaded, in the square [−1, 1]².
const CORNERS: [Vec2; 3] = [vec2(-0.9, -0.8), vec2(0.9, -0.8), vec2(0.0, 0.9)];

/// A triangle, each of its points asked with its own weights: gouraud and phong_shading, whose weights are the last argument.
pub(super) fn shaded(seen: &Seen<'_>) -> Option<Picture> {
    let (last, others) = seen.arguments.split_last()?;
    let at = <Barycentric as Plain>::from_value(last.clone())?;
    let question = |place: Vec2| {
        let weights = weights(place)?;
        Some(others.iter().cloned().chain([weights.into_value()]).collect::<Vec<Value>>())
    };
    let [a, b, c] = CORNERS;
    let p = at.alpha * a + at.beta * b + at.gamma * c;
    // Two letters on one place read as a third.
    let corners = [(a, "a"), (b, "b"), (c, "c")].into_iter().filter(|corner| corner.0.distance(p) > 0.2);
    let marks: Vec<(Vec2, &str)> = std::iter::once((p, "p")).chain(corners).collect();
    let name = Words::new("a triangle with these normals", "een driehoek met deze normalen");
    panels::draw(seen, &Subject { question: &question, marks: &marks, name })
}

/// Where in the triangle a place of the square lies, if it lies in it.
fn weights(place: Vec2) -> Option<Barycentric> {
    let [a, b, c] = CORNERS;
    let whole = (b - a).perp_dot(c - a);
    let beta = (place - a).perp_dot(c - a) / whole;
    let gamma = (b - a).perp_dot(place - a) / whole;
    let alpha = 1.0 - beta - gamma;
    (alpha >= 0.0 && beta >= 0.0 && gamma >= 0.0).then_some(Barycentric { alpha, beta, gamma })
}

/// The triangle with the right normal and yours.
pub(super) fn face_normal(seen: &Seen<'_>) -> Option<Picture> {
    let Triangle { a, b, c } = seen.argument(0)?;
    let right = seen.right_as::<Option<Vec3>>()?;
    let yours = seen.given_as::<Option<Vec3>>().flatten();
    let middle = (a + b + c) / 3.0;
    let mesh = Normals {
        positions: &[a, b, c],
        triangles: &[[0, 1, 2]],
        names: &["a", "b", "c"],
        right: right.map(|n| (middle, n)).into_iter().collect(),
        yours: yours.map(|n| (middle, n)).into_iter().collect(),
        up: right.unwrap_or(Vec3::Z),
        name: Words::new("the triangle and its normal", "de driehoek en zijn normaal"),
    };
    mesh.picture()
}

/// The mesh with the right normals and yours.
pub(super) fn vertex_normals(seen: &Seen<'_>) -> Option<Picture> {
    let positions = seen.argument::<Vec<Vec3>>(0)?;
    let triangles = seen.argument::<Vec<[usize; 3]>>(1)?;
    let right = seen.right_as::<Vec<Vec3>>()?;
    let yours = seen.given_as::<Vec<Vec3>>().unwrap_or_default();
    let standing = |normals: &[Vec3]| positions.iter().copied().zip(normals.iter().copied()).collect();
    let mesh = Normals {
        positions: &positions,
        triangles: &triangles,
        names: &["0", "1", "2", "3", "4", "5", "6", "7"],
        right: standing(&right),
        yours: standing(&yours),
        up: right.iter().sum(),
        name: Words::new("the mesh and its vertex normals", "het net en zijn hoekpuntnormalen"),
    };
    mesh.picture()
}

/// Triangles in space with normals on them.
struct Normals<'a> {
    positions: &'a [Vec3],
    triangles: &'a [[usize; 3]],
    names: &'a [&'static str],
    /// Where each stands, and the normal.
    right: Vec<(Vec3, Vec3)>,
    yours: Vec<(Vec3, Vec3)>,
    /// A direction that should point upwards on the sheet.
    up: Vec3,
    name: Words,
}

impl Normals<'_> {
    /// A normal of yours is drawn as long as it is, up to this many times the length of a right one.
    const TOO_LONG: f32 = 3.0;

    fn picture(&self) -> Option<Picture> {
        let up = self.up.try_normalize().unwrap_or(Vec3::Z);
        let along = self.positions.get(1)? - self.positions.first()?;
        let u = (along - up.dot(along) * up).try_normalize().unwrap_or_else(|| up.any_orthonormal_vector());
        // From the side and from above: what points up stays long, and the triangles are seen.
        let v = (up + 0.6 * up.cross(u)).normalize();
        let flat = |p: Vec3| vec2(p.dot(u), p.dot(v));
        let corners: Vec<Vec2> = self.positions.iter().map(|p| flat(*p)).collect();
        let least = corners.iter().copied().reduce(Vec2::min)?;
        let greatest = corners.iter().copied().reduce(Vec2::max)?;
        // A unit normal is as long as a third of the mesh.
        let unit = ((greatest - least).max_element() / 3.0).max(0.25);
        let tip = |(foot, n): &(Vec3, Vec3)| {
            let drawable = n.is_finite() && *n != Vec3::ZERO && n.length() <= Self::TOO_LONG;
            drawable.then(|| (flat(*foot), flat(*foot + unit * *n)))
        };
        let right: Vec<(Vec2, Vec2)> = self.right.iter().filter_map(tip).collect();
        let yours: Vec<(Vec2, Vec2)> = self.yours.iter().filter_map(tip).collect();

        let tips = right.iter().chain(&yours).map(|arrow| arrow.1);
        // Room for the words at the top.
        let top = vec2(greatest.x, greatest.y + 1.7 * unit);
        let points: Vec<Vec2> = corners.iter().copied().chain(tips).chain([top]).collect();
        let mut sheet = Sheet::around(&points, vec2(620.0, 460.0), 64.0, 0.0);
        for triangle in self.triangles {
            let triangle: Option<Vec<Vec2>> = triangle.iter().map(|k| corners.get(*k).copied()).collect();
            let triangle = triangle?;
            sheet.wash(&triangle, Ink::B);
            sheet.polygon(&triangle, Ink::B.pen());
        }
        self.put_names(&mut sheet, &corners);
        for (arrows, name, dutch, ink) in
            [(&right, "right", "goed", Ink::C), (&yours, "yours", "van jou", Ink::A)]
        {
            for (k, (foot, tip)) in arrows.iter().enumerate() {
                if k == 0 {
                    sheet.vectors(*foot, &[Vector::new(name, *tip, ink).called(name, dutch)]);
                } else {
                    sheet.arrow(*foot, *tip, ink.pen());
                }
            }
        }
        sheet.lines(4.0, 20.0, self.words(right.len(), yours.len()));
        let alt = Words::new(
            format!("{}: the right ones and yours as arrows", self.name.en),
            format!("{}: de goede en die van jou als pijlen", self.name.nl),
        );
        Some(Picture { svg: sheet.svg(&alt), text: None })
    }

    fn put_names(&self, sheet: &mut Sheet, corners: &[Vec2]) {
        for (corner, name) in corners.iter().zip(self.names) {
            sheet.dot(*corner, Ink::Main);
            sheet.label(*corner, Side::Below, *name, Letters::Vector, Ink::Main);
        }
    }

    fn words(&self, right: usize, yours: usize) -> [Words; 2] {
        let count = Words::new(
            format!("normals that can be drawn: right {right}, yours {yours}"),
            format!("normalen die te tekenen zijn: goed {right}, van jou {yours}"),
        );
        [self.name.clone(), count]
    }
}
