//! How far is it? A bar on a terminal, for work that takes long.

use std::sync::OnceLock;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work shorter than this shows no bar: it would only flicker.
const PATIENCE: Duration = Duration::from_millis(300);

/// The bar counts in thousandths of the work.
const WHOLE: u64 = 1000;

/// The progress of one piece of work, drawn on standard error if that is a terminal; in a pipe or a file nothing appears.
pub(crate) struct Progress {
    what: String,
    start: Instant,
    bar: OnceLock<ProgressBar>,
}

impl Progress {
    /// The work called `what` begins now.
    pub(crate) fn start(what: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            start: Instant::now(),
            bar: OnceLock::new(),
        }
    }

    /// A share of the work is done, 0 to 1. May be called from any thread.
    pub(crate) fn reached(&self, share: f32) {
        if self.start.elapsed() < PATIENCE {
            return;
        }
        let bar = self.bar.get_or_init(|| self.draw());
        // Threads may report out of order; a bar does not run backwards.
        let position = (share * WHOLE as f32) as u64;
        if position > bar.position() {
            bar.set_position(position.min(WHOLE));
        }
    }

    /// The work is done: the bar goes. Gives the time that it took.
    pub(crate) fn finish(self) -> Duration {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
        self.start.elapsed()
    }

    fn draw(&self) -> ProgressBar {
        let style = ProgressStyle::with_template("{prefix:10} {bar:40} {percent:>3} %, {eta} left")
            .expect("the template is well-formed");
        let bar = ProgressBar::with_draw_target(Some(WHOLE), ProgressDrawTarget::stderr());
        bar.set_style(style.progress_chars("=> "));
        bar.set_prefix(self.what.clone());
        bar
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_work_shows_no_bar() {
        let progress = Progress::start("short");
        progress.reached(0.3);
        assert!(progress.bar.get().is_none());
    }

    #[test]
    fn a_bar_does_not_run_backwards() {
        let mut progress = Progress::start("long");
        progress.start -= PATIENCE;
        for share in [0.2, 0.7, 0.4, 0.6] {
            progress.reached(share);
        }
        assert_eq!(progress.bar.get().unwrap().position(), 700);
        progress.reached(7.0);
        assert_eq!(progress.bar.get().unwrap().position(), WHOLE);
    }
}
