//! Frames: who takes how long, and do they show the same?

use std::io;

use shading::Shading;
use transforms::Pipeline;

use super::agreement::{Differences, compare};
use super::{Draws, peers};
use crate::report::count;
use crate::run::Run;
use crate::scenes::{Scene, view};
use crate::timing::medians;
use crate::{ours, targets};

/// The screen of all cases.
pub(crate) const WIDTH: u32 = 1920;
pub(crate) const HEIGHT: u32 = 1080;

const SHADINGS: [(Shading, &str); 2] = [(Shading::Gouraud, "Gouraud"), (Shading::Phong, "Phong")];

/// Draws every scene in every shading.
///
/// # Errors
/// If the report cannot be written.
pub(crate) fn run(run: &mut Run) -> io::Result<()> {
    let view = view(WIDTH, HEIGHT);
    let mut differences = Vec::new();
    for (name, prepare) in scenes() {
        let wanted: Vec<_> = SHADINGS
            .into_iter()
            .filter(|(_, shading)| run.wants(&format!("draw {name} {shading}")))
            .collect();
        if wanted.is_empty() {
            continue;
        }
        let scene = prepare(&view);
        for (shading, shading_name) in wanted {
            let case = format!("draw {name} {shading_name}");
            let found = contest(run, &case, (&scene, &view), (shading, shading_name))?;
            differences.extend(found.into_iter().map(|(peer, found)| (case.clone(), peer, found)));
        }
    }
    for (case, peer, found) in differences {
        tell(run, &case, peer, &found)?;
    }
    Ok(())
}

type Prepare = fn(&Pipeline) -> Scene;

fn scenes() -> [(&'static str, Prepare); 3] {
    [("1M", |_| Scene::million()), ("69k", |_| Scene::thousands()), ("fill", Scene::fill)]
}

/// Measures one case, and says what each peer sees otherwise than we do.
fn contest(
    run: &mut Run,
    case: &str,
    (scene, view): (&Scene, &Pipeline),
    (shading, shading_name): (Shading, &str),
) -> io::Result<Vec<(&'static str, Differences)>> {
    let mut drawing = ours::Drawing::new(scene, view, shading);
    let mut peers = peers(scene, view, shading);
    let mut our_turn = || drawing.draw();
    let mut their_turns: Vec<_> = peers.iter_mut().map(|peer| || peer.draw()).collect();
    let mut turns: Vec<&mut dyn FnMut()> = vec![&mut our_turn];
    turns.extend(their_turns.iter_mut().map(|turn| turn as &mut dyn FnMut()));
    let times = medians(run.effort(), &mut turns);
    let picture = drawing.picture();
    let mut found = Vec::new();
    for (peer, time) in peers.iter().zip(&times[1..]) {
        let name = peer.name();
        run.ratio(case, (name, *time), times[0], targets::frame(scene.name, shading_name, name))?;
        found.push((name, compare(&picture, &peer.picture())));
    }
    Ok(found)
}

/// Reports what differs, and judges it.
fn tell(run: &mut Run, case: &str, peer: &'static str, found: &Differences) -> io::Result<()> {
    run.agreed(case, peer, found.check());
    let cells = [
        ("pixels as", crate::report::Cell::Word(peer.to_owned())),
        ("covered", count(found.covered)),
        ("on outlines", count(found.on_outlines)),
        ("one only", count(found.coverage)),
        ("other distance", count(found.distance)),
        ("other colour", count(found.color)),
        ("agree", crate::report::Cell::Verdict(found.check().is_ok())),
    ];
    run.report.row(case, &cells)
}
