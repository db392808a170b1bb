//! What is x^p, for eight x at once? 2^(p · log₂ x), by two short polynomials.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, i32x8, u32x8};

/// max(0, x)^p, at most 1: the highlight's power (L31), for eight cosines at once.
///
/// 0 for x ≤ 0 and for NaN, whatever p; x above 1 counts as 1. A cosine below 2⁻¹²⁶, which rounding alone can produce, counts
/// as 2⁻¹²⁶.
///
/// - `exponent`: p ≥ 0, at most 10⁹.
///
/// **Error.** With y = p·log₂ x ≤ 0: log₂ is right to a relative error of ε₁ = 4 · 2⁻²⁴ (near x = 1 too, where the result lives
/// that large p ask for), so y is right to (ε₁ + 2⁻²⁴)·|y|, and 2^y to ln 2 · |y| · 2^y times that. |y| · 2^y is greatest at
/// |y| = 1/ln 2: 0.53. Together with the 4 · 2⁻²⁴ of exp2 itself that is less than 8 · 2⁻²⁴ < 5 · 10⁻⁷ for every x and p.
#[inline(always)]
pub fn power<S: Simd>(simd: S, x: f32x8<S>, exponent: f32x8<S>) -> f32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    let is_positive = x.simd_gt(zero);
    let tame = is_positive.select(x, f32x8::splat(simd, 1.0));
    let tame = tame.min(f32x8::splat(simd, 1.0)).max(f32x8::splat(simd, f32::MIN_POSITIVE));
    is_positive.select(exp2(simd, exponent * log2(simd, tame)), zero)
}

/// log₂ x for 2⁻¹²⁶ ≤ x ≤ 1.
///
/// x = 2^k · m with m from √½ to √2; s = (m − 1)/(m + 1) is at most 0.172, and
/// log₂ m = 2/ln 2 · (s + s³/3 + s⁵/5 + s⁷/7 + s⁹/9 + …); what follows is below 3 · 10⁻⁹ of the whole.
#[inline(always)]
fn log2<S: Simd>(simd: S, x: f32x8<S>) -> f32x8<S> {
    const MANTISSA: u32 = (1 << 23) - 1;
    /// The bits of √½: subtracting them moves the seam between two exponents there.
    const ROOT_HALF: u32 = 0x3f35_04f3;
    let bits: u32x8<S> = x.bitcast();
    let moved: i32x8<S> = (bits - u32x8::splat(simd, ROOT_HALF)).bitcast();
    let exponent: i32x8<S> = moved >> 23;
    let mantissa: u32x8<S> = moved.bitcast::<u32x8<S>>() & u32x8::splat(simd, MANTISSA);
    let m: f32x8<S> = (mantissa + u32x8::splat(simd, ROOT_HALF)).bitcast();
    let one = f32x8::splat(simd, 1.0);
    let s = (m - one) / (m + one);
    let s2 = s * s;
    let term = |over: f32| f32x8::splat(simd, std::f32::consts::LOG2_E * 2.0 / over);
    let series = ((term(9.0) * s2 + term(7.0)) * s2 + term(5.0)) * s2 + term(3.0);
    let log_m = s * (series * s2 + term(1.0));
    let k: f32x8<S> = exponent.to_float();
    k + log_m
}

/// 2^y for y ≤ 0; below −126 as for −126.
///
/// y = k + f with whole k and |f| ≤ ½; 2^f = e^(f ln 2) by its series up to the seventh power, what follows is below 6 · 10⁻⁹.
#[inline(always)]
fn exp2<S: Simd>(simd: S, y: f32x8<S>) -> f32x8<S> {
    let y = y.max(f32x8::splat(simd, -126.0));
    let k = y.round_ties_even();
    let f = (y - k) * f32x8::splat(simd, std::f32::consts::LN_2);
    let splat = |c: f32| f32x8::splat(simd, c);
    let high = (f * splat(1.0 / 5040.0) + splat(1.0 / 720.0)) * f + splat(1.0 / 120.0);
    let low = ((high * f + splat(1.0 / 24.0)) * f + splat(1.0 / 6.0)) * f + splat(0.5);
    let series = (low * f + splat(1.0)) * f + splat(1.0);
    let whole: i32x8<S> = k.to_int();
    let scale: f32x8<S> = ((whole + i32x8::splat(simd, 127)) << 23).bitcast();
    series * scale
}
