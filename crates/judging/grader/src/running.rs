//! How does a worker begin and end?

use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::net::Shutdown;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use course::{Fault, Late, Loss};
use sandbox::{Calls, Confinement, Launcher, ResourceLimits};
use worker::system::{self, Backlog, Channel, Offer};
use worker::wire::{self, Ready};

use crate::captured_output::Stream;
use crate::meter::{LOOK, Meter, Seen};
use crate::process::Limits;

/// Time for a worker to begin, counted in looks: a grader that is stopped does not look. None of the student's code should run until then.
const TO_BEGIN: Duration = Duration::from_secs(120);

/// Time for the last words of a worker that has ended, counted in pauses. They come at once, unless a process that it left behind holds its output
/// open; a confined worker leaves none.
const LAST_WORDS: Duration = Duration::from_secs(5);

/// The longest pause between two looks at whether something has ended.
const PAUSE: Duration = Duration::from_millis(5);

/// The system itself ends a worker whose grader does not: so much later.
const GRACE: Duration = Duration::from_secs(5);

/// An answer comes in at most so many pieces. Of one that comes byte by byte the meter learns even if no byte is late.
const PIECES: u32 = 64;

/// A worker that runs.
#[derive(Debug)]
pub(crate) struct Running {
    child: Child,
    pub(crate) channel: Channel,
    pub(crate) answers: BufReader<Timed>,
    outputs: Vec<JoinHandle<()>>,
}

/// A channel whose reading and writing wait as long as the worker's meter lets them.
#[derive(Debug)]
pub(crate) struct Timed {
    channel: Channel,
    pub(crate) meter: Meter,
    /// The worker's standard output and error, as far as they are not read yet.
    backlogs: Vec<Backlog>,
    /// Which limit the worker has reached, if reading failed for that.
    pub(crate) late: Option<Late>,
    /// Looks left until the worker must have begun.
    to_begin: Option<u32>,
    /// Pieces read since the present answer was due.
    pieces: u32,
    looked: Instant,
}

impl Timed {
    fn new(channel: Channel, meter: Meter, backlogs: Vec<Backlog>) -> io::Result<Self> {
        channel.set_read_timeout(Some(LOOK))?;
        channel.set_write_timeout(Some(LOOK))?;
        let looks = TO_BEGIN.as_millis() / LOOK.as_millis();
        Ok(Self {
            channel,
            meter,
            backlogs,
            late: None,
            to_begin: Some(looks as u32),
            pieces: 0,
            looked: Instant::now(),
        })
    }

    /// The worker says with its answer what it has computed so far. Gives the limit that the call has reached; the next answer is due.
    pub(crate) fn answered(&mut self, computed: Duration) -> Option<Late> {
        self.pieces = 0;
        self.meter.answered(computed)
    }

    /// Sends bytes. Whether the worker is gone is left to who reads.
    pub(crate) fn send(&mut self, mut bytes: &[u8]) -> io::Result<()> {
        while !bytes.is_empty() {
            match self.channel.write(bytes) {
                Ok(sent) => bytes = &bytes[sent..],
                Err(e) if e.kind() == ErrorKind::Interrupted => {}
                Err(e) if is_time_to_look(&e) => self.look()?,
                Err(_) => return Ok(()),
            }
        }
        Ok(())
    }

    fn see(&mut self) -> Seen {
        self.meter.look(self.backlogs.iter().any(Backlog::waits))
    }

    fn look(&mut self) -> io::Result<()> {
        self.looked = Instant::now();
        if let Some(looks) = &mut self.to_begin {
            *looks = looks.checked_sub(1).ok_or(ErrorKind::TimedOut)?;
            return Ok(());
        }
        match self.see() {
            Seen::Goes => Ok(()),
            Seen::Late(late) => {
                self.late = Some(late);
                Err(ErrorKind::TimedOut.into())
            }
            Seen::Stuck => Err(io::Error::other("it neither computes nor waits")),
        }
    }
}

impl Read for Timed {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.pieces += 1;
        if self.pieces > PIECES && self.looked.elapsed() >= LOOK {
            self.look()?;
        }
        loop {
            match self.channel.read(buffer) {
                // The grader was stopped and goes on.
                Err(e) if e.kind() == ErrorKind::Interrupted => {}
                Err(e) if is_time_to_look(&e) => self.look()?,
                read => return read,
            }
        }
    }
}

/// True if nothing came, or nothing could be sent, for the time between two looks.
fn is_time_to_look(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut)
}

/// Why a worker does not run.
#[derive(Debug)]
pub(crate) enum NotBegun {
    /// It is ours, or the system's.
    Fault(Fault),
    /// It ended before it could be asked. If a worker without a student's file begins, this is the file's doing.
    Ended(String),
    /// What the student's file lets the program take before its first line is more than it may have.
    Lost(Loss),
}

impl Running {
    /// Starts a worker, confined if there is a launcher, and waits until it is ready. `before` is what earlier workers of the exercise have taken.
    pub(crate) fn start(
        worker: &Path,
        limits: &Limits,
        before: Duration,
        launcher: Option<&Launcher>,
        printed: &[Stream; 2],
    ) -> Result<Self, NotBegun> {
        let mut running = Self::spawn(worker, limits, before, launcher, printed)?;
        let words = wire::receive::<Ready>(&mut running.answers);
        if let Ok(Some(Ready { computed })) = words {
            let answers = running.answers.get_mut();
            answers.to_begin = None;
            answers.answered(computed);
            return Ok(running);
        }
        let by_itself = running.settle();
        let status = running.end();
        let last = printed[1].last_words();
        let signal = by_itself.and_then(system::signal);
        // A program whose own data do not fit ends while the system, or the loader of its libraries, puts it into memory.
        let no_room = signal.is_some_and(|signal| signal != KILLED && !system::is_out_of_time(signal));
        if no_room || NO_ROOM.iter().any(|words| last.contains(words)) {
            return Err(NotBegun::Lost(Loss::OutOfMemory));
        }
        let problem = format!("the worker did not begin ({words:?}, {status:?}): {last}");
        let not_launched = status.is_none_or(|status| status.code() == Some(sandbox::NOT_LAUNCHED.into()));
        let ours = not_launched || signal == Some(KILLED);
        Err(if ours { NotBegun::Fault(Fault(problem)) } else { NotBegun::Ended(problem) })
    }

    fn spawn(
        worker: &Path,
        limits: &Limits,
        before: Duration,
        launcher: Option<&Launcher>,
        printed: &[Stream; 2],
    ) -> Result<Self, NotBegun> {
        let channel = |e: io::Error| fault("no channel to the worker", &e);
        let offer = Offer::new().map_err(channel)?;
        let address = offer.address().map_err(channel)?;
        let mut child = command(worker, &address, limits, launcher)
            .env_clear()
            .envs(system::ENVIRONMENT)
            .stdin(offer.stdin().map_err(channel)?)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|e| fault("the worker does not start", &e))?;
        let backlogs = [child.stdout.as_ref().map(Backlog::of), child.stderr.as_ref().map(Backlog::of)];
        let backlogs = backlogs.into_iter().flatten().collect::<Result<Vec<_>, _>>();
        let outputs = [
            child.stdout.take().map(|pipe| printed[0].follow(pipe)),
            child.stderr.take().map(|pipe| printed[1].follow(pipe)),
        ];
        let meter = Meter::new(child.id(), *limits, before);
        let begun = offer
            .accept(Instant::now() + TO_BEGIN)
            .and_then(|channel| Ok((channel.try_clone()?, Timed::new(channel, meter, backlogs?)?)))
            .map(|(channel, answers)| (channel, BufReader::new(answers)));
        match begun {
            Ok((channel, answers)) => {
                Ok(Self { child, channel, answers, outputs: outputs.into_iter().flatten().collect() })
            }
            Err(e) => {
                let _ = sandbox::end(&mut child);
                Err(fault("the worker does not connect", &e))
            }
        }
    }

    /// Waits until it ends by itself, for as long as one call may take; `None` if it does not.
    pub(crate) fn settle(&mut self) -> Option<ExitStatus> {
        let answers = self.answers.get_mut();
        answers.meter.begin();
        let mut pauses = pauses();
        loop {
            match self.child.try_wait() {
                Ok(Some(status)) => return Some(status),
                Ok(None) => {}
                Err(_) => return None,
            }
            // So long a pause counts as a look; the short ones before it are over at once.
            let pause = pauses.next().unwrap_or(LOOK);
            thread::sleep(pause);
            if pause == LOOK && answers.see() != Seen::Goes {
                return None;
            }
        }
    }

    /// Ends what still runs and waits for its last words.
    pub(crate) fn end(&mut self) -> Option<ExitStatus> {
        let status = sandbox::end(&mut self.child).ok();
        let mut patience = LAST_WORDS.as_millis() / PAUSE.as_millis();
        let mut pauses = pauses();
        for output in self.outputs.drain(..) {
            while !output.is_finished() && patience > 0 {
                thread::sleep(pauses.next().unwrap_or(PAUSE));
                patience -= 1;
            }
        }
        status
    }

    /// Lets it end by itself, since nobody asks any more: an honest worker does, and writes out what it still holds. True if it sent more than was
    /// read.
    pub(crate) fn finish(&mut self) -> bool {
        let _ = self.channel.shutdown(Shutdown::Write);
        self.settle();
        self.end();
        self.answers.fill_buf().is_ok_and(|rest| !rest.is_empty())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.end();
    }
}

/// Short pauses at first, then longer ones; some milliseconds in all.
fn pauses() -> impl Iterator<Item = Duration> {
    let first = Duration::from_micros(50);
    std::iter::successors(Some(first), |pause| (*pause < PAUSE).then(|| *pause * 3 / 2))
}

/// The processor time at which the system itself ends a worker.
pub(crate) fn last_resort(limits: &Limits) -> Duration {
    Duration::from_secs((limits.whole + GRACE).as_secs())
}

/// The signal of whoever ends a process from outside.
pub(crate) const KILLED: i32 = 9;

/// How a launcher and a loader of libraries say that memory is not enough.
const NO_ROOM: [&str; 2] = ["Cannot allocate memory", "failed to map segment"];

fn fault(what: &str, error: &io::Error) -> NotBegun {
    NotBegun::Fault(Fault(format!("{what}: {error}")))
}

/// The command for a worker.
fn command(worker: &Path, address: &str, limits: &Limits, launcher: Option<&Launcher>) -> Command {
    let Some(launcher) = launcher else {
        let mut command = Command::new(worker);
        command.arg(address).arg(limits.memory.to_string());
        return command;
    };
    let limits =
        ResourceLimits { memory: limits.memory, cpu: last_resort(limits), ..ResourceLimits::default() };
    let mut executable = sandbox::loaders();
    executable.push(worker.to_owned());
    let readable = sandbox::libraries();
    let confinement = Confinement { readable, executable, ..Confinement::new(Calls::Computing, limits) };
    let mut command = launcher.command(&confinement, worker);
    // It has its limit of memory already.
    command.arg(address).arg("0");
    command
}
