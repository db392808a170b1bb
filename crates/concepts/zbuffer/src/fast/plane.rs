//! How deep are the planes of eight triangles where their corners were snapped to? [`crate::plane`], four by four.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4};

/// Eight numbers in 64 bits: the first four and the others.
pub(crate) type Wide<S> = (f64x4<S>, f64x4<S>);

/// The depths of eight planes in their three snapped corners, with the slide's roundings.
///
/// - `snapped`: x, y in 1/256 pixels and z of the corners a, b, c.
/// - `rests`: what rounding left over of each.
#[inline(always)]
pub(crate) fn followed<S: Simd>(
    simd: S,
    snapped: [[f32x8<S>; 3]; 3],
    rests: [[f32x8<S>; 3]; 3],
) -> [Wide<S>; 3] {
    let snapped = three!(axis => three!(k => snapped[axis][k].widen()));
    let rests = three!(axis => three!(k => rests[axis][k].widen()));
    let low = four(
        simd,
        three!(axis => three!(k => snapped[axis][k].0)),
        three!(axis => three!(k => rests[axis][k].0)),
    );
    let high = four(
        simd,
        three!(axis => three!(k => snapped[axis][k].1)),
        three!(axis => three!(k => rests[axis][k].1)),
    );
    three!(k => (low[k], high[k]))
}

/// The same for four; line by line as [`crate::plane`].
#[inline(always)]
fn four<S: Simd>(simd: S, snapped: [[f64x4<S>; 3]; 3], rests: [[f64x4<S>; 3]; 3]) -> [f64x4<S>; 3] {
    let (zero, one) = (f64x4::splat(simd, 0.0), f64x4::splat(simd, 1.0));
    let [x, y, z] = three!(axis => three!(k => snapped[axis][k] + rests[axis][k]));
    let (ab, ac) = ([x[1] - x[0], y[1] - y[0]], [x[2] - x[0], y[2] - y[0]]);
    let (z_ab, z_ac) = (z[1] - z[0], z[2] - z[0]);
    let area = ab[0] * ac[1] - ab[1] * ac[0];
    let inv_area = area.simd_eq(zero).select(zero, one / area);
    let slope_x = (z_ab * ac[1] - z_ac * ab[1]) * inv_area;
    let slope_y = (z_ac * ab[0] - z_ab * ac[0]) * inv_area;
    let range = z[0].max(z[1]).max(z[2]) - z[0].min(z[1]).min(z[2]);
    three!(k => {
        z[k] - (slope_x * rests[0][k] + slope_y * rests[1][k]).max(zero - range).min(range)
    })
}
