//! Depth is affine on the screen, everything else is not (E9).

use geometry::{Barycentric, Triangle};
use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use testkit::{Law, assert_close, ensure, ensure_close};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::{Fragment, ScreenTriangle, project};

use super::{HEIGHT, WIDTH, deep, fragments, position};

/// Half a unit in the last place of a number up to 1: what rounding a result in [0, 1] to `f32` costs at most.
const ROUNDING: f32 = f32::EPSILON / 4.0;

fn triangle() -> impl Strategy<Value = ScreenTriangle> {
    let corners = [position(30), position(30), position(30)];
    let depths = [-1.0_f32..1.0, -1.0..1.0, -1.0..1.0];
    let inv_w = [-5.0_f32..-0.01, -5.0..-0.01, -5.0..-0.01];
    (corners, depths, inv_w).prop_map(|(corners, z, inv_w)| deep(corners, z, inv_w))
}

#[test]
fn depth_is_affine_on_the_screen_and_stays_between_the_vertices() {
    Law::new("z is that of the plane through the vertices, within their range")
        .cases(1000)
        .demand("drawn", 0.4)
        .holds_for(triangle(), |triangle, seen| {
            let drawn = fragments(&triangle);
            seen.class("drawn", !drawn.is_empty());
            let [a, b, c] = triangle.vertices.map(|v| v.position);
            // The plane n · (p − a) = 0, solved for z: another way than by edge functions.
            let n = (b - a).cross(c - a);
            let z_of =
                |f: &Fragment| a.z - (n.x * (f64::from(f.i) - a.x) + n.y * (f64::from(f.j) - a.y)) / n.z;
            let z = triangle.vertices.map(|v| v.position.z);
            let (least, greatest) = (z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2]));
            for f in &drawn {
                ensure(least <= f.z && f.z <= greatest, || format!("{f:?} leaves {least}..{greatest}"))?;
                // The 64-bit errors of a plane this steep.
                ensure((f.z - z_of(f)).abs() <= 1e-9, || format!("{f:?}, not {}", z_of(f)))?;
            }
            Ok(())
        });
}

#[test]
fn weights_sum_to_one_and_none_is_negative() {
    Law::new("weights are in [0, 1] and sum to 1").cases(1000).demand("drawn", 0.4).holds_for(
        triangle(),
        |t, seen| {
            let drawn = fragments(&t);
            seen.class("drawn", !drawn.is_empty());
            for f in drawn {
                let Barycentric { alpha, beta, gamma } = f.weights;
                ensure([alpha, beta, gamma].iter().all(|w| (0.0..=1.0).contains(w)), || format!("{f:?}"))?;
                // Three roundings.
                let sum = f64::from(alpha) + f64::from(beta) + f64::from(gamma);
                ensure_close("sum", sum as f32, 1.0, 3.0 * ROUNDING + f32::EPSILON / 2.0)?;
            }
            Ok(())
        },
    );
}

#[test]
fn weights_reproduce_the_screen_position() {
    Law::new("with equal w the weights give back the pixel's centre")
        .cases(1000)
        .demand("drawn", 0.4)
        .holds_for([position(30), position(30), position(30)], |corners, seen| {
            let triangle = deep(corners, [0.0; 3], [-0.3; 3]);
            let drawn = fragments(&triangle);
            seen.class("drawn", !drawn.is_empty());
            for f in drawn {
                let [a, b, c] = triangle.vertices.map(|v| v.position);
                let weights = f.weights.to_vec3().as_dvec3();
                let p = (weights.x * a + weights.y * b + weights.z * c).as_vec3();
                // Three rounded weights times coordinates of at most 54, and the rounding of the position itself.
                let bound = 4.0 * ROUNDING * 54.0;
                ensure_close("position", p, vec3(f.i as f32, f.j as f32, 0.0), bound)?;
            }
            Ok(())
        });
}

/// Where the camera is: not at the origin, where all multiples of a point lie under one pixel.
const EYE: Vec3 = vec3(3.0, -2.0, 5.0);

/// A camera that looks along −z, and a triangle before it, from 1 to 40 units away.
fn view_and_triangle() -> impl Strategy<Value = (Pipeline, Triangle)> {
    let corner =
        (-1.0_f32..1.0, -1.0_f32..1.0, 1.0_f32..40.0).prop_map(|(x, y, d)| EYE + vec3(x * d, y * d, -d));
    (-0.9_f32..-0.3, 0.4_f32..1.0, [corner.clone(), corner.clone(), corner]).prop_map(
        |(left, right, [a, b, c])| {
            let volume = ViewVolume { left, right, bottom: -0.7, top: 0.5, near: -0.8, far: -50.0 };
            let camera = Camera::look_at(EYE, EYE - Vec3::Z, Vec3::Y).expect("a fixed camera");
            (Pipeline::new(camera, volume, WIDTH, HEIGHT).expect("a valid volume"), Triangle::new(a, b, c))
        },
    )
}

/// Where a point of the world is on the screen, in 64 bits.
fn pixel_of(view: &Pipeline, p_world: DVec3) -> (f64, f64) {
    let clip = view.clip_from_world().as_dmat4() * p_world.extend(1.0);
    let to_pixel = |canonical: f64, side: u32| (0.5 * (canonical + 1.0)) * f64::from(side) - 0.5;
    (to_pixel(clip.x / clip.w, WIDTH), to_pixel(clip.y / clip.w, HEIGHT))
}

/// The greatest distance, in pixels, from a fragment's centre to where its weights lie on the screen.
fn worst_distance(
    view: &Pipeline,
    t: &Triangle,
    drawn: &[Fragment],
    weights: impl Fn(&Fragment) -> DVec3,
) -> f64 {
    let [a, b, c] = t.corners().map(|p| p.as_dvec3());
    let distance = |f: &Fragment| {
        let weights = weights(f);
        let (x, y) = pixel_of(view, weights.x * a + weights.y * b + weights.z * c);
        (x - f64::from(f.i)).abs().max((y - f64::from(f.j)).abs())
    };
    drawn.iter().map(distance).fold(0.0, f64::max)
}

#[test]
fn weights_give_the_world_point_under_the_pixel_and_affine_ones_do_not() {
    // Snapping moves a vertex by at most half of 1/256 pixel, and the point under the pixel no farther. Rounding: clip
    // coordinates are sums of at most four products, error below 4ε of terms as large as 12 · w (the eye's 5 units count
    // at distance 1), that is 48ε · half a screen (12 pixels); a weight's error counts up to 40-fold (the ratio of
    // depths) on 70 pixels of triangle.
    const BOUND: f64 = 0.5 / 256.0 + (48.0 * 12.0 + 40.0 * 70.0) * f32::EPSILON as f64;
    Law::new("perspective-correct weights give the world point that the pixel shows; affine weights do not")
        .cases(1000)
        .demand("drawn", 0.5)
        .demand("affine weights miss by more than a pixel", 0.2)
        .holds_for(view_and_triangle(), |(view, triangle), seen| {
            let polygon = project(&view.clip_from_world(), WIDTH, HEIGHT, &triangle);
            let screen: Vec<_> = polygon.triangles().collect();
            // Nothing is cut here, so that the screen's triangle has the corners of the world's.
            let [screen] = screen[..] else {
                return Err(TestCaseError::fail("cut"));
            };
            let drawn = fragments(&screen);
            seen.class("drawn", !drawn.is_empty());
            let correct = worst_distance(&view, &triangle, &drawn, |f| f.weights.to_vec3().as_dvec3());
            // The affine weights on the screen: what equal w would give.
            let affine_screen = ScreenTriangle {
                vertices: screen.vertices.map(|v| zbuffer::ScreenVertex { inv_w: -1.0, ..v }),
            };
            let affine = worst_distance(&view, &triangle, &fragments(&affine_screen), |f| {
                f.weights.to_vec3().as_dvec3()
            });
            seen.class("affine weights miss by more than a pixel", affine > 1.0);
            ensure(correct <= BOUND, || format!("{correct} pixels off, allowed is {BOUND}"))
        });
}

#[test]
fn halfway_on_the_screen_between_depths_2_and_50_lies_depth_3_85() {
    // E9: the slide interpolates z over the pixels, without saying which. A floor whose edge runs from z = −2 to −50.
    let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -100.0 };
    let camera = Camera::look_at(Vec3::ZERO, vec3(0.0, 0.0, -1.0), Vec3::Y).unwrap();
    let view = Pipeline::new(camera, volume, 21, 21).unwrap();
    // Columns 2 and 18 of row 10: canonical x = −16/21 and 16/21, y = 0.
    let on_ray = |x: f32, z: f32| vec3(x * -z, 0.0, z);
    let triangle =
        Triangle::new(on_ray(-16.0 / 21.0, -2.0), on_ray(16.0 / 21.0, -50.0), vec3(0.0, -3.0, -4.0));
    let screen = project(&view.clip_from_world(), 21, 21, &triangle).triangles().next().unwrap();
    let mut middle = None;
    zbuffer::rasterize(&screen, 21, 21, |f| {
        if (f.i, f.j) == (10, 10) {
            middle = Some(f);
        }
    });
    let z_camera = triangle.point(middle.expect("the top edge belongs to the triangle").weights).z;
    // 1/z is the mean of −1/2 and −1/50. Snapping is exact here to within ε; the far corner counts 50-fold.
    assert_close("z_camera", z_camera, -1.0 / 0.26, 50.0 * 8.0 * f32::EPSILON);
    let slide = 0.5 * (-2.0 + -50.0);
    assert!((z_camera - slide).abs() > 22.0, "the slide's {slide} is far off");
}
