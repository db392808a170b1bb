//! Where do the exercises lie, and with what are they judged?

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use course::Exercise;
use grader::{Build, Compiler, Judge, Judgement, Libraries, Limits, bytes_of};

use super::ink;
use super::memory::Memory;
use super::which::Meant;
use crate::checkout;
use crate::failure::Failure;
use crate::unfinished::Unfinished;

/// The seed of every check unless another one is asked for: the same inputs each time, so that a change of the verdict is a change
/// of the file.
pub(crate) const SEED: u64 = 1;

/// Names another folder of exercises than that of the project: a group's on a shared drive, say.
const ELSEWHERE: &str = "LIGHTLAB_EXERCISES";

/// A copy of the project, with its exercises.
#[derive(Clone, Debug)]
pub(crate) struct Workbench {
    /// The project's folder.
    pub(crate) root: PathBuf,
    /// The folder of the exercises.
    pub(crate) exercises: PathBuf,
    /// Where verdicts are remembered and pictures drawn: beside the exercises, so that cleaning what was built loses nothing.
    pub(crate) home: PathBuf,
    /// Where things are compiled; all of it can be made again.
    pub(crate) scratch: PathBuf,
}

impl Workbench {
    /// The project that the current folder is in.
    ///
    /// # Errors
    /// [`Failure`] if it is in none.
    pub(crate) fn find() -> Result<Self, Failure> {
        let here = std::env::current_dir().map_err(|e| {
            Failure::io("find", Path::new("the current folder"), &e, "change to the project's folder")
        })?;
        let Some(root) = checkout::around(&here) else {
            return Err(Failure::new(
                format!("no exercises in {} or above it", here.display()),
                "change to the project's folder: the one with `exercises` and `crates` in it",
            ));
        };
        let exercises =
            std::env::var_os(ELSEWHERE).map_or_else(|| root.join("exercises"), |folder| here.join(folder));
        if !exercises.is_dir() {
            return Err(Failure::new(
                format!("{ELSEWHERE} names {}, which is no folder", exercises.display()),
                "name the folder with the concepts' folders in it, or unset the variable",
            ));
        }
        let target =
            std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |it| here.join(it));
        Ok(Self {
            root: root.to_owned(),
            home: exercises.join(".lightlab"),
            exercises,
            scratch: target.join("lightlab"),
        })
    }

    /// Where the student's file of an exercise lies.
    pub(crate) fn file(&self, exercise: &Exercise) -> PathBuf {
        self.exercises.join(exercise.path())
    }

    /// A path as the user would type it, from the current folder.
    pub(crate) fn shown(&self, path: &Path) -> String {
        let here = std::env::current_dir().unwrap_or_default();
        path.strip_prefix(&here)
            .or_else(|_| path.strip_prefix(&self.root))
            .unwrap_or(path)
            .display()
            .to_string()
    }

    /// One who judges; the libraries for it are built the first time.
    ///
    /// # Errors
    /// [`Failure`] if they cannot be built.
    pub(crate) fn judge(&self, limit: Option<Duration>) -> Result<Judge, Failure> {
        fs::create_dir_all(&self.scratch).map_err(|e| {
            Failure::io("make the folder", &self.scratch, &e, "free some space, or make it writable")
        })?;
        // A debug build is one for tests.
        let build = if cfg!(debug_assertions) {
            Build::of_the_workspace()
        } else {
            Build { features: features(), ..Build::of(env!("CARGO_PKG_NAME")) }
        };
        let memory = self.scratch.join(format!("libraries-{}.json", build.profile));
        let libraries = Libraries::remembered(&self.root, build, &memory).map_err(|e| {
            Failure::new(e.to_string(), "see that `cargo build --release --package lab` succeeds")
        })?;
        let mut limits = Limits::default();
        limits.time = limit.unwrap_or(limits.time);
        limits.whole = limits.whole.max(3 * limits.time);
        let compiler = Compiler { libraries, root: self.root.clone(), color: ink::on() };
        Ok(Judge {
            compiler,
            limits,
            scratch: self.scratch.clone(),
            memory: Some((memory, build)),
            sandbox: None,
        })
    }

    /// Judges files; of one in which nothing has been done, says so at once.
    pub(crate) fn judge_files(&self, judge: &Judge, meant: &[Meant], seed: u64) -> Vec<Judgement> {
        let touched: Vec<&Meant> =
            meant.iter().filter(|meant| !is_untouched(meant.exercise, &meant.file)).collect();
        let files: Vec<(&Exercise, &Path)> =
            touched.iter().map(|meant| (meant.exercise, meant.file.as_path())).collect();
        let mut judgements = judge.judge_all(&files, seed).into_iter();
        meant
            .iter()
            .map(|meant| {
                let touched = touched.iter().any(|other| std::ptr::eq(*other, meant));
                let judged = if touched { judgements.next() } else { None };
                judged.unwrap_or_else(|| Judgement::not_started(meant.exercise, seed))
            })
            .collect()
    }

    /// Judges one file.
    pub(crate) fn judge_file(&self, judge: &Judge, exercise: &Exercise, file: &Path) -> Judgement {
        if is_untouched(exercise, file) {
            return Judgement::not_started(exercise, SEED);
        }
        judge.judge(exercise, file, SEED)
    }

    /// What is remembered of the exercises.
    pub(crate) fn memory(&self) -> Memory {
        Memory::read(&self.home.join("board.json"))
    }

    /// Draws a judgement's picture into a file and gives its path.
    pub(crate) fn draw(&self, judgement: &Judgement) -> Option<PathBuf> {
        let picture = judgement.picture.as_ref()?;
        let path = self.home.join("pictures").join(format!("{}.svg", judgement.exercise));
        fs::create_dir_all(path.parent()?).ok()?;
        let unfinished = Unfinished::beside(&path).ok()?;
        unfinished.finish(picture.svg.as_bytes(), None, &path).ok()?;
        Some(path)
    }
}

/// The features of this program, as cargo is asked for them.
fn features() -> &'static [&'static str] {
    match (cfg!(feature = "pictures"), cfg!(feature = "class"), cfg!(feature = "live")) {
        (true, true, true) => &[],
        (false, false, false) => &["--no-default-features"],
        (true, false, false) => &["--no-default-features", "--features", "pictures"],
        (false, true, false) => &["--no-default-features", "--features", "class"],
        (false, false, true) => &["--no-default-features", "--features", "live"],
        (true, true, false) => &["--no-default-features", "--features", "pictures,class"],
        (true, false, true) => &["--no-default-features", "--features", "pictures,live"],
        (false, true, true) => &["--no-default-features", "--features", "class,live"],
    }
}

/// Whether the file is as it was handed out, but for the ends of lines.
pub(crate) fn is_untouched(exercise: &Exercise, file: &Path) -> bool {
    bytes_of(file).is_some_and(|bytes| exercise.is_untouched(&bytes))
}
