//! A place like a platform's, in which a script runs with programs that only pretend.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::PathBuf;
use std::process::{Command, Output};

use class::export::File;
use tempfile::TempDir;

use crate::exports::put;

/// A place like the platform's: the export written out, and programs that only pretend.
pub(crate) struct Place {
    folder: TempDir,
}

impl Place {
    pub(crate) fn new(files: &[File], under: &str) -> Self {
        let folder = TempDir::new().expect("a folder");
        for file in files {
            let path = folder.path().join(under).join(&file.path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("made");
            fs::write(&path, &file.bytes).expect("written");
            let mode = if file.executable { 0o755 } else { 0o644 };
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("permissions");
        }
        let place = Self { folder };
        for program in ["apt-get", "curl", "sudo", "rustup"] {
            place.pretend(program, "cat >/dev/null </dev/null; exit 0");
        }
        place.pretend("cargo", CARGO);
        place
    }

    pub(crate) fn path(&self, path: &str) -> PathBuf {
        self.folder.path().join(path)
    }

    pub(crate) fn pretend(&self, program: &str, script: &str) {
        let path = self.path("bin").join(program);
        put(&path, &format!("#!/bin/sh\n{script}\n"));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("permissions");
    }

    pub(crate) fn run(&self, command: &str, variables: &[(&str, &str)]) -> Output {
        let path = format!("{}:/usr/bin:/bin", self.path("bin").display());
        let mut bash = Command::new("bash");
        bash.args(["-c", command]).current_dir(self.folder.path()).env_clear().env("PATH", path);
        bash.env("HOME", self.path("home")).env("PLACE", self.folder.path());
        bash.envs(variables.iter().copied()).output().expect("bash")
    }

    pub(crate) fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
    }
}

/// Writes down how it was called, with its environment, and what it can write to; then gives what $GIVES says.
const CARGO: &str = r#"
echo "$PWD: $*" >>"$PLACE/calls"
env >"$PLACE/environment"
if (echo forged >&3) 2>/dev/null; then echo open >"$PLACE/descriptor-3"; fi
case "$*" in
  *--help*|fetch*) exit 0 ;;
esac
out=; format=
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=$2 ;;
    --format) format=$2 ;;
  esac
  shift
done
[ "$GIVES" = nothing ] && exit 101
mkdir -p "$out/$format"
printf '%s' "$GIVES" >"$out/$format/submission.$EXTENSION"
[ "$GIVES" = twice ] && printf 'forged' >"$out/$format/other.$EXTENSION"
exit "${EXIT:-0}"
"#;
