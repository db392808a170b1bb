//! How does a matt surface look, and what is added? (L24–L28, E6, E8)

use canvas::srgb;
use geometry::Triangle;
use glam::{Vec3, vec3};
use lighting::{Highlight, Light, Material, Rgb, SurfacePoint, lambert, lit};
use raytrace::optics::fresnel;

use crate::sample::{Sequence, short, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, text, versions};

/// What a surface with normal z at the origin shows.
pub(super) fn shown(material: &Material, lights: &[Light], to_eye: Vec3) -> Rgb {
    let at = SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye };
    lit(material, lights, Highlight::Phong, &at, |_| true)
}

pub(super) fn sun(to_light: Vec3, color: Rgb) -> Light {
    Light::Directional { to_light, color }
}

pub(super) static THREE_PARTS: Claim = Claim {
    number: "L24",
    name: "three-parts",
    quote: "deels geabsorbeerd … deels weerspiegeld … deels doorgelaten",
    translation: "in part absorbed, in part reflected, in part transmitted",
    truth: text(
        "The parts add up to 1. At clear glass nothing is absorbed: what Fresnel's equations reflect and transmit, computed apart, is all the light.",
        "De delen zijn samen 1. Bij helder glas wordt niets geabsorbeerd: wat Fresnels vergelijkingen weerspiegelen en doorlaten, apart berekend, is al het licht.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::optics::fresnel"],
    examine: || {
        let trials = trials(200, 61, |random| {
            let (cosine, ratio) = (random.between(0.01, 1.0), random.between(0.4, 2.5));
            let sum = fresnel(cosine, ratio) + transmitted_share(cosine, ratio);
            // Quotients of numbers near 1.
            Trial::new(
                (sum - 1.0).abs() < 1e-5,
                format!("cos θ = {cosine:.3}, n₁/n₂ = {ratio:.3}: together {sum}"),
            )
        });
        judge("reflected and transmitted light are all that arrives", None, &trials)
    },
    pictures: None,
    versions: None,
};

/// The energy behind the surface, from the amplitudes that pass: m cos θ₂ / cos θ₁ times the mean of their squares.
fn transmitted_share(cosine: f32, ratio: f32) -> f32 {
    let cos_squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if cos_squared <= 0.0 {
        return 0.0;
    }
    let (m, behind) = (ratio.recip(), cos_squared.sqrt());
    let across = 2.0 * cosine / (cosine + m * behind);
    let along = 2.0 * cosine / (m * cosine + behind);
    m * behind / cosine * 0.5 * (across * across + along * along)
}

pub(super) static SUM: Claim = Claim {
    number: "L25",
    name: "sum-of-two",
    quote: "totale weerspiegelde licht is som van diffuse component en spiegelcomponent.",
    translation: "the reflected light is the sum of the diffuse and the specular component",
    truth: text(
        "The colour of a surface is that of its matt part plus that of its glossy part.",
        "De kleur van een oppervlak is die van het matte deel plus die van het glimmende deel.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::lit"],
    examine: || {
        let trials = trials(200, 62, |random| {
            let material = Material { diffuse: random.color(), specular: random.color(), exponent: 20.0 };
            let lights = [sun(random.direction(), random.color()), Light::Ambient { color: random.color() }];
            let to_eye = random.direction_around(Vec3::Z);
            let glossy = Material { diffuse: Rgb::ZERO, ..material };
            let whole = shown(&material, &lights, to_eye);
            let sum =
                shown(&Material::matt(material.diffuse), &lights, to_eye) + shown(&glossy, &lights, to_eye);
            // Sums of a few numbers up to 2.
            Trial::new(whole.abs_diff_eq(sum, 1e-6), format!("{} against {}", short(whole), short(sum)))
        });
        judge("the whole is the sum of the diffuse and the specular part", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static SAME_FROM_EVERYWHERE: Claim = Claim {
    number: "L26",
    name: "same-from-everywhere",
    quote: "Mat oppervlak ziet er vanaf alle richtingen even helder uit",
    translation: "a matt surface looks equally bright from all directions",
    truth: text(
        "The direction to the eye does not occur in the diffuse term.",
        "De richting naar het oog komt in de diffuse term niet voor.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::lambert", "lighting::lit"],
    examine: || {
        let trials = trials(200, 63, |random| {
            let material = Material::matt(random.color());
            let lights = [sun(random.direction_around(Vec3::Z), random.color())];
            let [one, other] = [0; 2].map(|_| shown(&material, &lights, random.direction_around(Vec3::Z)));
            Trial::new(one == other, format!("{} from one side, {} from another", short(one), short(other)))
        });
        judge("a matt surface has one colour for all directions to the eye", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static COSINE: Claim = Claim {
    number: "L26",
    name: "cosine-law",
    quote: "c = c_r c_l n·l = c_r c_l cos θ",
    translation: "c = c_r c_l n·l = c_r c_l cos θ",
    truth: text(
        "n and l have length 1, so n·l is the cosine of the angle of incidence.",
        "n en l hebben lengte 1, dus n·l is de cosinus van de invalshoek.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::lambert", "lighting::lit"],
    examine: || {
        let trials = trials(200, 67, |random| {
            let (c_r, c_l, theta) = (random.color(), random.color(), random.between(0.0, 90.0).to_radians());
            let to_light = vec3(theta.sin() * 0.6, theta.sin() * 0.8, theta.cos());
            let c = shown(&Material::matt(c_r), &[sun(to_light, c_l)], random.direction_around(Vec3::Z));
            let right = c_r * c_l * theta.cos();
            Trial::new(
                c.abs_diff_eq(right, 1e-6),
                format!("θ = {theta:.3}: {} and {}", short(c), short(right)),
            )
        });
        judge("c = c_r c_l cos θ", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static FACING_AWAY: Claim = Claim {
    number: "L27",
    name: "facing-away",
    quote: "Als normaalvector in punt in andere richting, dan n·l negatief. In dit geval: c = c_r c_l max(0, n·l)",
    translation: "where the normal points away from the light n·l is negative; then c = c_r c_l max(0, n·l)",
    truth: text(
        "With the maximum a surface that faces away from the light receives none, and one that faces it n·l.",
        "Met het maximum krijgt een oppervlak dat van het licht af kijkt niets, en een ander n·l.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::lambert"],
    examine: || {
        let trials = trials(200, 64, |random| {
            let (n, l) = (random.direction(), random.direction());
            let (with, without) = (lambert(n, l), n.dot(l));
            let holds = if without < 0.0 { with == 0.0 } else { (with - without).abs() < 1e-6 };
            Trial::new(holds, format!("n·l = {without:.3} gives {with:.3}"))
        });
        judge("light is 0 where n·l < 0, and n·l elsewhere", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static BLACK_SHADOWS: Claim = Claim {
    number: "L28",
    name: "black-without-ambient",
    quote: "Probleem: punt met normaal weg van lichtbron is zwart. Oplossing: voeg constante kleur toe",
    translation: "problem: a point whose normal faces away from the light is black; solution: add a constant colour",
    truth: text(
        "Without ambient light such a point is black; with it, it has c_r c_a, the same at every angle.",
        "Zonder omgevingslicht is zo'n punt zwart; met omgevingslicht heeft het c_r c_a, onder elke hoek gelijk.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::lit"],
    examine: || {
        let trials = trials(200, 65, |random| {
            let material = Material::matt(random.color());
            let (light, c_a) = (sun(-random.direction_around(Vec3::Z), random.color()), random.color());
            let black = shown(&material, &[light], Vec3::Z);
            let lifted = shown(&material, &[light, Light::Ambient { color: c_a }], Vec3::Z);
            let holds = black == Rgb::ZERO && lifted.abs_diff_eq(material.diffuse * c_a, 1e-6);
            Trial::new(holds, format!("{} without, {} with ambient light", short(black), short(lifted)))
        });
        judge("what faces away is black, and c_r c_a with ambient light", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static ANGLE: Claim = Claim {
    number: "E6",
    name: "proportional-to-the-angle",
    quote: "kleur c van oppervlak is evenredig met hoek tussen normaal n … en richting l van de lichtbron",
    translation: "the colour is proportional to the angle between the normal and the direction to the light",
    truth: text(
        "Proportional to the cosine of the angle: greatest at 0°, a half at 60°, none at 90°. The formula on the slide says so.",
        "Evenredig met de cosinus van de hoek: het grootst bij 0°, de helft bij 60°, niets bij 90°. De formule op de dia zegt dat ook.",
    ),
    expected: Verdict::Refuted,
    code: &["lighting::lambert"],
    examine: || {
        let angles = (0..=18_u8).map(|k| f32::from(k) * 5.0);
        let trials: Vec<Trial> = angles
            .map(|degrees| {
                let (slide, right) = (slide_lambert(degrees), by_cosine(degrees));
                Trial::new(
                    (slide - right).abs() < 1e-3,
                    format!("{degrees}°: {slide:.3} instead of {right:.3}"),
                )
            })
            .collect();
        judge("c = θ/90°", None, &trials).compared(
            "light at 60° from the normal",
            format!(
                "{:.3} (or {:.3}, if it falls with the angle)",
                slide_lambert(60.0),
                1.0 - slide_lambert(60.0)
            ),
            format!("{:.3}", by_cosine(60.0)),
        )
    },
    pictures: None,
    versions: Some(versions::angle),
};

pub(super) fn slide_lambert(degrees: f32) -> f32 {
    degrees / 90.0
}

pub(super) fn by_cosine(degrees: f32) -> f32 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    lambert(Vec3::Z, vec3(sin, 0.0, cos))
}

pub(super) static NO_FALLOFF: Claim = Claim {
    number: "E6",
    name: "no-falloff",
    quote: "c_l is intensiteit van puntlichtbron (constant voor alle voorwerpen)",
    translation: "c_l is the intensity of the point light (constant for all objects)",
    truth: text(
        "Constant for a directional light. Of a point light a surface twice as far away receives a quarter; the lecture leaves that out, and so does this code.",
        "Constant voor een richtingslicht. Van een puntlicht krijgt een oppervlak op dubbele afstand een kwart; het college laat dat weg, en deze code ook.",
    ),
    expected: Verdict::Refuted,
    code: &["lighting::Light::illumination", "geometry::Triangle"],
    examine: || {
        let trials: Vec<Trial> = [1.0, 2.0, 4.0, 8.0]
            .into_iter()
            .map(|distance| {
                let (slide, right) = (slide_intensity(distance), caught(distance) / caught(1.0));
                // A patch of a hundredth: its own size changes the share by less than 1e-3.
                Trial::new(
                    (slide - right).abs() < 1e-2,
                    format!("{distance} units away: {slide:.3} instead of {right:.3}"),
                )
            })
            .collect();
        judge("a surface receives the same from a point light at any distance", None, &trials).compared(
            "twice as far from the lamp",
            format!("{:.3} of the light", slide_intensity(2.0) / slide_intensity(1.0)),
            format!("{:.3}", caught(2.0) / caught(1.0)),
        )
    },
    pictures: None,
    versions: Some(versions::falloff),
};

/// The intensity that the model takes, at a distance from a lamp of intensity 1.
pub(super) fn slide_intensity(distance: f32) -> f32 {
    let lamp = Light::Point { position: Vec3::Z * distance, color: Rgb::ONE };
    lamp.illumination(Vec3::ZERO).map_or(0.0, |light| light.color.x)
}

/// How much of all directions a small patch takes up, seen from the lamp: its area on the unit sphere.
pub(super) fn caught(distance: f32) -> f32 {
    let corner = |x: f32, y: f32| vec3(x, y, distance).normalize();
    Triangle::new(corner(0.0, 0.0), corner(0.01, 0.0), corner(0.0, 0.01)).area()
}

pub(super) static BETWEEN_0_AND_1: Claim = Claim {
    number: "E8",
    name: "between-0-and-1",
    quote: "Kleur c tussen 0 en 1",
    translation: "colour c is between 0 and 1",
    truth: text(
        "0.8(0.2 + 1) + 1 = 1.96: diffuse, ambient and specular light add up. Clamp or tone-map, once, at output.",
        "0,8(0,2 + 1) + 1 = 1,96: diffuus, omgevings- en spiegellicht tellen op. Begrens of tonemap, één keer, bij de uitvoer.",
    ),
    expected: Verdict::Refuted,
    code: &["lighting::lit", "canvas::srgb::encode"],
    examine: between_0_and_1,
    pictures: None,
    versions: Some(versions::between_0_and_1),
};

fn between_0_and_1() -> Examination {
    let color = |c_r: f32, c_a: f32, to_eye: Vec3| {
        let lights = [Light::Ambient { color: Rgb::splat(c_a) }, sun(Vec3::Z, Rgb::ONE)];
        shown(&Material::new(Rgb::splat(c_r), 32.0), &lights, to_eye).x
    };
    let mut random = Sequence::new(66);
    let trials: Vec<Trial> = (0..200)
        .map(|_| {
            let (c_r, c_a) = (random.between(0.0, 1.0), random.between(0.0, 0.5));
            let c = color(c_r, c_a, random.direction_around(Vec3::Z));
            Trial::new((0.0..=1.0).contains(&c), format!("c_r = {c_r:.2}, c_a = {c_a:.2}: c = {c:.3}"))
        })
        .collect();
    let c = color(0.8, 0.2, Vec3::Z);
    judge("c lies between 0 and 1", None, &trials).compared(
        "c_r = 0.8, c_a = 0.2, c_l = 1, everything head-on",
        format!("c = {c:.2}"),
        format!("{:.2} after clamping at output", srgb::decode(srgb::encode(c))),
    )
}
