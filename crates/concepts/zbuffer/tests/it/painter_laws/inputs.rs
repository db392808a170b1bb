//! Triangles on the screen: touching, overlapping, piercing, in cycles, in meshes, in stacks.

use geometry::{Barycentric, Mesh};
use glam::{Mat3, Vec3, vec3};
use proptest::prelude::*;
use testkit::strategy;
use zbuffer::{ScreenTriangle, ScreenVertex};

pub(crate) fn on_screen(corners: [Vec3; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    let vertex =
        |k: usize| ScreenVertex { position: corners[k].as_dvec3(), inv_w: -1.0, weights: weights[k] };
    ScreenTriangle { vertices: [vertex(0), vertex(1), vertex(2)] }
}

/// A position on a coarse grid, so that triangles often touch, share corners and have no area; a little off screen too.
pub(crate) fn position() -> impl Strategy<Value = (f32, f32)> {
    (-8..40_i32, -8..32_i32).prop_map(|(x, y)| (2.0 * x as f32, 2.0 * y as f32))
}

/// A triangle anywhere; its depths differ by at most `thickness` from that of its first corner.
pub(crate) fn triangle(thickness: f32) -> impl Strategy<Value = ScreenTriangle> {
    let slope = -thickness..=thickness;
    (position(), position(), position(), -1.0_f32..1.0, slope.clone(), slope).prop_map(
        |(a, b, c, z, to_b, to_c)| {
            let at = |(x, y): (f32, f32), z: f32| vec3(x, y, z.clamp(-1.0, 1.0));
            on_screen([at(a, z), at(b, z + to_b), at(c, z + to_c)])
        },
    )
}

pub(crate) fn triangles(
    count: std::ops::Range<usize>,
    thickness: f32,
) -> impl Strategy<Value = Vec<ScreenTriangle>> {
    prop::collection::vec(triangle(thickness), count)
}

/// Flat polygons and some that reach from near to far: some inputs have an order, others have not.
pub(crate) fn mixed_triangles() -> impl Strategy<Value = Vec<ScreenTriangle>> {
    (triangles(1..12, 0.05), triangles(0..2, 2.0), 0..12_usize).prop_map(|(mut all, steep, turn)| {
        all.extend(steep);
        let turn = turn % all.len();
        all.rotate_left(turn);
        all
    })
}

/// The three long triangles of Fig 8.9, each over the next, moved a little and in any order, with others in between.
pub(crate) fn cycle_of_three() -> impl Strategy<Value = ([usize; 3], Vec<ScreenTriangle>)> {
    let corners = [
        [vec3(4.0, 6.0, -0.5), vec3(58.0, 9.0, 0.5), vec3(4.0, 16.0, -0.5)],
        [vec3(46.0, 3.0, -0.5), vec3(56.0, 4.0, -0.5), vec3(26.0, 46.0, 0.5)],
        [vec3(40.0, 40.0, -0.5), vec3(32.0, 48.0, -0.5), vec3(6.0, 2.0, 0.5)],
    ];
    let others = prop::collection::vec((position(), position(), position(), 0.7_f32..0.99), 0..3);
    let order = Just(vec![0, 1, 2]).prop_shuffle();
    (order, prop::collection::vec(strategy::point(1.0), 9), others).prop_map(move |(order, moves, others)| {
        let moved = |k: usize, c: usize| corners[k][c] + moves[3 * k + c] * vec3(0.9, 0.9, 0.05);
        let mut triangles: Vec<_> =
            order.iter().map(|k| on_screen([moved(*k, 0), moved(*k, 1), moved(*k, 2)])).collect();
        for (a, b, c, z) in others {
            triangles.push(on_screen([a, b, c].map(|(x, y)| vec3(x, y, z))));
        }
        let index = |k: usize| order.iter().position(|x| *x == k).unwrap_or(0);
        ([index(0), index(1), index(2)], triangles)
    })
}

pub(crate) fn seen_from(mesh: &Mesh, turn: Mat3) -> Vec<ScreenTriangle> {
    let corner = |p: Vec3| {
        let p = turn * p;
        // On the grid that the order is decided on: beside its snapped outline a back is nearer than the front that it touches.
        let on_grid = |pixel: f32| (pixel * 256.0).round() / 256.0;
        vec3(on_grid(31.5 + 21.0 * p.x), on_grid(24.25 + 21.0 * p.y), 0.9 * p.z)
    };
    (0..mesh.len()).map(|k| on_screen(mesh.triangle(k).corners().map(corner))).collect()
}

/// `count` sheets over the whole screen, one above the other, all with the same slope.
pub(crate) fn sheets(count: usize) -> Vec<ScreenTriangle> {
    let sheet = |k: usize| {
        // 1234577 is prime, so the sheets come in a mixed-up order, each depth once.
        let z = -0.8 + 1.5 * ((k * 1_234_577) % count) as f32 / count as f32;
        on_screen([vec3(-70.0, -9.0, z + 0.1), vec3(140.0, -5.0, z - 0.1), vec3(20.0, 130.0, z)])
    };
    (0..count).map(sheet).collect()
}
