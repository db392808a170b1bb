//! Does the ray of exercise 4.2 meet the triangle, and where? (L54)

use geometry::{Ray, Triangle};
use glam::{Vec2, Vec3, vec2, vec3};
use raytrace::triangle::{Solution, System, cramer, system};
use sheet::text::{decimal, triple};
use sheet::view::View;
use sheet::{Ink, Letters, Sheet, Side};
use transforms::DegenerateCamera;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L54", "L50"],
    name: "worked-example",
    title: Text { en: "Worked example: exercise 2 of chapter 4", nl: "Voorbeeld: opgave 2 hoofdstuk 4" },
    caption: Text {
        en: "The ray from e along d meets the plane through a, b and c at p. With the slide's e all three weights are positive, so p lies in the triangle, and t is positive, so it lies before the eye. The system at the right is the slide's with every row times −1.",
        nl: "De straal vanuit e in richting d snijdt het vlak door a, b en c in p. Met de e van de slide zijn de drie gewichten positief, dus p ligt in de driehoek; t is positief, dus p ligt voor het oog. Het stelsel rechts is dat van de slide, met elke rij maal −1.",
    },
    parameters: &[
        Parameter::number("x", Text { en: "x of the eye e", nl: "x van het oog e" }, 1.0, 0.2, 2.0),
        Parameter::number("y", Text { en: "y of the eye e", nl: "y van het oog e" }, 1.0, 0.2, 2.0),
        Parameter::number("z", Text { en: "z of the eye e", nl: "z van het oog e" }, 1.0, 0.2, 2.0),
    ],
    size: (640, 480),
    draw,
    handles,
};

fn ray(values: &Values) -> Ray {
    Ray::new(["x", "y", "z"].map(|axis| values.number(axis)).into(), Vec3::NEG_ONE)
}

/// The point of the plane y = 0 below another.
fn below(p: Vec3) -> Vec3 {
    vec3(p.x, 0.0, p.z)
}

/// The view, and a sheet that shows the axes and the whole ray.
fn laid_out(ray: &Ray) -> Result<(View, Sheet), DegenerateCamera> {
    let view = View::new(vec3(5.0, 2.6, 3.2), Vec3::ZERO)?;
    let axes = [1.4 * Vec3::X, 1.4 * Vec3::Y, 1.4 * Vec3::Z];
    let ends = axes.into_iter().chain([ray.origin, ray.at(LAST_T), below(ray.origin)]);
    let seen: Vec<Vec2> = ends.map(|p| view.at(p)).collect();
    Ok((view, Sheet::around(&seen, vec2(760.0, 460.0), 34.0, 300.0)))
}

fn draw(values: &Values) -> Drawn {
    let ray = ray(values);
    let triangle = Triangle::new(Vec3::X, Vec3::Y, Vec3::Z);
    let system = system(&ray, &triangle);
    let found = cramer(&system).ok_or("the ray is parallel to the plane")?;
    let (view, mut sheet) = laid_out(&ray)?;
    axes(&mut sheet, &view);
    // Where the eye stands is not seen from one side; the point of the floor below it tells.
    let below = view.at(below(ray.origin));
    sheet.line(view.at(ray.origin), below, Ink::Faint.pen().dashed().fine());
    sheet.dot(below, Ink::Faint);
    let corners = triangle.corners().map(|corner| view.at(corner));
    sheet.wash(&corners, Ink::B);
    sheet.polygon(&corners, Ink::B.pen());
    let (e, p) = (view.at(ray.origin), view.at(ray.at(found.t)));
    sheet.line(e, p, Ink::A.pen());
    sheet.arrow(p, view.at(ray.at(LAST_T)), Ink::A.pen().dashed());
    for corner in corners {
        sheet.dot(corner, Ink::B);
    }
    sheet.dot(e, Ink::A);
    sheet.dot(p, Ink::A);
    let around = |p: Vec2, x: f32, y: f32| p + sheet.units(15.0) * vec2(x, y);
    let [a, b, c] = corners;
    let names = [
        (around(a, -0.8, -0.9), "a", Ink::B),
        (around(b, -1.0, 0.6), "b", Ink::B),
        (around(c, -0.3, 1.1), "c", Ink::B),
        (around(e, 0.9, 0.7), "e", Ink::A),
        (around(p, 0.9, -0.8), "p", Ink::A),
    ];
    sheet.names(&names);
    numbers(&mut sheet, &ray, &system, &found);
    let alt = alt(&found);
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// The ray is drawn from the eye to here.
const LAST_T: f32 = 1.25;

fn axes(sheet: &mut Sheet, view: &View) {
    for (axis, name, side) in
        [(Vec3::X, "x", Side::Below), (Vec3::Y, "y", Side::Left), (Vec3::Z, "z", Side::Below)]
    {
        let end = view.at(1.4 * axis);
        sheet.arrow(view.at(Vec3::ZERO), end, Ink::Faint.pen());
        sheet.label(end, side, name, Letters::Scalar, Ink::Main);
    }
}

/// The three equations and their solution, at the right of the drawing.
fn numbers(sheet: &mut Sheet, ray: &Ray, system: &System, found: &Solution) {
    /// Where the words begin, in pixels from the left.
    const LEFT: f32 = 452.0;
    let entries = |column: Vec3| column.to_array().map(|x| decimal(x, if x.fract() == 0.0 { 0 } else { 2 }));
    let columns = [system.matrix.x_axis, system.matrix.y_axis, system.matrix.z_axis].map(entries);
    let end = sheet.matrix(LEFT, 40.0, 34.0, &columns);
    let unknowns = [["β", "γ", "t"].map(str::to_owned)];
    let end = sheet.matrix(end + 8.0, 40.0, 18.0, &unknowns);
    let equals = sheet.place(end + 13.0, 40.0 + 39.0);
    sheet.label(equals, Side::Middle, "=", Letters::Plain, Ink::Main);
    sheet.matrix(end + 26.0, 40.0, 48.0, &[entries(system.rhs)]);
    let weights = found.weights();
    let solved = [("α", weights.alpha), ("β", found.beta), ("γ", found.gamma), ("t", found.t)];
    let lines = solved.map(|(name, value)| format!("{name} = {}", decimal(value, 3)));
    sheet.lines(LEFT - 10.0, 160.0, lines);
    sheet.lines(LEFT - 10.0, 272.0, [format!("p = {}", triple(ray.at(found.t)))]);
    let verdict = if found.t <= 0.0 {
        Words::new("p is behind the eye", "p ligt achter het oog")
    } else if weights.is_inside() {
        Words::new("p is inside the triangle", "p ligt in de driehoek")
    } else {
        Words::new("p is not inside the triangle", "p ligt niet in de driehoek")
    };
    sheet.lines(LEFT - 10.0, 299.0, [verdict]);
}

fn alt(found: &Solution) -> Words {
    let [alpha, beta, gamma] = found.weights().to_vec3().to_array().map(|weight| decimal(weight, 3));
    let t = decimal(found.t, 3);
    Words::new(
        format!(
            "A ray crosses the plane of a triangle with corners on the three axes at α = {alpha}, β = {beta}, γ = {gamma}, t = {t}."
        ),
        format!(
            "Een straal snijdt het vlak van een driehoek met hoekpunten op de drie assen bij α = {alpha}, β = {beta}, γ = {gamma}, t = {t}."
        ),
    )
}

/// Seen from here x comes towards the reader: z and y are taken at the eye, x and z on the floor.
fn handles(values: &Values) -> Handled {
    let ray = ray(values);
    let (view, sheet) = laid_out(&ray)?;
    let list: [(Text, &[&str], Vec2); 2] = [
        (Text { en: "the eye e", nl: "het oog e" }, &["z", "y"], view.at(ray.origin)),
        (
            Text { en: "the place below the eye", nl: "de plek onder het oog" },
            &["x", "z"],
            view.at(below(ray.origin)),
        ),
    ];
    Ok(vec![Handles::on(&sheet, list)])
}
