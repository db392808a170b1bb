//! How is a worker asked, and how does one see that it will not answer any more?

use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use std::thread;
use std::time::{Duration, Instant};

use course::{Answerer, Exercise, Fault, Loss, Reply, Value};
use sandbox::Launcher;
use worker::system;
use worker::wire::{self, Answer, Panic};

use crate::printed::{Printed, Stream};
use crate::running::{NotBegun, Running, Timed};

/// A panic's message is kept up to so many characters.
const LONGEST_WORDS: usize = 2000;

/// So many bytes of questions are sent before the first answer is read: a channel holds more. Shrinking asks one question at a time, and a thread for
/// each would take longer than the answer.
const AT_ONCE: usize = 32 << 10;

/// What a worker may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// For one call.
    pub time: Duration,
    /// For all calls of one exercise together.
    pub whole: Duration,
    /// In bytes, of address space.
    pub memory: u64,
}

impl Default for Limits {
    /// Two seconds a call, twenty for all, one GiB: far more than any exercise needs, even on a busy machine.
    fn default() -> Self {
        Self { time: Duration::from_secs(2), whole: Duration::from_secs(20), memory: 1 << 30 }
    }
}

/// Answers by a worker process; after a loss the next question starts a new one.
#[derive(Debug)]
pub(crate) struct Process {
    worker: PathBuf,
    /// Which of the worker's functions is asked.
    function: u32,
    /// The reference's function: decides whose fault it is that a question does not fit.
    reference: worker::Function,
    limits: Limits,
    /// Confines the worker.
    launcher: Option<Launcher>,
    begun: Instant,
    running: Option<Running>,
    printed: [Stream; 2],
}

impl Process {
    /// Asks one function of a worker, that of an exercise.
    pub(crate) fn new(
        worker: &Path,
        function: u32,
        exercise: &Exercise,
        limits: Limits,
        launcher: Option<&Launcher>,
    ) -> Self {
        Self {
            worker: worker.to_owned(),
            function,
            reference: exercise.reference.function,
            limits,
            launcher: launcher.cloned(),
            begun: Instant::now(),
            running: None,
            printed: Default::default(),
        }
    }

    /// Starts the worker and lets it end.
    pub(crate) fn rehearse(self) -> Result<(), Fault> {
        match self.start() {
            Ok(_) => Ok(()),
            Err(NotBegun::Fault(fault)) => Err(fault),
            Err(NotBegun::Lost(_)) => Err(Fault("there is not enough memory for any worker".to_owned())),
        }
    }

    fn start(&self) -> Result<Running, NotBegun> {
        Running::start(&self.worker, &self.limits, self.launcher.as_ref(), &self.printed)
    }

    /// Ends the worker; gives what it printed, and whether it sent more than it was asked for.
    pub(crate) fn finish(mut self) -> (Printed, bool) {
        let surplus = self.running.take().is_some_and(|mut running| running.finish());
        let [out, err] = &self.printed;
        (Printed { out: out.output(), err: err.output() }, surplus)
    }

    /// Questions as bytes, one behind the other.
    fn asking(&self, questions: &[Vec<Value>]) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        for arguments in questions {
            wire::ask(&mut bytes, self.function, arguments)?;
        }
        Ok(bytes)
    }

    /// What became of the worker that fell silent.
    fn loss(&self, mut running: Running, silence: &Silence) -> Loss {
        if let Silence::Slow(limit) = silence {
            running.end();
            return timed_out(*limit);
        }
        // The channel is closed: the process is ending, or the student's code closed what is not its own.
        running.wait(self.limits.time);
        let status = running.end();
        let words = self.printed[1].last_words();
        if words.contains("has overflowed its stack") {
            return Loss::StackOverflow;
        }
        if words.contains("memory allocation of") {
            return Loss::OutOfMemory;
        }
        match (silence, status) {
            (Silence::TooLong(bytes), _) => Loss::Crashed(format!("its answer would take {bytes} bytes")),
            (Silence::Strange(error), _) => {
                Loss::Crashed(format!("it sent something that is no answer: {error}"))
            }
            (_, Some(status)) => self.exited(status),
            (_, None) => Loss::Crashed("it closed the channel of answers".to_owned()),
        }
    }

    fn exited(&self, status: ExitStatus) -> Loss {
        match (system::signal(status), status.code()) {
            (Some(signal), _) if system::is_out_of_time(signal) => timed_out(self.limits.whole),
            (Some(signal), _) => Loss::Crashed(format!("ended by signal {signal}")),
            (None, Some(code)) => Loss::Exited(code),
            (None, None) => Loss::Crashed("ended".to_owned()),
        }
    }

    /// Whether all calls together have taken longer than they may.
    fn is_over(&self) -> bool {
        self.begun.elapsed() > self.limits.whole
    }

    /// Reads the answers to questions. What cannot be asked is the error of a reply.
    fn read(
        &self,
        answers: &mut BufReader<Timed>,
        questions: &[Vec<Value>],
        replies: &mut Vec<Result<Reply, Fault>>,
    ) -> Result<(), Silence> {
        for question in questions {
            if self.is_over() {
                return Err(Silence::Slow(self.limits.whole));
            }
            answers.get_mut().until = Instant::now() + self.limits.time;
            replies.push(match wire::receive::<Answer>(answers) {
                Ok(Some(Answer::Value(value))) => Ok(Reply::Value(value)),
                Ok(Some(Answer::Panicked(panic))) => Ok(Reply::Panicked(shortened(panic))),
                // It may say so falsely: then the reference finds nothing wrong with the question.
                Ok(Some(Answer::Misasked(what))) if (self.reference)(question.clone()).is_err() => {
                    Err(Fault(what))
                }
                Ok(Some(Answer::Misasked(_))) => {
                    return Err(Silence::Strange(io::ErrorKind::InvalidData.into()));
                }
                Ok(Some(Answer::TooLong(bytes))) => return Err(Silence::TooLong(bytes)),
                Ok(None) => return Err(Silence::Closed),
                Err(e) => {
                    return Err(match e.kind() {
                        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => {
                            Silence::Slow(self.limits.time)
                        }
                        io::ErrorKind::InvalidData => Silence::Strange(e),
                        _ => Silence::Closed,
                    });
                }
            });
        }
        Ok(())
    }
}

fn timed_out(limit: Duration) -> Loss {
    Loss::TimedOut(u64::try_from(limit.as_millis()).unwrap_or(u64::MAX))
}

/// A panic whose message is no longer than anybody reads.
fn shortened(mut panic: Panic) -> Panic {
    for text in [&mut panic.message, &mut panic.file] {
        if let Some((end, _)) = text.char_indices().nth(LONGEST_WORDS) {
            text.truncate(end);
            text.push('…');
        }
    }
    panic
}

/// Why no further answer comes.
#[derive(Debug)]
enum Silence {
    /// The worker is over this limit.
    Slow(Duration),
    /// Its answer would take so many bytes, more than a message can hold.
    TooLong(usize),
    /// It sent something else.
    Strange(io::Error),
    /// It closed the channel.
    Closed,
}

impl Answerer for Process {
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        let mut running = match self.running.take() {
            Some(running) => running,
            None => match self.start() {
                Ok(running) => running,
                Err(NotBegun::Fault(fault)) => return Err(fault),
                Err(NotBegun::Lost(loss)) => return Ok(vec![Reply::Lost(loss)]),
            },
        };
        let mut replies = Vec::with_capacity(questions.len());
        let asking = self.asking(questions).map_err(|e| Fault(format!("a question cannot be sent: {e}")))?;
        let mut channel =
            running.channel.try_clone().map_err(|e| Fault(format!("no channel to the worker: {e}")))?;
        // A worker that is gone is noticed by the one who reads.
        let ended = if asking.len() <= AT_ONCE {
            let _ = channel.write_all(&asking);
            self.read(&mut running.answers, questions, &mut replies)
        } else {
            thread::scope(|scope| {
                // Written by a thread of its own: with both ends full, each would wait for the other.
                scope.spawn(move || channel.write_all(&asking));
                let ended = self.read(&mut running.answers, questions, &mut replies);
                if ended.is_err() {
                    // So that the thread that writes comes to an end.
                    let _ = running.channel.shutdown(std::net::Shutdown::Both);
                }
                ended
            })
        };
        match ended {
            Ok(()) => self.running = Some(running),
            Err(silence) => replies.push(Ok(Reply::Lost(self.loss(running, &silence)))),
        }
        replies.into_iter().collect()
    }
}
