//! How far may two results lie apart? As far as the caller can derive, and not a bit farther.

use glam::{Mat3, Mat4, Vec2, Vec3, Vec4};
use proptest::test_runner::TestCaseError;

use crate::Outcome;

/// How far two values lie apart: the greatest difference of a component. NaN if a component is NaN.
pub trait Deviation: std::fmt::Debug {
    /// The greatest absolute difference of a component.
    fn deviation(&self, other: &Self) -> f32;
}

impl Deviation for f32 {
    fn deviation(&self, other: &Self) -> f32 {
        (self - other).abs()
    }
}

macro_rules! deviation_by_components {
    ($($type:ty: $components:ident),*) => {$(
        impl Deviation for $type {
            fn deviation(&self, other: &Self) -> f32 {
                greatest(&self.$components(), &other.$components())
            }
        }
    )*};
}

deviation_by_components!(Vec2: to_array, Vec3: to_array, Vec4: to_array, Mat3: to_cols_array, Mat4: to_cols_array);

fn greatest(ours: &[f32], theirs: &[f32]) -> f32 {
    // `f32::max` would drop a NaN, and with it the news that something is badly wrong.
    let larger = |a: f32, b: f32| {
        if a.is_nan() || b.is_nan() { f32::NAN } else { a.max(b) }
    };
    ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
}

/// `Ok` if `got` lies within `bound` of `want` in every component; a NaN anywhere is a failure. For use in a law.
///
/// # Errors
/// A failure that names `what`, both values, the difference and the bound.
pub fn ensure_close<T: Deviation>(what: &str, got: T, want: T, bound: f32) -> Outcome {
    let deviation = got.deviation(&want);
    if deviation <= bound {
        return Ok(());
    }
    Err(TestCaseError::fail(format!(
        "{what}: got {got:?}, want {want:?}; they differ by {deviation:e}, allowed is {bound:e}"
    )))
}

/// `Ok` if `condition` holds. For use in a law.
///
/// # Errors
/// A failure with the sentence `otherwise`.
pub fn ensure(condition: bool, otherwise: impl FnOnce() -> String) -> Outcome {
    if condition { Ok(()) } else { Err(TestCaseError::fail(otherwise())) }
}

/// Panics unless `got` lies within `bound` of `want` in every component. For use in a unit test.
///
/// ```
/// testkit::assert_close("a third", 0.333_333, 1.0 / 3.0, 1e-6);
/// ```
///
/// # Panics
/// If they lie farther apart or a component is NaN.
#[track_caller]
pub fn assert_close<T: Deviation>(what: &str, got: T, want: T, bound: f32) {
    if let Err(failure) = ensure_close(what, got, want, bound) {
        panic!("{failure}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn the_bound_itself_is_allowed_and_more_is_not() {
        assert!(ensure_close("x", 1.5_f32, 1.0, 0.5).is_ok());
        assert!(ensure_close("x", 1.625_f32, 1.0, 0.5).is_err());
    }

    #[test]
    fn a_nan_is_never_close() {
        assert!(ensure_close("v", vec3(1.0, f32::NAN, 3.0), vec3(1.0, f32::NAN, 3.0), 1e9).is_err());
        assert!(ensure_close("v", vec3(f32::NAN, 2.0, 3.0), vec3(1.0, 2.0, 3.0), 1e9).is_err());
    }
}
