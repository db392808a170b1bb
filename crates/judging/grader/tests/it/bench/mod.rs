//! A judge, and a folder for one submission.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::Duration;

use course::{Exercise, Late};
use grader::{Build, CompiledFunction, Judge, Judgement, Libraries, Outcome};
use sandbox::Launcher;

/// The line of the submission on which the function's body begins.
pub(crate) const FIRST_LINE: u32 = 4;

/// How long a call may take here: far longer than any of an exercise does.
pub(crate) const A_CALL: Duration = Duration::from_millis(200);

/// How long the compiler may take here for one file: some five times what it does.
pub(crate) const COMPILING: Duration = Duration::from_secs(2);

/// What comes of a call that computes without end.
pub(crate) const LOOPS: Outcome = Outcome::TimedOut(Late::Computing(200));

/// What comes of a call that waits without end.
pub(crate) const SLEEPS: Outcome = Outcome::TimedOut(Late::Waiting(200));

/// A judge with a folder of its own.
pub(crate) struct Bench {
    folder: tempfile::TempDir,
    judge: Judge,
}

/// A file with `rotate_about_point` of this body.
pub(crate) fn in_function(body: &str) -> Vec<u8> {
    format!("use glam::{{Mat3, Vec2}};\n\npub fn rotate_about_point(theta: f32, p: Vec2) -> Mat3 {{\n    {body}\n}}\n")
        .into_bytes()
}

/// The workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(3).expect("crates/judging/grader").to_owned()
}

/// Built once for all tests of a program.
fn libraries() -> Libraries {
    static LIBRARIES: OnceLock<Libraries> = OnceLock::new();
    LIBRARIES
        .get_or_init(|| {
            Libraries::build(&root(), Build::of_the_workspace()).expect("the libraries are built")
        })
        .clone()
}

/// Confines, if this system can; if not, says so loudly, once.
fn launcher() -> Option<Launcher> {
    static LAUNCHER: OnceLock<Option<Launcher>> = OnceLock::new();
    let find = || {
        let launcher = Launcher::at(Path::new(env!("CARGO_BIN_EXE_grader-launcher")));
        let missing = sandbox::missing(&sandbox::doctor(launcher.as_ref()));
        if !missing.is_empty() {
            eprintln!("SKIPPED, NOTHING IS CONFINED HERE: this system lacks {}", missing.join(", "));
        }
        launcher.filter(|_| missing.is_empty())
    };
    LAUNCHER.get_or_init(find).clone()
}

impl Bench {
    /// One that confines; `None` where the system does not.
    pub(crate) fn confined() -> Option<Self> {
        let launcher = launcher()?;
        let mut bench = Self::new();
        bench.judge.sandbox = Some(launcher);
        Some(bench)
    }

    pub(crate) fn judge_itself(&self) -> &Judge {
        &self.judge
    }

    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let mut judge = Judge::in_folder(libraries(), folder.path());
        judge.limits.time = A_CALL;
        judge.limits.compiling = COMPILING;
        Self { folder, judge }
    }

    /// How long a call may take.
    pub(crate) fn limit_call(&mut self, time: Duration) {
        self.judge.limits.time = time;
    }

    /// How long all calls together may take.
    pub(crate) fn limit_whole(&mut self, whole: Duration) {
        self.judge.limits.whole = whole;
    }

    /// How much memory a worker may take.
    pub(crate) fn limit_memory(&mut self, memory: u64) {
        self.judge.limits.memory = memory;
    }

    /// How long the compiler may take for one file.
    pub(crate) fn limit_compiling(&mut self, time: Duration) {
        self.judge.limits.compiling = time;
    }

    /// How much memory all answers together may take.
    pub(crate) fn limit_answers(&mut self, answers: usize) {
        self.judge.limits.answers = answers;
    }

    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    pub(crate) fn judge(&self, source: &[u8]) -> Judgement {
        self.judge_with(source, 1)
    }

    pub(crate) fn judge_with(&self, source: &[u8], seed: u64) -> Judgement {
        self.judge_exercise(course::find("rotate_about_point").expect("the exercise"), source, seed)
    }

    pub(crate) fn judge_path(&self, file: &Path) -> Judgement {
        self.judge.judge(course::find("rotate_about_point").expect("the exercise"), file, 1)
    }

    /// One that cannot compile.
    pub(crate) fn that_cannot_compile() -> Self {
        let mut bench = Self::new();
        // Not a folder: no worker's folder can be made in it.
        bench.judge.scratch = bench.folder.path().join("file/scratch");
        fs::write(bench.folder.path().join("file"), "").expect("a file");
        bench
    }

    /// Compiles a file to be asked.
    pub(crate) fn open(
        &self,
        exercise: &'static Exercise,
        source: &[u8],
    ) -> Result<CompiledFunction, Outcome> {
        let file = self.folder.path().join("submission.rs");
        fs::write(&file, source).expect("a file");
        self.judge.open(exercise, &file)
    }

    pub(crate) fn judge_exercise(&self, exercise: &Exercise, source: &[u8], seed: u64) -> Judgement {
        let file = self.folder.path().join("submission.rs");
        fs::write(&file, source).expect("a file");
        self.judge.judge(exercise, &file, seed)
    }

    /// Judges functions `rotate_about_point` of these bodies, compiled together.
    pub(crate) fn judge_bodies(&self, bodies: &[&str]) -> Vec<Judgement> {
        let sources: Vec<Vec<u8>> = bodies.iter().map(|body| in_function(body)).collect();
        let exercise = course::find("rotate_about_point").expect("the exercise");
        self.judge_mixed(&sources.iter().map(|source| (exercise, source.as_slice())).collect::<Vec<_>>())
    }

    /// Judges several files of one exercise, compiled together.
    pub(crate) fn judge_together(&self, exercise: &Exercise, sources: &[String]) -> Vec<Judgement> {
        self.judge_mixed(&sources.iter().map(|source| (exercise, source.as_bytes())).collect::<Vec<_>>())
    }

    /// Judges files of any exercises, compiled together.
    pub(crate) fn judge_mixed(&self, sources: &[(&Exercise, &[u8])]) -> Vec<Judgement> {
        let files: Vec<PathBuf> =
            (0..sources.len()).map(|at| self.folder.path().join(format!("submission_{at}.rs"))).collect();
        let mut parts: Vec<(&Exercise, &Path)> = Vec::new();
        for (file, (exercise, source)) in files.iter().zip(sources) {
            fs::write(file, source).expect("a file");
            parts.push((exercise, file));
        }
        self.judge.judge_all(&parts, 1)
    }
}
