//! What may a program do?

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What a program may do. What is not said here it may not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Confinement {
    /// Which system calls it may make.
    pub calls: Calls,
    /// Files that it may read, and folders whose files it may read.
    pub readable: Vec<PathBuf>,
    /// Folders whose content it may list, without reading the files.
    pub listable: Vec<PathBuf>,
    /// Files that it may read and run, and folders of such.
    pub executable: Vec<PathBuf>,
    /// Files that it may write, and folders in which it may do anything but make devices.
    pub writable: Vec<PathBuf>,
    /// How much it may take.
    pub limits: ResourceLimits,
}

/// Which system calls a program may make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Calls {
    /// Those of a program that computes, reads, writes to what is already open, and starts threads. No process, no socket, no
    /// signal but to itself.
    Computing,
    /// All but those of the network, of other processes' memory and signals, of namespaces, mounts and the kernel itself. It may start
    /// programs, which may do no more.
    Building,
    /// All. Only the other limits hold.
    Any,
}

/// Resource limits of a program. Each process that it starts has the same limits for itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResourceLimits {
    /// Address space, in bytes.
    pub memory: u64,
    /// Computing time of all its threads, in whole seconds; a begun one counts.
    pub cpu: Duration,
    /// The longest file that it may write, in bytes.
    pub file: u64,
    /// How many files it may have open.
    pub open: u64,
    /// How many processes and threads its user may have; where that user is root, nothing counts them.
    pub processes: u64,
}

impl Default for ResourceLimits {
    /// A GiB, ten seconds, no file, sixty-four descriptors, four thousand processes: for a program that computes.
    fn default() -> Self {
        Self { memory: 1 << 30, cpu: Duration::from_secs(10), file: 0, open: 64, processes: 4096 }
    }
}

impl Confinement {
    /// One that grants no file at all, and no more than `limits`.
    pub fn new(calls: Calls, limits: ResourceLimits) -> Self {
        Self {
            calls,
            limits,
            readable: Vec::new(),
            listable: Vec::new(),
            executable: Vec::new(),
            writable: Vec::new(),
        }
    }

    /// As arguments of a command line, which [`Self::from_arguments`] reads back.
    pub(crate) fn arguments(&self) -> Vec<OsString> {
        let ResourceLimits { memory, cpu, file, open, processes } = self.limits;
        let cpu = cpu.as_secs() + u64::from(cpu.subsec_nanos() > 0);
        let mut arguments: Vec<OsString> = vec![self.calls.word().into()];
        arguments.extend([memory, cpu, file, open, processes].map(|number| number.to_string().into()));
        let lists = [&self.readable, &self.listable, &self.executable, &self.writable];
        for (mark, paths) in MARKS.iter().zip(lists) {
            for path in paths {
                arguments.extend([OsString::from(mark), path.clone().into_os_string()]);
            }
        }
        arguments.push(END.into());
        arguments
    }

    /// Takes a confinement from the beginning of a command line; `None` if there is none.
    pub(crate) fn from_arguments(arguments: &mut impl Iterator<Item = OsString>) -> Option<Self> {
        let calls = Calls::of_word(&arguments.next()?)?;
        let mut number = || arguments.next()?.to_str()?.parse::<u64>().ok();
        let (memory, cpu) = (number()?, Duration::from_secs(number()?));
        let limits = ResourceLimits { memory, cpu, file: number()?, open: number()?, processes: number()? };
        let mut confinement = Self::new(calls, limits);
        loop {
            let mark = arguments.next()?;
            let list = match MARKS.iter().position(|known| mark == OsStr::new(known)) {
                Some(0) => &mut confinement.readable,
                Some(1) => &mut confinement.listable,
                Some(2) => &mut confinement.executable,
                Some(_) => &mut confinement.writable,
                None => return (mark == OsStr::new(END)).then_some(confinement),
            };
            list.push(arguments.next()?.into());
        }
    }
}

/// What stands before a path that is readable, listable, executable, writable.
const MARKS: [&str; 4] = ["read", "list", "run", "write"];

/// What stands after the last path.
const END: &str = "--";

impl Calls {
    const ALL: [Self; 3] = [Self::Computing, Self::Building, Self::Any];

    fn word(self) -> &'static str {
        match self {
            Self::Computing => "computing",
            Self::Building => "building",
            Self::Any => "any",
        }
    }

    fn of_word(word: &OsStr) -> Option<Self> {
        Self::ALL.into_iter().find(|calls| word == OsStr::new(calls.word()))
    }
}

/// Where a system keeps its shared libraries, and what finds them. Readable for whoever loads one.
pub fn libraries() -> Vec<PathBuf> {
    existing(&[
        "/lib",
        "/lib32",
        "/lib64",
        "/usr/lib",
        "/usr/lib32",
        "/usr/lib64",
        "/etc/ld.so.cache",
        "/nix/store",
    ])
}

/// What loads a program together with its libraries: executable for whoever starts one.
pub fn loaders() -> Vec<PathBuf> {
    existing(&[
        "/lib64/ld-linux-x86-64.so.2",
        "/lib/ld-linux-aarch64.so.1",
        "/lib/ld-musl-x86_64.so.1",
        "/lib/ld-musl-aarch64.so.1",
        "/nix/store",
    ])
}

/// Where a system keeps its programs and what these need: executable for a compiler that starts a linker. Without `/usr/src`, where some keep
/// their own work.
pub fn programs() -> Vec<PathBuf> {
    let mut folders = existing(&[
        "/bin",
        "/usr/bin",
        "/usr/libexec",
        "/usr/local/bin",
        "/usr/local/lib",
        "/etc/ld.so.conf",
    ]);
    folders.extend(existing(&["/etc/ld.so.conf.d"]));
    folders.extend(libraries());
    folders
}

fn existing(paths: &[&str]) -> Vec<PathBuf> {
    paths.iter().map(PathBuf::from).filter(|path| Path::exists(path)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_confinement_survives_the_command_line() {
        let limits =
            ResourceLimits { memory: 7, cpu: Duration::from_secs(3), file: 5, open: 11, processes: 13 };
        let confinement = Confinement {
            readable: vec!["/a b".into(), "--".into()],
            listable: vec!["list".into()],
            executable: vec!["/x".into()],
            writable: vec!["run".into(), "/dev/null".into()],
            ..Confinement::new(Calls::Building, limits)
        };
        let mut line = confinement.arguments().into_iter().chain(["program".into()]);
        assert_eq!(Confinement::from_arguments(&mut line), Some(confinement));
        assert_eq!(line.next(), Some("program".into()), "what follows is left");
    }

    #[test]
    fn a_begun_second_counts() {
        let limits = ResourceLimits { cpu: Duration::from_millis(1500), ..ResourceLimits::default() };
        let arguments = Confinement::new(Calls::Any, limits).arguments();
        let read = Confinement::from_arguments(&mut arguments.into_iter()).expect("a confinement");
        assert_eq!(read.limits.cpu, Duration::from_secs(2));
    }

    #[test]
    fn half_a_confinement_is_none() {
        let whole = Confinement {
            readable: vec!["/a".into()],
            ..Confinement::new(Calls::Any, ResourceLimits::default())
        };
        let arguments = whole.arguments();
        for end in 0..arguments.len() {
            assert_eq!(Confinement::from_arguments(&mut arguments[..end].iter().cloned()), None, "{end}");
        }
    }
}
