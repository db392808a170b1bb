//! Eight vectors as three columns.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8};
use glam::Vec3;

/// How many there are of everything.
pub const LANES: usize = 8;

/// Eight vectors, or eight colours: their x, their y and their z.
#[derive(Clone, Copy, Debug)]
pub struct Vectors<S: Simd> {
    /// The eight x, or red shares.
    pub x: f32x8<S>,
    /// The eight y, or green shares.
    pub y: f32x8<S>,
    /// The eight z, or blue shares.
    pub z: f32x8<S>,
}

impl<S: Simd> Vectors<S> {
    /// Eight times the same vector.
    #[inline(always)]
    pub fn splat(simd: S, v: Vec3) -> Self {
        Self { x: f32x8::splat(simd, v.x), y: f32x8::splat(simd, v.y), z: f32x8::splat(simd, v.z) }
    }

    /// The vectors whose coordinates stand in three slices of at least eight numbers.
    ///
    /// # Panics
    /// If a slice is shorter.
    #[inline(always)]
    pub fn load(simd: S, [x, y, z]: [&[f32]; 3]) -> Self {
        let column = |from: &[f32]| f32x8::from_slice(simd, &from[..LANES]);
        Self { x: column(x), y: column(y), z: column(z) }
    }

    /// Vector number `k`.
    ///
    /// # Panics
    /// If `k` is 8 or more.
    #[inline(always)]
    #[must_use]
    pub fn get(&self, k: usize) -> Vec3 {
        Vec3::new(self.x[k], self.y[k], self.z[k])
    }

    /// The eight scalar products.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> f32x8<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// self − other.
    #[inline(always)]
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }

    /// self + other.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }

    /// Each vector times its own factor.
    #[inline(always)]
    #[must_use]
    pub fn scaled(self, factor: f32x8<S>) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }

    /// Coordinate by coordinate: what light of colour `self` is left by surfaces that reflect the shares `other`.
    #[inline(always)]
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }
}
