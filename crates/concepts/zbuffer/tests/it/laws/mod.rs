//! The laws of clipping, rasterization and the depth buffer.

mod clipping;
mod coverage;
mod depth;
mod exactness;
mod fast;
mod interpolation;

use geometry::Barycentric;
use glam::I64Vec2;
use proptest::prelude::*;
use zbuffer::screen::SUBPIXELS;
use zbuffer::{Fragment, ScreenTriangle, ScreenVertex};

const WIDTH: u32 = 24;
const HEIGHT: u32 = 20;

/// A snapped position at most `reach` pixels beyond the screen; each coordinate is often that of pixel centres.
fn position(reach: i64) -> impl Strategy<Value = I64Vec2> + Clone {
    let coordinate = |side: u32| {
        let (least, most) = (-reach, i64::from(side) - 1 + reach);
        let center = (least..=most).prop_map(|i| i * SUBPIXELS);
        prop_oneof![center, least * SUBPIXELS..=most * SUBPIXELS]
    };
    (coordinate(WIDTH), coordinate(HEIGHT)).prop_map(|(x, y)| I64Vec2::new(x, y))
}

/// A vertex exactly at a snapped position.
fn vertex(p: I64Vec2, z: f32, inv_w: f32, weights: Barycentric) -> ScreenVertex {
    let place = p.as_dvec2() / SUBPIXELS as f64;
    ScreenVertex { position: place.extend(z.into()), inv_w, weights }
}

/// A triangle of constant depth and w.
fn flat(corners: [I64Vec2; 3]) -> ScreenTriangle {
    deep(corners, [0.0; 3], [-1.0; 3])
}

fn deep([a, b, c]: [I64Vec2; 3], z: [f32; 3], inv_w: [f32; 3]) -> ScreenTriangle {
    let vertices = [
        vertex(a, z[0], inv_w[0], Barycentric::A),
        vertex(b, z[1], inv_w[1], Barycentric::B),
        vertex(c, z[2], inv_w[2], Barycentric::C),
    ];
    ScreenTriangle { vertices }
}

/// All fragments of the slide's rasterizer.
fn fragments(triangle: &ScreenTriangle) -> Vec<Fragment> {
    let mut all = Vec::new();
    zbuffer::rasterize(triangle, WIDTH, HEIGHT, |fragment| all.push(fragment));
    all
}

/// How often each pixel is covered, row by row.
fn coverage(triangles: impl IntoIterator<Item = ScreenTriangle>) -> Vec<u32> {
    let mut counts = vec![0; (WIDTH * HEIGHT) as usize];
    for triangle in triangles {
        for fragment in fragments(&triangle) {
            counts[(fragment.j * WIDTH + fragment.i) as usize] += 1;
        }
    }
    counts
}

/// Twice the signed area of abc, without rounding.
fn area(a: I64Vec2, b: I64Vec2, c: I64Vec2) -> i64 {
    (b - a).perp_dot(c - a)
}

/// The rectangle from `lowest` to `highest` cut into anticlockwise triangles that meet at whole edges, with a vertex at
/// each of `points`, which lie in it.
fn triangulation(lowest: I64Vec2, highest: I64Vec2, points: &[I64Vec2]) -> Vec<[I64Vec2; 3]> {
    let (a, c) = (lowest, highest);
    let (b, d) = (I64Vec2::new(c.x, a.y), I64Vec2::new(a.x, c.y));
    let mut triangles = vec![[a, b, c], [a, c, d]];
    for &p in points {
        let contains =
            |[a, b, c]: &[I64Vec2; 3]| area(*a, *b, p).min(area(*b, *c, p)).min(area(*c, *a, p)) >= 0;
        let (hit, mut rest): (Vec<_>, Vec<_>) = triangles.into_iter().partition(contains);
        // On an edge, p splits both neighbours in two; inside, one triangle in three; on a vertex, nothing.
        for [a, b, c] in hit {
            rest.extend(
                [[p, b, c], [a, p, c], [a, b, p]].into_iter().filter(|[a, b, c]| area(*a, *b, *c) > 0),
            );
        }
        triangles = rest;
    }
    triangles
}
