//! Rays, whole pictures, and what is built before either: who takes how long, and do they hit the same?

use std::io;
use std::time::Duration;

use geometry::Mesh;

use super::agreement::{Differences, compare};
use super::{Kind, Rays, Traces, obvhs, parry, peers};
use crate::ours::Tracing;
use crate::report::{Cell, count, ms};
use crate::run::Run;
use crate::scenes::{Scene, view};
use crate::timing::{Effort, medians};
use crate::{targets, threads};

/// Sends all kinds of rays at both meshes, draws the picture, and builds the hierarchies.
///
/// # Errors
/// If the report cannot be written.
pub(crate) fn run(run: &mut Run) -> io::Result<()> {
    let mut differences = Vec::new();
    for (name, prepare) in [("69k", Scene::thousands as fn() -> Scene), ("1M", Scene::million)] {
        let wanted: Vec<Kind> =
            Kind::ALL.into_iter().filter(|kind| run.wants(&format!("rays {name} {}", kind.name()))).collect();
        if !wanted.is_empty() {
            let found = contest(run, &prepare(), &wanted)?;
            differences.extend(found);
        }
    }
    for (case, peer, found) in differences {
        tell(run, &case, peer, &found)?;
    }
    picture(run)?;
    building(run)
}

type Found = (String, &'static str, Differences);

/// Measures the rays of one mesh, and says what each peer sees otherwise than we do.
fn contest(run: &mut Run, scene: &Scene, kinds: &[Kind]) -> io::Result<Vec<Found>> {
    let ours = Tracing::build(scene.mesh.clone());
    let rays = Rays::new(&ours, if run.quick { 256 } else { 1024 });
    let peers = peers(&scene.mesh, &rays);
    let mut found = Vec::new();
    for &kind in kinds {
        let case = format!("rays {} {}", scene.name, kind.name());
        let mut answers = vec![vec![0.0; rays.of(kind).len()]; peers.len() + 1];
        let times = times(run.effort(), kind, (&ours, rays.of(kind)), &peers, &mut answers);
        for (k, peer) in peers.iter().enumerate() {
            run.ratio(
                &case,
                (peer.name(), times[k + 1]),
                times[0],
                targets::rays(scene.name, kind.name(), peer.name()),
            )?;
            found.push((case.clone(), peer.name(), compare(&answers[0], &answers[k + 1])));
        }
    }
    Ok(found)
}

/// Median times, ours first; `answers` are everybody's in the same order.
fn times(
    effort: Effort,
    kind: Kind,
    (ours, rays): (&Tracing, &[geometry::Ray]),
    peers: &[Box<dyn Traces>],
    answers: &mut [Vec<f32>],
) -> Vec<Duration> {
    let (our_answers, their_answers) = answers.split_first_mut().expect("ours and the peers'");
    let mut our_turn = || match kind {
        Kind::Shadow => ours.any(rays, our_answers),
        Kind::Primary | Kind::Random => ours.nearest(rays, our_answers),
    };
    let mut their_turns: Vec<_> =
        peers.iter().zip(their_answers).map(|(peer, t)| move || peer.trace(kind, t)).collect();
    let mut turns: Vec<&mut dyn FnMut()> = vec![&mut our_turn];
    turns.extend(their_turns.iter_mut().map(|turn| turn as &mut dyn FnMut()));
    medians(effort, &mut turns)
}

/// Reports what differs, and judges it.
fn tell(run: &mut Run, case: &str, peer: &'static str, found: &Differences) -> io::Result<()> {
    run.agreed(case, peer, found.check());
    let cells = [
        ("hits as", Cell::Word(peer.to_owned())),
        ("rays", count(found.rays)),
        ("hits", count(found.hits)),
        ("only ours", count(found.only_ours)),
        ("only peer", count(found.only_theirs)),
        ("elsewhere", count(found.elsewhere)),
        ("agree", Cell::Verdict(found.check().is_ok())),
    ];
    run.report.row(case, &cells)
}

/// A whole picture with shadows, on one thread and on two; no peer draws any.
fn picture(run: &mut Run) -> io::Result<()> {
    if !run.wants("picture 69k") {
        return Ok(());
    }
    let ours = Tracing::build(Scene::thousands().mesh);
    let view = view(1024, 768);
    let two = threads::pinned(2);
    let mut on_one = || drop(std::hint::black_box(ours.picture(&view)));
    let mut on_two = || drop(std::hint::black_box(two.install(|| ours.picture(&view))));
    let times = medians(run.effort(), &mut [&mut on_one, &mut on_two]);
    let cells = crate::scaling::two_threads(times[0], times[1]);
    run.report.row("picture 69k", &cells)
}

/// Building the hierarchy of a million triangles; ours on one thread and on two. Who takes a mesh for itself is given a
/// copy, which is part of the time.
fn building(run: &mut Run) -> io::Result<()> {
    if !run.wants("build 1M") {
        return Ok(());
    }
    let mesh = Scene::million().mesh;
    let (triangles, points) = (obvhs::triangles(&mesh), parry::points(&mesh));
    let two = threads::pinned(2);
    let build = |mesh: &Mesh| drop(std::hint::black_box(Tracing::build(mesh.clone())));
    let mut turns: [&mut dyn FnMut(); 4] = [
        &mut || build(&mesh),
        &mut || two.install(|| build(&mesh)),
        &mut || drop(std::hint::black_box(obvhs::build(&triangles))),
        &mut || drop(std::hint::black_box(parry::build(points.clone(), mesh.triangles().to_vec()))),
    ];
    let times = medians(Effort { fewest: if run.quick { 1 } else { 3 }, ..run.effort() }, &mut turns);
    for (peer, time) in [("obvhs", times[2]), ("parry3d", times[3])] {
        run.ratio("build 1M", (peer, time), times[0], None)?;
    }
    let cells = [("one thread ms", ms(times[0])), ("two threads ms", ms(times[1]))];
    run.report.row("build 1M", &cells)
}
