//! How long does it take? Rounds in which everybody has a turn, and the median of each.

use std::time::{Duration, Instant};

/// How long a case is measured.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// At least this many rounds.
    pub(crate) fewest: usize,
    /// At most this many.
    pub(crate) most: usize,
    /// And between the two for as long as this lasts.
    pub(crate) time: Duration,
}

/// The median time of each contestant. A round gives each one turn, in their order, so that whatever disturbs the
/// machine for a while disturbs all of them; a round before the first is not counted: it fills caches and touches fresh
/// memory.
pub(crate) fn medians(effort: Effort, contestants: &mut [&mut dyn FnMut()]) -> Vec<Duration> {
    for turn in contestants.iter_mut() {
        turn();
    }
    let mut times = vec![Vec::new(); contestants.len()];
    let start = Instant::now();
    let goes_on = |rounds| rounds < effort.fewest || rounds < effort.most && start.elapsed() < effort.time;
    let mut rounds = 0;
    while goes_on(rounds) {
        for (turn, times) in contestants.iter_mut().zip(&mut times) {
            let before = Instant::now();
            turn();
            times.push(before.elapsed());
        }
        rounds += 1;
    }
    times.into_iter().map(median).collect()
}

/// The middle one; of an even number the mean of the middle two.
///
/// # Panics
/// If there are no times.
fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    let (low, high) = (times[(times.len() - 1) / 2], times[times.len() / 2]);
    (low + high) / 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_and_not_the_mean() {
        let times = |millis: &[u64]| millis.iter().map(|t| Duration::from_millis(*t)).collect();
        assert_eq!(median(times(&[900, 1, 2])), Duration::from_millis(2));
        assert_eq!(median(times(&[900, 1, 2, 4])), Duration::from_millis(3));
    }

    #[test]
    fn contestants_take_turns() {
        let order = std::cell::RefCell::new(String::new());
        let mut ours = || order.borrow_mut().push('o');
        let mut peer = || order.borrow_mut().push('p');
        let effort = Effort { fewest: 2, most: 3, time: Duration::ZERO };
        assert_eq!(medians(effort, &mut [&mut ours, &mut peer]).len(), 2);
        assert_eq!(*order.borrow(), "opopop");
    }
}
