//! Who may ask, and who answers? A server on the loopback address, for one person's browser.
//!
//! [`guard`] turns away what does not come from that browser, [`route`] finds who answers, [`files`] holds the page.

pub(crate) mod answer;
mod files;
mod guard;
mod route;

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener as StdListener};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpListener;
use tokio::runtime::{Builder, Runtime};
use tokio::sync::{Semaphore, mpsc};

use crate::api::Measured;
use crate::{Stage, StudentPictures};
use guard::{Guard, Key};

/// The port that is tried first: on a telephone's keys it spells "play", with a 4 before it.
pub const FIRST_PORT: u16 = 47529;
/// So many ports are tried after it.
const MORE_PORTS: u16 = 100;

/// A request's head may not take longer to arrive; an idle connection is closed after it.
const PATIENCE: Duration = Duration::from_secs(15);
/// After so long a connection is closed, whatever it does: a page opens another.
const LONGEST_CONNECTION: Duration = Duration::from_secs(600);
/// A request's head may not be longer, in bytes.
const LONGEST_HEAD: usize = 32 << 10;
/// So many connections at once: more than any browser opens for twenty tabs.
const MOST_CONNECTIONS: usize = 256;
/// So many requests are computed at once; the others wait. Renderers use all processors each.
const AT_WORK: usize = 3;
/// So many draw with the student's functions at once: these wait for other processes, and one without end must not keep the others.
const ASKING: usize = 4;
/// So many requests may wait; the next are refused.
const MOST_WAITING: usize = 128;

/// Why the server cannot start.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// No port is free.
    #[error("no port from {first} to {last} is free on {host}: {source}", host = Ipv4Addr::LOCALHOST)]
    NoPort {
        /// The first that was tried.
        first: u16,
        /// The last that was tried.
        last: u16,
        /// What the system said of the last one.
        source: io::Error,
    },
    /// The system gives no threads, or no random numbers.
    #[error("the system refuses what a server needs: {0}")]
    System(String),
}

/// A server that listens.
#[derive(Debug)]
pub struct Server {
    runtime: Runtime,
    listener: TcpListener,
    shared: Arc<Shared>,
    measured: Mutex<mpsc::Receiver<Measured>>,
}

/// What all requests share.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) guard: Guard,
    pub(crate) stage: Stage,
    pub(crate) mine: StudentPictures,
    /// Where the page's files are read from, for who changes them; else they are those of the program.
    pub(crate) folder: Option<std::path::PathBuf>,
    pub(crate) measured: mpsc::Sender<Measured>,
    work: Semaphore,
    asking: Semaphore,
    waiting: Semaphore,
}

impl Server {
    /// Listens on the loopback address.
    ///
    /// - `port`: where to begin looking for a free port; 0 leaves the choice to the system.
    /// - `mine`: draws with the student's functions.
    /// - `folder`: where the page's files are read from instead of the program itself.
    ///
    /// # Errors
    /// [`StartError`] if no port is free.
    pub fn start(
        port: u16,
        mine: StudentPictures,
        folder: Option<std::path::PathBuf>,
    ) -> Result<Self, StartError> {
        let system = |error: &dyn std::fmt::Display| StartError::System(error.to_string());
        let listener = listen(port)?;
        let address = listener.local_addr().map_err(|error| system(&error))?;
        let key = Key::new().map_err(|error| system(&error))?;
        let runtime = Builder::new_multi_thread()
            .worker_threads(2)
            .thread_name("serve")
            .enable_io()
            .enable_time()
            .build()
            .map_err(|error| system(&error))?;
        let listener = {
            let _inside = runtime.enter();
            TcpListener::from_std(listener).map_err(|error| system(&error))?
        };
        let (sender, receiver) = mpsc::channel(1);
        let shared = Arc::new(Shared {
            guard: Guard { port: address.port(), key },
            stage: Stage::default(),
            mine,
            folder,
            measured: sender,
            work: Semaphore::new(AT_WORK),
            asking: Semaphore::new(ASKING),
            waiting: Semaphore::new(MOST_WAITING),
        });
        Ok(Self { runtime, listener, shared, measured: Mutex::new(receiver) })
    }

    /// The port it listens on.
    #[must_use]
    pub fn port(&self) -> u16 {
        self.shared.guard.port
    }

    /// What to open in the browser: with the key that lets it run the student's code.
    ///
    /// - `place`: what the page shows first: `L31`, `loops`, `L31?p=64`; empty for the overview.
    #[must_use]
    pub fn address(&self, place: &str) -> String {
        let hash = if place.is_empty() { "" } else { "#" };
        format!("http://{}:{}/?key={}{hash}{place}", Ipv4Addr::LOCALHOST, self.port(), self.shared.guard.key)
    }

    /// Removes what was compiled for students' functions: for the end of a program that does not live to drop this value.
    pub fn clear(&self) {
        self.shared.mine.clear();
    }

    /// Answers for as long as the program lives.
    pub fn run(&self) {
        self.runtime.block_on(self.answer_all());
    }

    /// Answers until the page has measured itself.
    #[must_use]
    pub fn run_until_measured(&self) -> Option<Measured> {
        let mut measured = self.measured.lock().unwrap_or_else(PoisonError::into_inner);
        self.runtime.block_on(async {
            tokio::select! {
                () = self.answer_all() => None,
                result = measured.recv() => {
                    // So that the browser gets its answer before the program ends.
                    tokio::time::sleep(Duration::from_millis(200)).await;
                    result
                }
            }
        })
    }

    async fn answer_all(&self) {
        let connections = Arc::new(Semaphore::new(MOST_CONNECTIONS));
        loop {
            let Ok(room) = connections.clone().acquire_owned().await else { return };
            let stream = match self.listener.accept().await {
                Ok((stream, _)) => stream,
                // Too many open files, say: those that are open will end.
                Err(_) => {
                    tokio::time::sleep(Duration::from_millis(50)).await;
                    continue;
                }
            };
            // A picture is sent in one piece; waiting for more would only delay its end.
            let _ = stream.set_nodelay(true);
            let shared = self.shared.clone();
            tokio::spawn(async move {
                let service = service_fn(move |request| {
                    let shared = shared.clone();
                    async move { Ok::<_, std::convert::Infallible>(route::answer(shared, request).await) }
                });
                let connection = http1::Builder::new()
                    .timer(TokioTimer::new())
                    .header_read_timeout(PATIENCE)
                    .max_buf_size(LONGEST_HEAD)
                    .serve_connection(TokioIo::new(stream), service);
                // A torn request or a closed tab ends its own connection, and nothing else; one that takes no answers ends some time.
                let _ = tokio::time::timeout(LONGEST_CONNECTION, connection).await;
                drop(room);
            });
        }
    }
}

impl Shared {
    /// Computes something on a thread of its own, when it is this one's turn.
    ///
    /// # Errors
    /// [`Busy`] if too many wait, or it panicked.
    pub(crate) async fn compute<T: Send + 'static>(
        self: &Arc<Self>,
        work: impl FnOnce(&Self) -> T + Send + 'static,
    ) -> Result<T, Busy> {
        self.in_turn(&self.work, work).await
    }

    /// The same for what waits for a student's function.
    ///
    /// # Errors
    /// [`Busy`] if too many wait, or it panicked.
    pub(crate) async fn ask<T: Send + 'static>(
        self: &Arc<Self>,
        work: impl FnOnce(&Self) -> T + Send + 'static,
    ) -> Result<T, Busy> {
        self.in_turn(&self.asking, work).await
    }

    async fn in_turn<T: Send + 'static>(
        self: &Arc<Self>,
        turns: &Semaphore,
        work: impl FnOnce(&Self) -> T + Send + 'static,
    ) -> Result<T, Busy> {
        let _waiting = self.waiting.try_acquire().map_err(|_| Busy::Full)?;
        // Whoever leaves while waiting takes the request along: it is never computed.
        let _turn = turns.acquire().await.map_err(|_| Busy::Full)?;
        let shared = self.clone();
        tokio::task::spawn_blocking(move || work(&shared)).await.map_err(|_| Busy::Panicked)
    }
}

/// Why nothing was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Busy {
    /// Too many requests wait.
    Full,
    /// A fault of ours.
    Panicked,
}

/// The first free port from this one on.
fn listen(first: u16) -> Result<StdListener, StartError> {
    let last = if first == 0 { 0 } else { first.saturating_add(MORE_PORTS) };
    let mut refused = io::Error::from(io::ErrorKind::AddrInUse);
    for port in first..=last {
        match StdListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port))) {
            Ok(listener) => match listener.set_nonblocking(true) {
                Ok(()) => return Ok(listener),
                Err(error) => refused = error,
            },
            Err(error) => refused = error,
        }
    }
    Err(StartError::NoPort { first, last, source: refused })
}
