//! What do the printed matrices give when they are taken at their word? (E1, E2, E15)

use glam::{Mat4, Vec3, Vec4, vec2, vec3, vec4};
use transforms::opengl::OPENGL_CLIP_FROM_CLIP;
use transforms::projection::{canonical_from_camera, scale};
use transforms::{Basis, Pipeline, ViewVolume, change_of_basis};

use crate::sample::{pipeline, short, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, stage, text, versions};

pub(super) static ORDER_OF_FACTORS: Claim = Claim {
    number: "E1",
    name: "order-of-factors",
    quote: "R · T · P · S · C · V",
    translation: "camera, perspective, scale, translation and viewport, printed from left to right",
    truth: text(
        "With column vectors what acts first stands last: screen = V·S·C·P·R·T. The slide has the stages in the order of time.",
        "Bij kolomvectoren staat wat het eerst werkt achteraan: scherm = V·S·C·P·R·T. De dia zet de stappen op volgorde van tijd.",
    ),
    expected: Verdict::Refuted,
    code: &["transforms::Pipeline::screen_from_world", "transforms::Pipeline::factors"],
    examine: || {
        let pipeline = pipeline((vec3(1.0, 2.0, 8.0), vec3(0.5, 0.0, 0.0)), 0.8, (-1.0, -20.0), (640, 480));
        let (slide, right) = (slide_pipeline(&pipeline), pipeline.screen_from_world());
        let trials = trials(50, 11, |random| {
            let p = random.point(2.0);
            let (q, r) = (slide.project_point3(p), right.project_point3(p));
            Trial::new(
                q.abs_diff_eq(r, 0.01),
                format!("{} lands on {} instead of {}", short(p), short(q), short(r)),
            )
        });
        let p = vec3(1.0, 0.5, 0.0);
        let traced = crate::sample::trials(50, 18, |random| {
            let p = random.point(2.0);
            let screen = pipeline.trace(p).screen.unwrap_or(Vec3::NAN);
            // One product of six matrices against one step at a time, on a screen of 640 pixels.
            Trial::new(
                right.project_point3(p).abs_diff_eq(screen, 1e-2),
                format!("{} goes to {}", short(p), short(screen)),
            )
        });
        judge("the printed product finds the pixel", None, &trials)
            .with_right("V·S·C·P·R·T finds the pixel that the stages find one by one", &traced)
            .compared(
                format!("the point {}", short(p)),
                short(slide.project_point3(p)),
                short(right.project_point3(p)),
            )
    },
    pictures: None,
    versions: Some(versions::order_of_factors),
};

/// The product from left to right as printed: R·T, P, S, C, V.
pub(super) fn slide_pipeline(pipeline: &Pipeline) -> Mat4 {
    let [t, r, p, c, s, v] = pipeline.factors().map(|factor| factor.matrix);
    r * t * p * s * c * v
}

pub(super) static R_MINUS_ONE: Claim = Claim {
    number: "E1",
    name: "r-minus-one",
    quote: "2/(r−1)",
    translation: "the first entry of the scaling matrix",
    truth: text(
        "It is r − l, the width of the window: a letter l was printed as the digit 1. Right by accident where l = 1.",
        "Het is r − l, de breedte van het venster: een letter l is gedrukt als het cijfer 1. Toevallig goed waar l = 1.",
    ),
    expected: Verdict::HoldsIf(L_IS_ONE),
    code: &["transforms::projection::scale"],
    examine: || {
        let trials = trials(80, 12, |random| {
            let left = if random.below(4) == 0 { 1.0 } else { random.between(-5.0, -0.5) };
            scaling_trial(left, random.between(1.5, 6.0))
        });
        let volume = window(-2.0, 3.0);
        let r_minus_l = crate::sample::trials(80, 12, |random| {
            let (left, right) = (random.between(-5.0, 1.0), random.between(1.5, 6.0));
            let width = scale(&window(left, right)).x_axis.x * (right - left);
            Trial::new((width - 2.0).abs() < 1e-5, format!("width {width}"))
        });
        judge("2/(r−1) brings the window's width to 2", Some(L_IS_ONE), &trials)
            .with_right("2/(r − l) does, for any l", &r_minus_l)
            .compared(
                "l = −2, r = 3",
                format!("a window {:.1} wide", slide_scale(&volume) * 5.0),
                format!("one {:.1} wide", scale(&volume).x_axis.x * 5.0),
            )
    },
    pictures: None,
    versions: Some(versions::r_minus_one),
};

const L_IS_ONE: &str = "l is 1";

pub(super) fn slide_scale(volume: &ViewVolume) -> f32 {
    2.0 / (volume.right - 1.0)
}

fn scaling_trial(left: f32, right: f32) -> Trial {
    let volume = window(left, right);
    let width = slide_scale(&volume) * (right - left);
    // One division and one product.
    Trial::under(
        left == 1.0,
        (width - 2.0).abs() < 1e-5,
        format!("l = {left:.2}, r = {right:.2}: width {width:.3}"),
    )
}

pub(super) fn window(left: f32, right: f32) -> ViewVolume {
    ViewVolume { left, right, bottom: -1.0, top: 2.0, near: -1.0, far: -9.0 }
}

pub(super) static CLIP_W_NEGATIVE: Claim = Claim {
    number: "E2",
    name: "clip-w-is-negative",
    quote: "(n 0 0 0; 0 n 0 0; 0 0 n+f −fn; 0 0 1 0)",
    translation: "the perspective matrix; its last row makes w = z, and the slides state no sign",
    truth: text(
        "The camera looks along −w, so visible points have w = z < 0. The books' clip test −w ≤ x ≤ w is for w > 0: it throws away all that is visible. Negate the matrix, or turn the signs of the test.",
        "De camera kijkt langs −w, dus zichtbare punten hebben w = z < 0. De gebruikelijke kniptest −w ≤ x ≤ w is voor w > 0: die gooit alles weg wat zichtbaar is. Neem de matrix met min, of keer de tekens in de test om.",
    ),
    expected: Verdict::Refuted,
    code: &["transforms::canonical_from_camera", "zbuffer::project"],
    examine: || {
        let volume = window(-1.5, 1.0);
        let m = canonical_from_camera(&volume);
        let trials = trials(200, 13, |random| {
            // A point of the volume: on the window, pushed out.
            let out = random.between(1.0, 9.0);
            let on_window = vec2(random.between(-1.4, 0.9), random.between(-0.9, 1.9));
            let p = (on_window * out).extend(-out);
            let clip = m * p.extend(1.0);
            Trial::new(
                slide_is_inside(clip),
                format!("visible point {} has w = {:.2} and is cut away", short(p), clip.w),
            )
        });
        let clip = m * vec4(0.4, 0.5, -4.0, 1.0);
        let negated = crate::sample::trials(200, 13, |random| {
            let out = random.between(1.0, 8.9);
            let on_window = vec2(random.between(-1.4, 0.9), random.between(-0.9, 1.9));
            let p = (on_window * out).extend(-out - 0.01);
            Trial::new(
                slide_is_inside(-(m * p.extend(1.0))),
                format!("visible point {} is cut away", short(p)),
            )
        });
        judge("visible points pass −w ≤ x, y, z ≤ w", None, &trials)
            .with_right("visible points pass once the matrix is negated", &negated)
            .compared(
                "the point (0.4, 0.5, −4)",
                format!("w = {:.2}: {}", clip.w, inside(slide_is_inside(clip))),
                format!("with the matrix negated, w = {:.2}: {}", -clip.w, inside(slide_is_inside(-clip))),
            )
    },
    pictures: Some(stage::clipping_pair),
    versions: None,
};

/// −w ≤ x ≤ w, −w ≤ y ≤ w, −w ≤ z ≤ w.
pub(super) fn slide_is_inside(clip: Vec4) -> bool {
    clip.truncate().to_array().iter().all(|x| -clip.w <= *x && *x <= clip.w)
}

fn inside(is: bool) -> &'static str {
    if is { "inside" } else { "outside" }
}

pub(super) static OPENGL: Claim = Claim {
    number: "E2",
    name: "opengl-but-for-signs",
    quote: "(2/(r−l) …)(1 0 0 −(l+r)/2 …)(n 0 0 0; 0 n 0 0; 0 0 n+f −fn; 0 0 1 0)",
    translation: "S·C·P with n and f negative",
    truth: text(
        "Up to signs this is OpenGL's frustum matrix: S·C·P = diag(−1, −1, 1, −1) · frustum, with near and far as distances −n and −f.",
        "Op tekens na is dit OpenGL's frustum-matrix: S·C·P = diag(−1, −1, 1, −1) · frustum, met near en far als afstanden −n en −f.",
    ),
    expected: Verdict::Holds,
    code: &["transforms::canonical_from_camera", "transforms::opengl::OPENGL_CLIP_FROM_CLIP"],
    examine: || {
        let trials = trials(100, 14, |random| {
            let volume = ViewVolume {
                near: -random.between(0.5, 2.0),
                far: -random.between(5.0, 50.0),
                ..window(random.between(-3.0, -1.0), random.between(0.5, 2.0))
            };
            let ours = canonical_from_camera(&volume);
            // Entries up to some hundred, a handful of roundings.
            let holds = ours.abs_diff_eq(OPENGL_CLIP_FROM_CLIP * frustum(&volume), 2e-4);
            Trial::new(holds, format!("{volume}"))
        });
        judge("S·C·P = diag(−1, −1, 1, −1) · frustum", None, &trials).compared(
            "w of a point at z = −4",
            format!("{:.1}", (canonical_from_camera(&window(-1.0, 1.0)) * vec4(0.0, 0.0, -4.0, 1.0)).w),
            format!("{:.1} in OpenGL", (frustum(&window(-1.0, 1.0)) * vec4(0.0, 0.0, -4.0, 1.0)).w),
        )
    },
    pictures: None,
    versions: Some(versions::opengl),
};

/// glFrustum, from OpenGL's own reference page.
pub(super) fn frustum(volume: &ViewVolume) -> Mat4 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, near, far } = *volume;
    let (n, f) = (-near, -far);
    Mat4::from_cols(
        vec4(2.0 * n / (r - l), 0.0, 0.0, 0.0),
        vec4(0.0, 2.0 * n / (t - b), 0.0, 0.0),
        vec4((r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1.0),
        vec4(0.0, 0.0, -2.0 * f * n / (f - n), 0.0),
    )
}

pub(super) static HANDEDNESS: Claim = Claim {
    number: "E15",
    name: "opposite-handedness",
    quote: "Schrijf de 4×4 rotatiematrix M op die orthonormale basis u, v, w overvoert in orthonormale vectoren a, b, c.",
    translation: "write the 4×4 rotation matrix M that carries the orthonormal basis u, v, w to orthonormal vectors a, b, c",
    truth: text(
        "There is a rotation only between bases of one handedness; else det M = −1 and M mirrors. And the answer is 3×3: a rotation moves no origin.",
        "Alleen tussen bases van dezelfde oriëntatie bestaat een rotatie; anders is det M = −1 en spiegelt M. En het antwoord is 3×3: een rotatie verplaatst geen oorsprong.",
    ),
    expected: Verdict::HoldsIf(ONE_HANDEDNESS),
    code: &["transforms::change_of_basis"],
    examine: handedness,
    pictures: None,
    versions: Some(versions::handedness),
};

const ONE_HANDEDNESS: &str = "both bases have the same handedness";

fn handedness() -> Examination {
    let trials = trials(100, 17, |random| {
        let (from, to, mirror) = (random.basis(), random.basis(), random.below(2) == 0);
        let to = if mirror { Basis { w: -to.w, ..to } } else { to };
        let determinant = change_of_basis(&from, &to).determinant();
        // A product of unit vectors, some twenty roundings.
        let holds = (determinant - 1.0).abs() < 1e-5;
        Trial::under(
            !mirror,
            holds,
            format!("c = {}a×b: det M = {determinant:.3}", if mirror { "−" } else { "" }),
        )
    });
    let from = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };
    let determinant = |w: Vec3| change_of_basis(&from, &Basis { u: Vec3::Y, v: Vec3::Z, w }).determinant();
    judge("M is a rotation, det M = 1", Some(ONE_HANDEDNESS), &trials).compared(
        "a = y, b = z; c = −x as the exercise allows, or c = x",
        format!("det M = {}", determinant(-Vec3::X)),
        format!("det M = {}", determinant(Vec3::X)),
    )
}
