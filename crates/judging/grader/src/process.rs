//! How is a worker asked, and how does one see that it will not answer any more?

use std::io::{self, BufReader};
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use std::time::Duration;

use course::{Answerer, Exercise, Fault, Late, Loss, Reply, Value};
use sandbox::Launcher;
use worker::wire::{self, Answer, Answered, Panic};
use worker::{TOO_MANY_THREADS, system};

use crate::captured_output::{CapturedOutput, Stream};
use crate::meter::millis;
use crate::running::{KILLED, NotBegun, Running, Timed, last_resort};

/// A panic's message is kept up to so many characters.
const LONGEST_WORDS: usize = 2000;

/// Bytes of questions that may be under way. A channel holds more, so sending does not wait, and a worker always has something to do. With a thread that
/// sends all at once, a worker could seem to sleep where that thread only waits for a processor.
const UNDER_WAY: usize = if cfg!(target_os = "linux") { 32 << 10 } else { 4 << 10 };

/// What a worker may take. Time is what it computes, on all its processors together, and what it sleeps; waiting for a busy processor does not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// For one call.
    pub time: Duration,
    /// For all calls of one exercise together.
    pub whole: Duration,
    /// For the compiler, on the first file; a second more for each further file.
    pub compiling: Duration,
    /// In bytes, of address space.
    pub memory: u64,
    /// In bytes, of the grader's memory, for all answers of one exercise together.
    pub answers: usize,
}

impl Default for Limits {
    /// Two seconds a call, twenty for all, ten for the compiler, one GiB, 32 MiB of answers: far more than any exercise needs.
    fn default() -> Self {
        let [time, whole, compiling] = [2, 20, 10].map(Duration::from_secs);
        Self { time, whole, compiling, memory: 1 << 30, answers: 32 << 20 }
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
    /// What the workers that have ended have taken.
    taken: Duration,
    /// The memory that all answers so far take.
    kept: usize,
    /// How a worker ended before it could be asked, if one did.
    unbegun: Option<String>,
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
            taken: Duration::ZERO,
            kept: 0,
            unbegun: None,
            running: None,
            printed: Default::default(),
        }
    }

    /// Starts the worker and lets it end.
    pub(crate) fn rehearse(self) -> Result<(), Fault> {
        match self.start() {
            Ok(_) => Ok(()),
            Err(NotBegun::Fault(fault)) => Err(fault),
            Err(NotBegun::Ended(how)) => Err(Fault(how)),
            Err(NotBegun::Lost(_)) => Err(Fault("there is not enough memory for any worker".to_owned())),
        }
    }

    fn start(&self) -> Result<Running, NotBegun> {
        Running::start(&self.worker, &self.limits, self.taken, self.launcher.as_ref(), &self.printed)
    }

    /// How a worker ended before it could be asked, if one did.
    pub(crate) fn unbegun(&self) -> Option<String> {
        self.unbegun.clone()
    }

    /// Ends the worker; gives what it printed, and whether it sent more than it was asked for.
    pub(crate) fn finish(mut self) -> (CapturedOutput, bool) {
        let surplus = self.running.take().is_some_and(|mut running| running.finish());
        let [out, err] = &self.printed;
        (CapturedOutput { out: out.output(), err: err.output() }, surplus)
    }

    /// Questions as bytes.
    fn packed(&self, questions: &[Vec<Value>]) -> io::Result<Vec<Vec<u8>>> {
        let packed = |arguments: &Vec<Value>| {
            let mut bytes = Vec::new();
            wire::ask(&mut bytes, self.function, arguments).map(|()| bytes)
        };
        questions.iter().map(packed).collect()
    }

    /// What became of the worker that fell silent.
    ///
    /// # Errors
    /// [`Fault`]: the machine, or somebody on it, ended or stopped it.
    fn loss(&self, mut running: Running, silence: Silence) -> Result<Loss, Fault> {
        let silence = match silence {
            Silence::Late(late) => return Ok(Loss::TimedOut(late)),
            Silence::Stuck(why) => return Err(Fault(format!("a call does not go on: {why}"))),
            Silence::TooMuch => {
                let limit = self.limits.answers >> 20;
                return Ok(Loss::Crashed(format!("its answers together take over {limit} MiB")));
            }
            other => other,
        };
        // The channel is closed: the process is ending, or the student's code closed what is not its own.
        let by_itself = running.settle();
        running.end();
        if by_itself.and_then(|status| status.code()) == Some(TOO_MANY_THREADS.into()) {
            return Ok(Loss::TooManyThreads);
        }
        let words = self.printed[1].last_words();
        if words.contains("has overflowed its stack") {
            return Ok(Loss::StackOverflow);
        }
        if words.contains("memory allocation of") {
            return Ok(Loss::OutOfMemory);
        }
        match (silence, by_itself) {
            (Silence::TooLong(bytes), _) => Ok(Loss::Crashed(format!("its answer would take {bytes} bytes"))),
            (Silence::Strange(error), _) => {
                Ok(Loss::Crashed(format!("it sent something that is no answer: {error}")))
            }
            (_, Some(status)) => self.exited(status, &mut running),
            (_, None) => Ok(Loss::Crashed("it closed the channel of answers".to_owned())),
        }
    }

    fn exited(&self, status: ExitStatus, running: &mut Running) -> Result<Loss, Fault> {
        match (system::signal(status), status.code()) {
            (Some(signal), _) if system::is_out_of_time(signal) => {
                Ok(Loss::TimedOut(running.answers.get_mut().meter.ended_at(last_resort(&self.limits))))
            }
            // No student's code can send it.
            (Some(KILLED), _) => Err(Fault("something on this machine ended the program".to_owned())),
            (Some(signal), _) => Ok(Loss::Crashed(format!("ended by signal {signal}"))),
            (None, Some(code)) => Ok(Loss::Exited(code)),
            (None, None) => Ok(Loss::Crashed("ended".to_owned())),
        }
    }

    /// Sends questions and reads the answers to them. What cannot be asked is the error of a reply.
    fn converse(
        &mut self,
        answers: &mut BufReader<Timed>,
        questions: &[Vec<Value>],
        packed: &[Vec<u8>],
        replies: &mut Vec<Result<Reply, Fault>>,
    ) -> Result<(), Silence> {
        let mut unsent = packed.iter().peekable();
        let mut under_way = 0;
        for (question, bytes) in questions.iter().zip(packed) {
            // In few large pieces: a channel has room for a few hundred pieces, however small they are.
            if under_way <= UNDER_WAY / 2 {
                let mut piece = Vec::new();
                while let Some(next) =
                    unsent.next_if(|next| under_way == 0 || under_way + next.len() <= UNDER_WAY)
                {
                    under_way += next.len();
                    piece.extend_from_slice(next);
                }
                answers.get_mut().send(&piece).map_err(|e| silence(e, answers.get_ref().late))?;
            }
            let Answered { answer, computed } = match wire::receive(answers) {
                Ok(Some(answered)) => answered,
                Ok(None) => return Err(Silence::Closed),
                Err(e) => return Err(silence(e, answers.get_ref().late)),
            };
            under_way -= bytes.len();
            if let Some(late) = answers.get_mut().answered(computed) {
                return Err(Silence::Late(late));
            }
            replies.push(self.reply(question, answer)?);
        }
        Ok(())
    }

    fn reply(&mut self, question: &[Value], answer: Answer) -> Result<Result<Reply, Fault>, Silence> {
        Ok(match answer {
            Answer::Value(value) => {
                self.kept += value.memory();
                if self.kept > self.limits.answers {
                    return Err(Silence::TooMuch);
                }
                Ok(Reply::Value(value))
            }
            Answer::Panicked(panic) => Ok(Reply::Panicked(shortened(panic))),
            // It may say so falsely: then the reference finds nothing wrong with the question.
            Answer::Misasked(what) if (self.reference)(question.to_vec()).is_err() => Err(Fault(what)),
            Answer::Misasked(_) => return Err(Silence::Strange(io::ErrorKind::InvalidData.into())),
            Answer::TooLong(bytes) => return Err(Silence::TooLong(bytes)),
        })
    }
}

/// What an error of reading means; `late` is the limit of time that was reached, if it was.
fn silence(error: io::Error, late: Option<Late>) -> Silence {
    match (late, error.kind()) {
        (Some(late), _) => Silence::Late(late),
        (None, io::ErrorKind::InvalidData) => Silence::Strange(error),
        (None, io::ErrorKind::Other) => Silence::Stuck(error),
        (None, _) => Silence::Closed,
    }
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
    /// The worker has reached this limit.
    Late(Late),
    /// It makes no progress, and that is not its own doing.
    Stuck(io::Error),
    /// Its answers together take too much memory.
    TooMuch,
    /// Its answer would take so many bytes, more than a message can hold.
    TooLong(usize),
    /// It sent something else.
    Strange(io::Error),
    /// It closed the channel.
    Closed,
}

impl Answerer for Process {
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        if self.taken > self.limits.whole {
            return Ok(vec![Reply::Lost(Loss::TimedOut(Late::Together(millis(self.limits.whole))))]);
        }
        let mut running = match self.running.take().map_or_else(|| self.start(), Ok) {
            Ok(running) => running,
            Err(NotBegun::Fault(fault)) => return Err(fault),
            Err(NotBegun::Ended(how)) => {
                self.unbegun = Some(how.clone());
                return Err(Fault(how));
            }
            Err(NotBegun::Lost(loss)) => return Ok(vec![Reply::Lost(loss)]),
        };
        let mut replies = Vec::with_capacity(questions.len());
        let packed = self.packed(questions).map_err(|e| Fault(format!("a question cannot be sent: {e}")))?;
        let ended = self.converse(&mut running.answers, questions, &packed, &mut replies);
        match ended {
            Ok(()) => self.running = Some(running),
            Err(silence) => {
                self.taken = running.answers.get_ref().meter.total();
                replies.push(self.loss(running, silence).map(Reply::Lost));
            }
        }
        replies.into_iter().collect()
    }
}
