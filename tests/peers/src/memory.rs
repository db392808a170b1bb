//! How much memory does it take? Asked of the system, in a process of its own for each case.

use std::io::{self, Error, Write};
use std::process::Command;

use shading::Shading;

use crate::drawing::{Draws, HEIGHT, WIDTH};
use crate::ours::{Drawing, Tracing, bytes_of_buffers};
use crate::report::Cell;
use crate::run::Run;
use crate::scenes::{Scene, view};
use crate::targets;

/// The option that makes this program such a child.
pub(crate) const CHILD: &str = "--memory-of";

const CASES: [(&str, f64); 3] = [
    ("hierarchy", targets::MEGABYTES_OF_A_MILLION),
    ("frame", targets::MEGABYTES_BESIDE_BUFFERS),
    ("picture", targets::MEGABYTES_BESIDE_BUFFERS),
];

/// Measures all cases: mesh and hierarchy of a million triangles; beside its buffers, a frame that is drawn of them and
/// a picture that is traced.
///
/// # Errors
/// If the report cannot be written, or a child ends badly.
pub(crate) fn run(run: &mut Run) -> io::Result<()> {
    for (what, most) in CASES {
        let case = format!("memory 1M {what}");
        if !run.wants(&case) {
            continue;
        }
        if !cfg!(target_os = "linux") {
            run.report.say(&format!("{case}: this system does not say what is resident"))?;
            continue;
        }
        let [held, peak] = ask(what)?;
        let judged = if what == "hierarchy" { held } else { peak };
        let cells = [
            ("held MB", Cell::Number(held, 1)),
            ("peak MB", Cell::Number(peak, 1)),
            ("target", Cell::Number(most, 0)),
            ("reached", Cell::Verdict(judged <= most)),
        ];
        run.report.row(&case, &cells)?;
    }
    Ok(())
}

/// What a child says: megabytes held in the end, and at the peak.
fn ask(what: &str) -> io::Result<[f64; 2]> {
    let output = Command::new(std::env::current_exe()?).args([CHILD, what]).output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    numbers
        .try_into()
        .map_err(|_| Error::other(format!("memory of {what}: the child ended with {}", output.status)))
}

/// The child: makes the thing, and prints megabytes held and at the peak, both without what was there before, a
/// picture's also without its buffers.
///
/// # Errors
/// If the system does not say what is resident, or the answer cannot be written.
pub(crate) fn child(what: &str) -> io::Result<()> {
    let [held, peak] = match what {
        "hierarchy" => {
            let before = resident()?;
            let mesh = Scene::million().mesh;
            let (tracing, held, peak) = watched(before, || Tracing::build(mesh))?;
            drop(tracing);
            [held, peak]
        }
        "frame" => {
            let (scene, view) = (Scene::million(), view(WIDTH, HEIGHT));
            let mut drawing = Drawing::new(&scene, &view, Shading::Gouraud);
            let buffers = megabytes(bytes_of_buffers((WIDTH * HEIGHT) as usize));
            let (_, held, peak) = watched(resident()?, || drawing.draw())?;
            [held - buffers, peak - buffers]
        }
        "picture" => {
            let tracing = Tracing::build(Scene::million().mesh);
            let view = view(WIDTH, HEIGHT);
            let (image, held, peak) = watched(resident()?, || tracing.picture(&view))?;
            let buffers = megabytes(size_of_val(image.pixels()));
            [held - buffers, peak - buffers]
        }
        other => return Err(Error::other(format!("no memory of {other}"))),
    };
    // Less than nothing, where the allocator had kept more from earlier work than was needed.
    writeln!(io::stdout(), "{} {}", held.max(0.0), peak.max(0.0))
}

/// Does the work; megabytes held after it and the most on the way, both beyond `before`.
fn watched<T>(before: f64, work: impl FnOnce() -> T) -> io::Result<(T, f64, f64)> {
    // Five forgets the peak so far. Where that is refused, the peak may be that of what was made before.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
    let done = work();
    Ok((done, resident()? - before, status("VmHWM:")? - before))
}

/// Megabytes in memory now.
fn resident() -> io::Result<f64> {
    status("VmRSS:")
}

fn megabytes(bytes: usize) -> f64 {
    bytes as f64 / 1e6
}

/// A line of what Linux says about this process, in megabytes.
fn status(name: &str) -> io::Result<f64> {
    let text = std::fs::read_to_string("/proc/self/status")?;
    let line = text.lines().find_map(|line| line.strip_prefix(name));
    let kibibytes = line.and_then(|line| line.split_whitespace().next()?.parse::<usize>().ok());
    kibibytes
        .map(|k| megabytes(k * 1024))
        .ok_or_else(|| Error::other(format!("no {name} in /proc/self/status")))
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn memory_that_is_held_and_memory_that_was_freed_are_told_apart() {
        let before = resident().unwrap();
        let (kept, held, peak) = watched(before, || {
            drop(std::hint::black_box(vec![1_u8; 300_000_000]));
            std::hint::black_box(vec![1_u8; 100_000_000])
        })
        .unwrap();
        // Other tests of this process take some, too.
        assert!((90.0..200.0).contains(&held), "{held}");
        assert!((290.0..500.0).contains(&peak), "{peak}");
        drop(kept);
    }
}
