//! Measures what a worker's calls take: processor time, and time asleep. Time spent waiting for a busy processor counts nowhere, nor does time in
//! which the worker or the grader itself is stopped. So a verdict does not depend on what else the machine does.
//!
//! The worker says with each answer what it has computed so far, which is exact. Of a call that does not return, the grader learns it by looking from
//! time to time. Where the system does not let it look, each look counts as time asleep.

use std::time::Duration;

use course::Late;

use crate::activity::activity;
use crate::process::Limits;

/// Time between two looks at a worker that has not answered.
pub(crate) const LOOK: Duration = Duration::from_millis(25);

/// A call that neither computes nor sleeps for so long waits for the machine: for its disk, say.
const BACKSTOP: Duration = Duration::from_secs(1800);

/// What one worker has taken so far, and where its limits are.
#[derive(Debug)]
pub(crate) struct Meter {
    /// The number of the worker's process.
    process: u32,
    limits: Limits,
    /// What earlier workers of the same exercise have taken.
    before: Duration,
    /// Processor time of all threads since the worker began.
    computed: Duration,
    /// Time in which none of its threads had anything to do, though an answer was due.
    asleep: Duration,
    /// What it had taken, and of that asleep, when the present call began.
    begun: (Duration, Duration),
    /// Looks since the present call began.
    looks: u32,
}

/// What a look shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    /// The call may go on.
    Goes,
    /// It has reached a limit.
    Late(Late),
    /// It has made no progress for so long that the machine must be at fault.
    Stuck,
}

impl Meter {
    /// For a worker's process; `before` is what earlier workers of the exercise have taken.
    pub(crate) fn new(process: u32, limits: Limits, before: Duration) -> Self {
        let zero = Duration::ZERO;
        Self { process, limits, before, computed: zero, asleep: zero, begun: (zero, zero), looks: 0 }
    }

    /// The worker says, with an answer, what it has computed so far. Gives the limit that the call has reached; the next call begins.
    pub(crate) fn answered(&mut self, computed: Duration) -> Option<Late> {
        self.computed = computed;
        let late = self.late();
        self.begin();
        late
    }

    /// What was taken until now does not count for the next call.
    pub(crate) fn begin(&mut self) {
        self.begun = (self.taken(), self.asleep);
        self.looks = 0;
    }

    /// Looks at a worker whose answer has been due for another [`LOOK`]. `backlog` is true if the grader has not yet read all that the worker
    /// printed: then the worker may be waiting for the grader, which is no time of its own.
    pub(crate) fn look(&mut self, backlog: bool) -> Seen {
        self.looks += 1;
        match activity(self.process) {
            Some(now) => {
                let idle = now.asleep && now.computed <= self.computed && !backlog;
                self.computed = self.computed.max(now.computed);
                self.asleep += if idle { LOOK } else { Duration::ZERO };
            }
            None if backlog => {}
            None => self.asleep += LOOK,
        }
        match self.late() {
            Some(late) => Seen::Late(late),
            None if LOOK * self.looks > BACKSTOP => Seen::Stuck,
            None => Seen::Goes,
        }
    }

    /// The worker was ended by the system at this limit of processor time.
    pub(crate) fn ended_at(&mut self, computed: Duration) -> Late {
        self.computed = self.computed.max(computed);
        self.late().unwrap_or(Late::Together(millis(self.limits.whole)))
    }

    /// What this worker and those before it have taken.
    pub(crate) fn total(&self) -> Duration {
        self.before + self.taken()
    }

    fn taken(&self) -> Duration {
        self.computed + self.asleep
    }

    /// The limit that was reached first, however late somebody looked.
    fn late(&self) -> Option<Late> {
        let (begun, asleep) = self.begun;
        let call = begun + self.limits.time;
        let whole = self.limits.whole.saturating_sub(self.before);
        if self.taken() <= call.min(whole) {
            return None;
        }
        Some(if whole < call {
            Late::Together(millis(self.limits.whole))
        } else if self.asleep - asleep > self.limits.time / 2 {
            Late::Waiting(millis(self.limits.time))
        } else {
            Late::Computing(millis(self.limits.time))
        })
    }
}

/// As whole milliseconds.
pub(crate) fn millis(time: Duration) -> u64 {
    u64::try_from(time.as_millis()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn seconds(seconds: u64) -> Duration {
        Duration::from_secs(seconds)
    }

    /// Two seconds a call, twenty for all. No such process can be looked at.
    fn meter(before: Duration) -> Meter {
        Meter::new(u32::MAX, Limits::default(), before)
    }

    #[test]
    fn a_call_is_late_by_what_it_took_itself() {
        let mut meter = meter(Duration::ZERO);
        assert_eq!(meter.answered(seconds(1)), None);
        assert_eq!(meter.answered(seconds(3)), None, "two seconds");
        assert_eq!(meter.answered(seconds(6)), Some(Late::Computing(2000)), "three seconds");
    }

    #[test]
    fn all_calls_together_are_late_whoever_took_the_time() {
        let mut meter = meter(seconds(19));
        assert_eq!(meter.answered(Duration::from_millis(900)), None);
        assert_eq!(meter.answered(Duration::from_millis(1100)), Some(Late::Together(20_000)));
    }

    #[test]
    fn who_looks_too_late_says_the_same_as_who_looks_in_time() {
        let mut in_time = meter(Duration::ZERO);
        in_time.answered(seconds(1));
        let mut too_late = meter(Duration::ZERO);
        too_late.answered(seconds(1));
        assert_eq!(in_time.ended_at(Duration::from_millis(3010)), Late::Computing(2000));
        assert_eq!(too_late.ended_at(seconds(22)), Late::Computing(2000), "the grader was stopped meanwhile");
    }

    #[test]
    fn a_call_that_sleeps_is_late_by_the_looks_that_found_it_asleep() {
        let mut meter = meter(Duration::ZERO);
        let looks = (0..1000).take_while(|_| meter.look(false) == Seen::Goes).count();
        assert_eq!(looks as u32, 80, "two seconds of looks");
        assert_eq!(meter.look(false), Seen::Late(Late::Waiting(2000)));
    }

    #[test]
    fn a_call_that_waits_for_the_grader_to_read_its_output_takes_no_time() {
        let mut meter = meter(Duration::ZERO);
        assert!((0..1000).all(|_| meter.look(true) == Seen::Goes));
    }
}
