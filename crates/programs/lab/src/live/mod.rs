//! How does the lecture come alive in a browser? A server on this machine, and a page that it serves.
//!
//! [`args`] says what can be typed.

mod args;

use std::path::PathBuf;
use std::sync::OnceLock;

use play::{Measured, Server, StudentPictures};

pub(crate) use args::Command;
use args::PlayArgs;

use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::{say, warn};
use crate::student::workbench::Workbench;

/// Names a folder from which the page's files are read: for who changes them.
const PAGE: &str = "LIGHTLAB_PAGE";

/// Serves the page until somebody presses Ctrl-C.
///
/// # Errors
/// [`Failure`] if there is no such figure, or no port is free.
pub(crate) fn run(Command::Play(asked): &Command) -> Result<Outcome, Failure> {
    let place = place(asked)?;
    let page = std::env::var_os(PAGE).map(PathBuf::from);
    let server = Server::start(asked.port, mine(), page).map_err(|error| {
        Failure::new(
            error.to_string(),
            "end what uses the ports, or choose another one: cargo lab play --port 8000",
        )
    })?;
    let server = SERVER.get_or_init(|| server);
    let address = server.address(&place);
    say(&address)?;
    if !asked.no_open {
        say("In your browser now, and for as long as this program runs. Ctrl-C ends it.")?;
        if let Err(error) = open::that_detached(&address) {
            warn(&format!("no browser opens ({}): open the address above", crate::failure::reason(&error)));
        }
    }
    if !asked.measure {
        server.run();
        return Ok(Outcome::Done);
    }
    match server.run_until_measured() {
        Some(measured) => say(&report(&measured)).map(|()| Outcome::Done),
        None => Err(Failure::new(
            "the page measured nothing",
            "open the address in a browser, and keep its tab in sight",
        )),
    }
}

/// What the page shows first.
///
/// # Errors
/// [`Failure`] if nothing is called that.
fn place(asked: &PlayArgs) -> Result<String, Failure> {
    if asked.measure {
        return Ok("measure".to_owned());
    }
    let Some(figure) = &asked.figure else { return Ok(String::new()) };
    let (name, state) =
        figure.split_once('?').map_or((figure.as_str(), None), |(name, state)| (name, Some(state)));
    let views = ["loops", "claims", "steps"];
    let Some(place) = figures::find(name)
        .first()
        .map(|figure| figure.stem())
        .or_else(|| views.contains(&name).then(|| name.to_owned()))
        .or_else(|| {
            claims::find(name).first().map(|claim| format!("{}?claim={}", claim.number, claim.stem()))
        })
    else {
        return Err(Failure::new(
            format!("no figure is called {name:?}"),
            "name one by its number (L31, E4) or its name (exponent-strip): `cargo lab play` alone shows all",
        ));
    };
    Ok(match state {
        Some(state) if state.chars().all(is_plain) => format!("{place}?{state}"),
        Some(state) => {
            return Err(Failure::new(
                format!("{state:?} is no state of a figure"),
                "write it as the page's address does: 'L31?p=64'",
            ));
        }
        None => place,
    })
}

/// What may stand in an address as it is.
fn is_plain(sign: char) -> bool {
    sign.is_ascii_alphanumeric() || "=&.,-_+%".contains(sign)
}

/// Draws with the exercises of this copy of the project. Elsewhere there are none, and every figure but those moves all the same.
fn mine() -> StudentPictures {
    match Workbench::find() {
        Ok(bench) => {
            let exercises = bench.exercises.clone();
            let words = |failure: Failure| format!("{}: {}", failure.problem, failure.remedy);
            let scratch = SCRATCH.get_or_init(|| bench.scratch.join(format!("play-{}", std::process::id())));
            let judge = move || {
                let mut judge = bench.judge(None).map_err(words)?;
                judge.scratch.clone_from(scratch);
                Ok(judge)
            };
            StudentPictures::new(exercises, Box::new(judge))
        }
        Err(failure) => StudentPictures::new(PathBuf::new(), Box::new(move || Err(failure.problem.clone()))),
    }
}

/// The server that runs, for the one who ends it.
static SERVER: OnceLock<Server> = OnceLock::new();

/// Where this server's programs of students' functions lie.
static SCRATCH: OnceLock<PathBuf> = OnceLock::new();

/// Removes what was compiled for the page.
#[cfg_attr(not(unix), allow(dead_code, reason = "only the handler of signals calls it"))]
pub(crate) fn abandon() {
    if let Some(server) = SERVER.get() {
        server.clear();
    }
    if let Some(scratch) = SCRATCH.get() {
        // Of a function that is being asked just now the program is still there.
        let _ = std::fs::remove_dir_all(scratch);
    }
}

/// What was measured, in a line for each number.
fn report(measured: &Measured) -> String {
    let [width, height] = measured.size;
    let Measured { frames_per_second, latency_ms, frames, scene, .. } = measured;
    format!(
        "z-buffer, {scene}, {width}×{height}, {frames} pictures while the camera was dragged:\n\
         frames a second        {frames_per_second:.1}\n\
         drag to picture, ms    median {:.1}, 95 of 100 within {:.1}",
        latency_ms.median, latency_ms.p95
    )
}
