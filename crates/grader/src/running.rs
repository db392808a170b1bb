//! How does a worker begin and end?

use std::io::{self, BufRead, BufReader, Read};
use std::net::Shutdown;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use course::{Fault, Loss};
use sandbox::{Calls, Confinement, Launcher, Takings};
use worker::system::{self, Channel, Offer};
use worker::wire::{self, Ready};

use crate::printed::Stream;
use crate::process::Limits;

/// A worker that has not begun by then is not slow because of the student's code: none of it runs until then.
const TO_BEGIN: Duration = Duration::from_secs(20);

/// After its end a worker's last words are waited for so long: a process that it left behind may hold its output open.
const LAST_WORDS: Duration = Duration::from_millis(200);

/// A worker that runs.
#[derive(Debug)]
pub(crate) struct Running {
    child: Child,
    pub(crate) channel: Channel,
    pub(crate) answers: BufReader<Timed>,
    outputs: Vec<JoinHandle<()>>,
}

/// The answers' end of a channel, until a moment: a worker that sends byte by byte is as late as one that sends none.
#[derive(Debug)]
pub(crate) struct Timed {
    channel: Channel,
    pub(crate) until: Instant,
}

impl Read for Timed {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = self.until.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(io::ErrorKind::TimedOut.into());
        }
        self.channel.set_read_timeout(Some(left))?;
        self.channel.read(buffer)
    }
}

/// Why a worker does not run.
#[derive(Debug)]
pub(crate) enum NotBegun {
    /// It is ours, or the system's.
    Fault(Fault),
    /// What the student's file lets the program take before its first line is more than it may have.
    Lost(Loss),
}

impl Running {
    /// Starts a worker, confined if there is a launcher, and waits until it is ready.
    pub(crate) fn start(
        worker: &Path,
        limits: &Limits,
        launcher: Option<&Launcher>,
        printed: &[Stream; 2],
    ) -> Result<Self, NotBegun> {
        let mut running = Self::spawn(worker, limits, launcher, printed)?;
        let words = wire::receive::<Ready>(&mut running.answers);
        if let Ok(Some(Ready)) = words {
            let limit = running.channel.set_write_timeout(Some(limits.time));
            return limit.map(|()| running).map_err(|e| fault("no time limit can be set", &e));
        }
        running.wait(LAST_WORDS);
        let status = running.end();
        let last = printed[1].last_words();
        // A program whose own data do not fit ends while the system, or the loader of its libraries, puts it into memory.
        let ended =
            status.is_some_and(|status| system::signal(status).is_some_and(|signal| signal != KILLED));
        if ended || NO_ROOM.iter().any(|words| last.contains(words)) {
            return Err(NotBegun::Lost(Loss::OutOfMemory));
        }
        Err(NotBegun::Fault(Fault(format!("the worker did not begin ({words:?}, {status:?}): {last}"))))
    }

    fn spawn(
        worker: &Path,
        limits: &Limits,
        launcher: Option<&Launcher>,
        printed: &[Stream; 2],
    ) -> Result<Self, NotBegun> {
        let channel = |e: io::Error| fault("no channel to the worker", &e);
        let offer = Offer::new().map_err(channel)?;
        let address = offer.address().map_err(channel)?;
        let mut child = command(worker, &address, limits, launcher)
            .env_clear()
            .stdin(offer.stdin().map_err(channel)?)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|e| fault("the worker does not start", &e))?;
        let outputs = [
            child.stdout.take().map(|pipe| printed[0].follow(pipe)),
            child.stderr.take().map(|pipe| printed[1].follow(pipe)),
        ];
        let begun = offer.accept(Instant::now() + TO_BEGIN).and_then(|channel| {
            let until = Instant::now() + TO_BEGIN;
            let answers = BufReader::new(Timed { channel: channel.try_clone()?, until });
            Ok((channel, answers))
        });
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

    /// Waits for its end, but no longer than this.
    pub(crate) fn wait(&mut self, patience: Duration) {
        let until = Instant::now() + patience;
        while Instant::now() < until && matches!(self.child.try_wait(), Ok(None)) {
            thread::sleep(Duration::from_micros(200));
        }
    }

    /// Ends what still runs and waits for its last words.
    pub(crate) fn end(&mut self) -> Option<ExitStatus> {
        let status = sandbox::end(&mut self.child).ok();
        let patience = Instant::now() + LAST_WORDS;
        for output in self.outputs.drain(..) {
            while !output.is_finished() && Instant::now() < patience {
                thread::sleep(Duration::from_micros(100));
            }
        }
        status
    }

    /// Lets it end by itself, since nobody asks any more: an honest worker does, and writes out what it still holds. Whether it sent more than was
    /// read.
    pub(crate) fn finish(&mut self) -> bool {
        let _ = self.channel.shutdown(Shutdown::Write);
        self.wait(LAST_WORDS);
        self.end();
        self.answers.get_mut().until = Instant::now() + LAST_WORDS;
        self.answers.fill_buf().is_ok_and(|rest| !rest.is_empty())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.end();
    }
}

/// The signal of whoever ends a process from outside.
const KILLED: i32 = 9;

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
    let takings = Takings { memory: limits.memory, cpu: limits.whole, ..Takings::default() };
    let mut executable = sandbox::loaders();
    executable.push(worker.to_owned());
    let readable = sandbox::libraries();
    let confinement = Confinement { readable, executable, ..Confinement::new(Calls::Computing, takings) };
    let mut command = launcher.command(&confinement, worker);
    // It has its limit of memory already.
    command.arg(address).arg("0");
    command
}
