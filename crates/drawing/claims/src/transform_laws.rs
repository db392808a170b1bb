//! Do the matrices do what the slides say? (L1–L3, L6, L10–L12)

use glam::{Mat3, Vec2, Vec3, vec2, vec3};
use transforms::affine2::{rotate, rotate_about, translate};
use transforms::projection::{orthographic, perspective};
use transforms::{Basis, ViewVolume, change_of_basis, change_of_basis_inverse};

use crate::sample::{short, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, text};

pub(super) static CAMERA_IS_RIGID: Claim = Claim {
    number: "L1",
    name: "camera-is-rigid",
    quote: "(x_u y_u z_u 0; x_v y_v z_v 0; x_w y_w z_w 0; 0 0 0 1) · T(−e)",
    translation: "the rows u, v, w times the translation by −e",
    truth: text(
        "The camera matrix is rigid: it keeps all distances and does not mirror.",
        "De cameramatrix is star: alle afstanden blijven gelijk en er wordt niet gespiegeld.",
    ),
    expected: Verdict::Holds,
    code: &["transforms::Camera::camera_from_world"],
    examine: || {
        let trials = trials(200, 1, |random| {
            let m = random.camera().camera_from_world();
            let (p, q) = (random.point(9.0), random.point(9.0));
            let (before, after) = (p.distance(q), m.transform_point3(p).distance(m.transform_point3(q)));
            let determinant = Mat3::from_mat4(m).determinant();
            // Coordinates up to 30, each a sum of a few products: errors of some 30 · 2⁻²⁴.
            let holds = (before - after).abs() < 3e-5 && (determinant - 1.0).abs() < 1e-5;
            Trial::new(holds, format!("distance {before} becomes {after}, determinant {determinant}"))
        });
        judge("distances stay and the determinant is 1", None, &trials)
    },
    pictures: None,
    versions: None,
};

const BOTH_BEFORE_THE_EYE: &str = "both points lie before the eye";

pub(super) static DEPTH_ORDER: Claim = Claim {
    number: "L2",
    name: "keeps-depth-order",
    quote: "(n 0 0 0; 0 n 0 0; 0 0 n+f −fn; 0 0 1 0)",
    translation: "the perspective matrix",
    truth: text(
        "After division by w the order of depths is the same, for points before the eye; a point behind the eye lands farther than all of them.",
        "Na deling door w is de volgorde in diepte dezelfde, voor punten vóór het oog; een punt achter het oog komt verder weg te liggen dan al die punten.",
    ),
    expected: Verdict::HoldsIf(BOTH_BEFORE_THE_EYE),
    code: &["transforms::projection::perspective"],
    examine: || {
        let p = perspective(-2.0, -50.0);
        let trials = trials(400, 2, |random| {
            let (mut a, mut b) = (random.point(9.0), random.point(9.0));
            (a.z, b.z) = (random.between(-60.0, 5.0), random.between(-60.0, 5.0));
            let (z_a, z_b) = (p.project_point3(a).z, p.project_point3(b).z);
            // Nearer than a hundredth of each other, rounding may exchange them.
            let holds = (a.z < b.z) == (z_a < z_b) || (a.z - b.z).abs() < 0.01;
            Trial::under(
                a.z < 0.0 && b.z < 0.0,
                holds,
                format!("z = {:.2} and {:.2} become {z_a:.2} and {z_b:.2}", a.z, b.z),
            )
        });
        judge("the order of depths stays", Some(BOTH_BEFORE_THE_EYE), &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static LINES: Claim = Claim {
    number: "L2",
    name: "lines-to-lines",
    quote: "(n 0 0 0; 0 n 0 0; 0 0 n+f −fn; 0 0 1 0)",
    translation: "the perspective matrix",
    truth: text(
        "Three points on a line are on a line after the perspective too; distances along it do not stay in proportion.",
        "Drie punten op een lijn liggen na de perspectief weer op een lijn; verhoudingen van afstanden erlangs blijven niet.",
    ),
    expected: Verdict::Holds,
    code: &["transforms::projection::perspective"],
    examine: || {
        let p = perspective(-2.0, -50.0);
        let trials = trials(200, 3, |random| {
            let before_the_eye = |mut p: Vec3, z: f32| {
                p.z = z;
                p
            };
            let a = before_the_eye(random.point(9.0), random.between(-50.0, -2.0));
            let b = before_the_eye(random.point(9.0), random.between(-50.0, -2.0));
            let share = random.between(0.1, 0.9);
            let [a, m, b] = [a, a.lerp(b, share), b].map(|q| p.project_point3(q));
            let off = (m - a).cross(b - a).length() / (b - a).length().max(0.1);
            // Coordinates up to 50 and a few roundings: some 50 · 2⁻²³.
            Trial::new(off < 1e-4, format!("the image of the point between lies {off:.1e} beside the line"))
        });
        judge("points of a line stay on a line", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static BOX_TO_CUBE: Claim = Claim {
    number: "L3",
    name: "box-to-cube",
    quote: "S(2/(r−l), 2/(t−b), 2/(n−f)) · T(−(l+r)/2, −(b+t)/2, −(n+f)/2)",
    translation: "scale and translation of the orthographic step",
    truth: text(
        "The corners of the box land on those of the cube, near at z = +1 and far at z = −1.",
        "De hoekpunten van de doos komen op die van de kubus, near op z = +1 en far op z = −1.",
    ),
    expected: Verdict::Holds,
    code: &["transforms::projection::orthographic"],
    examine: || {
        let trials = trials(100, 4, |random| {
            let (l, b, n) =
                (random.between(-9.0, 0.0), random.between(-9.0, 0.0), random.between(-3.0, -0.5));
            let volume = ViewVolume {
                left: l,
                right: l + random.between(1.0, 9.0),
                bottom: b,
                top: b + random.between(1.0, 9.0),
                near: n,
                far: n - random.between(1.0, 50.0),
            };
            let m = orthographic(&volume);
            let first = m.transform_point3(vec3(volume.right, volume.top, volume.near));
            let last = m.transform_point3(vec3(volume.left, volume.bottom, volume.far));
            // Sums of numbers up to 50 times a scale of at most 2: some 50 · 2⁻²².
            let holds = first.abs_diff_eq(Vec3::ONE, 2e-5) && last.abs_diff_eq(Vec3::NEG_ONE, 2e-5);
            Trial::new(holds, format!("{volume}: {} and {}", short(first), short(last)))
        });
        judge("(r, t, n) becomes (1, 1, 1) and (l, b, f) becomes (−1, −1, −1)", None, &trials)
    },
    pictures: None,
    versions: None,
};

const UP_NOT_ALONG_GAZE: &str = "up does not lie along the gaze";

pub(super) static CAMERA_FRAME: Claim = Claim {
    number: "L6",
    name: "camera-frame",
    quote: "The w vector is opposite the view direction, and the v vector is coplanar with w and the up vector.",
    translation: "w is opposite the view direction, and v lies in the plane of w and up",
    truth: text(
        "So u, v, w are orthonormal and right-handed. If up lies along the gaze, nothing says which way is right: up×w is 0.",
        "Dan zijn u, v, w orthonormaal en rechtshandig. Ligt up langs de kijkrichting, dan bepaalt niets wat rechts is: up×w is 0.",
    ),
    expected: Verdict::HoldsIf(UP_NOT_ALONG_GAZE),
    code: &["transforms::Basis::from_gaze_and_up"],
    examine: || {
        let mut trials = trials(100, 5, |random| {
            let (gaze, up) = (random.point(4.0), random.point(4.0));
            frame_trial(gaze, up)
        });
        trials.push(frame_trial(vec3(1.0, -2.0, 3.0), vec3(-2.0, 4.0, -6.0)));
        judge("u, v, w are orthonormal and right-handed", Some(UP_NOT_ALONG_GAZE), &trials)
    },
    pictures: None,
    versions: None,
};

fn frame_trial(gaze: Vec3, up: Vec3) -> Trial {
    let meets = up.cross(gaze).length() > 1e-3 * up.length() * gaze.length();
    let numbers = format!("gaze {}, up {}", short(gaze), short(up));
    let Ok(Basis { u, v, w }) = Basis::from_gaze_and_up(gaze, up) else {
        return Trial::under(meets, false, format!("{numbers}: no frame"));
    };
    // Unit vectors to a few roundings.
    let holds = u.cross(v).abs_diff_eq(w, 1e-6)
        && v.cross(w).abs_diff_eq(u, 1e-6)
        && w.abs_diff_eq(-gaze.normalize(), 1e-6)
        && v.dot(w.cross(up)).abs() < 1e-5
        && v.dot(up) > 0.0;
    Trial::under(meets, holds, numbers)
}

pub(super) static ROTATION_ABOUT_A_POINT: Claim = Claim {
    number: "L10",
    name: "rotation-about-a-point",
    quote: "1. Verschuif p naar oorsprong 2. Roteer 3. Verschuif terug over p",
    translation: "1. move p to the origin 2. rotate 3. move back by p",
    truth: text(
        "The three factors give the multiplied matrix of the answer; it leaves p where it is and keeps distances.",
        "De drie factoren geven de uitgewerkte matrix van het antwoord; p blijft op zijn plaats en afstanden blijven gelijk.",
    ),
    expected: Verdict::Holds,
    code: &["transforms::affine2::rotate_about"],
    examine: || {
        let trials = trials(200, 6, |random| {
            let p = vec2(random.between(-5.0, 5.0), random.between(-5.0, 5.0));
            let q = vec2(random.between(-5.0, 5.0), random.between(-5.0, 5.0));
            let theta = random.between(-3.0, 3.0);
            let steps = translate(p) * rotate(theta) * translate(-p);
            let m = rotate_about(theta, p);
            let fixed: Vec2 = m.transform_point2(p);
            let turned = m.transform_point2(q);
            // Coordinates up to 20 and a handful of roundings.
            let holds = m.abs_diff_eq(steps, 1e-5)
                && fixed.abs_diff_eq(p, 1e-5)
                && (turned.distance(p) - q.distance(p)).abs() < 1e-5;
            Trial::new(holds, format!("θ = {theta:.3}, p = {p:.3} goes to {fixed:.3}"))
        });
        judge("T(p)·R(θ)·T(−p) is the matrix of the answer, and p stays", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static CHANGE_OF_BASIS: Claim = Claim {
    number: "L11",
    name: "change-of-basis",
    quote: "M = R_abcᵀ R_uvw; er moet gelden: Mu = a, Mv = b, Mw = c",
    translation: "M = R_abcᵀ R_uvw; Mu = a, Mv = b, Mw = c must hold",
    truth: text("M carries u to a, v to b and w to c.", "M voert u over in a, v in b en w in c."),
    expected: Verdict::Holds,
    code: &["transforms::change_of_basis"],
    examine: || {
        let trials = trials(200, 7, |random| {
            let (from, to) = (random.basis(), random.basis());
            let m = change_of_basis(&from, &to);
            let off = [(from.u, to.u), (from.v, to.v), (from.w, to.w)]
                .map(|(before, after)| (m * before).distance(after))
                .into_iter()
                .fold(0.0, f32::max);
            // Unit vectors, a dozen roundings.
            Trial::new(off < 2e-6, format!("off by {off:.1e}"))
        });
        judge("Mu = a, Mv = b and Mw = c", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static INVERSE_CHANGE: Claim = Claim {
    number: "L12",
    name: "inverse-change-of-basis",
    quote: "M⁻¹ = (R_abcᵀ R_uvw)⁻¹ = R_uvwᵀ R_abc",
    translation: "M⁻¹ = (R_abcᵀ R_uvw)⁻¹ = R_uvwᵀ R_abc",
    truth: text(
        "The transposed factors in reverse order undo M: no matrix needs inverting.",
        "De getransponeerde factoren in omgekeerde volgorde maken M ongedaan: er hoeft niets geïnverteerd te worden.",
    ),
    expected: Verdict::Holds,
    code: &["transforms::change_of_basis_inverse"],
    examine: inverse_change,
    pictures: None,
    versions: None,
};

fn inverse_change() -> Examination {
    let trials = trials(200, 8, |random| {
        let (from, to) = (random.basis(), random.basis());
        let product = change_of_basis_inverse(&from, &to) * change_of_basis(&from, &to);
        // Products of rotations, some twenty roundings.
        let holds = product.abs_diff_eq(Mat3::IDENTITY, 4e-6);
        Trial::new(holds, format!("M⁻¹·M = {product:.3}"))
    });
    judge("M⁻¹·M is the identity", None, &trials)
}
