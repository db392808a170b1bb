//! How great may an exponent be until a highlight in f32 is visibly wrong?

use glam::{DQuat, DVec3, dvec3};
use lighting::Highlight;
use lighting::highlight::GREATEST_EXPONENT;

/// A different fraction of 1 for each k and each axis (Weyl's sequence by irrational steps).
fn fraction(k: u32, axis: usize) -> f64 {
    (f64::from(k) * [0.618_033_988_7, 0.414_213_562_4, 0.732_050_807_6, 0.236_067_977_5][axis]).fract()
}

fn unit(u: f64, v: f64) -> DVec3 {
    let (z, turn) = (2.0 * u - 1.0, std::f64::consts::TAU * v);
    let radius = (1.0 - z * z).sqrt();
    dvec3(radius * turn.cos(), radius * turn.sin(), z)
}

/// The greatest error of a highlight in steps of an 8-bit file: the function in f32, on vectors rounded to f32, against f64.
fn greatest_error(highlight: Highlight, exponent: f32) -> f64 {
    let p = f64::from(exponent);
    let error = |k: u32| {
        let n = unit(fraction(k, 0), fraction(k, 1));
        // The light up to 75° off the normal, the eye near the mirror direction, as far as the highlight reaches.
        let off = DQuat::from_axis_angle(n.any_orthonormal_vector(), 1.3 * fraction(k, 2));
        let to_light = DQuat::from_axis_angle(n, 6.0 * fraction(k, 3)) * (off * n);
        let mirrored = 2.0 * n.dot(to_light) * n - to_light;
        let axis = mirrored.any_orthonormal_vector();
        let angle = 4.0 * fraction(k, 3) / p.sqrt();
        let to_eye = DQuat::from_axis_angle(axis, angle) * mirrored;
        let cosine = match highlight {
            Highlight::Phong => to_eye.dot(mirrored),
            Highlight::Blinn => (to_eye + to_light).normalize().dot(n),
        };
        let ours = highlight.at(n.as_vec3(), to_light.as_vec3(), to_eye.as_vec3(), exponent);
        255.0 * (f64::from(ours) - cosine.clamp(0.0, 1.0).powf(p)).abs()
    };
    (1..20_000).map(error).fold(0.0, f64::max)
}

#[test]
fn highlight_is_right_to_half_a_step_up_to_the_greatest_exponent_and_not_far_beyond() {
    for highlight in [Highlight::Phong, Highlight::Blinn] {
        for exponent in [1.0, 100.0, GREATEST_EXPONENT] {
            let error = greatest_error(highlight, exponent);
            assert!(error < 0.5, "{highlight:?}, exponent {exponent}: {error} steps");
        }
        // The limit is where it must be: four times as much is visibly wrong.
        let beyond = greatest_error(highlight, 4.0 * GREATEST_EXPONENT);
        assert!(beyond > 0.5, "{highlight:?}: {beyond} steps");
    }
}
