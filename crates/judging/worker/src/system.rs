//! What differs between systems? Where questions come from, what a worker may take, how it ended. It is here and nowhere else in the worker and in
//! whoever asks it.
//!
//! Questions and answers do not go over standard output: that belongs to the student's code. On Unix a socket takes the place of the worker's standard
//! input, elsewhere the worker connects to a loopback address.

#[cfg(unix)]
mod here {
    use std::io;
    use std::os::fd::{AsFd, OwnedFd};
    use std::os::unix::net::UnixStream;
    use std::os::unix::process::ExitStatusExt;
    use std::process::{ExitStatus, Stdio};
    use std::thread;
    use std::time::{Duration, Instant};

    use rustix::event::{PollFd, PollFlags, poll};
    use rustix::io::Errno;
    use rustix::process::nice;
    use rustix::time::{ClockId, clock_gettime};

    /// Both directions in one.
    pub type Channel = UnixStream;

    /// The asking end of a channel before the worker has taken the other.
    #[derive(Debug)]
    pub struct Offer {
        ours: UnixStream,
        theirs: UnixStream,
    }

    impl Offer {
        /// A fresh channel.
        ///
        /// # Errors
        /// What the system gives: too many open files, say.
        pub fn new() -> io::Result<Self> {
            let (ours, theirs) = UnixStream::pair()?;
            Ok(Self { ours, theirs })
        }

        /// What the worker gets as its first argument.
        pub fn address(&self) -> io::Result<String> {
            Ok("stdin".to_owned())
        }

        /// What the worker gets as its standard input.
        ///
        /// # Errors
        /// What the system gives.
        pub fn stdin(&self) -> io::Result<Stdio> {
            Ok(OwnedFd::from(self.theirs.try_clone()?).into())
        }

        /// The asking end, once the worker runs.
        ///
        /// # Errors
        /// None here; elsewhere a worker that does not connect before the `deadline`.
        pub fn accept(self, _deadline: Instant) -> io::Result<Channel> {
            Ok(self.ours)
        }
    }

    /// The worker's end.
    ///
    /// # Errors
    /// What duplicating the handle gives.
    pub fn open(_address: &str) -> io::Result<Channel> {
        Ok(UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?))
    }

    /// From now on this process may take so many bytes of memory, where the system can say so.
    ///
    /// # Errors
    /// What the system gives.
    pub fn limit_memory(bytes: u64) -> io::Result<()> {
        if rlimit::Resource::AS.is_supported() {
            rlimit::setrlimit(rlimit::Resource::AS, bytes, bytes)?;
        }
        Ok(())
    }

    /// Lets this process yield to whoever asks it, and to whatever else the machine does. A confined one has yielded already.
    pub fn lower_priority() {
        let _ = nice(super::YIELDS);
    }

    /// The processor time of all threads of this process so far.
    pub fn computed() -> Duration {
        let time = clock_gettime(ClockId::ProcessCPUTime);
        Duration::try_from(time).unwrap_or_default()
    }

    /// The address space that is left, in bytes, if it is limited.
    pub(super) fn address_space_left() -> Option<usize> {
        let limit = rlimit::getrlimit(rlimit::Resource::AS).ok()?.0;
        let limit = usize::try_from(limit).ok().filter(|_| limit != rlimit::INFINITY)?;
        let fits = |bytes: usize| Vec::<u8>::new().try_reserve_exact(bytes).is_ok();
        // Half an interval at a time; both ends are multiples of a page, so that no finer difference is sought.
        let (mut fitting, mut too_much) = (0, limit / super::PAGE + 1);
        while too_much - fitting > 1 {
            let middle = fitting.midpoint(too_much);
            if fits(middle * super::PAGE) { fitting = middle } else { too_much = middle }
        }
        Some(fitting * super::PAGE)
    }

    /// Ends this process, whatever it computes, once nobody holds the other end of the channel any more: whoever asked may have been killed, and
    /// then ends no worker.
    ///
    /// # Errors
    /// What duplicating the handle or starting a thread gives.
    pub fn end_with(channel: &Channel) -> io::Result<()> {
        let channel = channel.try_clone()?;
        let (begins, begun) = std::sync::mpsc::sync_channel(1);
        let watch = move || {
            let _ = begins.send(());
            // Of nothing that is asked for: that the other end is gone is told in any case. Its writing alone may end before.
            let mut watched = [PollFd::new(&channel, PollFlags::empty())];
            loop {
                match poll(&mut watched, None) {
                    Ok(_) if watched[0].revents().contains(PollFlags::HUP) => std::process::exit(0),
                    Ok(_) | Err(Errno::INTR) => {}
                    // Then only whoever asked can end this process.
                    Err(_) => return,
                }
            }
        };
        thread::Builder::new().name("watch".to_owned()).stack_size(WATCH).spawn(watch)?;
        // A thread that begins takes memory. From here on this one takes none, so what is left can be measured.
        begun.recv().map_err(io::Error::other)
    }

    /// The stack of the thread that waits for the end, in bytes: the least that a confined process may have.
    const WATCH: usize = 1 << 20;

    /// Whether this is the signal of a limit of computing time. Its number is the same on every Unix.
    pub fn is_out_of_time(signal: i32) -> bool {
        signal == 24
    }

    /// The signal that ended a process, if one did.
    pub fn signal(status: ExitStatus) -> Option<i32> {
        status.signal()
    }

    /// A second handle on a pipe, which tells whether bytes in it wait for their reader.
    #[derive(Debug)]
    pub struct Backlog(OwnedFd);

    impl Backlog {
        /// Watches the reading end of a pipe.
        ///
        /// # Errors
        /// There are no descriptors left.
        pub fn of(pipe: &impl AsFd) -> io::Result<Self> {
            pipe.as_fd().try_clone_to_owned().map(Self)
        }

        /// True if bytes wait to be read.
        pub fn waits(&self) -> bool {
            rustix::io::ioctl_fionread(&self.0).is_ok_and(|bytes| bytes > 0)
        }
    }
}

#[cfg(not(unix))]
mod here {
    use std::io;
    use std::net::{Ipv4Addr, TcpListener, TcpStream};
    use std::process::{ExitStatus, Stdio};
    use std::thread;
    use std::time::{Duration, Instant};

    /// Both directions in one.
    pub type Channel = TcpStream;

    /// The asking end of a channel before the worker has taken the other.
    #[derive(Debug)]
    pub struct Offer(TcpListener);

    impl Offer {
        /// A fresh channel.
        ///
        /// # Errors
        /// What the system gives.
        pub fn new() -> io::Result<Self> {
            let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
            listener.set_nonblocking(true)?;
            Ok(Self(listener))
        }

        /// What the worker gets as its first argument.
        ///
        /// # Errors
        /// What the system gives.
        pub fn address(&self) -> io::Result<String> {
            Ok(self.0.local_addr()?.to_string())
        }

        /// What the worker gets as its standard input.
        ///
        /// # Errors
        /// None here.
        pub fn stdin(&self) -> io::Result<Stdio> {
            Ok(Stdio::null())
        }

        /// The asking end, once the worker has connected.
        ///
        /// # Errors
        /// `TimedOut` if it has not by the `deadline`.
        pub fn accept(self, deadline: Instant) -> io::Result<Channel> {
            loop {
                match self.0.accept() {
                    Ok((channel, _)) => {
                        channel.set_nonblocking(false)?;
                        channel.set_nodelay(true)?;
                        return Ok(channel);
                    }
                    Err(e) if e.kind() == io::ErrorKind::WouldBlock && Instant::now() < deadline => {
                        thread::sleep(Duration::from_millis(1));
                    }
                    Err(e) if e.kind() == io::ErrorKind::WouldBlock => {
                        return Err(io::ErrorKind::TimedOut.into());
                    }
                    Err(e) => return Err(e),
                }
            }
        }
    }

    /// The worker's end.
    ///
    /// # Errors
    /// What connecting gives.
    pub fn open(address: &str) -> io::Result<Channel> {
        let channel = TcpStream::connect(address)?;
        channel.set_nodelay(true)?;
        Ok(channel)
    }

    /// Here a worker ends when it has answered and reads that nobody asks any more.
    ///
    /// # Errors
    /// None here.
    pub fn end_with(_channel: &Channel) -> io::Result<()> {
        Ok(())
    }

    /// No safe way to do so here.
    pub fn lower_priority() {}

    /// The time since this was first asked: no safe way to anything better here.
    pub fn computed() -> Duration {
        static BEGUN: std::sync::LazyLock<Instant> = std::sync::LazyLock::new(Instant::now);
        BEGUN.elapsed()
    }

    /// Not limited here.
    pub(super) fn address_space_left() -> Option<usize> {
        None
    }

    /// Such a limit is a thing of Unix.
    ///
    /// # Errors
    /// None here.
    pub fn limit_memory(_bytes: u64) -> io::Result<()> {
        Ok(())
    }

    /// Such a signal is a thing of Unix.
    pub fn is_out_of_time(_signal: i32) -> bool {
        false
    }

    /// Signals are a thing of Unix: none.
    pub fn signal(_status: ExitStatus) -> Option<i32> {
        None
    }

    /// A second handle on a pipe; here nothing tells whether bytes wait in it.
    #[derive(Debug)]
    pub struct Backlog;

    impl Backlog {
        /// Watches nothing.
        ///
        /// # Errors
        /// None.
        pub fn of<T>(_pipe: &T) -> io::Result<Self> {
            Ok(Self)
        }

        /// Always false.
        pub fn waits(&self) -> bool {
            false
        }
    }
}

pub use here::{
    Backlog, Channel, Offer, computed, end_with, is_out_of_time, limit_memory, lower_priority, open, signal,
};

/// The environment that a worker needs to behave alike each time.
///
/// - glibc sets 64 MiB of address space aside for each thread that allocates, unless it is told to share one arena.
/// - A thread that says nothing about its stack gets one as long as the main thread's.
pub const ENVIRONMENT: [(&str, &str); 2] = [("MALLOC_ARENA_MAX", "1"), ("RUST_MIN_STACK", "8388608")];

/// How far a worker steps back behind other processes, in the unit of `nice`. A little: on a busy machine it still has to come to an end.
pub const YIELDS: i32 = 3;

/// The stack of a thread, as [`ENVIRONMENT`] sets it, and what the C library adds to it: a page that guards it.
const STACK: usize = (8 << 20) + PAGE;

/// The smallest unit of memory.
const PAGE: usize = 4096;

/// Where address space is limited, this much is left beside whole stacks of threads: what the threads themselves set aside when they begin.
const BESIDE_STACKS: usize = 6 << 20;

/// Takes so much address space that what is left holds whole stacks, and a known rest. So the thread that is one too many gets no stack, and says so,
/// while all others have what they need to begin: otherwise one of them would end the process at a moment that is chance.
pub(crate) fn room_for_whole_stacks() -> Vec<u8> {
    let Some(left) = here::address_space_left() else { return Vec::new() };
    let surplus = (left % STACK + STACK - BESIDE_STACKS) % STACK;
    let mut ballast = Vec::new();
    // Without it a bomb of threads may end in another way; nothing else depends on it.
    let _ = ballast.try_reserve_exact(surplus);
    ballast
}
