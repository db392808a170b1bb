//! Where do the slides' highlights go wrong? (E3, E4)

use canvas::Image;
use geometry::Sphere;
use glam::{Vec3, vec3};
use lighting::{Rgb, blinn_highlight, halfway, lambert, phong_highlight, reflect};

use crate::sample::{pipeline, short, trials};
use crate::stage::SIZE;
use crate::{Claim, Trial, Verdict, judge, pair, text, versions};
use figures::{Drawing, Drawn};

/// (h·n)^p as on the slide: no maximum, no gate.
pub(super) fn slide_blinn(n: Vec3, to_light: Vec3, to_eye: Vec3, p: f32) -> f32 {
    ((to_eye + to_light) / (to_eye + to_light).length()).dot(n).powf(p)
}

/// max(0, e·r)^p as on the slide: no gate.
fn slide_phong(n: Vec3, to_light: Vec3, to_eye: Vec3, p: f32) -> f32 {
    to_eye.dot(reflect(n, to_light)).max(0.0).powf(p)
}

/// The light behind the surface z = 0, and an eye low before it: e ∝ (1, 0, 0.1), l ∝ (−0.5, 0, −0.2).
pub(super) fn behind() -> (Vec3, Vec3) {
    (vec3(1.0, 0.0, 0.1).normalize(), vec3(-0.5, 0.0, -0.2).normalize())
}

const ON_THE_NORMALS_SIDE: &str = "eye and light lie on the normal's side";

pub(super) static ALWAYS_POSITIVE: Claim = Claim {
    number: "E3",
    name: "h-n-always-positive",
    quote: "vervangen door h·n (altijd positief)",
    translation: "replaced by h·n (always positive)",
    truth: text(
        "Positive only if eye and light lie on the normal's side. With the light behind the surface h·n = −0.971 for e ∝ (1, 0, 0.1), l ∝ (−0.5, 0, −0.2), and (h·n)¹⁰ = 0.748 lights a point that no light reaches. Clamp, and gate by n·l > 0.",
        "Alleen positief als oog en licht aan de kant van de normaal liggen. Met het licht achter het oppervlak is h·n = −0,971 voor e ∝ (1, 0, 0,1), l ∝ (−0,5, 0, −0,2), en (h·n)¹⁰ = 0,748 verlicht een punt waar geen licht komt. Begrens op 0 en eis n·l > 0.",
    ),
    expected: Verdict::HoldsIf(ON_THE_NORMALS_SIDE),
    code: &["lighting::halfway", "lighting::blinn_highlight"],
    examine: || {
        let trials = trials(500, 81, |random| {
            let (e, l) = (random.direction_around(Vec3::Z), random.direction());
            let product = halfway(e, l).map_or(f32::NAN, |h| h.z);
            let numbers = format!("e = {}, l = {}, n = z: h·n = {product:.3}", short(e), short(l));
            Trial::under(l.z > 0.0, product > 0.0, numbers)
        });
        let (e, l) = behind();
        let product = halfway(e, l).map_or(f32::NAN, |h| h.z);
        judge("h·n > 0", Some(ON_THE_NORMALS_SIDE), &trials)
            .with_right(
                "our highlight is 0 where the light is behind the surface, else (h·n)^p",
                &gated(blinn_highlight, slide_blinn),
            )
            .compared(
                "e ∝ (1, 0, 0.1), l ∝ (−0.5, 0, −0.2), n = z",
                format!("h·n = {product:.3} and (h·n)¹⁰ = {:.3}", slide_blinn(Vec3::Z, l, e, 10.0)),
                format!(
                    "highlight {:.3}: the light is behind the surface",
                    blinn_highlight(Vec3::Z, l, e, 10.0)
                ),
            )
    },
    pictures: Some(dark_side_pair),
    versions: None,
};

pub(super) static A_NUMBER: Claim = Claim {
    number: "E3",
    name: "power-of-a-negative",
    quote: "c_l (h·n)^p",
    translation: "c_l (h·n)^p",
    truth: text(
        "Of a negative h·n an odd power is negative light and a fractional one no number; for e = −l there is no h at all.",
        "Van een negatieve h·n is een oneven macht negatief licht en een gebroken macht geen getal; voor e = −l bestaat h niet.",
    ),
    expected: Verdict::HoldsIf(ON_THE_NORMALS_SIDE),
    code: &["lighting::blinn_highlight"],
    examine: || {
        let mut trials = trials(300, 82, |random| {
            let p = [9.0, 10.0, 10.5, 11.0][random.below(4)];
            number_trial(random.direction_around(Vec3::Z), random.direction(), p)
        });
        trials.push(number_trial(Vec3::X, Vec3::NEG_X, 10.0));
        let (e, l) = behind();
        let slide = [11.0, 10.5].map(|p| slide_blinn(Vec3::Z, l, e, p));
        let right = [11.0, 10.5].map(|p| blinn_highlight(Vec3::Z, l, e, p));
        let ours = crate::sample::trials(300, 82, |random| {
            let (e, l, p) = (random.direction(), random.direction(), random.between(0.5, 12.0));
            let c = blinn_highlight(Vec3::Z, l, if random.below(9) == 0 { -l } else { e }, p);
            Trial::new(c >= 0.0, format!("{c}"))
        });
        judge("(h·n)^p is a number and not negative", Some(ON_THE_NORMALS_SIDE), &trials)
            .with_right("our highlight is a number and not negative", &ours)
            .compared(
                "the same e and l, p = 11 and 10.5; then e = −l",
                format!(
                    "{:.3} and {}; {}",
                    slide[0],
                    slide[1],
                    slide_blinn(Vec3::Z, Vec3::X, Vec3::NEG_X, 10.0)
                ),
                format!(
                    "{} and {}; {}",
                    right[0],
                    right[1],
                    blinn_highlight(Vec3::Z, Vec3::X, Vec3::NEG_X, 10.0)
                ),
            )
    },
    pictures: None,
    versions: Some(versions::a_number),
};

fn number_trial(e: Vec3, l: Vec3, p: f32) -> Trial {
    let c = slide_blinn(Vec3::Z, l, e, p);
    let meets = e.z > 0.0 && l.z > 0.0;
    Trial::under(meets, c >= 0.0, format!("e = {}, l = {}, p = {p}: {c:.1e}", short(e), short(l)))
}

type Form = fn(Vec3, Vec3, Vec3, f32) -> f32;

/// Trials of our form: nothing where the light is behind the surface, and the slide's number where eye and light are before it.
fn gated(ours: Form, slide: Form) -> Vec<Trial> {
    trials(300, 86, |random| {
        let (e, l) = (random.direction_around(Vec3::Z), random.direction());
        let c = ours(Vec3::Z, l, e, 9.0);
        let right = if l.z > 0.0 { slide(Vec3::Z, l, e, 9.0) } else { 0.0 };
        // A ninth power multiplies a rounding by nine.
        Trial::new((c - right).abs() < 1e-5, format!("{c} instead of {right}"))
    })
}

const SURFACE_LIT: &str = "n·l > 0";

pub(super) static REFLECTED_LEAKS: Claim = Claim {
    number: "E3",
    name: "e-r-leaks-too",
    quote: "c_r(c_a + c_l max(0, n·l)) + c_l max(0, e·r)^p",
    translation: "c_r(c_a + c_l max(0, n·l)) + c_l max(0, e·r)^p",
    truth: text(
        "The maximum does not help: with the light below the horizon, n·l = −0.17, the mirror direction lies below it too and an eye just above sees e·r = 0.97. The highlight too needs n·l > 0.",
        "Het maximum helpt niet: met het licht onder de horizon, n·l = −0,17, ligt de spiegelrichting daar ook onder en ziet een oog er net boven e·r = 0,97. Ook de glansplek vraagt n·l > 0.",
    ),
    expected: Verdict::HoldsIf(SURFACE_LIT),
    code: &["lighting::phong_highlight"],
    examine: || {
        let trials = trials(500, 83, |random| {
            let (e, l) = (random.direction_around(Vec3::Z), random.direction());
            let (slide, right) = (slide_phong(Vec3::Z, l, e, 4.0), phong_highlight(Vec3::Z, l, e, 4.0));
            let numbers = format!(
                "n·l = {:.2}, e·r = {:.2}: {slide:.3} instead of {right:.3}",
                l.z,
                e.dot(reflect(Vec3::Z, l))
            );
            // The clamp to 1 alone sets them apart, by rounding.
            Trial::under(l.z > 0.0, (slide - right).abs() < 1e-6, numbers)
        });
        let l = vec3(-(1.0 - 0.17_f32.powi(2)).sqrt(), 0.0, -0.17);
        let e = vec3(0.997, 0.0, 0.0775).normalize();
        judge("the highlight is that of a surface that the light reaches", Some(SURFACE_LIT), &trials)
            .with_right(
                "our highlight is 0 where the light is behind the surface, else (e·r)^p",
                &gated(phong_highlight, slide_phong),
            )
            .compared(
                format!("n·l = {:.2}, e·r = {:.2}, p = 10", l.z, e.dot(reflect(Vec3::Z, l))),
                format!("{:.3}", slide_phong(Vec3::Z, l, e, 10.0)),
                format!("{:.3}", phong_highlight(Vec3::Z, l, e, 10.0)),
            )
    },
    pictures: Some(grazing_pair),
    versions: None,
};

/// A ball with the light behind it, left of the eye's line.
fn dark_side_pair() -> Drawn {
    let to_light = vec3(-0.55, 0.0, -0.83).normalize();
    let alt_slide = text(
        "A dark ball lit from behind at the left. Its right rim, which no light reaches, glows, and the glow at the left reaches far into the dark side.",
        "Een donkere bal, van linksachter belicht. De rechterrand, waar geen licht komt, gloeit, en de gloed links reikt ver in de donkere kant.",
    );
    let alt_right = text(
        "A dark ball lit from behind at the left: only its left rim is bright.",
        "Een donkere bal, van linksachter belicht: alleen de linkerrand is licht.",
    );
    pair(
        Drawing::picture("slide", alt_slide, ball(slide_blinn, to_light)),
        Drawing::picture("right", alt_right, ball(blinn_highlight, to_light)),
    )
}

/// The same with the other form, and the light nearly behind the ball.
fn grazing_pair() -> Drawn {
    let to_light = vec3(-0.34, 0.0, -0.94).normalize();
    let alt_slide = text(
        "A dark ball, lit from behind, with a broad glowing crescent at the left, far into the side that no light reaches.",
        "Een donkere bal, van achteren belicht, met links een brede gloeiende sikkel, tot ver in de kant waar geen licht komt.",
    );
    let alt_right = text(
        "A dark ball, lit from behind: only a hair of light on its left rim.",
        "Een donkere bal, van achteren belicht: alleen op de linkerrand een streepje licht.",
    );
    pair(
        Drawing::picture("slide", alt_slide, ball(slide_phong, to_light)),
        Drawing::picture("right", alt_right, ball(phong_highlight, to_light)),
    )
}

fn ball(highlight: Form, to_light: Vec3) -> Image {
    let pipeline = pipeline((vec3(0.0, 0.0, 4.0), Vec3::ZERO), 0.6, (-1.0, -9.0), SIZE);
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    Image::from_fn(SIZE.0, SIZE.1, |i, j| {
        let ray = raytrace::viewing_ray(&pipeline, i as f32, j as f32);
        let Some(t) = raytrace::sphere::intersect(&ray, &sphere, 0.0, f32::INFINITY) else {
            return Rgb::new(0.02, 0.02, 0.03);
        };
        let p = ray.at(t);
        let (n, to_eye) = (sphere.normal(p), -ray.direction.normalize());
        let matt = Rgb::new(0.1, 0.25, 0.6) * (0.15 + lambert(n, to_light));
        matt + Rgb::ONE * highlight(n, to_light, to_eye, 10.0)
    })
}

pub(super) static SAME_HIGHLIGHT: Claim = Claim {
    number: "E4",
    name: "e-r-or-h-n",
    quote: "… + c_l max(0, e·r)^p ⇒ … + c_l (h·n)^p",
    translation: "… + c_l max(0, e·r)^p ⇒ … + c_l (h·n)^p",
    truth: text(
        "Two different highlights. In one plane σ = 2ω, so h·n needs about 4p to match p: at ω = 10° and p = 32 they give 0.137 (e·r), 0.613 (h·n, p) and 0.141 (h·n, 4p).",
        "Twee verschillende glansplekken. In één vlak is σ = 2ω, dus h·n heeft ongeveer 4p nodig bij p: bij ω = 10° en p = 32 geven ze 0,137 (e·r), 0,613 (h·n, p) en 0,141 (h·n, 4p).",
    ),
    expected: Verdict::Refuted,
    code: &["lighting::phong_highlight", "lighting::blinn_highlight"],
    examine: || {
        let trials = trials(200, 84, |random| {
            let (omega, p) = (random.between(3.0, 30.0), random.between(4.0, 60.0));
            let [phong, blinn, _] = at_omega(omega, p);
            Trial::new(
                (phong - blinn).abs() < 1e-3,
                format!("ω = {omega:.1}°, p = {p:.1}: {phong:.3} by e·r, {blinn:.3} by h·n"),
            )
        });
        let [phong, blinn, with_4p] = at_omega(10.0, 32.0);
        let fourfold = crate::sample::trials(200, 84, |random| {
            let (omega, p) = (random.between(3.0, 30.0), random.between(4.0, 60.0));
            let [phong, _, blinn] = at_omega(omega, p);
            // The logarithms differ by p·ω⁴ to first order: at most ω²/e² ≤ 0.04 of the light, and a little for the rest.
            Trial::new(
                (phong - blinn).abs() < 0.05,
                format!("ω = {omega:.1}°, p = {p:.1}: {phong:.3}, {blinn:.3}"),
            )
        });
        judge("(h·n)^p is what (e·r)^p is", None, &trials)
            .with_right("(h·n)^4p is within 0.05 of it", &fourfold)
            .compared(
                format!("ω = 10°, p = 32, where e·r gives {phong:.3}"),
                format!("{blinn:.3} (h·n, p)"),
                format!("{with_4p:.3} (h·n, 4p)"),
            )
    },
    pictures: None,
    versions: Some(versions::same_highlight),
};

/// With l on the normal and e at 2ω from it: (e·r)^p, (h·n)^p, (h·n)^4p.
pub(super) fn at_omega(omega_degrees: f32, p: f32) -> [f32; 3] {
    let (sin, cos) = (2.0 * omega_degrees).to_radians().sin_cos();
    let e = vec3(sin, 0.0, cos);
    [
        phong_highlight(Vec3::Z, Vec3::Z, e, p),
        blinn_highlight(Vec3::Z, Vec3::Z, e, p),
        blinn_highlight(Vec3::Z, Vec3::Z, e, 4.0 * p),
    ]
}
