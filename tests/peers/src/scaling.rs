//! How does time grow with pixels, with triangles, and with threads?

use std::io;
use std::time::Duration;

use shading::Shading;

use crate::drawing::Draws;
use crate::ours::{Drawing, Tracing};
use crate::report::{Cell, count, ms};
use crate::run::Run;
use crate::scenes::{Scene, sphere, view};
use crate::timing::{Effort, medians};
use crate::{targets, threads};

/// Pictures of the ball in doubling numbers of pixels, and in ten times as many triangles each time.
///
/// # Errors
/// If the report cannot be written.
pub(crate) fn run(run: &mut Run) -> io::Result<()> {
    pixels(run)?;
    triangles(run)
}

/// One thread's time and two threads' as cells, with what two should gain where a picture is long enough.
pub(crate) fn two_threads(one: Duration, two: Duration) -> [(&'static str, Cell); 5] {
    let gain = one.as_secs_f64() / two.as_secs_f64();
    let is_long = one.as_secs_f64() * 1e3 > targets::LONG;
    let verdict = |cell| if is_long { cell } else { Cell::Empty };
    [
        ("one thread ms", ms(one)),
        ("two threads ms", ms(two)),
        ("gain", Cell::Number(gain, 2)),
        ("target", verdict(Cell::Number(targets::TWO_THREADS, 2))),
        ("reached", verdict(Cell::Verdict(gain >= targets::TWO_THREADS))),
    ]
}

/// Twice as many pixels each time, in two steps: width by 2, then height by 2.
fn pixels(run: &mut Run) -> io::Result<()> {
    let sizes: [(u32, u32); 5] = [(960, 540), (1920, 540), (1920, 1080), (3840, 1080), (3840, 2160)];
    let sizes = if run.quick { &sizes[..2] } else { &sizes[..] };
    let wanted = ["drawn", "traced"].map(|how| run.wants(&format!("scaling pixels {how}")));
    if wanted == [false; 2] {
        return Ok(());
    }
    let scene = Scene::thousands();
    let tracing = Tracing::build(scene.mesh.clone());
    let two = threads::pinned(2);
    for (how, _) in ["drawn", "traced"].into_iter().zip(wanted).filter(|(_, wanted)| *wanted) {
        for &(width, height) in sizes {
            let view = view(width, height);
            let mut drawing = Drawing::new(&scene, &view, Shading::Phong);
            let mut picture = || match how {
                "drawn" => drawing.draw(),
                _ => drop(std::hint::black_box(tracing.picture(&view))),
            };
            let times = one_and_two(effort(run), &two, &mut picture);
            let pixels = (width * height) as usize;
            let of_a_pixel = times[0].as_secs_f64() * 1e9 / pixels as f64;
            let mut cells = vec![("pixels", count(pixels)), ("ns a pixel", Cell::Number(of_a_pixel, 2))];
            cells.extend(two_threads(times[0], times[1]));
            run.report.row(&format!("scaling pixels {how}"), &cells)?;
        }
    }
    Ok(())
}

/// The medians of the same work on this thread and in a pool of two.
fn one_and_two(effort: Effort, two: &rayon::ThreadPool, work: &mut (dyn FnMut() + Send)) -> Vec<Duration> {
    let work = std::cell::RefCell::new(work);
    let mut on_one = || (work.borrow_mut())();
    let mut on_two = || {
        let work = &mut *work.borrow_mut();
        two.install(work);
    };
    medians(effort, &mut [&mut on_one, &mut on_two])
}

/// From a thousand to ten million triangles on one screen, on one thread: drawn, their hierarchy built, traced.
fn triangles(run: &mut Run) -> io::Result<()> {
    if !run.wants("scaling triangles") {
        return Ok(());
    }
    // 12·n² is nearest to each power of ten.
    let sizes: &[u32] = if run.quick { &[9, 29] } else { &[9, 29, 91, 289, 913] };
    let view = view(960, 540);
    for n in sizes {
        let scene = Scene { name: "n", mesh: sphere::bumpy(*n) };
        let mut drawing = Drawing::new(&scene, &view, Shading::Gouraud);
        let drawn = medians(effort(run), &mut [&mut || drawing.draw()])[0];
        let once = Effort { fewest: 1, ..effort(run) };
        let build = || drop(std::hint::black_box(Tracing::build(scene.mesh.clone())));
        let built = medians(once, &mut [&mut || build()])[0];
        let tracing = Tracing::build(scene.mesh.clone());
        let picture = || drop(std::hint::black_box(tracing.picture(&view)));
        let traced = medians(effort(run), &mut [&mut || picture()])[0];
        let triangles = scene.mesh.len() as f64;
        let nanoseconds = built.as_secs_f64() * 1e9;
        let cells = [
            ("triangles", count(scene.mesh.len())),
            ("drawn ms", ms(drawn)),
            ("built ms", ms(built)),
            ("ns of n log n", Cell::Number(nanoseconds / (triangles * triangles.log2()), 2)),
            ("traced ms", ms(traced)),
        ];
        run.report.row("scaling triangles", &cells)?;
    }
    Ok(())
}

/// Shorter than where ratios are at stake.
fn effort(run: &Run) -> Effort {
    Effort { fewest: 1, most: 9, time: Duration::from_millis(if run.quick { 200 } else { 1500 }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_long_pictures_are_judged_by_what_a_second_thread_gains() {
        let ms = Duration::from_millis;
        assert_eq!(two_threads(ms(100), ms(50))[4].1, Cell::Verdict(true));
        assert_eq!(two_threads(ms(100), ms(55))[4].1, Cell::Verdict(false));
        assert_eq!(two_threads(ms(40), ms(40))[4].1, Cell::Empty);
    }
}
