//! From where does one see eye, window and hit all at once? From the side, a little above; on the side that hides least.

use glam::Vec3;
use raytrace::{any_hit, viewing_ray};
use scene::{Lens, View};
use transforms::Pipeline;

use super::SIZE;
use crate::Refusal;
use crate::story::light::OnHit;
use crate::story::rays::Cast;
use crate::story::subject::Subject;

/// The vertical field of view: narrow, so that nothing is bent much.
const FOV_DEGREES: f32 = 26.0;

/// So much of the picture stays free at each side.
const MARGIN: f32 = 0.09;

/// How many rays along each side of the window find out what the scene reaches to.
const PROBES: u16 = 5;

/// What is farther away than so many times the median of what is seen need not be in the picture.
const MOST_OF_THE_MEDIAN: f32 = 1.5;

/// How much of the way to a light is drawn, as a part of what the drawing shows.
const OF_THE_WAY_TO_A_LIGHT: f32 = 0.22;

/// A window that takes up less than such a part of the way to the end of the ray would be too small to see.
const LEAST_OF_THE_WAY: f32 = 0.08;

/// Where a window too small to see is drawn instead, as a part of the way.
const INSTEAD: f32 = 0.3;

/// The t at which the window is drawn: 1, where it is, or farther along the rays through it if it would be too small there.
pub(super) fn t_of_window(subject: &Subject, cast: &Cast) -> f32 {
    let end = cast.hit.as_ref().map_or_else(|| farthest_probe(subject), |hit| hit.t);
    if 1.0 < LEAST_OF_THE_WAY * end { INSTEAD * end } else { 1.0 }
}

/// The corners of the window, drawn at `t`.
pub(super) fn window(pipeline: &Pipeline, t: f32) -> [Vec3; 4] {
    let (right, top) = (pipeline.width() as f32 - 0.5, pipeline.height() as f32 - 0.5);
    [(-0.5, -0.5), (right, -0.5), (right, top), (-0.5, top)].map(|(i, j)| viewing_ray(pipeline, i, j).at(t))
}

/// Where the drawn part of the viewing ray ends: at the hit, or where the scene ends.
pub(super) fn end_of_ray(subject: &Subject, cast: &Cast) -> Vec3 {
    cast.hit.as_ref().map_or_else(|| cast.ray.at(farthest_probe(subject)), |hit| hit.point)
}

/// The greatest t of what the eye sees, or the far plane if it sees nothing.
fn farthest_probe(subject: &Subject) -> f32 {
    let (t0, t1) = subject.interval();
    let met = probes(subject).filter_map(|ray| raytrace::nearest(&subject.world, &ray, t0, t1));
    let mut all: Vec<f32> = met.map(|hit| hit.t).collect();
    all.sort_by(f32::total_cmp);
    // A floor that runs to the horizon would make everything else small.
    let most = all.get(all.len() / 2).map_or(t1, |median| MOST_OF_THE_MEDIAN * median);
    all.into_iter().rfind(|t| *t <= most).unwrap_or(t1)
}

fn probes(subject: &Subject) -> impl Iterator<Item = raytrace::Ray> + '_ {
    let pipeline = &subject.pipeline;
    let at = |k: u16, pixels: u32| pixels as f32 * (f32::from(k) + 0.5) / f32::from(PROBES) - 0.5;
    (0..PROBES).flat_map(move |row| {
        (0..PROBES).map(move |column| {
            viewing_ray(pipeline, at(column, pipeline.width()), at(row, pipeline.height()))
        })
    })
}

/// The points that must be seen.
fn points(subject: &Subject, cast: &Cast) -> Vec<Vec3> {
    let mut points = vec![cast.ray.origin, end_of_ray(subject, cast)];
    points.extend(window(&subject.pipeline, t_of_window(subject, cast)));
    let reach = farthest_probe(subject);
    let (t0, t1) = subject.interval();
    for ray in probes(subject) {
        let hit = raytrace::nearest(&subject.world, &ray, t0, t1);
        points.extend(hit.filter(|hit| hit.t <= reach).map(|hit| hit.point));
    }
    points
}

/// The ends of the drawn parts of the shadow rays, `room` being the size of what is shown.
pub(super) fn ends_of_shadow_rays(light: &OnHit, room: f32) -> Vec<Vec3> {
    let end = |shadow: &crate::story::light::Shadow| {
        let most = shadow.distance.min(OF_THE_WAY_TO_A_LIGHT * room);
        let t = shadow.met.as_ref().map_or(most, |met| met.t.min(most));
        shadow.ray.at(t)
    };
    light.shadows.iter().map(end).collect()
}

/// The size of what the drawing shows: from the eye to the end of the ray.
pub(super) fn room(subject: &Subject, cast: &Cast) -> f32 {
    (end_of_ray(subject, cast) - cast.ray.origin).length()
}

/// The place of the eye outside.
pub(super) fn view(subject: &Subject, cast: &Cast, light: &OnHit) -> Result<View, Refusal> {
    let mut points = points(subject, cast);
    points.extend(ends_of_shadow_rays(light, room(subject, cast)));
    let least = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let greatest = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let (center, radius) = (0.5 * (least + greatest), 0.5 * (greatest - least).length());
    let basis = subject.pipeline.camera().basis();
    let distance = radius.max(1e-3) / (0.5 * FOV_DEGREES).to_radians().sin();
    let from = |(aside, up): (f32, f32)| {
        let direction = (aside * basis.u + up * basis.v + 0.35 * basis.w).normalize();
        View { eye: center + distance * direction, target: center, up: basis.v, lens: lens(None) }
    };
    // The most visible; of equal ones the first.
    let places = [(1.0, 0.5), (-1.0, 0.5), (1.0, 0.9), (-1.0, 0.9), (0.6, 1.3), (-0.6, 1.3)];
    let mut best = from(places[0]);
    let mut most = (0, false);
    for (k, view) in places.map(from).into_iter().enumerate() {
        let seen = visible_from(subject, cast, view.eye);
        if k == 0 || (seen.1, seen.0) > (most.1, most.0) {
            (best, most) = (view, seen);
        }
    }
    closer(subject, &mut best, &points)?;
    if !most.1 {
        // The end of the ray is seen from nowhere: cut away what stands before the rays.
        let mut rays = vec![cast.ray.origin, end_of_ray(subject, cast)];
        rays.extend(ends_of_shadow_rays(light, room(subject, cast)));
        best.lens = lens(nearest_depth(&best, &rays));
    }
    Ok(best)
}

fn lens(near: Option<f32>) -> Lens {
    Lens::FieldOfView { degrees: FOV_DEGREES, near, far: None }
}

/// How many of a few points of the ray are seen from `eye`, and whether its end is.
fn visible_from(subject: &Subject, cast: &Cast, eye: Vec3) -> (usize, bool) {
    const STEPS: u16 = 8;
    let end = end_of_ray(subject, cast);
    let seen = |p: Vec3| !any_hit(&subject.world, &raytrace::Ray::new(p, eye - p), 0.0, 1.0);
    let along = (0..STEPS).filter(|k| seen(cast.ray.origin.lerp(end, f32::from(*k) / f32::from(STEPS))));
    // A little before the surface, or the surface itself would be in the way.
    let just_before = end.lerp(cast.ray.origin, 1e-3);
    (along.count(), seen(just_before))
}

/// Goes nearer as long as all points stay in the picture.
fn closer(subject: &Subject, view: &mut View, points: &[Vec3]) -> Result<(), Refusal> {
    const STEP: f32 = 0.94;
    for _ in 0..40 {
        let nearer = View { eye: view.target + STEP * (view.eye - view.target), ..*view };
        let pipeline = subject.prepared.seen_by(&nearer)?.pipeline(SIZE.0, SIZE.1)?;
        if !points.iter().all(|p| is_inside(&pipeline, *p)) {
            break;
        }
        *view = nearer;
    }
    Ok(())
}

fn is_inside(pipeline: &Pipeline, p: Vec3) -> bool {
    let traced = pipeline.trace(p);
    let least = 2.0 * MARGIN - 1.0;
    traced.clip.w < 0.0 && traced.canonical.is_some_and(|p| p.truncate().abs().max_element() <= -least)
}

/// The w-coordinate of a near plane a little before all points.
fn nearest_depth(view: &View, points: &[Vec3]) -> Option<f32> {
    let gaze = (view.target - view.eye).normalize();
    let nearest = points.iter().map(|p| gaze.dot(*p - view.eye)).fold(f32::INFINITY, f32::min);
    (nearest > 0.0).then_some(-0.98 * nearest)
}
