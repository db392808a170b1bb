//! How do questions and answers become bytes? Length first, then postcard's compact form.

use std::io::{self, Read, Write};
use std::time::Duration;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::value::Value;

/// No message is longer, in bytes: whoever sends more is not answering the question.
pub const LONGEST: usize = 64 << 10;

/// The first message of a worker: it has its limits and waits for questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Ready {
    /// Processor time of the process so far.
    pub computed: Duration,
}

/// Calls one function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Which of the worker's functions.
    pub function: u32,
    /// What it is called with.
    pub arguments: Vec<Value>,
}

/// An answer, and what has been computed for it and all before it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answered {
    /// What came of the call.
    pub answer: Answer,
    /// Processor time of the process so far.
    pub computed: Duration,
}

/// What came of a call.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// It returned.
    Value(Value),
    /// It panicked, or a thread of its did.
    Panicked(Panic),
    /// It returned more than a message can hold; so many bytes it would take.
    TooLong(usize),
    /// It was not called: the arguments were not of its types. The mistake of whoever asked.
    Misasked(String),
}

/// The first panic of a call.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Panic {
    /// What it said.
    pub message: String,
    /// The source file, as the compiler was told its name.
    pub file: String,
    /// The line in it, from 1.
    pub line: u32,
    /// Whether another thread than the one that was called panicked.
    pub elsewhere: bool,
}

/// Writes one question, without taking its arguments.
///
/// # Errors
/// What writing gives; `InvalidInput` for a question over [`LONGEST`].
pub fn ask(to: &mut impl Write, function: u32, arguments: &[Value]) -> io::Result<()> {
    send(to, &BorrowedQuestion { function, arguments })
}

/// A [`Question`] whose arguments stay where they are; the same bytes.
#[derive(Serialize)]
struct BorrowedQuestion<'a> {
    function: u32,
    arguments: &'a [Value],
}

/// Writes one message.
///
/// # Errors
/// What writing gives; `InvalidInput` for a message over [`LONGEST`].
pub fn send<T: Serialize>(to: &mut impl Write, message: &T) -> io::Result<()> {
    to.write_all(&packed(message)?.map_err(|length| {
        io::Error::new(io::ErrorKind::InvalidInput, format!("a message of {length} bytes"))
    })?)
}

/// Writes an answer; in place of one that is too long, that it is.
///
/// # Errors
/// What writing gives.
pub fn send_answer(to: &mut impl Write, answered: &Answered) -> io::Result<()> {
    match packed(answered)? {
        Ok(bytes) => to.write_all(&bytes),
        Err(length) => send(to, &Answered { answer: Answer::TooLong(length), ..*answered }),
    }
}

/// The message with its length before it; its length alone if that is over [`LONGEST`].
fn packed<T: Serialize>(message: &T) -> io::Result<Result<Vec<u8>, usize>> {
    let mut bytes = postcard::to_extend(message, vec![0; 4]).map_err(io::Error::other)?;
    let length = bytes.len() - 4;
    if length > LONGEST {
        return Ok(Err(length));
    }
    bytes[..4].copy_from_slice(&(length as u32).to_le_bytes());
    Ok(Ok(bytes))
}

/// Reads one message; `None` where the sender ended between two.
///
/// # Errors
/// What reading gives; `UnexpectedEof` within a message; `InvalidData` for bytes that are not a message, or one over
/// [`LONGEST`].
pub fn receive<T: DeserializeOwned>(from: &mut impl Read) -> io::Result<Option<T>> {
    let mut length = [0; 4];
    let got = from.read(&mut length[..1])?;
    if got == 0 {
        return Ok(None);
    }
    from.read_exact(&mut length[1..])?;
    let length = u32::from_le_bytes(length) as usize;
    if length > LONGEST {
        return Err(io::Error::new(io::ErrorKind::InvalidData, format!("a message of {length} bytes")));
    }
    let mut bytes = vec![0; length];
    from.read_exact(&mut bytes)?;
    postcard::from_bytes(&bytes).map(Some).map_err(|e| io::Error::new(io::ErrorKind::InvalidData, e))
}
