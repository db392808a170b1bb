//! The depth buffer, and the algorithm over it.

use canvas::{Image, Rgb};
use glam::vec3;
use proptest::prelude::*;
use testkit::{Law, ensure, strategy};
use transforms::canonical_from_camera;
use zbuffer::depth_format::step_at;
use zbuffer::draw::{draw, draw_fast, z_buffer};
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle};

use super::{HEIGHT, WIDTH, deep, fragments, position};

const FORMATS: [DepthFormat; 3] = [DepthFormat::F32, DepthFormat::Bits24, DepthFormat::Bits16];

fn format() -> impl Strategy<Value = DepthFormat> {
    prop::sample::select(FORMATS.to_vec())
}

/// Triangles, each with a colour of its own, and the same in another order.
fn shuffled_triangles() -> impl Strategy<Value = [Vec<(ScreenTriangle, Rgb)>; 2]> {
    let depth = || prop_oneof![-1.0_f32..1.0, Just(0.25)];
    let triangle = ([position(5), position(5), position(5)], [depth(), depth(), depth()])
        .prop_map(|(corners, z)| deep(corners, z, [-0.5, -1.0, -0.2]));
    proptest::collection::vec(triangle, 3..12).prop_flat_map(|triangles| {
        let colored: Vec<_> =
            triangles.into_iter().zip(1_u8..).map(|(t, k)| (t, Rgb::splat(k.into()))).collect();
        Just(colored.clone()).prop_shuffle().prop_map(move |shuffled| [colored.clone(), shuffled])
    })
}

#[test]
fn the_picture_does_not_depend_on_the_drawing_order() {
    Law::new("where no two depths are equal, every drawing order gives the same picture")
        .demand("the orders differ", 0.8)
        .demand("pixels with several fragments", 0.5)
        .demand("pixels whose nearest depths are equal", 0.05)
        .holds_for((shuffled_triangles(), format()), |([first, second], format), seen| {
            let render = |polygons: &[(ScreenTriangle, Rgb)]| {
                let mut image = Image::new(WIDTH, HEIGHT, Rgb::ZERO);
                let mut depth = DepthBuffer::new(WIDTH, HEIGHT, format);
                z_buffer(Rgb::ZERO, polygons, &mut image, &mut depth);
                (image, depth)
            };
            let ((image, depth), (other_image, other_depth)) = (render(&first), render(&second));
            let mut codes = vec![Vec::new(); (WIDTH * HEIGHT) as usize];
            for f in first.iter().flat_map(|(triangle, _)| fragments(triangle)) {
                codes[(f.j * WIDTH + f.i) as usize].push(format.code(f.z));
            }
            let tie = |codes: &Vec<u32>| {
                let nearest = codes.iter().max();
                codes.iter().filter(|code| Some(*code) == nearest).count() > 1
            };
            seen.class("the orders differ", first != second);
            seen.class("pixels with several fragments", codes.iter().any(|codes| codes.len() > 1));
            seen.class("pixels whose nearest depths are equal", codes.iter().any(tie));
            // The depths agree everywhere, the colours wherever one depth is the nearest.
            ensure(depth == other_depth, || "depths differ".to_owned())?;
            for (codes, k) in codes.iter().zip(0_u32..) {
                let (i, j) = (k % WIDTH, k / WIDTH);
                ensure(tie(codes) || image.get(i, j) == other_image.get(i, j), || {
                    format!("({i}, {j}) differs")
                })?;
            }
            Ok(())
        });
}

#[test]
fn the_fast_drawing_gives_the_slides_picture() {
    Law::new("draw_fast and draw give the same picture, depths and work")
        .demand("hidden fragments", 0.4)
        .holds_for((shuffled_triangles(), format()), |([triangles, _], format), seen| {
            let new = || (Image::new(WIDTH, HEIGHT, Rgb::ZERO), DepthBuffer::new(WIDTH, HEIGHT, format));
            let (mut slide, mut fast) = (new(), new());
            for (triangle, color) in &triangles {
                let work = draw(triangle, |f| *color * f.z as f32, &mut slide.0, &mut slide.1);
                seen.class("hidden fragments", work.colored < work.fragments && work.colored > 0);
                let same = draw_fast(triangle, |f| *color * f.z as f32, &mut fast.0, &mut fast.1) == work;
                ensure(same, || "the work differs".to_owned())?;
            }
            ensure(slide == fast, || "the picture differs".to_owned())
        });
}

#[test]
fn a_nearer_depth_never_has_a_smaller_code() {
    let depth = || prop_oneof![-1.0_f32..=1.0, proptest::num::f32::NORMAL, Just(-0.0), Just(0.0)];
    Law::new("codes have the order of the depths")
        .demand("near to each other", 0.2)
        .demand("in range", 0.4)
        .holds_for((depth(), depth(), any::<bool>()), |(a, b, close), seen| {
            let b = if close { a.next_up() } else { b };
            let (far, near) = (a.min(b), a.max(b));
            seen.class("near to each other", close);
            seen.class("in range", a.abs() <= 1.0 && b.abs() <= 1.0);
            for format in FORMATS {
                ensure(format.code(far) <= format.code(near), || format!("{format:?}: {far} and {near}"))?;
            }
            let exact = DepthFormat::F32.code(far) < DepthFormat::F32.code(near);
            ensure(exact == (far < near), || format!("F32 must tell {far} from {near}"))
        });
}

#[test]
fn a_stored_depth_is_the_nearest_step() {
    Law::new("what is read back lies within half a step of what was stored").demand("stored", 0.9).holds_for(
        (-1.0_f32..=1.0, format()),
        |(z, format), seen| {
            let mut depth = DepthBuffer::new(3, 2, format);
            depth.test_and_set(2, 1, z);
            let stored = depth.get(2, 1);
            seen.class("stored", stored.is_some());
            let steps = 2.0_f64.powi(format.bits() as i32) - 1.0;
            // Half a step of 2 / (2^b − 1), and the rounding of what is read back to `f32`; in 32 bits nothing is lost.
            let bound =
                if format == DepthFormat::F32 { 0.0 } else { 1.0 / steps + f64::from(f32::EPSILON) / 4.0 };
            let error = (f64::from(stored.unwrap_or(-1.0)) - f64::from(z)).abs();
            ensure(error <= bound, || format!("{z} was stored as {stored:?}"))
        },
    );
}

#[test]
fn a_step_in_distance_is_a_step_in_the_buffer() {
    let fixed = prop_oneof![Just(DepthFormat::Bits24), Just(DepthFormat::Bits16)];
    Law::new("surfaces a hundred steps apart have codes a hundred apart (L20)")
        .demand("checked", 0.3)
        .holds_for((strategy::view_volume(), fixed, 0.05_f32..0.9), |(volume, format, share), seen| {
            let distance = -(volume.near + share * (volume.far - volume.near));
            let apart = 100.0 * step_at(format, &volume, distance);
            // The step is that of the first order: the second order is apart / distance of it.
            let linear = apart < 0.002 * distance && apart > 0.0 && distance + apart < -volume.far;
            seen.class("checked", linear);
            if !linear {
                return Ok(());
            }
            // In 64 bits: rounding z to 32 bits costs as much as 24-bit steps are wide.
            let z_of = |distance: f64| {
                let m = canonical_from_camera(&volume).as_dmat4();
                m.project_point3(vec3(0.0, 0.0, -1.0).as_dvec3() * distance).z
            };
            let (d, steps) = (f64::from(distance), 2.0_f64.powi(format.bits() as i32) - 1.0);
            let between = (z_of(d) - z_of(d + f64::from(apart))) * steps / 2.0;
            // The second order: 0.2 of 100; the matrix in 32 bits: its entries carry some roundings each.
            ensure((between - 100.0).abs() < 0.5, || format!("{between} steps"))
        });
}

#[test]
fn colours_are_computed_the_harmonic_number_of_times_on_average() {
    // E16: over all n! orders of n layers, exactly n! · H_n colours a pixel. 1/1 + … + 1/6 = 49/20; 6! · 49/20 = 1764.
    for (n, all_writes) in [(1, 1), (2, 3), (3, 11), (4, 50), (5, 274), (6, 1764)] {
        let mut writes = 0;
        for order in orders((0..n).collect()) {
            let mut image = Image::new(1, 1, Rgb::ZERO);
            let mut depth = DepthBuffer::new(1, 1, DepthFormat::F32);
            let layer = |k: u8| {
                deep(
                    [(-9, -7), (300, -5), (-11, 500)].map(|(x, y)| glam::I64Vec2::new(x, y)),
                    [f32::from(k) / 8.0; 3],
                    [-1.0; 3],
                )
            };
            writes += order
                .iter()
                .map(|k| draw(&layer(*k), |_| Rgb::ONE, &mut image, &mut depth).colored)
                .sum::<u64>();
        }
        assert_eq!(writes, all_writes, "{n} layers");
    }
}

fn orders(layers: Vec<u8>) -> Vec<Vec<u8>> {
    if layers.is_empty() {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for &first in &layers {
        let rest = layers.iter().copied().filter(|k| *k != first).collect();
        all.extend(orders(rest).into_iter().map(|order| [vec![first], order].concat()));
    }
    all
}
