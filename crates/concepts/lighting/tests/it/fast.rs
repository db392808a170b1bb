//! Eight points at a time give what one at a time gives, but for rounding.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8};
use glam::{Vec3, vec3};
use lighting::fast::{Points, Vectors};
use lighting::{Highlight, Light, Material, Rgb, SurfacePoint, lit};
use proptest::prelude::*;
use testkit::strategy::unit_vector;

fn powers(level: Level, cosines: [f32; 8], exponent: f32) -> [f32; 8] {
    dispatch!(level, simd => powers_of(simd, cosines, exponent))
}

#[inline(always)]
fn powers_of<S: Simd>(simd: S, cosines: [f32; 8], exponent: f32) -> [f32; 8] {
    let p = f32x8::splat(simd, exponent);
    lighting::fast::power(simd, f32x8::load_array(simd, cosines), p).to_array()
}

/// The bound that `power` derives.
const GREATEST_ERROR: f64 = 8.0 / (1 << 24) as f64;

#[test]
fn powers_are_right_for_every_cosine_from_a_half_to_one() {
    // All 2²³ of them; highlights live here. Exponents as they occur, and one that picks out the last few numbers below 1.
    let level = Level::new();
    for (exponent, step) in [(1.0, 5), (2.7, 3), (32.0, 1), (1e6, 7)] {
        let mut worst = 0.0_f64;
        let all: Vec<u32> = (0.5_f32.to_bits()..=1.0_f32.to_bits()).step_by(step).collect();
        for eight in all.chunks_exact(8) {
            let x: [f32; 8] = std::array::from_fn(|k| f32::from_bits(eight[k]));
            for (x, ours) in x.iter().zip(powers(level, x, exponent)) {
                worst = worst.max((f64::from(ours) - f64::from(*x).powf(exponent.into())).abs());
            }
        }
        assert!(worst < GREATEST_ERROR, "exponent {exponent}: {worst:e}");
    }
}

#[test]
fn what_is_no_cosine_gives_what_the_slides_power_gives() {
    let x = [0.0, -0.0, -0.5, f32::NAN, 1.5, 1.0, f32::INFINITY, f32::NEG_INFINITY];
    for exponent in [0.0, 0.5, 32.0, 1e9] {
        assert_eq!(powers(Level::new(), x, exponent), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0]);
    }
    let tiny = powers(Level::new(), [1e-30, 1e-38, 1e-45, 0.5, 0.5, 0.5, 0.5, 0.5], 0.0);
    assert_eq!(tiny, [1.0; 8]);
}

/// Eight points lit at once, the last of them repeated if there are fewer.
fn eight(
    material: &Material,
    lights: &[Light],
    highlight: Highlight,
    eye: Vec3,
    points: &[(Vec3, Vec3); 8],
) -> [Rgb; 8] {
    #[inline(always)]
    fn colors<S: Simd>(
        simd: S,
        material: &Material,
        lights: &[Light],
        highlight: Highlight,
        eye: Vec3,
        points: &[(Vec3, Vec3); 8],
    ) -> [Rgb; 8] {
        let column = |of: &dyn Fn(&(Vec3, Vec3)) -> f32| points.each_ref().map(of);
        let p = [column(&|p| p.0.x), column(&|p| p.0.y), column(&|p| p.0.z)];
        let n = [column(&|p| p.1.x), column(&|p| p.1.y), column(&|p| p.1.z)];
        let load = |v: &[[f32; 8]; 3]| Vectors::load(simd, [&v[0], &v[1], &v[2]]);
        let at = Points::seen_from(simd, eye, load(&p), load(&n));
        let all = lighting::fast::lit(simd, material, lights, highlight, &at, |_, _, _, before| before);
        std::array::from_fn(|k| all.get(k))
    }
    dispatch!(Level::new(), simd => colors(simd, material, lights, highlight, eye, points))
}

proptest! {
    /// The cosine of a highlight is rounded some ten times on either way, each time by at most 2⁻²⁴ of a number up to 2: together 2⁻¹⁹. To
    /// the power of p that is p times as much, and the power itself adds 2⁻²¹. Two lights of up to 1.
    #[test]
    fn eight_points_at_once_are_lit_as_one_by_one(
        normals in prop::array::uniform8(unit_vector()),
        places in prop::array::uniform8(prop::array::uniform3(-2.0_f32..2.0)),
        sun in unit_vector(),
        lamp in prop::array::uniform3(2.5_f32..6.0),
        exponent in 0.0_f32..400.0,
        blinn: bool,
    ) {
        let eye = vec3(1.5, -3.5, 4.0);
        let material = Material { diffuse: vec3(0.6, 0.3, 0.9), specular: vec3(1.0, 0.5, 0.25), exponent };
        let lights = [
            Light::Ambient { color: vec3(0.1, 0.2, 0.3) },
            Light::Directional { to_light: sun, color: vec3(1.0, 0.7, 0.2) },
            Light::Point { position: Vec3::from(lamp), color: vec3(0.3, 0.8, 1.0) },
        ];
        let highlight = if blinn { Highlight::Blinn } else { Highlight::Phong };
        let points: [(Vec3, Vec3); 8] = std::array::from_fn(|k| (Vec3::from(places[k]), normals[k]));
        let ours = eight(&material, &lights, highlight, eye, &points);
        let bound = (exponent + 2.0) * 2.0_f32.powi(-18);
        for (k, (p_world, n)) in points.into_iter().enumerate() {
            let to_eye = (eye - p_world).normalize();
            // At the horizon rounding decides whether there is light, and at p near 0 the highlight starts with a jump.
            let near_horizon = lights[1..].iter().any(|light| {
                let l = light.illumination(p_world).unwrap().to_light;
                let cosine = to_eye.dot(lighting::reflect(n, l));
                n.dot(l).abs() < 1e-5 || cosine.abs() < 1e-5 || (l + to_eye).dot(n).abs() < 1e-5
            });
            if near_horizon {
                continue;
            }
            let at = SurfacePoint { p_world, n, to_eye };
            let theirs = lit(&material, &lights, highlight, &at, |_| true);
            prop_assert!(ours[k].abs_diff_eq(theirs, bound), "{} {theirs} within {bound}", ours[k]);
        }
    }
}

#[test]
fn a_light_that_reaches_some_points_lights_only_those() {
    let lights = [Light::Directional { to_light: Vec3::Z, color: Rgb::ONE }];
    let material = Material::matt(vec3(0.5, 0.25, 0.125));
    #[inline(always)]
    fn colors<S: Simd>(simd: S, material: &Material, lights: &[Light]) -> [Rgb; 8] {
        let n = Vectors::splat(simd, Vec3::Z);
        let at = Points::seen_from(simd, vec3(1.0, 2.0, 3.0), Vectors::splat(simd, Vec3::ZERO), n);
        let odd = fearless_simd::mask32x8::from_bitmask(simd, 0b1010_1010);
        let all = lighting::fast::lit(simd, material, lights, Highlight::Phong, &at, |_, _, _, _| odd);
        std::array::from_fn(|k| all.get(k))
    }
    let got = dispatch!(Level::new(), simd => colors(simd, &material, &lights));
    for (k, color) in got.into_iter().enumerate() {
        assert_eq!(color, if k % 2 == 1 { material.diffuse } else { Rgb::ZERO }, "{k}");
    }
}

/// The distances to a lamp that `lit` hands to its shadow test.
fn distances(position: Vec3, points: &[Vec3; 8]) -> [f32; 8] {
    #[inline(always)]
    fn of<S: Simd>(simd: S, position: Vec3, points: &[Vec3; 8]) -> [f32; 8] {
        let [x, y, z] = [0, 1, 2].map(|axis| points.map(|p| p[axis]));
        let n = Vectors::splat(simd, Vec3::Z);
        let at = Points::seen_from(simd, vec3(1.0, 2.0, 9.0), Vectors::load(simd, [&x, &y, &z]), n);
        let lights = [Light::Point { position, color: Rgb::ONE }];
        let mut seen = [0.0; 8];
        lighting::fast::lit(
            simd,
            &Material::matt(Rgb::ONE),
            &lights,
            Highlight::Phong,
            &at,
            |_, _, far, all| {
                seen = far.to_array();
                all
            },
        );
        seen
    }
    dispatch!(Level::new(), simd => of(simd, position, points))
}

#[test]
fn the_distance_to_a_lamp_is_right_near_and_far() {
    let points: [Vec3; 8] = std::array::from_fn(|k| vec3(k as f32, 2.0, 3.0));
    for position in
        [vec3(4.0, -1.0, 9.0), vec3(1e9, 2e9, 3e9), vec3(1e19, 2e19, 3e19), vec3(0.0, -1e30, 2e30)]
    {
        for (got, p) in distances(position, &points).into_iter().zip(points) {
            let right = position.as_dvec3().distance(p.as_dvec3());
            // A difference, three squares and their sum, the root: each rounds by half an epsilon, and the root halves what is below it.
            let bound = right * 4.0 * f64::from(f32::EPSILON);
            assert!((f64::from(got) - right).abs() <= bound, "{position}, {p}: {got}, not {right}");
        }
    }
}

#[test]
fn a_lamp_at_the_point_lights_nothing_and_one_far_away_does() {
    let material = Material::new(vec3(0.5, 0.25, 0.125), 8.0);
    let points: [(Vec3, Vec3); 8] = std::array::from_fn(|k| (vec3(k as f32, 2.0, 3.0), Vec3::Z));
    let eye = vec3(1.0, 2.0, 9.0);
    for position in
        [points[3].0, points[0].0, vec3(1e19, 2e19, 3e19), vec3(0.0, -1e30, 2e30), vec3(1e37, 0.0, 1e37)]
    {
        let lights =
            [Light::Ambient { color: vec3(0.1, 0.2, 0.3) }, Light::Point { position, color: Rgb::ONE }];
        for highlight in [Highlight::Blinn, Highlight::Phong] {
            let ours = eight(&material, &lights, highlight, eye, &points);
            for (k, (p_world, n)) in points.into_iter().enumerate() {
                let at = SurfacePoint { p_world, n, to_eye: (eye - p_world).normalize() };
                let theirs = lit(&material, &lights, highlight, &at, |_| true);
                assert!(ours[k].abs_diff_eq(theirs, 1e-5), "{position}, point {k}: {} {theirs}", ours[k]);
            }
        }
    }
}
