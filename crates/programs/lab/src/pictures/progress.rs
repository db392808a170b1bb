//! A progress bar on a terminal, for work that takes long.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work shorter than this shows no bar: it would only flicker.
const PATIENCE: Duration = Duration::from_millis(300);

/// The environment variable that shows the bar at once, however short the work is, if it is `always`.
const WHEN: &str = "LIGHTLAB_PROGRESS";

/// Time between two looks at the clock, once the bar is there.
const TICK: Duration = Duration::from_millis(100);

/// The bar counts in thousandths of the work.
const WHOLE: u64 = 1000;

/// The progress of one piece of work, drawn on standard error if that is a terminal; in a pipe or a file nothing appears.
pub(crate) struct Progress {
    start: Instant,
    bar: ProgressBar,
    /// The thread that loses patience, and the line that ends it.
    patience: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    /// Starts the work called `what`. A bar appears after a moment, or at once if `LIGHTLAB_PROGRESS=always`.
    pub(crate) fn start(what: &'static str) -> Self {
        let always = std::env::var_os(WHEN).is_some_and(|when| when == "always");
        Self::start_with(what, if always { None } else { Some(PATIENCE) })
    }

    /// Starts the work called `what` and shows a bar after so much `patience`; at once if there is none.
    fn start_with(what: &'static str, patience: Option<Duration>) -> Self {
        let style = ProgressStyle::with_template("{prefix:10}[{bar:40}] {percent:>3} %  {elapsed}")
            .expect("the template is well-formed");
        let bar = ProgressBar::with_draw_target(Some(WHOLE), ProgressDrawTarget::hidden())
            .with_style(style.progress_chars("=> "))
            .with_prefix(what);
        let patience = match patience {
            Some(patience) => show_later(bar.clone(), patience),
            None => {
                bar.set_draw_target(ProgressDrawTarget::stderr());
                bar.tick();
                None
            }
        };
        Self { start: Instant::now(), bar, patience }
    }

    /// A share of the work is done, 0 to 1. May be called from any thread.
    pub(crate) fn reached(&self, share: f32) {
        // Threads may report out of order; a bar does not run backwards.
        let position = ((share * WHOLE as f32) as u64).min(WHOLE);
        if position > self.bar.position() {
            self.bar.set_position(position);
        }
    }

    /// The work is done: the bar goes. Gives the time that the work took.
    pub(crate) fn finish(self) -> Duration {
        let time = self.start.elapsed();
        if let Some((done, waiting)) = self.patience {
            drop(done);
            // A panic there would cost a bar, no more.
            let _ = waiting.join();
        }
        self.bar.finish_and_clear();
        time
    }
}

/// Shows the bar when `patience` is over, unless the work ends before. `None` if the system has no thread left: then no bar is drawn.
fn show_later(bar: ProgressBar, patience: Duration) -> Option<(Sender<()>, JoinHandle<()>)> {
    let (done, wait) = mpsc::channel();
    let waiting = thread::Builder::new().spawn(move || {
        if wait.recv_timeout(patience) == Err(RecvTimeoutError::Timeout) {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            bar.enable_steady_tick(TICK);
        }
    });
    waiting.ok().map(|waiting| (done, waiting))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_does_not_run_backwards() {
        let progress = Progress::start("work");
        for share in [0.2, 0.7, 0.4, 0.6] {
            progress.reached(share);
        }
        assert_eq!(progress.bar.position(), 700);
        progress.reached(7.0);
        assert_eq!(progress.bar.position(), WHOLE);
    }

    #[test]
    fn short_work_is_not_held_up() {
        // The end of the work wakes the waiting thread: else this would take a day.
        let day = Duration::from_secs(24 * 60 * 60);
        assert!(Progress::start_with("work", Some(day)).finish() < day);
    }
}
