//! What happens on Ctrl-C? The unfinished file goes, and the program with it.

use crate::failure::Failure;

/// From now on Ctrl-C ends the program with 130, a request to terminate ends it with 143, and neither leaves anything
/// unfinished.
///
/// A limit on the size of files (`ulimit -f`) ends the program no longer; writing fails instead, as on a full disk.
///
/// # Errors
/// [`Failure`] if the system refuses.
#[cfg(unix)]
pub(crate) fn watch() -> Result<(), Failure> {
    use signal_hook::consts::{SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;

    let refused = |error: std::io::Error| {
        Failure::new(
            format!("cannot watch for Ctrl-C: {}", crate::failure::reason(&error)),
            "the system is short of something: end other programs and try again",
        )
    };
    let mut signals = Signals::new([SIGINT, SIGTERM, SIGXFSZ]).map_err(refused)?;
    std::thread::Builder::new()
        .name("signals".to_owned())
        .spawn(move || {
            if let Some(signal) = signals.forever().find(|signal| *signal != SIGXFSZ) {
                end(signal);
            }
        })
        .map_err(refused)?;
    Ok(())
}

/// Such signals are a thing of Unix. Elsewhere Ctrl-C ends the program at once; a file `.lab-….tmp` may remain.
///
/// # Errors
/// None.
#[cfg(not(unix))]
pub(crate) fn watch() -> Result<(), Failure> {
    Ok(())
}

/// Ends the program with 128 plus the number of the signal, as a shell would say it.
#[cfg(unix)]
fn end(signal: i32) -> ! {
    use std::io::{IsTerminal, Write};

    crate::student::restore_terminal();
    crate::live::abandon();
    let _no_new_file = crate::unfinished::abandon();
    if std::io::stderr().is_terminal() {
        // The line of the progress bar ends here; the prompt comes below it.
        let _ = writeln!(std::io::stderr());
    }
    std::process::exit(128 + signal)
}
