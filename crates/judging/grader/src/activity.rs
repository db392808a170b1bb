//! What another process is doing, as far as the system tells.

use std::time::Duration;

/// What a process has done so far, and is doing now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Activity {
    /// Processor time of all its threads, and of the processes that it has waited for.
    pub(crate) computed: Duration,
    /// True if every thread waits for something other than a processor, the disk, or whoever stopped it.
    pub(crate) asleep: bool,
}

/// Linux tells it in files. `None` if the process is gone.
#[cfg(target_os = "linux")]
pub(crate) fn activity(process: u32) -> Option<Activity> {
    let folder = format!("/proc/{process}");
    let computed = ticks(&std::fs::read_to_string(format!("{folder}/stat")).ok()?)?;
    let threads = std::fs::read_dir(format!("{folder}/task")).ok()?.flatten();
    let asleep = threads
        .map(|thread| std::fs::read_to_string(thread.path().join("stat")).unwrap_or_default())
        .all(|stat| {
            fields(&stat).and_then(|mut fields| fields.next()).is_none_or(|state| "SZXI".contains(state))
        });
    Some(Activity { computed: TICK * computed, asleep })
}

/// Elsewhere there is no way without unsafe code.
#[cfg(not(target_os = "linux"))]
pub(crate) fn activity(_process: u32) -> Option<Activity> {
    None
}

/// The unit in which Linux tells processor times to programs, whatever the kernel counts in itself.
#[cfg(target_os = "linux")]
const TICK: Duration = Duration::from_millis(10);

/// What follows the name of the program, which may hold anything: the state first.
#[cfg(target_os = "linux")]
fn fields(stat: &str) -> Option<impl Iterator<Item = &str>> {
    Some(stat.rsplit_once(')')?.1.split_ascii_whitespace())
}

/// User and system time of a process and of its children, in ticks.
#[cfg(target_os = "linux")]
fn ticks(stat: &str) -> Option<u32> {
    let times: Vec<u32> = fields(stat)?.skip(11).take(4).filter_map(|field| field.parse().ok()).collect();
    (times.len() == 4).then(|| times.iter().sum())
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn times_and_state_are_found_behind_any_name() {
        let stat = "17 (a) b (c) S 1 17 17 0 -1 4194560 90 80 0 0 3 4 5 6 20 0 2 0 99";
        assert_eq!(fields(stat).expect("fields").next(), Some("S"));
        assert_eq!(ticks(stat), Some(18));
        assert_eq!(ticks("17 (a) S 1"), None);
    }

    #[test]
    fn a_process_that_computes_is_not_asleep_and_its_time_grows() {
        let own = || activity(std::process::id()).expect("it is there");
        let begun = own();
        while own().computed == begun.computed {
            assert!(!own().asleep, "this thread asks");
        }
    }
}
