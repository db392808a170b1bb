//! Is there time for a live view? One frame of what is drawn by default.

use std::io;
use std::time::Duration;

use scene::{Renderer, Settings, builtin, prepare, render};

use crate::report::{Cell, count, ms};
use crate::run::Run;
use crate::timing::medians;
use crate::{targets, threads};

/// The default scene by z-buffer, 640 × 480, one sample a pixel, on one thread and on two.
///
/// # Errors
/// If the report cannot be written.
pub(crate) fn run(run: &mut Run) -> io::Result<()> {
    if !run.wants("live default scene") {
        return Ok(());
    }
    let loaded = builtin::all()[0].load().expect("built in");
    let prepared = prepare(&loaded).expect("built in");
    let settings =
        Settings { renderer: Renderer::ZBuffer, size: (640, 480), samples: 1, ..loaded.scene.settings };
    let draw = || drop(std::hint::black_box(render(&prepared, &settings, &|_| ()).expect("built in")));
    let two = threads::pinned(2);
    let times = medians(run.effort(), &mut [&mut || draw(), &mut || two.install(draw)]);
    let of = |time: Duration| time.as_secs_f64() * 1e3;
    let cells = [
        ("triangles", count(prepared.triangle_count())),
        ("one thread ms", ms(times[0])),
        ("two threads ms", ms(times[1])),
        ("target ms", Cell::Number(targets::LIVE, 1)),
        ("reached", Cell::Verdict(of(times[1]) <= targets::LIVE)),
    ];
    run.report.row("live default scene", &cells)
}
