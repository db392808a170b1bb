//! What a student's code prints. Everything is read, so that printing never blocks; the beginning and the end are stored.

use std::io::Read;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};

/// Number of bytes stored from the beginning of each stream; the rest is only counted.
const KEPT: usize = 16 << 10;

/// Number of bytes stored from the end of each stream: enough for Rust's message when it aborts a process.
const LAST: usize = 1 << 10;

/// What a student's code printed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CapturedOutput {
    /// On standard output.
    pub out: Output,
    /// On standard error.
    pub err: Output,
}

/// What was printed on one stream.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Output {
    /// The beginning of what was printed.
    pub text: String,
    /// Number of bytes that were not stored.
    pub dropped: usize,
}

/// One stream of all workers that answer one after another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stream(Arc<Mutex<Kept>>);

#[derive(Debug, Default)]
struct Kept {
    bytes: Vec<u8>,
    dropped: usize,
    /// The end of what the worker that runs now printed, kept or not: its last words.
    last: Vec<u8>,
}

impl Kept {
    fn add(&mut self, bytes: &[u8]) {
        let room = KEPT.saturating_sub(self.bytes.len()).min(bytes.len());
        self.bytes.extend_from_slice(&bytes[..room]);
        self.dropped += bytes.len() - room;
        self.last.extend_from_slice(bytes);
        let surplus = self.last.len().saturating_sub(LAST);
        self.last.drain(..surplus);
    }
}

impl Stream {
    /// Reads a pipe to its end, in a thread of its own.
    pub(crate) fn follow(&self, mut pipe: impl Read + Send + 'static) -> JoinHandle<()> {
        self.kept().last.clear();
        let stream = self.clone();
        thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(count) = pipe.read(&mut buffer) {
                if count == 0 {
                    break;
                }
                stream.kept().add(&buffer[..count]);
            }
        })
    }

    /// What was printed so far.
    pub(crate) fn output(&self) -> Output {
        let kept = self.kept();
        Output { text: String::from_utf8_lossy(&kept.bytes).into_owned(), dropped: kept.dropped }
    }

    /// The last words of the worker that runs now, or ran last.
    pub(crate) fn last_words(&self) -> String {
        String::from_utf8_lossy(&self.kept().last).into_owned()
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
