//! How is a program started so that nothing of it runs before it is confined?
//!
//! By a program that confines itself and then becomes the other: what it took from itself it cannot get back, nor can what it became.

use std::env;
use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::confinement::Confinement;
use crate::{checkup, here};

/// The exit code of a launcher that could not confine itself, or could not start the program. Standard error says why.
pub const NOT_LAUNCHED: u8 = 120;

/// The first argument of a launcher.
const MARK: &str = "--launch-confined";

/// Starts programs confined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Launcher {
    program: PathBuf,
}

impl Launcher {
    /// The running program itself, whose main function must begin with [`launched`]. It stays the same one when its file is replaced
    /// meanwhile. `None` on a system that confines nothing.
    pub fn this_program() -> Option<Self> {
        here::THIS_PROGRAM.map(|path| Self { program: path.into() })
    }

    /// Another program, whose main function begins with [`launched`]. `None` on a system that confines nothing.
    pub fn at(program: &Path) -> Option<Self> {
        here::THIS_PROGRAM.map(|_| Self { program: program.to_owned() })
    }

    /// Returns the program that it starts first.
    #[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
    pub(crate) fn program(&self) -> &Path {
        &self.program
    }

    /// A command that starts `program` confined, in a process group of its own. The caller adds arguments, environment and streams; an inherited
    /// descriptor other than these streams is closed.
    ///
    /// The program ends when the thread that started it does.
    pub fn command(&self, confinement: &Confinement, program: &Path) -> Command {
        let mut command = Command::new(&self.program);
        command.arg(MARK).arg(std::process::id().to_string()).args(confinement.arguments()).arg(program);
        here::in_a_group_of_its_own(&mut command);
        command
    }
}

/// The first thing in the main function of a program that launches: if it was started to launch another, it becomes that other one and this function
/// does not return, or gives the exit code with which main must end at once. `None` if it was started as itself.
///
/// It must run before any thread is started.
pub fn launched() -> Option<ExitCode> {
    let mut arguments = env::args_os().skip(1);
    let first = arguments.next()?;
    if first == OsStr::new(checkup::MARK) {
        return Some(checkup::attempt(arguments));
    }
    if first != OsStr::new(MARK) {
        return None;
    }
    let problem = match launch(arguments) {
        Ok(never) => match never {},
        Err(problem) => problem,
    };
    let _ = writeln!(std::io::stderr(), "not launched: {problem}");
    Some(ExitCode::from(NOT_LAUNCHED))
}

/// Confines this process and becomes the program that the arguments name.
fn launch(mut arguments: impl Iterator<Item = OsString>) -> Result<std::convert::Infallible, String> {
    let starter = arguments.next().and_then(|pid| pid.to_str()?.parse::<u32>().ok());
    let confinement = Confinement::from_arguments(&mut arguments);
    let (Some(starter), Some(confinement), Some(program)) = (starter, confinement, arguments.next()) else {
        return Err("the command line is not a launcher's".to_owned());
    };
    here::confine(&confinement, starter)?;
    Err(here::become_program(&program, confinement.calls, arguments))
}
