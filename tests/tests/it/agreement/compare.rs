//! Do two renderers show the same, pixel by pixel, or is there a reason why not?

use canvas::{Rgb, row_from_j, srgb};
use glam::{DVec2, Vec3};
use testkit::{Outcome, ensure};

use crate::agreement::snapping::{SNAP, depths_are_close, distance_to_edge, edges, length_on_screen};
use crate::agreement::stage::Stage;

/// How many pixels were compared and how many were left to snapping, over all scenes of a law.
#[derive(Default)]
pub(crate) struct Tally {
    pub(crate) pixels: usize,
    pub(crate) different: usize,
    /// The area within `SNAP` of an edge: 2 · SNAP · length, a pixel having area 1.
    pub(crate) edge_area: f64,
    /// Pixels with one winner whose colours differ by more than 1/255.
    pub(crate) colors_left_to_snapping: usize,
}

/// Pixel by pixel: the same (object, triangle) or a reason.
pub(crate) fn compare_winners(
    stage: &Stage,
    ours: impl Fn(usize) -> Option<(usize, usize)>,
    theirs: impl Fn(usize) -> Option<(usize, usize)>,
    tally: &mut Tally,
) -> Outcome {
    let edges = edges(stage);
    let (width, height) = (stage.pipeline.width(), stage.pipeline.height());
    tally.pixels += width as usize * height as usize;
    tally.edge_area += edges.iter().map(|edge| 2.0 * SNAP * length_on_screen(stage, *edge)).sum::<f64>();
    for j in 0..height {
        for i in 0..width {
            let index = row_from_j(j, height) as usize * width as usize + i as usize;
            let (one, other) = (ours(index), theirs(index));
            if one == other {
                continue;
            }
            tally.different += 1;
            let p = DVec2::new(i.into(), j.into());
            let near_an_edge = edges.iter().any(|edge| distance_to_edge(p, *edge) <= SNAP);
            let undecided = matches!((one, other), (Some(a), Some(b)) if depths_are_close(stage, a, b, p));
            ensure(near_an_edge || undecided, || format!("pixel ({i}, {j}): {one:?} against {other:?}"))?;
        }
    }
    Ok(())
}

/// The colours, as a file shows them: sRGB-encoded, 0 to 1.
pub(crate) fn encoded(color: Rgb) -> Vec3 {
    Vec3::from(color.to_array().map(srgb::encode))
}

/// Pixel by pixel, where the same triangle won: colours within 1/255, or a reason.
///
/// The reason can only be snapping: the rasterizer's colour belongs to a point of the triangle that is seen at most `SNAP`
/// from the pixel's centre. Where a surface is seen at a grazing angle its colour may change by more than 1/255 on that way,
/// so the colour must then lie between those that rays `SNAP` to all sides bring back.
pub(crate) fn compare_colors(
    stage: &Stage,
    frame: &shading::Frame,
    world: &raytrace::World,
    hits: &[Option<raytrace::Hit>],
    tally: &mut Tally,
) -> Outcome {
    let settings = raytrace::Settings { shadows: false, ..raytrace::Settings::default() };
    let traced = raytrace::render(world, &stage.pipeline, &settings, &|_| ());
    let (width, height) = (stage.pipeline.width(), stage.pipeline.height());
    for j in 0..height {
        for i in 0..width {
            let index = row_from_j(j, height) as usize * width as usize + i as usize;
            let winner = hits[index].map(|hit| (hit.object, hit.triangle));
            let (ours, theirs) = (encoded(frame.image.get(i, j)), encoded(traced.get(i, j)));
            let apart = (ours - theirs).abs().max_element();
            if apart <= 1.0 / 255.0 || frame.visible[index].map(|v| (v.object, v.triangle)) != winner {
                continue;
            }
            tally.colors_left_to_snapping += 1;
            let around = colors_around(stage, world, (i, j), winner);
            let (low, high) = around.fold((theirs, theirs), |(low, high), c| (low.min(c), high.max(c)));
            let within = ours.cmpge(low - 1.0 / 255.0).all() && ours.cmple(high + 1.0 / 255.0).all();
            ensure(within, || format!("pixel ({i}, {j}): {ours} against {theirs}, sRGB"))?;
        }
    }
    Ok(())
}

/// What rays `SNAP` beside a pixel's centre bring back, to all eight sides, where they meet the same triangle.
pub(crate) fn colors_around<'a>(
    stage: &'a Stage,
    world: &'a raytrace::World,
    (i, j): (u32, u32),
    winner: Option<(usize, usize)>,
) -> impl Iterator<Item = Vec3> + 'a {
    let settings = raytrace::Settings { shadows: false, ..raytrace::Settings::default() };
    let (t0, t1) = raytrace::visible_interval(&stage.pipeline.volume());
    (0..9).filter(|k| *k != 4).filter_map(move |k| {
        let aside = |step: i32| (f64::from(step - 1) * SNAP) as f32;
        let ray = raytrace::viewing_ray(&stage.pipeline, i as f32 + aside(k % 3), j as f32 + aside(k / 3));
        let hit = raytrace::nearest(world, &ray, t0, t1)?;
        let same = Some((hit.object, hit.triangle)) == winner;
        same.then(|| encoded(raytrace::ray_color(world, &ray, t0, t1, &settings)))
    })
}
