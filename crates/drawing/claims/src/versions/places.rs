//! Where do points land, and what do matrices do to space? (E1, E2, E13, E15)

use glam::{Vec3, vec3, vec4};
use transforms::projection::{canonical_from_camera, scale};
use transforms::{Basis, change_of_basis};

use super::version;
use crate::Version;
use crate::sample::{pipeline, short};
use crate::transform_errors::{frustum, slide_pipeline, slide_scale, window};
use crate::window_errors::ray_and_slide;
use figures::Words;

/// The six factors in the order of time, and in that in which they act.
pub(crate) fn order_of_factors() -> [Version; 2] {
    let pipeline = pipeline((vec3(1.0, 2.0, 8.0), vec3(0.5, 0.0, 0.0)), 0.8, (-1.0, -20.0), (640, 480));
    let p = vec3(1.0, 0.5, 0.0);
    let lands = |says: &str, at: Vec3| {
        let (p, at) = (short(p), short(at));
        version(
            says,
            format!("{p} lands on {at} of a screen of 640 × 480 pixels"),
            format!("{p} komt terecht op {at} van een scherm van 640 × 480 pixels"),
        )
    };
    [
        lands("R · T · P · S · C · V", slide_pipeline(&pipeline).project_point3(p)),
        lands("V · S · C · P · R · T", pipeline.screen_from_world().project_point3(p)),
    ]
}

/// A window of five units by two letters that look alike.
pub(crate) fn r_minus_one() -> [Version; 2] {
    let volume = window(-2.0, 3.0);
    let width = volume.right - volume.left;
    let becomes = |says: &str, factor: f32| {
        let after = factor * width;
        version(
            says,
            format!("l = −2, r = 3: the window, {width} wide, becomes {after:.1} wide; the cube is 2 wide"),
            format!("l = −2, r = 3: het venster, {width} breed, wordt {after:.1} breed; de kubus is 2 breed"),
        )
    };
    [becomes("2/(r−1)", slide_scale(&volume)), becomes("2/(r−l)", scale(&volume).x_axis.x)]
}

/// One point by the slide's matrices and by OpenGL's.
pub(crate) fn opengl() -> [Version; 2] {
    let (volume, p) = (window(-1.0, 1.0), vec4(0.0, 0.0, -4.0, 1.0));
    let clip = |says: Words, w: f32| {
        version(
            says,
            format!("a point at z = −4 has w = {w:.1}"),
            format!("een punt op z = −4 heeft w = {w:.1}"),
        )
    };
    let opengl = Words::new("OpenGL: diag(−1, −1, 1, −1) · S·C·P", "OpenGL: diag(−1, −1, 1, −1) · S·C·P");
    [clip("S·C·P".into(), (canonical_from_camera(&volume) * p).w), clip(opengl, (frustum(&volume) * p).w)]
}

/// The middle of a pixel, from an eye that is not at the origin.
pub(crate) fn window_point() -> [Version; 2] {
    let eye = vec3(5.0, 1.0, 4.0);
    let (ray, slide) = ray_and_slide(eye, vec3(6.0, -1.0, -1.0));
    let at = |says: &str, s: Vec3| {
        let (eye, s, away) = (short(eye), short(s), s.distance(ray.at(1.0)));
        version(
            says,
            format!("the eye at {eye}: s = {s}, {away:.2} from the ray of the pixel"),
            format!("het oog op {eye}: s = {s}, {away:.2} van de straal van de pixel"),
        )
    };
    [at("s = u_s u + v_s v + n w", slide), at("s = e + u_s u + v_s v + n w", ray.at(1.0))]
}

/// Bases of opposite and of one handedness.
pub(crate) fn handedness() -> [Version; 2] {
    let from = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };
    let carried = |says: Words, w: Vec3| {
        let determinant = change_of_basis(&from, &Basis { u: Vec3::Y, v: Vec3::Z, w }).determinant();
        let [en, nl] = if determinant < 0.0 {
            ["a mirror image", "een spiegeling"]
        } else {
            ["a rotation", "een rotatie"]
        };
        let c = short(w);
        version(
            says,
            format!("a = y, b = z, c = {c}: det M = {determinant}, {en}"),
            format!("a = y, b = z, c = {c}: det M = {determinant}, {nl}"),
        )
    };
    [
        carried(Words::new("any orthonormal a, b, c", "elke orthonormale a, b, c"), -Vec3::X),
        carried(Words::new("a, b and c = a × b", "a, b en c = a × b"), Vec3::Y.cross(Vec3::Z)),
    ]
}
