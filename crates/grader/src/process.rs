//! How is a worker asked, and how does one see that it will not answer any more?

use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use course::{Answerer, Exercise, Fault, Loss, Reply, Value};
use sandbox::{Calls, Confinement, Launcher, Takings};
use worker::system::{self, Channel, Offer};
use worker::wire::{self, Answer, Panic, Question, Ready};

/// So much of what a student's code prints is kept, in bytes; of the rest only the amount.
const KEPT: usize = 16 << 10;

/// So much of the end is kept, in bytes: the words with which Rust ends a process fit in.
const LAST: usize = 1 << 10;

/// A panic's message is kept up to so many characters.
const LONGEST_WORDS: usize = 2000;

/// A worker that does not even begin within this time is not to blame on the student's code: none of it runs until then.
const TO_BEGIN: Duration = Duration::from_secs(20);

/// After its end a worker's last words are waited for so long: a process that it left behind may hold its output open.
const LAST_WORDS: Duration = Duration::from_millis(200);

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

/// What a student's code printed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Printed {
    /// On standard output.
    pub out: Output,
    /// On standard error.
    pub err: Output,
}

/// What was printed on one stream.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Output {
    /// The beginning.
    pub text: String,
    /// Further bytes that were not kept.
    pub dropped: usize,
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
    printed: [Arc<Mutex<Kept>>; 2],
}

#[derive(Debug)]
struct Running {
    child: Child,
    channel: Channel,
    answers: BufReader<Channel>,
    outputs: Vec<thread::JoinHandle<()>>,
}

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
    pub(crate) fn rehearse(mut self) -> Result<(), Fault> {
        self.running = Some(self.start()?);
        Ok(())
    }

    /// Ends the worker; gives what it printed, and whether it sent more than it was asked for.
    pub(crate) fn finish(mut self) -> (Printed, bool) {
        let mut surplus = false;
        if let Some(mut running) = self.running.take() {
            // Nobody asks any more: an honest worker ends by itself and writes out what it still holds.
            let _ = running.channel.shutdown(std::net::Shutdown::Write);
            wait(&mut running.child, LAST_WORDS);
            end(&mut running);
            let _ = running.channel.set_read_timeout(Some(LAST_WORDS));
            surplus = running.answers.fill_buf().is_ok_and(|rest| !rest.is_empty());
        }
        let [out, err] = &self.printed;
        (Printed { out: output(out), err: output(err) }, surplus)
    }

    /// The command for a worker: confined if there is a launcher.
    fn command(&self, address: &str) -> Command {
        let Some(launcher) = &self.launcher else {
            let mut command = Command::new(&self.worker);
            command.arg(address).arg(self.limits.memory.to_string());
            return command;
        };
        let takings = Takings { memory: self.limits.memory, cpu: self.limits.whole, ..Takings::default() };
        let mut executable = sandbox::loaders();
        executable.push(self.worker.clone());
        let readable = sandbox::libraries();
        let confinement = Confinement { readable, executable, ..Confinement::new(Calls::Computing, takings) };
        let mut command = launcher.command(&confinement, &self.worker);
        // It has its limit of memory already.
        command.arg(address).arg("0");
        command
    }

    fn start(&self) -> Result<Running, Fault> {
        let fault = |what: &str, e: io::Error| Fault(format!("{what}: {e}"));
        let offer = Offer::new().map_err(|e| fault("no channel to the worker", e))?;
        let mut child = self
            .command(&offer.address().map_err(|e| fault("no channel to the worker", e))?)
            .env_clear()
            .stdin(offer.stdin().map_err(|e| fault("no channel to the worker", e))?)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|e| fault("the worker does not start", e))?;
        locked(&self.printed[1]).last.clear();
        let pipes: [Option<Box<dyn Read + Send>>; 2] = [
            child.stdout.take().map(|pipe| Box::new(pipe) as Box<dyn Read + Send>),
            child.stderr.take().map(|pipe| Box::new(pipe) as Box<dyn Read + Send>),
        ];
        let outputs = pipes
            .into_iter()
            .zip(&self.printed)
            .filter_map(|(pipe, kept)| {
                let kept = Arc::clone(kept);
                pipe.map(|pipe| thread::spawn(move || keep(pipe, &kept)))
            })
            .collect();
        let begun = offer.accept(Instant::now() + TO_BEGIN).and_then(|channel| {
            channel.set_read_timeout(Some(TO_BEGIN))?;
            let answers = BufReader::new(channel.try_clone()?);
            Ok((channel, answers))
        });
        let (channel, answers) = match begun {
            Ok(ends) => ends,
            Err(e) => {
                let _ = sandbox::end(&mut child);
                return Err(fault("the worker does not connect", e));
            }
        };
        let mut running = Running { child, channel, answers, outputs };
        match wire::receive::<Ready>(&mut running.answers) {
            Ok(Some(Ready)) => {}
            other => {
                let status = end(&mut running);
                let words = output(&self.printed[1]).text;
                return Err(Fault(format!("the worker did not begin ({other:?}, {status:?}): {words}")));
            }
        }
        running
            .channel
            .set_read_timeout(Some(self.limits.time))
            .map_err(|e| fault("no time limit can be set", e))?;
        Ok(running)
    }

    /// What became of the worker that fell silent.
    fn loss(&self, mut running: Running, silence: &Silence) -> Loss {
        if let Silence::Slow(limit) = silence {
            end(&mut running);
            return timed_out(*limit);
        }
        // The channel is closed: the process is ending, or the student's code closed what is not its own.
        wait(&mut running.child, self.limits.time);
        let status = end(&mut running);
        let words = String::from_utf8_lossy(&locked(&self.printed[1]).last).into_owned();
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
        answers: &mut BufReader<Channel>,
        questions: &[Vec<Value>],
        replies: &mut Vec<Result<Reply, Fault>>,
    ) -> Result<(), Silence> {
        for question in questions {
            if self.is_over() {
                return Err(Silence::Slow(self.limits.whole));
            }
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
            None => self.start()?,
        };
        let mut replies = Vec::with_capacity(questions.len());
        let mut asking =
            running.channel.try_clone().map_err(|e| Fault(format!("no channel to the worker: {e}")))?;
        let function = self.function;
        let ended = thread::scope(|scope| {
            // Written by a thread of its own: with both ends full, each would wait for the other.
            scope.spawn(move || {
                for arguments in questions {
                    let question = Question { function, arguments: arguments.clone() };
                    // A worker that is gone is noticed by the one who reads.
                    if wire::send(&mut asking, &question).is_err() {
                        break;
                    }
                }
            });
            let ended = self.read(&mut running.answers, questions, &mut replies);
            if ended.is_err() {
                // So that the thread that writes comes to an end.
                let _ = running.channel.shutdown(std::net::Shutdown::Both);
            }
            ended
        });
        match ended {
            Ok(()) => self.running = Some(running),
            Err(silence) => replies.push(Ok(Reply::Lost(self.loss(running, &silence)))),
        }
        replies.into_iter().collect()
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        if let Some(running) = &mut self.running {
            end(running);
        }
    }
}

/// Waits for the end of a process, but no longer than this.
fn wait(child: &mut Child, patience: Duration) {
    let until = Instant::now() + patience;
    while Instant::now() < until && matches!(child.try_wait(), Ok(None)) {
        thread::sleep(Duration::from_micros(200));
    }
}

/// Kills what still runs and waits for its last words.
fn end(running: &mut Running) -> Option<ExitStatus> {
    let status = sandbox::end(&mut running.child).ok();
    let patience = Instant::now() + LAST_WORDS;
    for output in running.outputs.drain(..) {
        while !output.is_finished() && Instant::now() < patience {
            thread::sleep(Duration::from_micros(100));
        }
    }
    status
}

/// Reads all that is printed, so that printing never waits, and keeps the beginning.
fn keep(mut pipe: impl Read, kept: &Mutex<Kept>) {
    let mut buffer = [0; 4096];
    while let Ok(count) = pipe.read(&mut buffer) {
        if count == 0 {
            break;
        }
        locked(kept).add(&buffer[..count]);
    }
}

fn output(kept: &Mutex<Kept>) -> Output {
    let kept = locked(kept);
    Output { text: String::from_utf8_lossy(&kept.bytes).into_owned(), dropped: kept.dropped }
}

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
