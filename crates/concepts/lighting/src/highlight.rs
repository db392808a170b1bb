//! How bright is the mirror image of the light on a glossy surface? Two answers, which differ (L31, L34, E4).
//!
//! In one plane the angle σ between e and r is twice the angle ω between h and n, so that h·n needs an exponent of about
//! 4p to give a highlight as wide as e·r with p. The slides join the two forms by ⇒, as if they were the same (E4).

use glam::Vec3;

use crate::{halfway, reflect};

/// Which of the two highlights a lighting model uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Highlight {
    /// (e·r)^p (L31): [`phong_highlight`].
    Phong,
    /// (h·n)^p (L34): [`blinn_highlight`]. The form of the lecture's `raycolor` (L57).
    #[default]
    Blinn,
}

/// Maximum exponent for which a highlight computed in f32 is off by less than half a step of an 8-bit file, 1/510.
///
/// Rounding the three vectors and their cosine costs a few times 2⁻²⁴, and the power makes p times as much of it: at
/// p = 10⁶ the highlight is off by more than 40 steps. `tests` measure it. The functions here take any exponent.
pub const GREATEST_EXPONENT: f32 = 4096.0;

impl Highlight {
    /// The highlight's brightness, 0 to 1; for the arguments see [`phong_highlight`].
    #[must_use]
    pub fn at(self, n: Vec3, to_light: Vec3, to_eye: Vec3, exponent: f32) -> f32 {
        match self {
            Self::Phong => phong_highlight(n, to_light, to_eye, exponent),
            Self::Blinn => blinn_highlight(n, to_light, to_eye, exponent),
        }
    }
}

/// Phong's highlight: max(0, e·r)^p, and 0 where the light is behind the surface. 0 to 1.
///
/// Equation L31. Without the gate n·l > 0 even this form leaks: at n·l = −0.17 it can have e·r = 0.97 (E3). The first
/// attempt e·r (L30) has two faults, it goes negative and is too wide: the clamp and p mend them.
///
/// - `n`, `to_light`, `to_eye`: unit vectors in one common space.
/// - `exponent`: p ≥ 0, larger is narrower; 0 gives 1 wherever the reflected light leans to the eye. A negative p would give
///   more than 1; whoever reads materials from files refuses it.
///
/// ```
/// use glam::{Vec3, vec3};
/// let (to_light, to_eye) = (vec3(0.6, 0.0, 0.8), vec3(-0.6, 0.0, 0.8));
/// assert_eq!(lighting::phong_highlight(Vec3::Z, to_light, to_eye, 32.0), 1.0); // the eye stands in the mirror direction
/// assert_eq!(lighting::phong_highlight(Vec3::NEG_Z, to_light, to_eye, 32.0), 0.0); // lit from behind
/// ```
#[must_use]
pub fn phong_highlight(n: Vec3, to_light: Vec3, to_eye: Vec3, exponent: f32) -> f32 {
    if !is_lit(n, to_light) {
        return 0.0;
    }
    power_of_cosine(to_eye.dot(reflect(n, to_light)), exponent)
}

/// The halfway form: max(0, h·n)^p, and 0 where the light is behind the surface. 0 to 1.
///
/// Equation L34. The slide says that h·n is always positive and leaves out clamp and gate; it is positive only where eye
/// and light lie on the normal's side (E3). Where h is undefined (e = −l) there is no highlight.
///
/// - `n`, `to_light`, `to_eye`: unit vectors in one common space.
/// - `exponent`: p ≥ 0; about four times that of [`phong_highlight`] for a highlight of the same width (E4).
///
/// ```
/// use glam::{Vec3, vec3};
/// let (to_light, to_eye) = (vec3(0.6, 0.0, 0.8), vec3(-0.6, 0.0, 0.8));
/// assert_eq!(lighting::blinn_highlight(Vec3::Z, to_light, to_eye, 128.0), 1.0);
/// ```
#[must_use]
pub fn blinn_highlight(n: Vec3, to_light: Vec3, to_eye: Vec3, exponent: f32) -> f32 {
    if !is_lit(n, to_light) {
        return 0.0;
    }
    halfway(to_eye, to_light).map_or(0.0, |h| power_of_cosine(h.dot(n), exponent))
}

/// The gate of E3. A NaN is not lit.
fn is_lit(n: Vec3, to_light: Vec3) -> bool {
    n.dot(to_light) > 0.0
}

/// max(0, cos)^p, at most 1, and 0 for a cosine of 0 whatever p: `powf(0, 0)` is 1, which would light the unlit side.
/// A cosine of NaN, from vectors that are none, gives 0.
fn power_of_cosine(cosine: f32, exponent: f32) -> f32 {
    if cosine > 0.0 { cosine.min(1.0).powf(exponent) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    /// L34 as the slide prints it: no clamp, no gate.
    fn slide_blinn(n: Vec3, to_light: Vec3, to_eye: Vec3, exponent: f32) -> f32 {
        ((to_eye + to_light) / (to_eye + to_light).length()).dot(n).powf(exponent)
    }

    /// The slide's witness against "h·n is always positive" (E3).
    fn light_behind_the_surface() -> (Vec3, Vec3, Vec3) {
        (Vec3::Z, vec3(-0.5, 0.0, -0.2).normalize(), vec3(1.0, 0.0, 0.1).normalize())
    }

    #[test]
    fn the_slides_form_lights_an_unlit_point_and_ours_does_not() {
        let (n, to_light, to_eye) = light_behind_the_surface();
        // h·n = −0.971 and its tenth power 0.7475 follow from the three vectors by hand.
        assert!((halfway(to_eye, to_light).unwrap().dot(n) + 0.971).abs() < 5e-4);
        assert!((slide_blinn(n, to_light, to_eye, 10.0) - 0.7475).abs() < 5e-5);
        assert_eq!(blinn_highlight(n, to_light, to_eye, 10.0), 0.0);
    }

    #[test]
    fn the_slides_form_goes_negative_and_to_nan_and_ours_does_neither() {
        let (n, to_light, to_eye) = light_behind_the_surface();
        assert!(slide_blinn(n, to_light, to_eye, 11.0) < 0.0);
        assert!(slide_blinn(n, to_light, to_eye, 10.5).is_nan());
        assert!(slide_blinn(n, Vec3::X, Vec3::NEG_X, 10.0).is_nan());
        assert_eq!(blinn_highlight(n, to_light, to_eye, 11.0), 0.0);
        assert_eq!(blinn_highlight(n, to_light, to_eye, 10.5), 0.0);
        assert_eq!(blinn_highlight(n, Vec3::X, Vec3::NEG_X, 10.0), 0.0);
    }

    #[test]
    fn vectors_that_are_none_give_no_highlight() {
        let nan = Vec3::splat(f32::NAN);
        for form in [Highlight::Phong, Highlight::Blinn] {
            assert_eq!(form.at(nan, Vec3::Z, Vec3::Z, 8.0), 0.0);
            assert_eq!(form.at(Vec3::Z, nan, Vec3::Z, 8.0), 0.0);
            assert_eq!(form.at(Vec3::Z, Vec3::Z, nan, 8.0), 0.0);
        }
    }

    #[test]
    fn a_cosine_of_zero_gives_no_highlight_even_to_the_power_of_zero() {
        // e·r = −0.6 · 0.8 + 0.8 · 0.6, which is 0 without rounding.
        let (to_light, to_eye) = (vec3(0.6, 0.0, 0.8), vec3(0.8, 0.0, 0.6));
        assert_eq!(to_eye.dot(reflect(Vec3::Z, to_light)), 0.0);
        assert_eq!(phong_highlight(Vec3::Z, to_light, to_eye, 0.0), 0.0);
        assert_eq!(phong_highlight(Vec3::Z, to_light, vec3(0.0, 0.6, 0.8), 0.0), 1.0);
    }

    #[test]
    fn the_reflected_form_leaks_without_a_gate() {
        // n·l = −0.17: the light is 9.8° below the horizon, and the mirror direction too.
        let to_light = vec3(-0.985_444, 0.0, -0.17);
        let r = reflect(Vec3::Z, to_light);
        let to_eye = vec3(0.997, 0.0, 0.0775).normalize();
        assert!((to_eye.dot(r) - 0.97).abs() < 5e-3);
        assert_eq!(phong_highlight(Vec3::Z, to_light, to_eye, 1.0), 0.0);
    }

    #[test]
    fn the_halfway_form_needs_four_times_the_exponent() {
        // E4: ω = 10°, so σ = 20°; p = 32.
        let omega = 10.0_f32.to_radians();
        let to_light = Vec3::Z;
        let to_eye = vec3((2.0 * omega).sin(), 0.0, (2.0 * omega).cos());
        assert!((phong_highlight(Vec3::Z, to_light, to_eye, 32.0) - 0.137).abs() < 5e-4);
        assert!((blinn_highlight(Vec3::Z, to_light, to_eye, 32.0) - 0.613).abs() < 5e-4);
        assert!((blinn_highlight(Vec3::Z, to_light, to_eye, 128.0) - 0.141).abs() < 5e-4);
    }

    #[test]
    fn the_first_attempt_is_negative_and_too_wide() {
        // L30: c = c_l (e·r). 60° off the mirror direction it still has half its brightness; p = 32 leaves nothing.
        let to_eye = vec3(0.75_f32.sqrt(), 0.0, 0.5);
        assert!((to_eye.dot(reflect(Vec3::Z, Vec3::Z)) - 0.5).abs() < 1e-6);
        assert!(phong_highlight(Vec3::Z, Vec3::Z, to_eye, 32.0) < 1e-9);
        let low_light = vec3(0.995, 0.0, 0.0998).normalize();
        let beside_the_light = vec3(0.9, 0.0, 0.1).normalize();
        assert!(beside_the_light.dot(reflect(Vec3::Z, low_light)) < 0.0);
        assert_eq!(phong_highlight(Vec3::Z, low_light, beside_the_light, 1.0), 0.0);
    }
}
