//! Does the ray of exercise 4.2 meet the triangle, and where? (L54)

use geometry::{Ray, Triangle};
use glam::{Vec3, vec2, vec3};
use raytrace::triangle::{Solution, cramer, system};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
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
    let found = cramer(&system(&ray, &triangle)).ok_or("the ray is parallel to the plane")?;
    let alt = alt(&found);
    let view = View::new(vec3(5.0, 2.6, 3.2), Vec3::ZERO)?;
    let mut sheet = Sheet::new(vec2(-1.5, -0.85), vec2(2.2, 2.0), 720.0);
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
    numbers(&mut sheet, &ray, &found);
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

/// The solution, a line each, at the right of the drawing.
fn numbers(sheet: &mut Sheet, ray: &Ray, found: &Solution) {
    let p = ray.at(found.t);
    let weights = found.weights();
    let lines = [
        format!("α = {:.3}", weights.alpha),
        format!("β = {:.3}", found.beta),
        format!("γ = {:.3}", found.gamma),
        format!("t = {:.3}", found.t),
        format!("p = ({:.3}, {:.3}, {:.3})", p.x, p.y, p.z),
    ];
    for (k, line) in lines.into_iter().enumerate() {
        sheet.label(vec2(1.05, 1.75 - 0.16 * k as f32), Side::Right, line, Letters::Plain, Ink::Main);
    }
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
