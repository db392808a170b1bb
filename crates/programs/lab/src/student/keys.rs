//! Which key was pressed? Only where somebody sits at a terminal.

use std::io::{IsTerminal, stdin, stdout};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::thread;

use crossterm::event::{Event, KeyCode, KeyEventKind, KeyModifiers, read};
use crossterm::terminal::{disable_raw_mode, enable_raw_mode};

use super::watch::Happening;

/// Whether the terminal gives keys one by one at the moment.
static RAW: AtomicBool = AtomicBool::new(false);

/// Keys come one by one as long as this is kept; then the terminal is as it was.
#[derive(Debug)]
pub(crate) struct Keys;

impl Drop for Keys {
    fn drop(&mut self) {
        restore();
    }
}

/// Gives the terminal back as it was; also when a signal ends the program.
pub(crate) fn restore() {
    if RAW.swap(false, Ordering::SeqCst) {
        let _ = disable_raw_mode();
    }
}

/// Whether line ends must return the carriage themselves.
pub(crate) fn raw() -> bool {
    RAW.load(Ordering::SeqCst)
}

/// From now on each key is sent. `None` where there is no terminal, or it does not give its keys.
pub(crate) fn listen(to: &Sender<Happening>) -> Option<Keys> {
    if !stdin().is_terminal() || !stdout().is_terminal() || enable_raw_mode().is_err() {
        return None;
    }
    RAW.store(true, Ordering::SeqCst);
    let to = to.clone();
    thread::spawn(move || {
        while let Ok(event) = read() {
            let Event::Key(key) = event else { continue };
            let interrupts =
                key.modifiers.contains(KeyModifiers::CONTROL) && matches!(key.code, KeyCode::Char('c' | 'd'));
            let happening = match key.code {
                _ if key.kind == KeyEventKind::Release => continue,
                _ if interrupts => Happening::Key('q'),
                _ if key.modifiers.contains(KeyModifiers::CONTROL) => continue,
                KeyCode::Char(letter) => Happening::Key(letter.to_ascii_lowercase()),
                KeyCode::Esc => Happening::Key('q'),
                KeyCode::Enter => Happening::Key('r'),
                _ => continue,
            };
            if to.send(happening).is_err() {
                break;
            }
        }
    });
    Some(Keys)
}
