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
    use std::time::Instant;

    use rustix::event::{PollFd, PollFlags, poll};
    use rustix::io::Errno;

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

    /// Ends this process, whatever it computes, once nobody holds the other end of the channel any more: whoever asked may have been killed, and
    /// then ends no worker.
    ///
    /// # Errors
    /// What duplicating the handle or starting a thread gives.
    pub fn end_with(channel: &Channel) -> io::Result<()> {
        let channel = channel.try_clone()?;
        let watch = move || {
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
        thread::Builder::new().name("watch".to_owned()).stack_size(WATCH).spawn(watch).map(drop)
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
}

pub use here::{Channel, Offer, end_with, is_out_of_time, limit_memory, open, signal};
