//! What does a worker do all its life? Read a question, call the function, send the answer.

use std::io::{BufReader, ErrorKind, Write};
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, ThreadId};

use crate::function::Function;
use crate::system;
use crate::wire::{self, Answer, Answered, Panic, Question, Ready};

/// The first panic since the call began.
static PANIC: Mutex<Option<(Panic, ThreadId)>> = Mutex::new(None);

/// Whether this process serves: it does once. A student's function that serves too would answer for the others.
static SERVES: AtomicBool = AtomicBool::new(false);

/// The stack of a student's function, in bytes: as long as that of a main function.
const STACK: usize = 8 << 20;

/// The exit code of a worker whose code wanted more threads than it may have. Its other threads would take what the next call needs.
pub const TOO_MANY_THREADS: u8 = 117;

/// A worker's main function: answers questions about `functions` until nobody asks any more.
///
/// Its first command-line argument is the channel's address, its second the memory it may take, in bytes (0: no limit here).
/// Each answer is sent before the next call begins, so that whoever asked knows on which question a call did not return.
/// It does so in a thread of its own. Where the main thread's stack ends, a process learns from a file, which one that is confined cannot read; and
/// only who knows the end can say that a function has filled its stack.
pub fn serve(functions: &[Function]) -> ExitCode {
    if SERVES.swap(true, Ordering::Relaxed) {
        return failed("it serves already");
    }
    let served = thread::scope(|scope| {
        let server = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || answer_all(functions));
        server.map(|thread| thread.join().unwrap_or_else(|panic| panic::resume_unwind(panic)))
    });
    match served.and_then(|answered| answered) {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever asked has heard enough.
        Err(error) if matches!(error.kind(), ErrorKind::BrokenPipe | ErrorKind::ConnectionReset) => {
            ExitCode::SUCCESS
        }
        // Standard error belongs to the student's code; but without a channel nothing of it runs.
        Err(error) => failed(&error.to_string()),
    }
}

fn failed(why: &str) -> ExitCode {
    let _ = writeln!(std::io::stderr(), "worker: {why}");
    ExitCode::from(70)
}

fn answer_all(functions: &[Function]) -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let address = arguments.next().unwrap_or_default();
    let memory = arguments.next().and_then(|bytes| bytes.parse().ok()).unwrap_or(0);
    if memory > 0 {
        system::limit_memory(memory)?;
    }
    system::lower_priority();
    let mut answers = system::open(&address)?;
    system::end_with(&answers)?;
    // Kept to the end.
    let _ballast = system::room_for_whole_stacks();
    let mut questions = BufReader::new(answers.try_clone()?);
    panic::set_hook(Box::new(remember));
    // What fails before this is not the student's doing.
    wire::send(&mut answers, &Ready { computed: system::computed() })?;
    while let Some(question) = wire::receive::<Question>(&mut questions)? {
        let answer = answer(functions, question);
        wire::send_answer(&mut answers, &Answered { answer, computed: system::computed() })?;
    }
    Ok(())
}

fn answer(functions: &[Function], question: Question) -> Answer {
    let Some(function) = functions.get(question.function as usize) else {
        return Answer::Misasked(format!("no function {}", question.function));
    };
    *PANIC.lock().unwrap_or_else(PoisonError::into_inner) = None;
    let outcome = panic::catch_unwind(AssertUnwindSafe(|| function(question.arguments)));
    let remembered = PANIC.lock().unwrap_or_else(PoisonError::into_inner).take();
    match (remembered, outcome) {
        (Some((panic, thread)), _) => {
            Answer::Panicked(Panic { elsewhere: thread != thread::current().id(), ..panic })
        }
        (None, Ok(Ok(value))) => Answer::Value(value),
        (None, Ok(Err(mismatch))) => Answer::Misasked(format!("argument {}", mismatch.parameter)),
        // Somebody set a hook of their own.
        (None, Err(_)) => Answer::Panicked(Panic {
            message: "the panic's message was not kept".to_owned(),
            file: String::new(),
            line: 0,
            elsewhere: false,
        }),
    }
}

/// The panic hook: keeps the first panic instead of printing it. A thread that cannot be started ends the process.
fn remember(info: &panic::PanicHookInfo<'_>) {
    let payload = info.payload();
    let message = payload
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "a panic without a message".to_owned());
    let (file, line) = info.location().map_or((String::new(), 0), |at| (at.file().to_owned(), at.line()));
    if message.starts_with(NO_THREAD) && file.replace('\\', "/").contains(STARTS_THREADS) {
        std::process::exit(TOO_MANY_THREADS.into());
    }
    let panic = Panic { message, file, line, elsewhere: false };
    PANIC.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert((panic, thread::current().id()));
}

/// How the standard library's panic begins where the system refuses a thread…
const NO_THREAD: &str = "failed to spawn thread";

/// …and in which of its files that is.
const STARTS_THREADS: &str = "library/std/src/thread";
