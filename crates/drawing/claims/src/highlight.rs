//! Where is the highlight, how wide, and what colour has it? (L29–L31, L33, L35)

use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material, Rgb, SurfacePoint, halfway, lit, phong_highlight, reflect};
use raytrace::{Object, Settings, Shape, Surface, ray_color};

use crate::sample::{short, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, measured, stage, text};

pub(super) static LIGHTS_COLOUR: Claim = Claim {
    number: "L29",
    name: "highlight-has-the-lights-colour",
    quote: "Op glansplek lijkt appel niet rood, maar wit (Kleur invallende licht)",
    translation: "in the highlight the apple looks not red but white (the colour of the light)",
    truth: text(
        "What the highlight adds is a multiple of the light's colour, whatever the colour of the surface.",
        "Wat de glansplek toevoegt is een veelvoud van de kleur van het licht, wat de kleur van het oppervlak ook is.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::lit", "lighting::Material::new"],
    examine: || {
        let trials = trials(200, 71, |random| {
            let (diffuse, color) = (random.color(), random.color());
            let at =
                SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye: random.direction_around(Vec3::Z) };
            let lights = [Light::Directional { to_light: random.direction_around(Vec3::Z), color }];
            let shown = |material: &Material| lit(material, &lights, Highlight::Blinn, &at, |_| true);
            let added = shown(&Material::new(diffuse, 8.0)) - shown(&Material::matt(diffuse));
            // Parallel to the light's colour: their cross product is rounding of numbers below 2.
            let holds = added.cross(color).length() < 1e-6;
            Trial::new(holds, format!("light {} adds {}", short(color), short(added)))
        });
        judge("the highlight adds a multiple of the light's colour", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static MAY_BE_NEGATIVE: Claim = Claim {
    number: "L30",
    name: "first-attempt-negative",
    quote: "Twee problemen: inproduct kan negatief zijn …",
    translation: "two problems: the inner product can be negative …",
    truth: text(
        "It can, even for an eye and a light on the side of the normal: with the light low and the eye beside it.",
        "Dat kan, ook met oog en licht aan de kant van de normaal: bij laag licht en het oog ernaast.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::reflect"],
    examine: || {
        let mut random = crate::sample::Sequence::new(72);
        let samples = (0..1000).map(|_| {
            let (e, l) = (random.direction_around(Vec3::Z), random.direction_around(Vec3::Z));
            (e.dot(reflect(Vec3::Z, l)), e, l)
        });
        let negative: Vec<_> = samples.filter(|(product, ..)| *product < 0.0).collect();
        let least = negative.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0));
        let numbers = least.map_or(String::new(), |(product, e, l)| {
            format!("e·r = {product:.3} for e = {}, l = {}, n = z; ", short(e), short(l))
        });
        measured(!negative.is_empty(), format!("{numbers}{} of 1000 pairs e, l are negative", negative.len()))
    },
    pictures: None,
    versions: None,
};

/// The angle σ, in degrees, at which a highlight has half its brightness, by bisection.
fn half_width(exponent: f32) -> f32 {
    let (mut bright, mut dark) = (0.0_f32, 90.0_f32);
    for _ in 0..30 {
        let middle = 0.5 * (bright + dark);
        let (sin, cos) = middle.to_radians().sin_cos();
        let c = phong_highlight(Vec3::Z, Vec3::Z, vec3(sin, 0.0, cos), exponent);
        if c > 0.5 { bright = middle } else { dark = middle }
    }
    bright
}

pub(super) static TOO_WIDE: Claim = Claim {
    number: "L30",
    name: "first-attempt-too-wide",
    quote: "… en highlight te breed",
    translation: "… and the highlight is too wide",
    truth: text(
        "e·r alone still has half its brightness 60° off the mirror direction: as wide as diffuse light. With p = 32 it is 12°.",
        "e·r alleen heeft 60° naast de spiegelrichting nog de halve helderheid: zo breed als diffuus licht. Met p = 32 is dat 12°.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::phong_highlight"],
    examine: || {
        let (first, with_p) = (half_width(1.0), half_width(32.0));
        // Too wide: no narrower than Lambert's cosine, which has half its brightness at 60°.
        measured(
            first > 59.9 && with_p < first,
            format!("half brightness at {first:.1}° for (e·r), at {with_p:.1}° for (e·r)³²"),
        )
    },
    pictures: None,
    versions: None,
};

pub(super) static NARROWER: Claim = Claim {
    number: "L31",
    name: "larger-p-narrower",
    quote: "The effect of the Phong exponent on highlight characteristics.",
    translation: "the effect of the Phong exponent on the highlight",
    truth: text(
        "The larger p, the narrower the highlight; four times p, half the width.",
        "Hoe groter p, hoe smaller de glansplek; vier keer p, de halve breedte.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::phong_highlight"],
    examine: || {
        let widths: Vec<(i32, f32)> = (0..11).map(|k| (1 << k, half_width((1 << k) as f32))).collect();
        let trials: Vec<Trial> = widths
            .windows(2)
            .map(|two| {
                let ((p, wide), (q, narrow)) = (two[0], two[1]);
                Trial::new(narrow < wide, format!("p = {p}: {wide:.2}°, p = {q}: {narrow:.2}°"))
            })
            .collect();
        let list: Vec<_> = widths.iter().step_by(2).map(|(p, w)| format!("{w:.1}° for p = {p}")).collect();
        judge("twice the exponent gives a narrower highlight", None, &trials)
            .noted(format!("half brightness at {}", list.join(", ")))
    },
    pictures: None,
    versions: None,
};

const NOT_OPPOSITE: &str = "e is not −l";

pub(super) static HALFWAY: Claim = Claim {
    number: "L33",
    name: "halfway-vector",
    quote: "The unit vector h is halfway between l and e.",
    translation: "the unit vector h is halfway between l and e",
    truth: text(
        "h has length 1, makes equal angles with e and l, and does not change if they are exchanged. For e = −l there is no h.",
        "h heeft lengte 1, maakt gelijke hoeken met e en l en verandert niet als die verwisseld worden. Voor e = −l bestaat h niet.",
    ),
    expected: Verdict::HoldsIf(NOT_OPPOSITE),
    code: &["lighting::halfway"],
    examine: || {
        let trials = trials(200, 73, |random| {
            let e = random.direction();
            let l = if random.below(10) == 0 { -e } else { random.direction() };
            let Some(h) = halfway(e, l) else {
                return Trial::under(l != -e, false, format!("e = {}, l = −e: no h", short(e)));
            };
            // For e and l nearly opposite the sum is short and its rounding weighs more.
            let slack = 1e-6 / (e + l).length();
            let holds = h.is_normalized() && (h.dot(e) - h.dot(l)).abs() < slack && halfway(l, e) == Some(h);
            Trial::under(l != -e, holds, format!("e = {}, l = {}: h = {}", short(e), short(l), short(h)))
        });
        judge("h is a unit vector with equal angles to e and l", Some(NOT_OPPOSITE), &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static EMPIRICAL: Claim = Claim {
    number: "L35",
    name: "empirical",
    quote: "Phong belichtingsmodel is empirisch model …",
    translation: "the Phong lighting model is an empirical model …",
    truth: text(
        "No law of nature: a surface can send out more light than it receives, as the numbers of one show.",
        "Geen natuurwet: een oppervlak kan meer licht uitstralen dan het ontvangt, zoals de getallen van één oppervlak tonen.",
    ),
    expected: Verdict::Holds,
    code: &["lighting::phong", "lighting::reflect"],
    examine: || {
        let to_light = vec3(0.75_f32.sqrt(), 0.0, 0.5);
        let at = SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye: reflect(Vec3::Z, to_light) };
        let lights = [Light::Directional { to_light, color: Rgb::ONE }];
        let material = Material::new(Rgb::splat(0.8), 1.0);
        let c = lit(&material, &lights, Highlight::Phong, &at, |_| true).x;
        let (received, sent) =
            (lighting::lambert(Vec3::Z, to_light), mean_over_hemisphere(&material, &lights));
        measured(
            sent > received,
            format!(
                "c_r = 0.8, p = 1, light 1 at 60°: {received:.2} is received, {sent:.2} is sent out over all directions, and the mirror direction shows {c:.2}"
            ),
        )
    },
    pictures: None,
    versions: None,
};

/// What leaves the surface: the colour seen, weighted by the cosine over the hemisphere; a white matt surface sends what it
/// receives.
fn mean_over_hemisphere(material: &Material, lights: &[Light]) -> f32 {
    const STEPS: u16 = 60;
    let share = |k: u16| (f32::from(k) + 0.5) / f32::from(STEPS);
    let mut sum = 0.0;
    for (a, b) in (0..STEPS).flat_map(|a| (0..STEPS).map(move |b| (share(a), share(b)))) {
        // Equal steps of sin² θ weigh directions by their cosine.
        let (sin_phi, cos_phi) = (std::f32::consts::TAU * b).sin_cos();
        let to_eye = vec3(a.sqrt() * cos_phi, a.sqrt() * sin_phi, (1.0 - a).sqrt());
        let at = SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye };
        sum += lit(material, lights, Highlight::Phong, &at, |_| true).x;
    }
    sum / f32::from(STEPS * STEPS)
}

pub(super) static LOCAL: Claim = Claim {
    number: "L35",
    name: "local",
    quote: "… model voor locale belichting",
    translation: "… a model of local lighting",
    truth: text(
        "No other surface takes part: a ball hidden from view changes no colour, unless shadow rays are sent.",
        "Geen ander oppervlak doet mee: een bal buiten beeld verandert geen kleur, tenzij er schaduwstralen zijn.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::ray_color"],
    examine: local,
    pictures: None,
    versions: None,
};

fn local() -> Examination {
    let alone = stage::world();
    let red = Surface::opaque(Material::matt(Rgb::X));
    let ball = Shape::Sphere(geometry::Sphere::new(vec3(2.0, 9.0, 3.0), 2.5));
    let ball = Object::new(ball, Mat4::IDENTITY, vec![red]).expect("an object");
    let mut objects = alone.objects().to_vec();
    objects.push(ball);
    let mut together = raytrace::World::new(objects, alone.lights.clone());
    together.background = alone.background;
    let mut shadowed = 0;
    let trials = trials(300, 74, |random| {
        let (eye, target) = (vec3(0.0, 2.2, 6.0), 2.0 * random.point(1.0) * vec3(1.0, 0.0, 1.0));
        let ray = geometry::Ray::through(eye, target);
        let color = |world, shadows| {
            ray_color(world, &ray, 0.0, f32::INFINITY, &Settings { shadows, ..Settings::default() })
        };
        shadowed += usize::from(color(&alone, true) != color(&together, true));
        let [before, after] = [&alone, &together].map(|world| color(world, false));
        Trial::new(before == after, format!("{} becomes {}", short(before), short(after)))
    });
    judge("a red ball above the scene changes no colour without shadow rays", None, &trials)
        .noted(format!("with shadow rays {shadowed} of 300 colours change"))
}
