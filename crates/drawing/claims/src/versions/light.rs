//! How bright, and at what cost? (E3, E4, E5, E6, E8)

use canvas::{Rgb, srgb};
use glam::Vec3;
use lighting::{Light, Material, blinn_highlight};

use super::version;
use crate::Version;
use crate::cost::{Count, operands, slide_h, slide_r};
use crate::diffuse::{by_cosine, caught, shown, slide_intensity, slide_lambert, sun};
use crate::highlight_errors::{at_omega, behind, slide_blinn};
use figures::Words;

/// A fractional power of a negative number.
pub(crate) fn a_number() -> [Version; 2] {
    let (e, l) = behind();
    let powers = |says: &str, form: fn(Vec3, Vec3, Vec3, f32) -> f32| {
        let [odd, fractional] = [11.0, 10.5].map(|p| form(Vec3::Z, l, e, p));
        let [en, nl] =
            if fractional.is_nan() { ["no number", "geen getal"] } else { ["a number", "een getal"] };
        version(
            says,
            format!("light from behind: {odd:.3} for p = 11; for p = 10.5 {fractional}, {en}"),
            format!("licht van achteren: {odd:.3} voor p = 11; voor p = 10.5 {fractional}, {nl}"),
        )
    };
    [powers("c_l (h·n)^p", slide_blinn), powers("c_l max(0, h·n)^p, n·l > 0", blinn_highlight)]
}

/// The same exponent in both forms, and four times as much in the second.
pub(crate) fn same_highlight() -> [Version; 2] {
    let [phong, blinn, with_4p] = at_omega(10.0, 32.0);
    let instead = |says: &str, value: f32| {
        version(
            says,
            format!("ω = 10°, p = 32: {value:.3} where (e·r)^p is {phong:.3}"),
            format!("ω = 10°, p = 32: {value:.3} waar (e·r)^p {phong:.3} is"),
        )
    };
    [instead("(e·r)^p ⇒ (h·n)^p", blinn), instead("(e·r)^p ⇒ (h·n)^4p", with_4p)]
}

/// What the slide calls expensive, and what is to replace it.
pub(crate) fn cost() -> [Version; 2] {
    let counted = |says: Words, form: fn(&Count, Vec3, Vec3, Vec3) -> f32, name: &str| {
        let (count, [e, l, n]) = (Count::default(), operands());
        form(&count, e, l, n);
        let (all, roots) = (count.all(), count.roots());
        version(
            says,
            format!("{name}: {all} operations, {roots} of them square roots"),
            format!("{name}: {all} bewerkingen, waarvan {roots} wortels"),
        )
    };
    let dear =
        Words::new("e·r is expensive: replace it by h·n", "e·r is rekenintensief: vervang het door h·n");
    let cheap = Words::new(
        "e·r with r = 2(n·l)n − l needs no square root",
        "e·r met r = 2(n·l)n − l heeft geen wortel nodig",
    );
    [counted(dear, slide_h, "h·n"), counted(cheap, slide_r, "e·r")]
}

/// Light from 60° beside the normal.
pub(crate) fn angle() -> [Version; 2] {
    let at_60 = |says: Words, share: f32| {
        version(
            says,
            format!("light at 60° from the normal: {share:.3} of it"),
            format!("licht op 60° van de normaal: {share:.3} ervan"),
        )
    };
    [
        at_60(Words::new("proportional to the angle", "evenredig met de hoek"), slide_lambert(60.0)),
        at_60(Words::new("proportional to its cosine", "evenredig met de cosinus ervan"), by_cosine(60.0)),
    ]
}

/// A lamp, once and twice as far away.
pub(crate) fn falloff() -> [Version; 2] {
    let twice = |says: Words, share: f32| {
        version(
            says,
            format!("twice as far from the lamp: {share:.3} of the light"),
            format!("twee keer zo ver van de lamp: {share:.3} van het licht"),
        )
    };
    [
        twice(
            Words::new("c_l is constant for all objects", "c_l is constant voor alle voorwerpen"),
            slide_intensity(2.0) / slide_intensity(1.0),
        ),
        twice(Words::new("c_l / d²", "c_l / d²"), caught(2.0) / caught(1.0)),
    ]
}

/// Everything head-on: diffuse, ambient and specular light add up.
pub(crate) fn between_0_and_1() -> [Version; 2] {
    let lights = [Light::Ambient { color: Rgb::splat(0.2) }, sun(Vec3::Z, Rgb::ONE)];
    let c = shown(&Material::new(Rgb::splat(0.8), 32.0), &lights, Vec3::Z).x;
    let output = srgb::decode(srgb::encode(c));
    let of = |says: Words, en: &str, nl: &str| {
        version(
            says,
            format!("c_r = 0.8, c_a = 0.2, c_l = 1, head-on: {en}"),
            format!("c_r = 0.8, c_a = 0.2, c_l = 1, recht van voren: {nl}"),
        )
    };
    [
        of(
            Words::new("colour c is between 0 and 1", "kleur c tussen 0 en 1"),
            &format!("c = {c:.2}"),
            &format!("c = {c:.2}"),
        ),
        of(
            Words::new("clamp c, once, at output", "begrens c, één keer, bij de uitvoer"),
            &format!("c = {c:.2} is kept, {output:.2} is shown"),
            &format!("c = {c:.2} blijft bewaard, {output:.2} wordt getoond"),
        ),
    ]
}
