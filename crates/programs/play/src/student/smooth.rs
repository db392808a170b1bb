//! How does a shading function look? As a ball of few triangles, where each way to shade shows what it does.

use std::collections::BTreeMap;

use canvas::Rgb;
use course::{Value, arguments};
use geometry::shapes;
use glam::{Vec2, Vec3, vec3};
use vocabulary::{Barycentric, Material, Triangle};

use super::knobs::Knobs;
use super::light::direction;
use super::panel::{Dot, Panel, dot};

/// Pixels along each side of a ball.
const SIDE: u32 = 60;

const C_R: Vec3 = vec3(0.75, 0.4, 0.2);
const C_A: Vec3 = vec3(0.2, 0.22, 0.3);
const C_L: Vec3 = vec3(1.2, 1.15, 1.0);

/// Sideways: on the far side the light is behind the surface.
fn to_light() -> Vec3 {
    vec3(-0.8, 0.5, 0.25).normalize()
}

/// A light that is behind most of what is seen.
fn from_behind() -> Vec3 {
    vec3(-0.6, 0.4, -0.7).normalize()
}

/// A ball of few triangles.
struct Coarse {
    positions: Vec<Vec3>,
    triangles: Vec<[usize; 3]>,
}

impl Coarse {
    /// As fine as the figure says, but no finer than this.
    fn new(knobs: &Knobs<'_>, finest: u32) -> Option<Self> {
        let level = (knobs.or("subdivision", 1.0) as u32).min(finest);
        let mesh = shapes::icosphere(level).ok()?;
        // Turned, so that no side is seen edge-on.
        let turn = glam::Quat::from_euler(glam::EulerRot::XYZ, 0.3, 0.4, 0.1);
        Some(Self {
            positions: mesh.positions().iter().map(|p| turn * *p).collect(),
            triangles: mesh.triangles().iter().map(|corners| corners.map(|at| at as usize)).collect(),
        })
    }

    /// The triangle that is seen at a pixel, looking along −z, and the weights of its corners there.
    fn seen(&self, i: u32, j: u32) -> Option<(usize, Barycentric)> {
        let place = |k: u32| 1.04 * ((2 * k + 1) as f32 / SIDE as f32 - 1.0);
        let p = Vec2::new(place(i), place(j));
        let inside = |(at, corners): (usize, &[usize; 3])| {
            let [a, b, c] = corners.map(|k| self.positions[k].truncate());
            let area = (b - a).perp_dot(c - a);
            let (beta, gamma) = ((p - a).perp_dot(c - a) / area, (b - a).perp_dot(p - a) / area);
            let alpha = 1.0 - beta - gamma;
            (area > 0.0 && alpha.min(beta).min(gamma) >= 0.0)
                .then_some((at, Barycentric { alpha, beta, gamma }))
        };
        self.triangles.iter().enumerate().find_map(inside)
    }

    /// What is seen at each pixel.
    fn all_seen(&self) -> BTreeMap<(u32, u32), (usize, Barycentric)> {
        let places = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
        places.filter_map(|place| Some((place, self.seen(place.0, place.1)?))).collect()
    }

    /// The normals at a triangle's corners: those of the ball.
    fn normals(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|k| self.positions[k].normalize())
    }

    /// A ball whose pixels are asked one by one.
    fn panel(&self, question: impl Fn([Vec3; 3], Barycentric) -> Vec<Value>) -> Panel {
        let asked = |i, j| self.seen(i, j).map(|(triangle, at)| question(self.normals(triangle), at));
        Panel::of_pixels((SIDE, SIDE), asked, |_, _, c: Vec3| Some(c))
    }
}

pub(super) fn gouraud(knobs: &Knobs<'_>) -> Vec<Panel> {
    let Some(ball) = Coarse::new(knobs, 2) else { return Vec::new() };
    vec![ball.panel(|normals, at| arguments![C_R, C_A, C_L, to_light(), normals, at])]
}

pub(super) fn phong_shading(knobs: &Knobs<'_>) -> Vec<Panel> {
    let Some(ball) = Coarse::new(knobs, 2) else { return Vec::new() };
    let p = knobs.exponents()[0];
    let lit = |p: f32, l: Vec3| {
        let material = Material { diffuse: C_R, exponent: p };
        ball.panel(move |normals, at| arguments![material, C_L, l, Vec3::Z, normals, at])
    };
    vec![lit(p, to_light()), lit(p.min(2.0), from_behind())]
}

/// The colour of a matt surface with this normal.
fn matt(n: Vec3) -> Rgb {
    C_R * (C_A + C_L * lighting::lambert(n, to_light()))
}

/// Cells in a row, one for each of some things.
const CELLS: u32 = 6;

/// Which of them a cell shows.
fn cell(i: u32, j: u32) -> usize {
    (j * CELLS + i) as usize
}

/// The ball in flat shading; and the normals of some other triangles as colours: turned away, degenerate, large and small.
pub(super) fn face_normal(knobs: &Knobs<'_>) -> Vec<Panel> {
    let Some(ball) = Coarse::new(knobs, 2) else { return Vec::new() };
    let triangles = ball.triangles.iter().map(|corners| {
        let [a, b, c] = corners.map(|k| ball.positions[k]);
        arguments![Triangle { a, b, c }]
    });
    let seen = ball.all_seen();
    let flat = move |i, j, normals: &[Option<Option<Vec3>>]| match seen.get(&(i, j)) {
        None => Dot::Ground,
        Some((triangle, _)) => {
            dot(normals.get(*triangle).copied().flatten().map(|n| n.map_or(Rgb::ZERO, matt)))
        }
    };
    let others = |k: usize| {
        let a = vec3(0.5, -0.25, 1.0);
        let (u, v) = (vec3(1.0, 0.25, 0.5), vec3(-0.25, 0.75, -0.5));
        let scale = 0.25 * (1 + k / 4) as f32;
        let (b, c) = (a + scale * u, a + scale * v);
        match k % 4 {
            0 => Triangle { a, b, c },
            1 => Triangle { a, b: c, c: b },
            2 => Triangle { a, b, c: a + 2.0 * scale * u },
            _ => Triangle { a, b: a, c: a },
        }
    };
    let cells = CELLS * CELLS;
    let colored = |i, j, normals: &[Option<Option<Vec3>>]| {
        dot(normals.get(cell(i, j)).copied().flatten().map(|n| n.map_or(Rgb::ZERO, direction)))
    };
    vec![
        Panel::of_all((SIDE, SIDE), triangles.collect(), flat),
        Panel::of_all((CELLS, CELLS), (0..cells as usize).map(|k| arguments![others(k)]).collect(), colored),
    ]
}

/// The ball in smooth shading; and the normals of its positions as colours, among them some without a triangle.
pub(super) fn vertex_normals(knobs: &Knobs<'_>) -> Vec<Panel> {
    // So coarse that at each position the triangles lie the same to both sides: then every way to count them gives one normal.
    let Some(ball) = Coarse::new(knobs, 1) else { return Vec::new() };
    // Beside the origin: a position is no normal.
    let mut positions: Vec<Vec3> = ball.positions.iter().map(|p| *p + vec3(0.5, -0.25, 0.75)).collect();
    let mut triangles = ball.triangles.clone();
    let used = positions.len();
    positions.extend([vec3(2.0, 0.0, 0.0), vec3(2.0, 1.0, 0.0), vec3(2.0, 2.0, 0.0), vec3(0.0, 3.0, 0.0)]);
    // Without an area: one by itself, one at a corner of the ball.
    triangles.extend([[used, used + 1, used + 2], [0, 0, 1]]);
    let question = vec![arguments![positions, triangles.clone()]];
    let seen = ball.all_seen();
    let corners = ball.triangles;
    let smooth = move |i, j, answers: &[Option<Vec<Vec3>>]| {
        let Some((triangle, at)) = seen.get(&(i, j)) else { return Dot::Ground };
        let normals = answers.first().and_then(Option::as_ref);
        let n = normals.and_then(|normals| {
            let [a, b, c] = corners[*triangle].map(|k| normals.get(k).copied());
            Some(at.alpha * a? + at.beta * b? + at.gamma * c?)
        });
        // As long as it came out: who forgets the unit length is seen.
        dot(n.map(matt))
    };
    let rows = (used as u32 + 4).div_ceil(CELLS);
    let colored = move |i, j, answers: &[Option<Vec<Vec3>>]| {
        if cell(i, j) >= used + 4 {
            return Dot::Ground;
        }
        let normals = answers.first().and_then(Option::as_ref);
        dot(normals.and_then(|normals| normals.get(cell(i, j)).copied()).map(direction))
    };
    vec![
        Panel::of_all((SIDE, SIDE), question.clone(), smooth),
        Panel::of_all((CELLS, rows), question, colored),
    ]
}
