//! The ray from the eye through a pixel's centre (L46, L9, E13).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{axes, between, coordinate, point3};
use vocabulary::{Basis, Ray, ViewVolume};

use super::drawing;
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The viewing ray of a pixel (L46, L9).
//!
//! Give the ray p(t) = e + t(s − e) from the eye e through the centre s of the pixel (i, j) in the window:
//!
//!     u_s = l + (r − l)(i + ½)/n_x
//!     v_s = b + (t − b)(j + ½)/n_y
//!     s = u_s u + v_s v + n w       in camera coordinates, where the eye is the origin
//!
//! - `eye`: e, in world coordinates. `basis`: the camera's axes u, v, w, in world coordinates too; it looks along −w.
//! - `volume`: left l, right r, bottom b, top t of the window, and its plane w = n (near), n < 0.
//! - `width`, `height`: n_x and n_y, the number of pixels. `i`, `j`: the pixel; i runs to the right, j upwards, both from 0.
//! - Give the ray in world coordinates, its direction with the length that makes p(1) = s. No input is degenerate.

use glam::Vec3;
use vocabulary::{Basis, Ray, ViewVolume};

pub fn viewing_ray(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    todo!()
}
"#;

signature!((eye: Vec3, basis: Basis, volume: ViewVolume, width: u32, height: u32, i: u32, j: u32) -> Ray);

/// The eye's coordinates are at most 6, those of the window and its plane at most 8. u_s and v_s take three roundings of such
/// numbers, a coordinate of the direction three products and two sums below 24, to form the world point s and to subtract e
/// again two more below 30: together 3·3·8·2⁻²⁴ + 3·8·2⁻²⁴ + 2·24·2⁻²⁴ + 2·30·2⁻²⁴ < 1.3e-5. The laws add a product or two.
const TOLERANCE: f32 = 3e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "viewing_ray",
        concept: Concept::Raytrace,
        items: "L46, L9, E13",
        title: Title { english: "The viewing ray of a pixel", dutch: "De viewing ray van een pixel" },
        prerequisites: &["window_from_pixel"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "A ray has a start and a direction. All viewing rays start at the same point; which one?",
            "First find u_s and v_s; write `i as f32`, for u32 divides as whole numbers. Then go u_s along u, v_s along v, n along w.",
            "In the world the point is e + u_s u + v_s v + n w. The direction is that point minus e, so e drops out of it.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(through_the_world_point), program!(from_the_middle_of_the_window)],
        misconceptions: misconceptions(),
        explanation: "The slide's s is written in camera coordinates, so it is an arrow from the eye: it is s − e already. The direction \
            keeps its length, and t = 1 is the near plane for every pixel, t = f/n the far plane. With a direction of length 1 the near plane \
            would lie at another t for each pixel.",
        draw: drawing::ray_through_the_window,
        source: include_str!("viewing_ray.rs"),
    }
}

fn examples() -> Vec<Example> {
    let straight = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };
    let wide = ViewVolume { left: -2.0, right: 2.0, bottom: -1.0, top: 3.0, near: -1.0, far: -9.0 };
    let along_x = Basis { u: Vec3::Z, v: Vec3::Y, w: Vec3::NEG_X };
    let beside = ViewVolume { left: -1.0, right: 3.0, bottom: -2.0, top: 2.0, near: -2.0, far: -10.0 };
    vec![
        Example::new(
            "the lower right pixel of 8 × 4, looking along −z",
            arguments![vec3(5.0, 0.0, 4.0), straight, wide, 8_u32, 4_u32, 7_u32, 0_u32],
            Ray { origin: vec3(5.0, 0.0, 4.0), direction: vec3(1.75, -0.5, -1.0) },
            TOLERANCE,
        ),
        Example::new(
            "pixel (1, 2) of 4 × 8, looking along x",
            arguments![vec3(1.0, 2.0, 3.0), along_x, beside, 4_u32, 8_u32, 1_u32, 2_u32],
            Ray { origin: vec3(1.0, 2.0, 3.0), direction: vec3(2.0, -0.75, 0.5) },
            TOLERANCE,
        ),
    ]
}

/// An eye and its axes.
fn camera() -> impl Strategy<Value = (Vec3, Basis)> + Clone {
    (point3(6), axes()).prop_map(|(eye, [u, v, w])| (eye, Basis { u, v, w }))
}

/// A viewing volume, usually not about the middle.
fn volume() -> impl Strategy<Value = ViewVolume> + Clone {
    let sizes = (between(1, 4), between(1, 4), between(1, 4), between(1, 8));
    (coordinate(4), coordinate(4), sizes).prop_map(|(left, bottom, (width, height, near, depth))| {
        ViewVolume {
            left,
            right: left + width,
            bottom,
            top: bottom + height,
            near: -near,
            far: -near - depth,
        }
    })
}

/// A number of pixels, at least two, and one of them that is not the last.
fn pixel() -> impl Strategy<Value = (u32, u32)> + Clone {
    (2..=12_u32, 0..11_u32).prop_map(|(count, i)| (count, i % (count - 1)))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "it_starts_at_the_eye",
            1,
            "The ray starts at the eye: p(0) = e.",
            "All viewing rays start in one point. Where is the window only passed?",
        )
        .over((camera(), volume(), pixel(), pixel()), |&((eye, basis), volume, (width, i), (height, j)), program| {
            let ray: Ray = program.ask(arguments![eye, basis, volume, width, height, i, j])?;
            close("p(0)", ray.origin, eye, TOLERANCE)
        }),
        Law::of(
            "t_is_1_in_the_window",
            2,
            "At t = 1 the ray is in the window's plane: (s − e)·w = n.",
            "The plane is not reached at t = 1. Which sign has n, which length the direction, and is it e's place in the world that slipped in?",
        )
        .over((camera(), volume(), pixel(), pixel()), |&((eye, basis), volume, (width, i), (height, j)), program| {
            let ray: Ray = program.ask(arguments![eye, basis, volume, width, height, i, j])?;
            close("d·w", ray.direction.dot(basis.w), volume.near, TOLERANCE)
        }),
        Law::of(
            "opposite_corners_are_even",
            2,
            "The samples lie evenly in the window: halfway between the first and the last pixel's s is the window's centre.",
            "All samples are shifted to one side. Where in the pixel is its centre?",
        )
        .over((camera(), volume(), pixel(), pixel()), |&((eye, basis), volume, (width, _), (height, _)), program| {
            let first: Ray = program.ask(arguments![eye, basis, volume, width, height, 0_u32, 0_u32])?;
            let last: Ray = program.ask(arguments![eye, basis, volume, width, height, width - 1, height - 1])?;
            let middle = (first.direction + last.direction) / 2.0;
            let (centre_u, centre_v) = ((volume.left + volume.right) / 2.0, (volume.bottom + volume.top) / 2.0);
            close("the middle along u", middle.dot(basis.u), centre_u, TOLERANCE)?;
            close("the middle along v", middle.dot(basis.v), centre_v, TOLERANCE)
        }),
        Law::of(
            "a_pixel_to_the_right",
            2,
            "The pixel to the right has its s one pixel's width further along u: (r − l)/n_x.",
            "The step from one column to the next is wrong: how many pixels share the window's width?",
        )
        .over((camera(), volume(), pixel(), pixel()), |&((eye, basis), volume, (width, i), (height, j)), program| {
            let here: Ray = program.ask(arguments![eye, basis, volume, width, height, i, j])?;
            let right: Ray = program.ask(arguments![eye, basis, volume, width, height, i + 1, j])?;
            let step = (volume.right - volume.left) / width as f32 * basis.u;
            close("the step to the right", right.direction - here.direction, step, TOLERANCE)
        }),
        Law::of(
            "a_pixel_up",
            2,
            "The pixel with the next j has its s one pixel's height further along v, upwards: (t − b)/n_y.",
            "The step from one row to the next is wrong: which way does j run, and how many pixels share the window's height?",
        )
        .over((camera(), volume(), pixel(), pixel()), |&((eye, basis), volume, (width, i), (height, j)), program| {
            let here: Ray = program.ask(arguments![eye, basis, volume, width, height, i, j])?;
            let above: Ray = program.ask(arguments![eye, basis, volume, width, height, i, j + 1])?;
            let step = (volume.top - volume.bottom) / height as f32 * basis.v;
            close("the step upwards", above.direction - here.direction, step, TOLERANCE)
        }),
    ]
}

fn slide(eye: Vec3, basis: Basis, volume: ViewVolume, width: u32, height: u32, i: u32, j: u32) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * (i as f32 + 0.5) / width as f32;
    let v_s = volume.bottom + (volume.top - volume.bottom) * (j as f32 + 0.5) / height as f32;
    Ray { origin: eye, direction: u_s * basis.u + v_s * basis.v + volume.near * basis.w }
}

fn through_the_world_point(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    // The slide's window matrix, with its corner 1 (E14), then the camera's own axes as columns.
    let (across, up) =
        ((volume.right - volume.left) / width as f32, (volume.top - volume.bottom) / height as f32);
    let window = glam::mat3(
        glam::vec3(across, 0.0, 0.0),
        glam::vec3(0.0, up, 0.0),
        glam::vec3(0.5 * across + volume.left, 0.5 * up + volume.bottom, 1.0),
    );
    let on_window = window * glam::vec3(i as f32, j as f32, 1.0);
    let s_camera = glam::vec3(on_window.x, on_window.y, volume.near);
    let s_world = eye + glam::Mat3::from_cols(basis.u, basis.v, basis.w) * s_camera;
    Ray { origin: eye, direction: s_world - eye }
}

fn from_the_middle_of_the_window(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    // Counted in half pixels from the centre, which is exact.
    let halves = |k: u32, count: u32| (2 * k + 1) as f32 - count as f32;
    let window = glam::vec2(volume.right - volume.left, volume.top - volume.bottom);
    let centre = 0.5 * glam::vec2(volume.left + volume.right, volume.bottom + volume.top);
    let away = glam::vec2(halves(i, width) / (2 * width) as f32, halves(j, height) / (2 * height) as f32);
    let place = centre + away * window;
    let direction = basis.w * volume.near + basis.v * place.y + basis.u * place.x;
    Ray { origin: eye, direction }
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(s_taken_for_a_world_point),
            looks_like: "s is taken for a point of the world, and e is subtracted from it",
            help: "u_s u + v_s v + n w is counted from the eye: it is s − e already. Subtracting e takes it away twice.",
        },
        Misconception {
            program: program!(corners_of_pixels),
            looks_like: "the ray goes through the pixel's lower left corner",
            help: "Pixel i reaches from i − ½ to i + ½ on the screen, and the screen begins at −½: its centre is i + ½ pixels from the left side.",
        },
        Misconception {
            program: program!(along_plus_w),
            looks_like: "the ray leaves backwards, along +w",
            help: "n is negative already: n·w points along −w. One more minus turns the ray round.",
        },
        Misconception {
            program: program!(rows_from_above),
            looks_like: "j runs downwards, as the rows of an image file",
            help: "In the lecture j runs upwards: row 0 lies at the window's lower side b.",
        },
        Misconception {
            program: program!(of_length_one),
            looks_like: "the direction is brought to length 1",
            help: "p(1) = s holds only if the direction is all of s − e. Do not normalize it.",
        },
        Misconception {
            program: program!(one_pixel_too_few),
            looks_like: "the window is divided by n_x − 1 and n_y − 1, from edge to edge",
            help: "n_x pixels lie side by side, each (r − l)/n_x wide. The division by n_x − 1 puts the outer pixels' centres onto the window's edge.",
        },
        Misconception {
            program: program!(starts_in_the_window),
            looks_like: "the ray starts in the window",
            help: "p(0) = e: the ray starts at the eye and passes the window at t = 1.",
        },
        Misconception {
            program: program!(divided_as_whole_numbers),
            looks_like: "i / n_x is divided as whole numbers, which gives 0",
            help: "u32 / u32 drops what is behind the point. Convert first: `i as f32 / width as f32`.",
        },
    ]
}

fn s_taken_for_a_world_point(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * (i as f32 + 0.5) / width as f32;
    let v_s = volume.bottom + (volume.top - volume.bottom) * (j as f32 + 0.5) / height as f32;
    let s = u_s * basis.u + v_s * basis.v + volume.near * basis.w;
    Ray { origin: eye, direction: s - eye }
}

fn corners_of_pixels(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * i as f32 / width as f32;
    let v_s = volume.bottom + (volume.top - volume.bottom) * j as f32 / height as f32;
    Ray { origin: eye, direction: u_s * basis.u + v_s * basis.v + volume.near * basis.w }
}

fn along_plus_w(eye: Vec3, basis: Basis, volume: ViewVolume, width: u32, height: u32, i: u32, j: u32) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * (i as f32 + 0.5) / width as f32;
    let v_s = volume.bottom + (volume.top - volume.bottom) * (j as f32 + 0.5) / height as f32;
    Ray { origin: eye, direction: u_s * basis.u + v_s * basis.v - volume.near * basis.w }
}

fn rows_from_above(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * (i as f32 + 0.5) / width as f32;
    let v_s = volume.top - (volume.top - volume.bottom) * (j as f32 + 0.5) / height as f32;
    Ray { origin: eye, direction: u_s * basis.u + v_s * basis.v + volume.near * basis.w }
}

fn of_length_one(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * (i as f32 + 0.5) / width as f32;
    let v_s = volume.bottom + (volume.top - volume.bottom) * (j as f32 + 0.5) / height as f32;
    let direction = u_s * basis.u + v_s * basis.v + volume.near * basis.w;
    Ray { origin: eye, direction: direction.normalize() }
}

fn one_pixel_too_few(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * i as f32 / (width as f32 - 1.0);
    let v_s = volume.bottom + (volume.top - volume.bottom) * j as f32 / (height as f32 - 1.0);
    Ray { origin: eye, direction: u_s * basis.u + v_s * basis.v + volume.near * basis.w }
}

fn starts_in_the_window(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * (i as f32 + 0.5) / width as f32;
    let v_s = volume.bottom + (volume.top - volume.bottom) * (j as f32 + 0.5) / height as f32;
    let direction = u_s * basis.u + v_s * basis.v + volume.near * basis.w;
    Ray { origin: eye + direction, direction }
}

fn divided_as_whole_numbers(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    let u_s = volume.left + (volume.right - volume.left) * ((i / width) as f32 + 0.5 / width as f32);
    let v_s = volume.bottom + (volume.top - volume.bottom) * ((j / height) as f32 + 0.5 / height as f32);
    Ray { origin: eye, direction: u_s * basis.u + v_s * basis.v + volume.near * basis.w }
}
