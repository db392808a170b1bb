//! What is wrong with c = c_l (e·r), and what does Phong's exponent mend? (L30, L31)

use canvas::Rgb;
use glam::{Vec3, vec3};
use lighting::{phong_highlight, reflect};

use crate::ball;
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L30", "L31"],
    name: "first-attempt",
    title: Text { en: "First attempt and Phong's highlight", nl: "Eerste poging en highlight van Phong" },
    caption: Text {
        en: "The highlight alone on a ball. The first attempt e·r (left) is negative on the far side, shown blue, and so wide that nearly the whole lit half gleams. max(0, e·r)^p (right) has neither fault.",
        nl: "Alleen de highlight op een bol. De eerste poging e·r (links) is negatief aan de afgekeerde kant, blauw getekend, en zo breed dat bijna de hele verlichte helft glanst. max(0, e·r)^p (rechts) heeft geen van beide fouten.",
    },
    parameters: &[
        Parameter::number("p", Text { en: "Phong exponent p", nl: "Phong-exponent p" }, 32.0, 0.0, 2000.0),
        Parameter::number(
            "light",
            Text {
                en: "angle of the light from the gaze, degrees",
                nl: "hoek van het licht met de kijkrichting, graden",
            },
            50.0,
            0.0,
            90.0,
        ),
    ],
    size: (360, 360),
    draw,
    handles,
};

fn draw(values: &Values) -> Drawn {
    let (p, to_light) = (values.number("p"), to_light(values.number("light")));
    let mut least = f32::INFINITY;
    let [first, phong] = ball::pictures(values.size(), |n, to_eye| {
        let value = to_eye.dot(reflect(n, to_light));
        least = least.min(value);
        [shown(value), shown(phong_highlight(n, to_light, to_eye, p))]
    })?;
    let drawings = vec![
        Drawing::picture(
            "attempt",
            Words::new(
                format!(
                    "A ball that is white over most of its lit side and blue, which means negative, elsewhere; the least value is {least:.2}."
                ),
                format!(
                    "Een bol die wit is over het grootste deel van de verlichte kant en elders blauw, dat is negatief; de kleinste waarde is {least:.2}."
                ),
            ),
            first,
        ),
        Drawing::picture(
            "phong",
            Words::new(
                format!("A dark ball with one small white highlight, p = {p}."),
                format!("Een donkere bol met één kleine witte highlight, p = {p}."),
            ),
            phong,
        ),
    ];
    with_handles(drawings, handles(values))
}

/// White for 1, black for 0, blue below.
fn shown(value: f32) -> Rgb {
    if value >= 0.0 { Rgb::splat(value) } else { Rgb::new(0.1, 0.25, 1.0) * -value }
}

/// To the light, so many degrees from the gaze: above the eye at the left.
fn to_light(degrees: f32) -> Vec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    vec3(-0.8 * sin, 0.6 * sin, cos)
}

fn handles(values: &Values) -> Handled {
    let light = ball::place(values.size(), to_light(values.number("light")))?;
    let name = Text { en: "where the ball faces the light", nl: "waar de bol naar het licht wijst" };
    Ok([(); 2].map(|()| ball::handles(values.size()).and(name, &["light"], light)).into())
}
