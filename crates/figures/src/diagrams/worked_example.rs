//! Does the ray of exercise 4.2 meet the triangle, and where? (L54)

use geometry::{Ray, Triangle};
use glam::{Vec3, vec2, vec3};
use raytrace::triangle::{Solution, System, cramer, system};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::text::{decimal, triple};
use crate::sheet::view::View;
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L54", "L50"],
    name: "worked-example",
    title: Text { en: "Worked example: exercise 2 of chapter 4", nl: "Voorbeeld: opgave 2 hoofdstuk 4" },
    caption: Text {
        en: "The ray from e along d meets the plane through a, b and c at p. All three weights are positive, so p lies in the triangle, and t is positive, so it lies before the eye.",
        nl: "De straal vanuit e in richting d snijdt het vlak door a, b en c in p. De drie gewichten zijn positief, dus p ligt in de driehoek; t is positief, dus p ligt voor het oog.",
    },
    parameters: &[
        Parameter::number("x", Text { en: "x of the eye e", nl: "x van het oog e" }, 1.0, 0.2, 2.0),
        Parameter::number("y", Text { en: "y of the eye e", nl: "y van het oog e" }, 1.0, 0.2, 2.0),
        Parameter::number("z", Text { en: "z of the eye e", nl: "z van het oog e" }, 1.0, 0.2, 2.0),
    ],
    size: (640, 480),
    draw,
};

fn draw(values: &Values) -> Drawn {
    let ray = Ray::new(["x", "y", "z"].map(|axis| values.number(axis)).into(), Vec3::NEG_ONE);
    let triangle = Triangle::new(Vec3::X, Vec3::Y, Vec3::Z);
    let system = system(&ray, &triangle);
    let found = cramer(&system).ok_or("the ray is parallel to the plane")?;
    let alt = alt(&found);
    let view = View::new(vec3(5.0, 2.6, 3.2), Vec3::ZERO)?;
    let seen = [view.at(1.5 * Vec3::X), view.at(1.5 * Vec3::Y), view.at(1.5 * Vec3::Z), view.at(ray.origin)];
    let mut sheet = Sheet::around(&seen, vec2(820.0, 470.0), 24.0, 330.0);
    axes(&mut sheet, &view);
    let corners = triangle.corners().map(|corner| view.at(corner));
    sheet.wash(&corners, Ink::B);
    sheet.polygon(&corners, Ink::B.pen());
    for ((name, side), corner) in
        [("a", Side::BelowLeft), ("b", Side::AboveLeft), ("c", Side::BelowLeft)].into_iter().zip(corners)
    {
        sheet.dot(corner, Ink::B);
        sheet.label(corner, side, name, Letters::Vector, Ink::B);
    }
    let (e, p, end) = (view.at(ray.origin), view.at(ray.at(found.t)), view.at(ray.at(1.25)));
    sheet.line(e, p, Ink::A.pen());
    sheet.arrow(p, end, Ink::A.pen().dashed());
    sheet.dot(e, Ink::A);
    sheet.label(e, Side::AboveRight, "e", Letters::Vector, Ink::A);
    sheet.dot(p, Ink::A);
    sheet.label(p, Side::AboveRight, "p", Letters::Vector, Ink::A);
    numbers(&mut sheet, &ray, &system, &found);
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

fn axes(sheet: &mut Sheet, view: &View) {
    for (axis, name, side) in
        [(Vec3::X, "x", Side::Below), (Vec3::Y, "y", Side::Left), (Vec3::Z, "z", Side::Below)]
    {
        let end = view.at(1.4 * axis);
        sheet.arrow(view.at(Vec3::ZERO), end, Ink::Faint.pen());
        sheet.label(end, side, name, Letters::Scalar, Ink::Main);
    }
}

/// The system A·x = b of L50 and its solution, at the right of the drawing.
fn numbers(sheet: &mut Sheet, ray: &Ray, system: &System, found: &Solution) {
    const LEFT: f32 = 470.0;
    let columns = system.matrix;
    let column = |v: Vec3| v.to_array().map(|entry| decimal(entry, 2));
    let parts: [(&str, [String; 3]); 5] = [
        ("", column(columns.x_axis)),
        ("A", column(columns.y_axis)),
        ("", column(columns.z_axis)),
        ("x", ["β", "γ", "t"].map(str::to_owned)),
        ("b", column(system.rhs)),
    ];
    for (k, (head, entries)) in parts.into_iter().enumerate() {
        let left = LEFT + 68.0 * k as f32;
        sheet.lines(left, 40.0, [head]);
        sheet.lines(left, 72.0, entries);
    }
    let weights = found.weights();
    sheet.lines(
        LEFT,
        190.0,
        [
            format!("α = {}", decimal(weights.alpha, 3)),
            format!("β = {}", decimal(found.beta, 3)),
            format!("γ = {}", decimal(found.gamma, 3)),
            format!("t = {}", decimal(found.t, 3)),
            format!("p = {}", triple(ray.at(found.t))),
        ],
    );
}

fn alt(found: &Solution) -> Words {
    let Solution { beta, gamma, t } = *found;
    let alpha = found.weights().alpha;
    Words::new(
        format!(
            "A ray crosses a triangle with corners on the three axes at α = {alpha:.3}, β = {beta:.3}, γ = {gamma:.3}, t = {t:.3}."
        ),
        format!(
            "Een straal snijdt een driehoek met hoekpunten op de drie assen bij α = {alpha:.3}, β = {beta:.3}, γ = {gamma:.3}, t = {t:.3}."
        ),
    )
}
