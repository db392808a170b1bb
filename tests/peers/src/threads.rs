//! On which processors does it run? Each thread on one of its own, where the system lets us say so.

use std::sync::OnceLock;

use rayon::ThreadPool;

/// A pool of `count` threads, thread k bound to processor k of those that this process may use.
///
/// The first call must come from a thread that is not bound itself: a new thread may use the processors of the one that
/// starts it.
///
/// # Panics
/// If the system gives no threads.
pub(crate) fn pinned(count: usize) -> ThreadPool {
    let processors = PROCESSORS.get_or_init(processors);
    let bind = |thread: usize| processors.get(thread).into_iter().for_each(|processor| bind(*processor));
    let builder = rayon::ThreadPoolBuilder::new().num_threads(count).start_handler(bind);
    builder.build().expect("the system gives no threads")
}

/// Those that this process was given.
static PROCESSORS: OnceLock<Vec<usize>> = OnceLock::new();

/// What the report says about it.
pub(crate) fn pinning() -> &'static str {
    if cfg!(target_os = "linux") {
        "each thread bound to a processor"
    } else {
        "threads not bound to processors: this system has no call for it here"
    }
}

#[cfg(target_os = "linux")]
fn processors() -> Vec<usize> {
    let allowed = rustix::thread::sched_getaffinity(None).unwrap_or_default();
    (0..rustix::thread::CpuSet::MAX_CPU).filter(|processor| allowed.is_set(*processor)).collect()
}

#[cfg(not(target_os = "linux"))]
fn processors() -> Vec<usize> {
    Vec::new()
}

/// Binds this thread to one processor.
#[cfg(target_os = "linux")]
fn bind(processor: usize) {
    let mut only = rustix::thread::CpuSet::new();
    only.set(processor);
    // Refused, it only moves about: the ratios are noisier and still true.
    let _ = rustix::thread::sched_setaffinity(None, &only);
}

#[cfg(not(target_os = "linux"))]
fn bind(_processor: usize) {}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn a_pool_made_by_a_bound_thread_has_processors_of_its_own() {
        let allowed = || rustix::thread::sched_getaffinity(None).unwrap();
        let all = allowed();
        let inner = pinned(1).install(|| pinned(2).broadcast(|_| allowed()));
        assert!(inner.iter().all(|set| set.count() == 1));
        assert!(all.count() == 1 || inner[0] != inner[1], "two threads, two processors");
    }
}
