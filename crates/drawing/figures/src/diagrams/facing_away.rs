//! What if the light is behind the surface? Then n·l is negative, and no light may be taken away (L27).

use std::error::Error;

use canvas::Rgb;
use glam::{Vec2, Vec3, vec2};
use lighting::{Highlight, Light, Material, SurfacePoint, lambert, lit};
use sheet::label_layout::Vector;
use sheet::text::{decimal, degrees};
use sheet::{Ink, Letters, Side};

use super::slice::{self, N, THE_LIGHT, WORDS, direction, tip};
use crate::ball;
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L27"],
    name: "facing-away",
    title: Text { en: "A surface that faces away", nl: "Een oppervlak dat is afgewend" },
    caption: Text {
        en: "Beyond 90° the light is behind the surface and the product n·l is negative; the model uses max(0, n·l). On a ball under this lamp alone nobody sees the difference, since what is below 0 shows as black. Once there is other light, here ambient light, a negative colour takes that away too: without max half of the ball turns black, with max it keeps the other light.",
        nl: "Voorbij 90° staat het licht achter het oppervlak en is het inproduct n·l negatief; het model gebruikt max(0, n·l). Op een bol onder alleen deze lamp ziet niemand het verschil, want onder 0 is alles zwart. Zodra er ander licht is, hier omgevingslicht, neemt een negatieve kleur ook dat weg: zonder max wordt de halve bol zwart, met max houdt die het andere licht.",
    },
    parameters: &[Parameter::number(
        "theta",
        Text { en: "angle θ between n and l, degrees", nl: "hoek θ tussen n en l, graden" },
        125.0,
        0.0,
        180.0,
    )],
    size: (300, 300),
    draw,
    handles,
};

/// All directions are seen, those below the surface too.
const LOWEST: f32 = -1.12;

/// The colour of the ball; the lamp is white.
const CLAY: Rgb = Rgb::new(0.85, 0.55, 0.3);
const LAMP: Rgb = Rgb::splat(0.9);
const AMBIENT: Rgb = Rgb::splat(0.35);

fn draw(values: &Values) -> Drawn {
    let theta = values.number("theta");
    let mut drawings = vec![vectors(theta)];
    drawings.extend(balls(values.size(), direction(theta))?);
    with_handles(drawings, handles(values))
}

fn handles(values: &Values) -> Handled {
    let (size, l) = (values.size(), direction(values.number("theta")));
    let facing = ball::place(size, l)?;
    let ball = || ball::handles(size).and(THE_LIGHT, &["theta"], facing);
    Ok(vec![Handles::on(&slice::paper(LOWEST), [(THE_LIGHT, &["theta"], tip(l))]), ball(), ball(), ball()])
}

/// The vectors at one point of the surface.
fn vectors(theta: f32) -> Drawing {
    let l = direction(theta);
    let product = N.dot(l);
    let (ink, sign) = if product < 0.0 { (Ink::D, "n·l < 0") } else { (Ink::C, "n·l") };
    let mut sheet = slice::sheet(LOWEST);
    let foot = vec2(0.0, product);
    sheet.line(tip(l), foot, ink.pen().dashed());
    sheet.vectors(Vec2::ZERO, &[Vector::new("n", tip(N), Ink::B), Vector::new("l", tip(l), Ink::A)]);
    let beside = vec2(-sheet.units(9.0), 0.0);
    sheet.line(beside, foot + beside, ink.pen().wide());
    // However short the line is, its name stands clear of the surface.
    let half = 0.5 * product;
    let name = vec2(1.4 * beside.x, if product < 0.0 { half.min(-0.12) } else { half.max(0.12) });
    sheet.label(name, Side::Left, sign, Letters::Plain, ink);
    sheet.angle(Vec2::ZERO, 0.3, [tip(N), tip(l)], "θ", Ink::Main);
    sheet.dot(Vec2::ZERO, Ink::Main);
    let (product, share) = (decimal(product, 3), decimal(lambert(N, l), 3));
    sheet.lines(
        WORDS,
        60.0,
        [
            format!("θ = {}", degrees(theta.to_radians())),
            format!("n·l = cos θ = {product}"),
            format!("max(0, n·l) = {share}"),
        ],
    );
    let alt = Words::new(
        format!("The light is {theta:.1}° from the normal: n·l is {product}, max(0, n·l) is {share}."),
        format!("Het licht staat {theta:.1}° van de normaal: n·l is {product}, max(0, n·l) is {share}."),
    );
    Drawing::diagram("vectors", alt.clone(), sheet.svg(&alt))
}

/// A ball under the lamp alone, and with ambient light: by the product as it is, and by the model.
fn balls(size: (u32, u32), l: Vec3) -> Result<[Drawing; 3], Box<dyn Error + Send + Sync>> {
    let lamp = Light::Directional { to_light: l, color: LAMP };
    let both = [lamp, Light::Ambient { color: AMBIENT }];
    let [alone, without_max, with_max] = ball::pictures(size, |n, to_eye| {
        let at = SurfacePoint { p_world: n, n, to_eye };
        let by_the_model =
            |lights: &[Light]| lit(&Material::matt(CLAY), lights, Highlight::Phong, &at, |_| true);
        [by_the_model(&[lamp]), CLAY * (AMBIENT + LAMP * n.dot(l)), by_the_model(&both)]
    })?;
    Ok([
        Drawing::picture(
            "lamp-alone",
            Text {
                en: "A ball under the lamp alone: the half that faces away is black.",
                nl: "Een bol onder alleen de lamp: de afgewende helft is zwart.",
            },
            alone,
        ),
        Drawing::picture(
            "without-max",
            Text {
                en: "With ambient light and without max: the half that faces away turns dark and black, the ambient light is taken from it.",
                nl: "Met omgevingslicht en zonder max: de afgewende helft wordt donker en zwart, het omgevingslicht is ervan afgetrokken.",
            },
            without_max,
        ),
        Drawing::picture(
            "with-max",
            Text {
                en: "With ambient light and with max: the half that faces away has the ambient light everywhere.",
                nl: "Met omgevingslicht en met max: de afgewende helft heeft overal het omgevingslicht.",
            },
            with_max,
        ),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Content;

    fn drawn(theta: f32) -> Vec<Drawing> {
        let mut values = Values::of(&FIGURE);
        values.set_size(64, 48).unwrap();
        values.set("theta", theta).unwrap();
        draw(&values).unwrap()
    }

    /// The colour of a drawing at a share of its width and height, from the top left corner.
    fn color(drawing: &Drawing, at: Vec2) -> Rgb {
        let Content::Picture(image) = &drawing.content else { panic!("{} is no picture", drawing.name) };
        let pixel = (at * vec2(64.0, 48.0)).as_uvec2();
        image.pixels()[(pixel.y * 64 + pixel.x) as usize]
    }

    #[test]
    fn without_max_the_other_light_is_taken_away() {
        let drawings = drawn(125.0);
        // Inside the ball, on the far side of its middle from the light.
        let away = Vec2::ONE - drawings[1].handles[0].at;
        let away = away.lerp(Vec2::splat(0.5), 0.2);
        assert_eq!(color(&drawings[1], away), Rgb::ZERO);
        assert!(color(&drawings[2], away).max_element() < 0.0, "less than no light");
        assert_eq!(color(&drawings[3], away), CLAY * AMBIENT);
    }

    #[test]
    fn a_dragged_light_changes_the_shading() {
        let (behind, above) = (drawn(150.0), drawn(20.0));
        // Above the middle of the ball is the n of the diagram.
        let top = vec2(0.5, 0.2);
        assert_eq!(color(&behind[1], top), Rgb::ZERO);
        assert!(color(&above[1], top).min_element() > 0.1);
    }
}
