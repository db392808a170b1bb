//! How does a process take rights from itself on Linux? In an order in which every step still may do what it needs.

mod attempts;
mod calls;
mod checks;
mod files;

use std::ffi::{OsStr, OsString};
use std::io;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus};

use rlimit::Resource;
use rustix::process::{Pid, Signal, WaitId, WaitIdOptions};
use rustix::thread::{CapabilitySet, CapabilitySets};

pub(crate) use attempts::attempt;
pub(crate) use checks::checks;

use crate::confinement::{Calls, Confinement, ResourceLimits};

/// The running program, whatever has become of its file.
pub(crate) const THIS_PROGRAM: Option<&str> = Some("/proc/self/exe");

/// Makes the command's process the first of a group.
pub(crate) fn in_a_group_of_its_own(command: &mut Command) {
    command.process_group(0);
}

/// Takes from this process all that the confinement does not grant. It cannot be taken back.
pub(crate) fn confine(confinement: &Confinement, starter: u32) -> Result<(), String> {
    end_with(starter)?;
    // What was inherited stays behind when this process becomes the program: all but standard input, output and error.
    close_fds::CloseFdsBuilder::new().cloexecfrom(3);
    limit(&confinement.limits).map_err(|e| format!("a limit cannot be set: {e}"))?;
    // Who starts it and watches it goes first, and so does whatever else the machine does.
    let _ = rustix::process::nice(YIELDS);
    drop_capabilities().map_err(|e| format!("capabilities cannot be dropped: {e}"))?;
    files::confine(confinement)?;
    // Last: the filter forbids what the other steps need.
    calls::confine(confinement.calls)
}

/// How far a confined program steps back behind other processes, in the unit of `nice`. A little: on a busy machine it still has to come to an end.
const YIELDS: i32 = 3;

/// Becomes the program; gives back only why it did not.
pub(crate) fn become_program(
    program: &OsStr,
    calls: Calls,
    arguments: impl Iterator<Item = OsString>,
) -> String {
    let mut command = Command::new(program);
    // A program that only computes need not know where it lies. A compiler finds its libraries by it.
    if calls == Calls::Computing
        && let Some(name) = Path::new(program).file_name()
    {
        command.arg0(name);
    }
    let error = command.args(arguments).exec();
    format!("{}: {error}", program.display())
}

/// Lets this process end when the one that started it does.
fn end_with(starter: u32) -> Result<(), String> {
    rustix::process::set_parent_process_death_signal(Some(Signal::KILL))
        .map_err(|e| format!("it would outlive the one that starts it: {e}"))?;
    // It may have ended before that line.
    let parent = rustix::process::getppid().map(|pid| pid.as_raw_nonzero().get());
    if parent.and_then(|pid| u32::try_from(pid).ok()) == Some(starter) {
        Ok(())
    } else {
        Err("whoever started it has ended".to_owned())
    }
}

/// Sets the limits, both those that warn and those that cannot be raised again.
fn limit(limits: &ResourceLimits) -> io::Result<()> {
    let cpu = limits.cpu.as_secs();
    let limits = [
        (Resource::CORE, 0, 0),
        (Resource::AS, limits.memory, limits.memory),
        // The first ends the process with a signal that says why; were both the same, it would be that of any killed process.
        (Resource::CPU, cpu, cpu + 1),
        (Resource::FSIZE, limits.file, limits.file),
        (Resource::NOFILE, limits.open, limits.open),
        (Resource::NPROC, limits.processes, limits.processes),
    ];
    for (resource, soft, hard) in limits {
        // Somebody may have set a lower one already.
        let (_, ceiling) = resource.get()?;
        resource.set(soft.min(ceiling), hard.min(ceiling))?;
    }
    Ok(())
}

/// Of what root may do, leaves what files' owners and modes say, which the rules for files restrict in their own way: root may run this in
/// another's folder.
fn drop_capabilities() -> rustix::io::Result<()> {
    let files = CapabilitySet::DAC_OVERRIDE | CapabilitySet::DAC_READ_SEARCH;
    let had = rustix::thread::capabilities(None)?;
    let kept = CapabilitySets {
        effective: had.effective & files,
        permitted: had.permitted & files,
        inheritable: CapabilitySet::empty(),
    };
    rustix::thread::set_capabilities(None, kept)
}

/// Ends a program and all that it started, at once. For one that was started by [`crate::Launcher::command`]; of any other it ends the program alone.
///
/// # Errors
/// What the system gives.
pub fn end(child: &mut Child) -> io::Result<ExitStatus> {
    end_group(child, WaitIdOptions::NOHANG);
    let _ = child.kill();
    child.wait()
}

/// Waits until a program ends by itself, and then ends all that it started.
///
/// # Errors
/// What the system gives.
pub fn finish(child: &mut Child) -> io::Result<ExitStatus> {
    end_group(child, WaitIdOptions::empty());
    child.wait()
}

/// Ends the group of a program, which may still run or has not been waited for: until then nobody else can have its number.
fn end_group(child: &Child, patience: WaitIdOptions) {
    let Some(pid) = i32::try_from(child.id()).ok().and_then(Pid::from_raw) else { return };
    let options = WaitIdOptions::EXITED | WaitIdOptions::NOWAIT | patience;
    // Waiting may be interrupted by a signal.
    while let Err(error) = rustix::process::waitid(WaitId::Pid(pid), options) {
        if error != rustix::io::Errno::INTR {
            return;
        }
    }
    // There is no such group if the program is in that of this process.
    let _ = rustix::process::kill_process_group(pid, Signal::KILL);
}
