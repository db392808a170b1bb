//! When was a file saved? The system says so; where it does not, looking again and again does.

use std::path::Path;
use std::sync::mpsc::Sender;
use std::time::Duration;

use notify::{Config, EventKind, PollWatcher, RecommendedWatcher, RecursiveMode, Watcher};

use super::watch::Happening;

/// Between two looks, where the system does not tell.
const LOOKS: Duration = Duration::from_millis(250);

/// Watches as long as it is kept.
pub(crate) struct Changes {
    _watcher: Box<dyn Watcher>,
    /// Whether it looks again and again.
    pub(crate) polls: bool,
}

/// From now on every change below `folder` is sent.
///
/// # Errors
/// What the system gives if it can neither tell nor be asked.
pub(crate) fn watch(folder: &Path, poll: bool, to: &Sender<Happening>) -> notify::Result<Changes> {
    if !poll && let Ok(watcher) = told(folder, to) {
        return Ok(Changes { _watcher: Box::new(watcher), polls: false });
    }
    let config = Config::default().with_poll_interval(LOOKS).with_compare_contents(true);
    let mut watcher = PollWatcher::new(passing_on(to), config)?;
    watcher.watch(folder, RecursiveMode::Recursive)?;
    Ok(Changes { _watcher: Box::new(watcher), polls: true })
}

fn told(folder: &Path, to: &Sender<Happening>) -> notify::Result<RecommendedWatcher> {
    let mut watcher = RecommendedWatcher::new(passing_on(to), Config::default())?;
    watcher.watch(folder, RecursiveMode::Recursive)?;
    Ok(watcher)
}

fn passing_on(to: &Sender<Happening>) -> impl Fn(notify::Result<notify::Event>) + Send + 'static {
    let to = to.clone();
    move |event| {
        let Ok(event) = event else { return };
        // Reading a file is no change; what the others mean differs from editor to editor.
        if matches!(event.kind, EventKind::Access(_)) {
            return;
        }
        for path in event.paths.into_iter().filter(|path| is_source(path)) {
            // Nobody listens any more: the program is ending.
            let _ = to.send(Happening::Saved(path));
        }
    }
}

fn is_source(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "rs")
}
