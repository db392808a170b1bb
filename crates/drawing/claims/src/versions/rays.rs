//! What is hit, and how often is it drawn? (E10, E11, E12, E16)

use geometry::Ray;
use glam::{Vec3, vec3};
use raytrace::triangle::{raytri, watertight};

use super::version;
use crate::Version;
use crate::depth::{Saved, colors_computed, visible_pixels, wrong_pixels};
use crate::ray_errors::{across, flat_triangle, lamp_and_wall, slide_raytri, who_sees};
use crate::sample::{Sequence, pipeline};
use crate::samples::{edge_owners, slide_inclusive};
use figures::Words;

/// Rays at the common edge of two triangles.
pub(crate) fn inclusive() -> [Version; 2] {
    let hits = |says: Words, (rays, hits): (usize, usize)| {
        version(
            says,
            format!("{rays} rays at the common edge of two triangles: {hits} hits"),
            format!("{rays} stralen op de gedeelde rand van twee driehoeken: {hits} treffers"),
        )
    };
    let ours = Words::new("each edge belongs to one triangle", "elke rand hoort bij één driehoek");
    [
        hits(
            "if (γ < 0 or γ > 1) … if (β < 0 or β > 1 − γ) return false".into(),
            edge_owners(slide_inclusive),
        ),
        hits(ours, edge_owners(|ray, triangle| watertight(ray, triangle, 0.0, f32::INFINITY).is_some())),
    ]
}

/// A ray in the plane of a triangle that starts beside it and leads away.
pub(crate) fn parallel() -> [Version; 2] {
    let (ray, triangle) = (Ray::new(vec3(-3.0, -2.0, 0.0), vec3(-1.0, 0.0, 0.0)), flat_triangle());
    let says = |says: Words, hit: bool| {
        let [en, nl] = if hit { ["hit", "raak"] } else { ["no hit", "mis"] };
        version(
            says,
            format!("a ray in the triangle's plane, beside it and away from it: {en}"),
            format!("een straal in het vlak van de driehoek, ernaast en ervan weg: {nl}"),
        )
    };
    let ours = Words::new("parallel: return no hit; then t, γ, β", "evenwijdig: geen treffer; dan t, γ, β");
    [
        says("t, γ, β, return true".into(), slide_raytri(&ray, &triangle, 0.0, 99.0)),
        says(ours, raytri(&ray, &triangle, 0.0, 99.0).is_some()),
    ]
}

/// Two triangles, one behind the other.
pub(crate) fn returns_no_t() -> [Version; 2] {
    let ray = Ray::new(Vec3::ZERO, vec3(0.0, 0.0, -2.0));
    let two = [across(-6.0), across(-10.0)];
    let slide = two.map(|triangle| slide_raytri(&ray, &triangle, 0.0, 99.0));
    let right = two.map(|triangle| raytri(&ray, &triangle, 0.0, 99.0).map_or(f32::NAN, |hit| hit.t));
    [
        version(
            "boolean raytri(r, a, b, c, t0, t1)",
            format!("two triangles, one behind the other: {} and {}", slide[0], slide[1]),
            format!("twee driehoeken achter elkaar: {} en {}", slide[0], slide[1]),
        ),
        version(
            Words::new("raytri returns t, β and γ", "raytri geeft t, β en γ"),
            format!("two triangles, one behind the other: t = {} and t = {}", right[0], right[1]),
            format!("twee driehoeken achter elkaar: t = {} en t = {}", right[0], right[1]),
        ),
    ]
}

/// A point of the floor under a lamp that hangs before a wall.
pub(crate) fn beyond_the_lamp() -> [Version; 2] {
    let (slide, right) = lamp_and_wall(&mut Sequence::new(124), 2.0, Some(4.5));
    let under = |says: Words, is_lit: bool| {
        let [en, nl] = if is_lit { ["lit", "is verlicht"] } else { ["in shadow", "ligt in schaduw"] };
        version(
            says,
            format!("a lamp 2 above the floor, a wall 4.5 above it: the floor is {en}"),
            format!("een lamp 2 boven de vloer, een muur 4.5 erboven: de vloer {nl}"),
        )
    };
    let ours = Words::new("p + t·l with t up to the lamp", "p + t·l met t tot aan de lamp");
    [under(Words::new("p + t·l with t in [0, ∞]", "p + t·l met t in [0, ∞]"), slide), under(ours, right)]
}

/// A wall half way to the near plane.
pub(crate) fn viewing_interval() -> [Version; 2] {
    let pipeline = pipeline((Vec3::ZERO, Vec3::NEG_Z), 0.9, (-1.0, -10.0), (32, 32));
    let (slide, right, buffer) = who_sees(&pipeline, 0.5);
    let [seen, gezien] = [["not seen", "seen"], ["niet gezien", "gezien"]];
    let wall = |says: Words, by_rays: bool| {
        let (rays, buffer) = (usize::from(by_rays), usize::from(buffer));
        version(
            says,
            format!(
                "a wall half way to the near plane: {} by rays, {} by the z-buffer",
                seen[rays], seen[buffer]
            ),
            format!(
                "een muur halverwege het near-vlak: {} door stralen, {} door de z-buffer",
                gezien[rays], gezien[buffer]
            ),
        )
    };
    let ours = Words::new("t from 1 to f/n", "t van 1 tot f/n");
    [wall(Words::new("t in [0, ∞]", "t in [0, ∞]"), slide), wall(ours, right)]
}

/// Eight triangles, with a saved depth that nobody sets and with one that is kept.
pub(crate) fn saved_depth() -> [Version; 2] {
    let loops = |says: Words, saved: &Saved| {
        let (wrong, all) = wrong_pixels(saved);
        version(
            says,
            format!("8 triangles, 3 in memory before: {wrong} of {all} pixels are wrong"),
            format!("8 driehoeken, vooraf 3 in het geheugen: {wrong} van {all} pixels zijn fout"),
        )
    };
    let slide = Words::new("closer than the saved depth", "dichterbij dan de bewaarde diepte");
    let ours = Words::new(
        "saved depth = ∞; closer than it: saved depth = t",
        "bewaarde diepte = ∞; dichterbij: bewaarde diepte = t",
    );
    [loops(slide, &Saved::NeverSet(3.0)), loops(ours, &Saved::InitializedAndUpdated)]
}

/// Layers from back to front, coloured inside the loop and after it.
pub(crate) fn shaded_again() -> [Version; 2] {
    let order: Vec<usize> = (0..6).collect();
    let colors = |says: Words, count: usize| {
        let layers = order.len();
        version(
            says,
            format!("{layers} layers over a pixel, from back to front; colours computed: {count}"),
            format!("{layers} lagen over een pixel, van achter naar voren; berekende kleuren: {count}"),
        )
    };
    let slide = Words::new("shade in the loop", "kleuren berekenen in de lus");
    let ours =
        Words::new("shade what is seen, after the loop", "kleur berekenen van wat te zien is, na de lus");
    [colors(slide, colors_computed(&order)), colors(ours, visible_pixels(&order))]
}
