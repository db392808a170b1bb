//! On which processors does it run? Each thread on one of its own, where the system lets us say so.

use rayon::ThreadPool;

/// A pool of `count` threads, thread k bound to processor k of those that this process may use.
///
/// # Panics
/// If the system gives no threads.
pub(crate) fn pinned(count: usize) -> ThreadPool {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(count).start_handler(pin);
    builder.build().expect("the system gives no threads")
}

/// What the report says about it.
pub(crate) fn pinning() -> &'static str {
    if cfg!(target_os = "linux") {
        "each thread bound to a processor"
    } else {
        "threads not bound to processors: this system has no call for it here"
    }
}

#[cfg(target_os = "linux")]
fn pin(thread: usize) {
    use rustix::thread::{CpuSet, sched_getaffinity, sched_setaffinity};
    let Ok(allowed) = sched_getaffinity(None) else { return };
    let processors: Vec<usize> = (0..CpuSet::MAX_CPU).filter(|cpu| allowed.is_set(*cpu)).collect();
    if let Some(cpu) = processors.get(thread) {
        let mut one = CpuSet::new();
        one.set(*cpu);
        // Refused, it only moves about: the ratios are noisier and still true.
        let _ = sched_setaffinity(None, &one);
    }
}

#[cfg(not(target_os = "linux"))]
fn pin(_thread: usize) {}
