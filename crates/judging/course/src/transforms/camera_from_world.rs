//! Where does the camera see a point of the world? (L1)

use glam::{Mat4, Vec3, Vec4, vec3};
use testkit::by_hand::point3;
use vocabulary::Basis;

use super::drawing;
use super::inputs::{STANDARD, basis};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! From the world to the camera (the pipeline's first two matrices, L1).
//!
//! Give the 4×4 matrix M that turns world coordinates into camera coordinates, M = R · T(−e):
//!
//!     x_u y_u z_u 0     1 0 0 −x_e
//!     x_v y_v z_v 0  ·  0 1 0 −y_e
//!     x_w y_w z_w 0     0 0 1 −z_e
//!      0   0   0  1     0 0 0   1
//!
//! - `eye`: e, where the camera is, in world coordinates.
//! - `frame`: its axes u (right), v (up), w (backwards) in world coordinates: unit vectors at right angles, right-handed.
//! - A point is a column (x, y, z, 1). In camera coordinates the eye is the origin and (a, b, c) means a·u + b·v + c·w from it.
//! - No input is degenerate.
//!
//! glam: `Mat4::from_cols` takes columns, `transpose()` exchanges them for rows, `Mat4::from_translation`, `extend`.

use glam::{Mat4, Vec3};
use vocabulary::Basis;

pub fn camera_from_world(eye: Vec3, frame: Basis) -> Mat4 {
    todo!()
}
"#;

signature!((eye: Vec3, frame: Basis) -> Mat4);

/// The eye is at most 6·√3 < 11 from the origin and a point as far from the eye, so no coordinate is above 22. Making the point
/// takes six roundings, its image eight more, of 22 · 2⁻²⁴ each: 2e-5. The axes are at right angles up to 2⁻²², which
/// counts 11 times: 3e-6. An inverted matrix gets twice as much.
const TOLERANCE: f32 = 6e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "camera_from_world",
        concept: Concept::Transforms,
        items: "L1",
        title: Title { english: "From the world to the camera", dutch: "Van wereld naar camera" },
        prerequisites: &["change_of_basis", "camera_frame"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Two things happen, one after the other: the eye goes to the origin, the axes u, v, w go to x, y, z. Which must \
                be first?",
            "The matrix that acts first stands rightmost: R · T(−e). The rows of R are u, v, w, and glam builds a matrix \
                from columns.",
            "The rows of the product are (u, −u·e), (v, −v·e), (w, −w·e) and (0, 0, 0, 1), with dot products in the last \
                column.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(multiplied_out), program!(inverse_of_the_camera)],
        misconceptions: misconceptions(),
        explanation: "The camera stands at the columns u, v, w, e: that matrix carries camera coordinates to the world, and \
            ours is its inverse. The last column is not −e but (−u·e, −v·e, −w·e): minus the eye, as the camera's own axes \
            measure it. M is rigid: it moves the world without bending it.",
        draw: drawing::world_before_the_camera,
        source: include_str!("camera_from_world.rs"),
    }
}

fn examples() -> Vec<Example> {
    // From (3, 0, 4) the camera looks at the origin, 5 before it.
    let frame = Basis { u: vec3(0.8, 0.0, -0.6), v: Vec3::Y, w: vec3(0.6, 0.0, 0.8) };
    let at_the_origin = Mat4::from_cols(
        Vec4::new(0.8, 0.0, 0.6, 0.0),
        Vec4::new(0.0, 1.0, 0.0, 0.0),
        Vec4::new(-0.6, 0.0, 0.8, 0.0),
        Vec4::new(0.0, 0.0, -5.0, 1.0),
    );
    vec![
        Example::new(
            "axes as in the world, eye at (1, 2, 3)",
            arguments![vec3(1.0, 2.0, 3.0), STANDARD],
            Mat4::from_translation(vec3(-1.0, -2.0, -3.0)),
            TOLERANCE,
        ),
        Example::new(
            "from (3, 0, 4), looking at the origin",
            arguments![vec3(3.0, 0.0, 4.0), frame],
            at_the_origin,
            TOLERANCE,
        ),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_eye_becomes_the_origin",
            2,
            "The eye is the origin of camera space: M·e = (0, 0, 0).",
            "The eye is not carried to the origin: what has to be done to it before the axes are turned?",
        )
        .over((point3(6), basis()), |&(eye, frame), program| {
            let m: Mat4 = program.ask(arguments![eye, frame])?;
            close("M·e", m.transform_point3(eye), Vec3::ZERO, TOLERANCE)
        }),
        Law::of(
            "coordinates_along_the_axes",
            3,
            "The point e + a·u + b·v + c·w has camera coordinates (a, b, c).",
            "A point comes out with other coordinates than it has along u, v, w from the eye. Are u, v, w rows or columns, \
                and what acts first?",
        )
        .over((point3(6), basis(), point3(6)), |&(eye, frame, p_camera), program| {
            let m: Mat4 = program.ask(arguments![eye, frame])?;
            let p_world = eye + p_camera.x * frame.u + p_camera.y * frame.v + p_camera.z * frame.w;
            close("M·(e + a·u + b·v + c·w)", m.transform_point3(p_world), p_camera, TOLERANCE)
        }),
        Law::of(
            "moving_together",
            2,
            "Where camera and point move together, nothing changes: M(e + s)·(p + s) = M(e)·p.",
            "Moving camera and world together changed the picture: does the eye enter in world coordinates, before the axes \
                are turned?",
        )
        .over((point3(3), basis(), point3(3), point3(3)), |&(eye, frame, p, shift), program| {
            let here: Mat4 = program.ask(arguments![eye, frame])?;
            let there: Mat4 = program.ask(arguments![eye + shift, frame])?;
            let (before, after) = (here.transform_point3(p), there.transform_point3(p + shift));
            close("M(e + s)·(p + s)", after, before, TOLERANCE)
        }),
        Law::of(
            "points_stay_points",
            1,
            "The last row is (0, 0, 0, 1): a point stays a point.",
            "The last row is not (0, 0, 0, 1): glam's `from_cols` takes columns. Is the whole matrix transposed?",
        )
        .over((point3(6), basis()), |&(eye, frame), program| {
            let m: Mat4 = program.ask(arguments![eye, frame])?;
            close("the last row", m.row(3), Vec4::W, TOLERANCE)
        }),
    ]
}

fn slide(eye: Vec3, frame: Basis) -> Mat4 {
    let r = glam::Mat3::from_cols(frame.u, frame.v, frame.w).transpose();
    Mat4::from_mat3(r) * Mat4::from_translation(-eye)
}

fn multiplied_out(eye: Vec3, frame: Basis) -> Mat4 {
    let row = |axis: Vec3| axis.extend(-axis.dot(eye));
    Mat4::from_cols(row(frame.u), row(frame.v), row(frame.w), glam::Vec4::W).transpose()
}

fn inverse_of_the_camera(eye: Vec3, frame: Basis) -> Mat4 {
    let Basis { u, v, w } = frame;
    Mat4::from_cols(u.extend(0.0), v.extend(0.0), w.extend(0.0), eye.extend(1.0)).inverse()
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(translated_last),
            looks_like: "the axes are turned first and the eye is subtracted after that",
            help: "The eye is given in world coordinates, so it must be subtracted there: T(−e) acts first and stands on the \
                right.",
        },
        Misconception {
            program: program!(columns_for_rows),
            looks_like: "R has u, v, w as columns",
            help: "The slide's R has u, v, w as rows; `from_cols` makes columns of them. Transpose.",
        },
        Misconception {
            program: program!(world_from_camera),
            looks_like: "the matrix goes from the camera to the world",
            help: "The columns u, v, w, e carry camera coordinates to the world. Here the inverse is wanted.",
        },
        Misconception {
            program: program!(eye_added),
            looks_like: "the eye is added instead of subtracted",
            help: "The eye must come to the origin: move everything by −e.",
        },
        Misconception {
            program: program!(eye_forgotten),
            looks_like: "the eye's position is not used",
            help: "R alone looks from the world's origin, wherever the eye is.",
        },
        Misconception {
            program: program!(transposed),
            looks_like: "the whole matrix is transposed",
            help: "The translation belongs in the last column. Rows read from the slide into `from_cols` come out transposed.",
        },
    ]
}

fn translated_last(eye: Vec3, frame: Basis) -> Mat4 {
    let r = glam::Mat3::from_cols(frame.u, frame.v, frame.w).transpose();
    Mat4::from_translation(-eye) * Mat4::from_mat3(r)
}

fn columns_for_rows(eye: Vec3, frame: Basis) -> Mat4 {
    let r = glam::Mat3::from_cols(frame.u, frame.v, frame.w);
    Mat4::from_mat3(r) * Mat4::from_translation(-eye)
}

fn world_from_camera(eye: Vec3, frame: Basis) -> Mat4 {
    let Basis { u, v, w } = frame;
    Mat4::from_cols(u.extend(0.0), v.extend(0.0), w.extend(0.0), eye.extend(1.0))
}

fn eye_added(eye: Vec3, frame: Basis) -> Mat4 {
    let r = glam::Mat3::from_cols(frame.u, frame.v, frame.w).transpose();
    Mat4::from_mat3(r) * Mat4::from_translation(eye)
}

fn eye_forgotten(_eye: Vec3, frame: Basis) -> Mat4 {
    Mat4::from_mat3(glam::Mat3::from_cols(frame.u, frame.v, frame.w).transpose())
}

fn transposed(eye: Vec3, frame: Basis) -> Mat4 {
    let row = |axis: Vec3| axis.extend(-axis.dot(eye));
    Mat4::from_cols(row(frame.u), row(frame.v), row(frame.w), glam::Vec4::W)
}
