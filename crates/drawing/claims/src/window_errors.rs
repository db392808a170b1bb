//! Which point of the window belongs to a pixel, and where is that in the world? (E13, E14)

use glam::{Mat3, Vec2, Vec3, vec2, vec3};
use transforms::viewport::window_from_pixel;
use transforms::{Basis, Pipeline, ViewVolume, affine2};

use crate::sample::{pipeline, short, trials};
use crate::{Claim, Trial, Verdict, judge, stage, text, versions};

pub(super) static WINDOW_POINT: Claim = Claim {
    number: "E13",
    name: "point-on-the-window",
    quote: "s = u_s u + v_s v + n w",
    translation: "s = u_s u + v_s v + n w",
    truth: text(
        "That is s in camera coordinates, or s − e. The point of the world is e + u_s u + v_s v + n w.",
        "Dat is s in cameracoördinaten, of s − e. Het punt in de wereld is e + u_s u + v_s v + n w.",
    ),
    expected: Verdict::HoldsIf(EYE_AT_ORIGIN),
    code: &["raytrace::viewing_ray"],
    examine: || {
        let trials = trials(80, 15, |random| {
            let eye = if random.below(4) == 0 { Vec3::ZERO } else { random.point(5.0) };
            let (ray, slide) = ray_and_slide(eye, random.point(5.0) - 9.0 * Vec3::Z);
            let numbers = format!("s = {} instead of {}", short(slide), short(ray.at(1.0)));
            Trial::under(eye == Vec3::ZERO, slide.abs_diff_eq(ray.at(1.0), 1e-5), numbers)
        });
        let (ray, slide) = ray_and_slide(vec3(5.0, 1.0, 4.0), vec3(6.0, -1.0, -1.0));
        let in_camera = crate::sample::trials(80, 15, |random| {
            let (eye, target) = (random.point(5.0), random.point(5.0) - 9.0 * Vec3::Z);
            let pipeline = pipeline((eye, target), 0.8, (-1.0, -9.0), (64, 48));
            let s = pipeline
                .trace(raytrace::viewing_ray(&pipeline, 50.0, 10.0).at(1.0))
                .screen
                .unwrap_or(Vec3::NAN);
            // World coordinates up to 20, times some fifty pixels a unit.
            Trial::new(s.abs_diff_eq(vec3(50.0, 10.0, 1.0), 1e-3), format!("e + … is seen at {}", short(s)))
        });
        judge("s is the point of the world that the ray passes", Some(EYE_AT_ORIGIN), &trials)
            .with_right("e + u_s u + v_s v + n w is seen in pixel (50, 10)", &in_camera)
            .compared("the eye at (5, 1, 4)", short(slide), short(ray.at(1.0)))
    },
    pictures: None,
    versions: Some(versions::window_point),
};

const EYE_AT_ORIGIN: &str = "the eye is at the origin";

/// The ray of pixel (50, 10), and where the slide has its s.
pub(super) fn ray_and_slide(eye: Vec3, target: Vec3) -> (geometry::Ray, Vec3) {
    let pipeline = pipeline((eye, target), 0.8, (-1.0, -9.0), (64, 48));
    (raytrace::viewing_ray(&pipeline, 50.0, 10.0), slide_window_point(&pipeline, vec2(50.0, 10.0)))
}

fn slide_window_point(pipeline: &Pipeline, pixel: Vec2) -> Vec3 {
    let (volume, Basis { u, v, w }) = (pipeline.volume(), pipeline.camera().basis());
    let s = transforms::viewport::window_point(&volume, pipeline.width(), pipeline.height(), pixel);
    s.x * u + s.y * v + volume.near * w
}

pub(super) static CORNER: Claim = Claim {
    number: "E14",
    name: "zero-in-the-corner",
    quote: "(1 0 0.5; 0 1 0.5; 0 0 0)",
    translation: "the last factor of the window transform",
    truth: text(
        "A 1 belongs in the corner. With 0 the third coordinate is lost, and no pixel is moved by (l, b): the picture shows what lies to the right of and above the origin of the view plane.",
        "In de hoek hoort een 1. Met 0 gaat de derde coördinaat verloren en wordt geen pixel over (l, b) verschoven: het beeld toont wat rechts van en boven de oorsprong van het viewplane ligt.",
    ),
    expected: Verdict::Refuted,
    code: &["transforms::viewport::window_from_pixel"],
    examine: || {
        let volume = ViewVolume { left: -2.0, right: 1.0, bottom: -1.0, top: 2.0, near: -1.0, far: -9.0 };
        let (slide, right) = (slide_window_from_pixel(&volume, 30, 15), window_from_pixel(&volume, 30, 15));
        let trials = trials(50, 16, |random| {
            let pixel = vec3(random.below(30) as f32, random.below(15) as f32, 1.0);
            let (s, r) = (slide * pixel, right * pixel);
            Trial::new(
                s.abs_diff_eq(r, 1e-5),
                format!("pixel {} goes to {}, not {}", short(pixel), short(s), short(r)),
            )
        });
        let pixel = vec3(7.0, 3.0, 1.0);
        let with_one = crate::sample::trials(50, 16, |random| {
            let (i, j) = (random.below(30) as f32, random.below(15) as f32);
            let s = transforms::viewport::window_point(&volume, 30, 15, vec2(i, j));
            Trial::new(
                (right * vec3(i, j, 1.0)).abs_diff_eq(s.extend(1.0), 1e-5),
                format!("pixel ({i}, {j})"),
            )
        });
        judge("the three factors give the printed product", None, &trials)
            .with_right("with 1 in the corner they give (u_s, v_s, 1)", &with_one)
            .compared(
                "pixel (7, 3) of 30 × 15 in the window [−2, 1] × [−1, 2]",
                short(slide * pixel),
                short(right * pixel),
            )
    },
    pictures: Some(stage::window_pair),
    versions: None,
};

/// The three factors as printed.
pub(super) fn slide_window_from_pixel(volume: &ViewVolume, width: u32, height: u32) -> Mat3 {
    let size =
        vec2((volume.right - volume.left) / width as f32, (volume.top - volume.bottom) / height as f32);
    let half = Mat3::from_cols(Vec3::X, Vec3::Y, vec3(0.5, 0.5, 0.0));
    affine2::translate(vec2(volume.left, volume.bottom)) * affine2::scale(size) * half
}
