//! How does what the eye sees become a cube? (L3 after L2, E1)

use glam::{Mat4, Vec3, vec3};
use testkit::by_hand::share;
use vocabulary::ViewVolume;
use worker::{Plain, Value};

use super::drawing;
use super::inputs::{two_shares, volume};
use crate::exercise::{arguments, signature};
use crate::law::that;
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! From the camera to the canonical cube (L2 and L3).
//!
//! Give the 4×4 matrix that carries the viewing volume, a pyramid without its top, to the cube [−1, 1]³: S · C · P. P is the
//! perspective matrix (it makes the pyramid a box), C moves the middle of the box to the origin, S scales it:
//!
//!     2/(r−l)    0       0    0     1 0 0 −(l+r)/2     n 0  0    0
//!        0    2/(t−b)    0    0     0 1 0 −(b+t)/2     0 n  0    0
//!        0       0    2/(n−f) 0  ·  0 0 1 −(n+f)/2  ·  0 0 n+f −fn
//!        0       0       0    1     0 0 0     1        0 0  1    0
//!
//! The slide prints r−1, with a one, where it means r−l, and its factors in the order of time (E1).
//!
//! - `volume`: the window's sides `left`, `right`, `bottom`, `top` (l, r, b, t) on the near plane, `near` and `far` (n, f) with
//!   0 > n > f; in camera coordinates.
//! - The image of (x, y, z, 1) is looked at after division by its fourth coordinate: the near plane becomes z = +1, the
//!   far plane z = −1, left and bottom −1, right and top +1. The matrix times any number but 0 is as good.
//! - No input is degenerate: l < r and b < t.
//!
//! glam: `Mat4::from_scale`, `Mat4::from_translation`, `Mat4::from_cols(column, column, column, column)`, `vec3`, `vec4`.

use glam::Mat4;
use vocabulary::ViewVolume;

pub fn canonical_from_camera(volume: ViewVolume) -> Mat4 {
    todo!()
}
"#;

signature!((volume: ViewVolume) -> Mat4);

/// In x and y the sum of two terms below 2·|r|/(r−l) + |l+r|/(r−l) ≤ 11, the worst being l = 4, r = 6. In z the terms are below
/// 2·(2|f|+|n|)/(n−f) ≤ 22, the worst being n = −3, f = −4. Eight roundings, 8 · 22 · 2⁻²⁴ ≈ 1.1e-5; other orders of the same
/// products get twice as much.
const TOLERANCE: f32 = 2.5e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "canonical_from_camera",
        concept: Concept::Transforms,
        items: "L2, L3, E1, E2",
        title: Title {
            english: "From the camera to the canonical cube",
            dutch: "Van camera naar canoniek volume",
        },
        prerequisites: &["perspective"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Three steps: the pyramid becomes a box over the window, the box moves to the origin, and is scaled to [−1, 1]³. \
             What is the middle of [l, r], and how wide is it?",
            "The point meets P first, so P stands rightmost: S · C · P. S after C: once the middle is the origin, half the \
             width r − l must become 1.",
            "Mat4::from_scale(vec3(2/(r−l), 2/(t−b), 2/(n−f))) · Mat4::from_translation(−½ vec3(l+r, b+t, n+f)) · P, with \
                the P of the exercise before.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(multiplied_out), program!(negated_for_clipping)],
        misconceptions: misconceptions(),
        explanation: "After this every volume looks the same: visible is what lies between −1 and 1 in all three \
            coordinates. Here near is +1, so larger z is nearer; OpenGL has near at −1 and w > 0, and its matrix is diag(−1, \
            −1, 1, −1) times this one (E2).",
        draw: drawing::cube_from_pyramid,
        source: include_str!("canonical_from_camera.rs"),
    }
}

/// An example: points and their images, for the matrix or any multiple of it.
fn example(caption: &'static str, volume: ViewVolume, images: [(Vec3, Vec3); 3]) -> Example {
    Example::with_check(caption, arguments![volume], slide(volume), move |given: &Value| {
        // Not a matrix: the worker's signature does not let that happen.
        let m = Mat4::from_value(given.clone()).unwrap_or(Mat4::NAN);
        for (point, image) in images {
            close(&format!("the image of {point}"), m.project_point3(point), image, TOLERANCE)?;
        }
        Ok(())
    })
}

fn examples() -> Vec<Example> {
    let symmetric = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -3.0 };
    let aside = ViewVolume { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0, near: -2.0, far: -6.0 };
    vec![
        example(
            "a window in the middle, n = −1, f = −3",
            symmetric,
            [
                (vec3(1.0, 1.0, -1.0), vec3(1.0, 1.0, 1.0)),
                (vec3(-3.0, 3.0, -3.0), vec3(-1.0, 1.0, -1.0)),
                // n + f − f·n/z = −4 + 3/1.5 = −2, the middle between n and f, comes from z = −1.5.
                (vec3(0.0, 0.0, -1.5), vec3(0.0, 0.0, 0.0)),
            ],
        ),
        example(
            "a window to the side, n = −2, f = −6",
            aside,
            [
                (vec3(3.0, -2.0, -2.0), vec3(1.0, -1.0, 1.0)),
                (vec3(-3.0, 3.0, -6.0), vec3(-1.0, 1.0, -1.0)),
                (vec3(1.0, -0.5, -2.0), vec3(0.0, 0.0, 1.0)),
            ],
        ),
    ]
}

/// Where two shares, from left to right and from bottom to top, lie on the window.
fn on_window(volume: &ViewVolume, across: f32, upwards: f32) -> Vec3 {
    let ViewVolume { left, right, bottom, top, near, .. } = *volume;
    vec3(left + across * (right - left), bottom + upwards * (top - bottom), near)
}

/// The same point, pushed away from the eye along its ray, by a share of the way to the far plane.
fn pushed(volume: &ViewVolume, on_window: Vec3, share: f32) -> Vec3 {
    on_window * (1.0 + share * (volume.far / volume.near - 1.0))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_window_becomes_the_front",
            3,
            "The window [l, r] × [b, t] on the near plane becomes [−1, 1] × [−1, 1] at z = +1, evenly.",
            "A point of the window lands elsewhere on the front of the cube: take a corner of the window through all three \
                steps by hand.",
        )
        .over((volume(), share(), share()), |&(volume, across, upwards), program| {
            let m: Mat4 = program.ask(arguments![volume])?;
            let image = m.project_point3(on_window(&volume, across, upwards));
            close("the image", image, vec3(2.0 * across - 1.0, 2.0 * upwards - 1.0, 1.0), TOLERANCE)
        }),
        Law::of(
            "the_far_plane_becomes_the_back",
            2,
            "The far plane becomes z = −1.",
            "z of the far plane is not −1. Which planes does P leave in place, and where do C and S carry them?",
        )
        .over((volume(), share(), share()), |&(volume, across, upwards), program| {
            let m: Mat4 = program.ask(arguments![volume])?;
            let far = pushed(&volume, on_window(&volume, across, upwards), 1.0);
            close("z of the image", m.project_point3(far).z, -1.0, TOLERANCE)
        }),
        Law::of(
            "rays_become_parallel",
            2,
            "Points on one ray from the eye have images with the same x and y.",
            "Two points that the eye sees in the same direction land on different places: is the perspective in the product, \
                and does it act first?",
        )
        .over((volume(), share(), share(), share()), |&(volume, across, upwards, share), program| {
            let m: Mat4 = program.ask(arguments![volume])?;
            let near = on_window(&volume, across, upwards);
            let beyond = m.project_point3(pushed(&volume, near, share));
            close("x and y of the farther one", beyond.truncate(), m.project_point3(near).truncate(), TOLERANCE)
        }),
        Law::of(
            "nearer_is_larger",
            1,
            "Within the volume a nearer point has the larger z: near is +1, far is −1.",
            "The order of depths is turned round: here near is +1, and larger z is nearer.",
        )
        .over((volume(), share(), share(), two_shares()), |&(volume, across, upwards, shares), program| {
            let m: Mat4 = program.ask(arguments![volume])?;
            let window = on_window(&volume, across, upwards);
            let depth = |share: f32| m.project_point3(pushed(&volume, window, share)).z;
            let (nearer, farther) = (depth(shares.0), depth(shares.1));
            that(nearer > farther, || format!("z of the nearer image is {nearer}, of the farther one {farther}"))
        }),
    ]
}

fn slide(volume: ViewVolume) -> Mat4 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, near: n, far: f } = volume;
    let p = Mat4::from_cols(
        glam::vec4(n, 0.0, 0.0, 0.0),
        glam::vec4(0.0, n, 0.0, 0.0),
        glam::vec4(0.0, 0.0, n + f, 1.0),
        glam::vec4(0.0, 0.0, -f * n, 0.0),
    );
    let c = Mat4::from_translation(-0.5 * glam::vec3(l + r, b + t, n + f));
    let s = Mat4::from_scale(glam::vec3(2.0 / (r - l), 2.0 / (t - b), 2.0 / (n - f)));
    s * c * p
}

fn multiplied_out(volume: ViewVolume) -> Mat4 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, near: n, far: f } = volume;
    let mut m = Mat4::ZERO;
    m.x_axis.x = 2.0 * n / (r - l);
    m.y_axis.y = 2.0 * n / (t - b);
    m.z_axis = glam::vec4((l + r) / (l - r), (b + t) / (b - t), (n + f) / (n - f), 1.0);
    m.w_axis.z = 2.0 * f * n / (f - n);
    m
}

fn negated_for_clipping(volume: ViewVolume) -> Mat4 {
    // From distances and angles, as OpenGL has it, with z turned round so that near is +1; w is positive.
    let window = glam::vec2(volume.right - volume.left, volume.top - volume.bottom);
    let middle = 0.5 * glam::vec2(volume.right + volume.left, volume.top + volume.bottom);
    let (near, far) = (-volume.near, -volume.far);
    let scale = 2.0 * near / window;
    let aside = 2.0 * middle / window;
    let depth = far - near;
    glam::mat4(
        glam::vec4(scale.x, 0.0, 0.0, 0.0),
        glam::vec4(0.0, scale.y, 0.0, 0.0),
        glam::vec4(aside.x, aside.y, (far + near) / depth, -1.0),
        glam::vec4(0.0, 0.0, 2.0 * far * near / depth, 0.0),
    )
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(r_minus_one),
            looks_like: "the window's width is taken for r − 1",
            help: "The slide's r−1 is a misprint (E1): the width of the window is r − l, with the letter l.",
        },
        Misconception {
            program: program!(perspective_forgotten),
            looks_like: "the perspective matrix is not in the product",
            help: "S · C alone carries a box to the cube. The volume is a pyramid: P must make it a box first.",
        },
        Misconception {
            program: program!(factors_in_reading_order),
            looks_like: "the factors stand in the order in which they happen",
            help: "The slide prints the stages in the order of time (E1). With column vectors what acts first stands \
                rightmost: S · C · P.",
        },
        Misconception {
            program: program!(scaled_before_centred),
            looks_like: "the box is scaled first and then moved by its old middle",
            help: "The middle (l+r)/2 is measured before scaling: C acts before S, so S stands to the left of C.",
        },
        Misconception {
            program: program!(window_in_the_middle),
            looks_like: "the window is taken to lie in the middle",
            help: "l + r and b + t need not be 0: the middle of the window must be moved to the origin too.",
        },
        Misconception {
            program: program!(near_at_minus_one),
            looks_like: "near becomes −1 and far +1",
            help: "With 2/(f−n) depth is turned round. n is greater than f, and here near is +1: 2/(n−f).",
        },
        Misconception {
            program: program!(opengl),
            looks_like: "the matrix is OpenGL's, which has near at −1",
            help: "OpenGL's cube is turned round in depth. In the lecture near is z = +1 and far is z = −1.",
        },
    ]
}

// Each of the wrong programs differs from the slide's in one place. What they have in common stands here once, so that the place is seen.

/// P: the pyramid becomes a box.
fn boxed(volume: ViewVolume) -> Mat4 {
    let ViewVolume { near: n, far: f, .. } = volume;
    Mat4::from_cols(
        glam::vec4(n, 0.0, 0.0, 0.0),
        glam::vec4(0.0, n, 0.0, 0.0),
        glam::vec4(0.0, 0.0, n + f, 1.0),
        glam::vec4(0.0, 0.0, -f * n, 0.0),
    )
}

/// C: the box's middle goes to the origin.
fn centred(volume: ViewVolume) -> Mat4 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, near: n, far: f } = volume;
    Mat4::from_translation(-0.5 * glam::vec3(l + r, b + t, n + f))
}

/// S: its sides become 2 long.
fn scaled(volume: ViewVolume) -> Mat4 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, near: n, far: f } = volume;
    Mat4::from_scale(glam::vec3(2.0 / (r - l), 2.0 / (t - b), 2.0 / (n - f)))
}

fn r_minus_one(volume: ViewVolume) -> Mat4 {
    scaled(ViewVolume { left: 1.0, ..volume }) * centred(volume) * boxed(volume)
}

fn perspective_forgotten(volume: ViewVolume) -> Mat4 {
    scaled(volume) * centred(volume)
}

fn factors_in_reading_order(volume: ViewVolume) -> Mat4 {
    boxed(volume) * scaled(volume) * centred(volume)
}

fn scaled_before_centred(volume: ViewVolume) -> Mat4 {
    centred(volume) * scaled(volume) * boxed(volume)
}

fn window_in_the_middle(volume: ViewVolume) -> Mat4 {
    let middle = ViewVolume { left: 0.0, right: 0.0, bottom: 0.0, top: 0.0, ..volume };
    scaled(volume) * centred(middle) * boxed(volume)
}

fn near_at_minus_one(volume: ViewVolume) -> Mat4 {
    let turned = ViewVolume { near: volume.far, far: volume.near, ..volume };
    scaled(turned) * centred(volume) * boxed(volume)
}

fn opengl(volume: ViewVolume) -> Mat4 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, near: n, far: f } = volume;
    let (near, far) = (-n, -f);
    Mat4::from_cols(
        glam::vec4(2.0 * near / (r - l), 0.0, 0.0, 0.0),
        glam::vec4(0.0, 2.0 * near / (t - b), 0.0, 0.0),
        glam::vec4((r + l) / (r - l), (t + b) / (t - b), (near + far) / (near - far), -1.0),
        glam::vec4(0.0, 0.0, 2.0 * near * far / (near - far), 0.0),
    )
}
