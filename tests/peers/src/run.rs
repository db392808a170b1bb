//! One run: which cases, how long each, where the results go, and what went wrong.

use std::io;
use std::time::{Duration, Instant};

use crate::arguments::Arguments;
use crate::report::{Cell, Report, ms};
use crate::timing::Effort;

/// What all cases share.
pub(crate) struct Run {
    /// Where rows go.
    pub(crate) report: Report,
    /// Whether it should be over within a minute.
    pub(crate) quick: bool,
    filter: Option<String>,
    offered: Vec<String>,
    chosen: usize,
    disagreements: Vec<String>,
    started: Instant,
}

impl Run {
    /// A run as the arguments ask for it.
    pub(crate) fn new(arguments: &Arguments, report: Report) -> Self {
        Self {
            report,
            quick: arguments.quick,
            filter: arguments.filter.as_ref().map(|words| words.to_lowercase()),
            offered: Vec::new(),
            chosen: 0,
            disagreements: Vec::new(),
            started: Instant::now(),
        }
    }

    /// Whether the case of this name is to be measured.
    pub(crate) fn wants(&mut self, case: &str) -> bool {
        let wanted = self.filter.as_ref().is_none_or(|words| case.to_lowercase().contains(words));
        self.chosen += usize::from(wanted);
        self.offered.push(case.to_owned());
        wanted
    }

    /// How long a case is measured whose turns are short.
    pub(crate) fn effort(&self) -> Effort {
        if self.quick {
            Effort { fewest: 1, most: 3, time: Duration::from_millis(300) }
        } else {
            Effort { fewest: 5, most: 25, time: Duration::from_secs(6) }
        }
    }

    /// A peer's time beside ours, from the same rounds.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(crate) fn ratio(
        &mut self,
        case: &str,
        (peer, theirs): (&str, Duration),
        ours: Duration,
        target: Option<f64>,
    ) -> io::Result<()> {
        let ratio = theirs.as_secs_f64() / ours.as_secs_f64();
        let cells = [
            ("peer", Cell::Word(peer.to_owned())),
            ("ours ms", ms(ours)),
            ("peer ms", ms(theirs)),
            ("ratio", Cell::Number(ratio, 2)),
            ("target", target.map_or(Cell::Empty, |target| Cell::Number(target, 2))),
            ("reached", target.map_or(Cell::Empty, |target| Cell::Verdict(ratio >= target))),
        ];
        self.report.row(case, &cells)
    }

    /// Notes that a case's results are not the same, if they are not.
    pub(crate) fn agreed(&mut self, case: &str, peer: &str, verdict: Result<(), String>) {
        if let Err(why) = verdict {
            self.disagreements.push(format!("{case}, ours and {peer}: {why}"));
        }
    }

    /// What is wrong with the run as a whole, if anything.
    pub(crate) fn verdict(&self) -> Verdict {
        if self.chosen == 0 {
            let words = self.filter.clone().unwrap_or_default();
            return Verdict::NoCase(format!(
                "no case has «{words}» in its name; there are: {}",
                self.offered.join(", ")
            ));
        }
        if self.disagreements.is_empty() {
            Verdict::Fine
        } else {
            Verdict::Disagree(self.disagreements.join("\n"))
        }
    }

    /// How long it has taken so far.
    pub(crate) fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }
}

/// How a run ends.
pub(crate) enum Verdict {
    /// All see the same.
    Fine,
    /// Somebody sees something else, and what.
    Disagree(String),
    /// The filter fits nothing, and what there is.
    NoCase(String),
}
