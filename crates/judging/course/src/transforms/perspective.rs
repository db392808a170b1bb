//! How does a pyramid become a box? By the perspective matrix (L2, E2).

use glam::{Mat4, Vec3, vec3};
use testkit::by_hand::{point2, share};
use worker::{Plain, Value};

use super::drawing;
use super::inputs::{near_and_far, two_shares};
use crate::exercise::{arguments, signature};
use crate::law::that;
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The perspective matrix (L2).
//!
//! Give the 4×4 matrix P that turns the pyramid between the near and the far plane into a box:
//!
//!     n 0  0    0
//!     0 n  0    0
//!     0 0 n+f −fn
//!     0 0  1    0
//!
//! P maps a point (x, y, z, 1) of camera space to (x', y', z', w'); the image is (x'/w', y'/w', z'/w'), after division by w'.
//! Points of the near plane stay where they are; points of the far plane keep their z; what lies between keeps its order.
//!
//! - `near`, `far`: n and f, the z-coordinates of the two planes. The camera looks along −z, so both are negative: 0 > n > f.
//!   The slides never say so (E2).
//! - No input is degenerate. Only the images after division are looked at: P times any number but 0 is as good.
//!
//! glam: `Mat4::from_cols(column, column, column, column)`, `vec4`; four columns, not rows.

use glam::Mat4;

pub fn perspective(near: f32, far: f32) -> Mat4 {
    todo!()
}
"#;

signature!((near: f32, far: f32) -> Mat4);

/// An image's z is ((n+f)·z − f·n)/z with |n| ≤ 3, |z| ≤ |f| ≤ 15, |z| ≥ |n|: both terms over z are below |n| + 2·|f| ≤ 33. Four
/// roundings, and one more an entry where P is multiplied by a number: 5 · 33 · 2⁻²⁴ ≈ 1e-5. Coordinates x, y are at most 6·15.
const TOLERANCE: f32 = 2e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "perspective",
        concept: Concept::Transforms,
        items: "L2, E2",
        title: Title { english: "The perspective matrix", dutch: "De perspectiefmatrix" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "A matrix cannot divide by z, but the division by w' follows anyway: which row makes w' equal to z?",
            "x/z times n is the image on the near plane: the first two rows have n on the diagonal. Then z'/w' = (a·z + \
             b)/z: find a and b so that z = n and z = f stay.",
            "a·n + b = n² and a·f + b = f² give a = n + f and b = −f·n. n + f stands in the third column; −f·n in the fourth, \
             and the 1 of the last row in the third.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(divided_by_near), program!(negated), program!(from_two_conditions)],
        misconceptions: misconceptions(),
        explanation: "n and f are negative here, and so is w' = z for all that is visible: whoever clips by −w ≤ x ≤ w needs \
            w > 0 and so the negated matrix, which has the same images (E2). z'/w' = n + f − f·n/z: depth is squeezed \
            towards the far plane, which is why a z-buffer's steps are coarse there.",
        draw: drawing::box_from_pyramid,
        source: include_str!("perspective.rs"),
    }
}

/// An example: points and their images, for P or any multiple.
fn example(caption: &'static str, near: f32, far: f32, images: [(Vec3, Vec3); 2]) -> Example {
    Example::with_check(caption, arguments![near, far], slide(near, far), move |given: &Value| {
        // Not a matrix: the worker's signature does not let that happen.
        let p = Mat4::from_value(given.clone()).unwrap_or(Mat4::NAN);
        for (point, image) in images {
            close(&format!("the image of {point}"), p.project_point3(point), image, TOLERANCE)?;
        }
        Ok(())
    })
}

fn examples() -> Vec<Example> {
    vec![
        example(
            "n = −1, f = −3: a corner of the near plane stays, three times as far is a third as large",
            -1.0,
            -3.0,
            [(vec3(2.0, 1.0, -1.0), vec3(2.0, 1.0, -1.0)), (vec3(6.0, 3.0, -3.0), vec3(2.0, 1.0, -3.0))],
        ),
        // (n + f) − f·n/z = −52 + 100/4 = −27.
        example(
            "n = −2, f = −50: at z = −4 half the size",
            -2.0,
            -50.0,
            [(vec3(3.0, 1.0, -4.0), vec3(1.5, 0.5, -27.0)), (vec3(0.0, 0.0, -50.0), vec3(0.0, 0.0, -50.0))],
        ),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_near_plane_stays",
            2,
            "Points of the near plane stay where they are: z = n.",
            "A point of the near plane moved: put z = n into every row by hand, and divide by w'.",
        )
        .over((near_and_far(), point2(6)), |&((near, far), p), program| {
            let m: Mat4 = program.ask(arguments![near, far])?;
            let p = p.extend(near);
            close("the image", m.project_point3(p), p, TOLERANCE)
        }),
        Law::of(
            "the_far_plane_keeps_its_depth",
            2,
            "Points of the far plane keep their z: z = f.",
            "A point of the far plane has another z: put z = f into the third row, and divide by w'.",
        )
        .over((near_and_far(), point2(6)), |&((near, far), p), program| {
            let m: Mat4 = program.ask(arguments![near, far])?;
            close("z of the image", m.project_point3(p.extend(far)).z, far, TOLERANCE)
        }),
        Law::of(
            "rays_become_parallel",
            2,
            "Points on one ray from the eye have images with the same x and y.",
            "Two points that the eye sees in the same direction land on different places: what is w', and does it grow with \
                the distance?",
        )
        .over((near_and_far(), point2(6), share()), |&((near, far), p, share), program| {
            let m: Mat4 = program.ask(arguments![near, far])?;
            let on_near = p.extend(near);
            let beyond = on_near * (1.0 + share * (far / near - 1.0));
            let (first, second) = (m.project_point3(on_near), m.project_point3(beyond));
            close("x and y of the farther one", second.truncate(), first.truncate(), TOLERANCE)
        }),
        Law::of(
            "nearer_stays_nearer",
            2,
            "Between the planes a nearer point has the greater z, before and after.",
            "The order of depths changed: z'/w' should fall from n to f. What sign has each entry of the third row?",
        )
        .over((near_and_far(), point2(6), two_shares()), |&((near, far), p, shares), program| {
            let m: Mat4 = program.ask(arguments![near, far])?;
            let depth = |share: f32| m.project_point3(p.extend(near + share * (far - near))).z;
            let (nearer, farther) = (depth(shares.0), depth(shares.1));
            that(nearer > farther, || format!("z of the nearer image is {nearer}, of the farther one {farther}"))
        }),
    ]
}

fn slide(near: f32, far: f32) -> Mat4 {
    let (n, f) = (near, far);
    Mat4::from_cols(
        glam::vec4(n, 0.0, 0.0, 0.0),
        glam::vec4(0.0, n, 0.0, 0.0),
        glam::vec4(0.0, 0.0, n + f, 1.0),
        glam::vec4(0.0, 0.0, -f * n, 0.0),
    )
}

fn divided_by_near(near: f32, far: f32) -> Mat4 {
    // The book's other form: x and y untouched, w' = z/n.
    let mut p = Mat4::IDENTITY;
    p.z_axis.z = (near + far) / near;
    p.z_axis.w = 1.0 / near;
    p.w_axis.z = -far;
    p.w_axis.w = 0.0;
    p
}

fn negated(near: f32, far: f32) -> Mat4 {
    let rows = glam::mat4(
        glam::vec4(-near, 0.0, 0.0, 0.0),
        glam::vec4(0.0, -near, 0.0, 0.0),
        glam::vec4(0.0, 0.0, -(near + far), far * near),
        glam::vec4(0.0, 0.0, -1.0, 0.0),
    );
    rows.transpose()
}

fn from_two_conditions(near: f32, far: f32) -> Mat4 {
    // a·z + b = z² at z = n and at z = f: the line through two points of the parabola.
    let slope = (near * near - far * far) / (near - far);
    let offset = near * near - slope * near;
    let mut p = Mat4::from_diagonal(glam::vec4(near, near, slope, 0.0));
    p.col_mut(3)[2] = offset;
    p.col_mut(2)[3] = 1.0;
    p
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(product_with_plus),
            looks_like: "the entry f·n has no minus sign",
            help: "(n+f)·z − f·n at z = n is n², which divided by z gives n. With a plus sign near and far change their order.",
        },
        Misconception {
            program: program!(transposed),
            looks_like: "rows and columns are exchanged",
            help: "`from_cols` takes columns: rows read from the slide, one after the other, come out transposed.",
        },
        Misconception {
            program: program!(far_for_near),
            looks_like: "x and y are multiplied by f instead of n",
            help: "The view plane is the near plane: what lies there keeps its size, so n stands in the first two rows.",
        },
        Misconception {
            program: program!(planes_taken_for_distances),
            looks_like: "near and far are made positive",
            help: "n and f are coordinates, negative before the eye, and the slide's matrix wants them so. Nothing is to be \
                negated.",
        },
        Misconception {
            program: program!(depth_lost),
            looks_like: "every depth becomes n",
            help: "With n on the diagonal of the third row all points land on the view plane: the picture is right, but the \
                order of depths is lost.",
        },
        Misconception {
            program: program!(nothing_divides),
            looks_like: "the last row is (0, 0, 0, 1)",
            help: "w' must be z: then the division by w' makes far things small. The last row is (0, 0, 1, 0).",
        },
        Misconception {
            program: program!(minus_one_in_the_last_row),
            looks_like: "w' is −z, as in OpenGL, and the other rows are the slide's",
            help: "One row with another sign mirrors everything: either all of the matrix is negated, or nothing.",
        },
    ]
}

fn product_with_plus(near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        glam::vec4(near, 0.0, 0.0, 0.0),
        glam::vec4(0.0, near, 0.0, 0.0),
        glam::vec4(0.0, 0.0, near + far, 1.0),
        glam::vec4(0.0, 0.0, far * near, 0.0),
    )
}

fn transposed(near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        glam::vec4(near, 0.0, 0.0, 0.0),
        glam::vec4(0.0, near, 0.0, 0.0),
        glam::vec4(0.0, 0.0, near + far, -far * near),
        glam::vec4(0.0, 0.0, 1.0, 0.0),
    )
}

fn far_for_near(near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        glam::vec4(far, 0.0, 0.0, 0.0),
        glam::vec4(0.0, far, 0.0, 0.0),
        glam::vec4(0.0, 0.0, near + far, 1.0),
        glam::vec4(0.0, 0.0, -far * near, 0.0),
    )
}

fn planes_taken_for_distances(near: f32, far: f32) -> Mat4 {
    let (n, f) = (near.abs(), far.abs());
    Mat4::from_cols(
        glam::vec4(n, 0.0, 0.0, 0.0),
        glam::vec4(0.0, n, 0.0, 0.0),
        glam::vec4(0.0, 0.0, n + f, 1.0),
        glam::vec4(0.0, 0.0, -f * n, 0.0),
    )
}

fn depth_lost(near: f32, _far: f32) -> Mat4 {
    Mat4::from_cols(
        glam::vec4(near, 0.0, 0.0, 0.0),
        glam::vec4(0.0, near, 0.0, 0.0),
        glam::vec4(0.0, 0.0, near, 1.0),
        glam::Vec4::ZERO,
    )
}

fn nothing_divides(near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        glam::vec4(near, 0.0, 0.0, 0.0),
        glam::vec4(0.0, near, 0.0, 0.0),
        glam::vec4(0.0, 0.0, near + far, 0.0),
        glam::vec4(0.0, 0.0, -far * near, 1.0),
    )
}

fn minus_one_in_the_last_row(near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        glam::vec4(near, 0.0, 0.0, 0.0),
        glam::vec4(0.0, near, 0.0, 0.0),
        glam::vec4(0.0, 0.0, near + far, -1.0),
        glam::vec4(0.0, 0.0, -far * near, 0.0),
    )
}
