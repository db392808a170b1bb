//! The libraries that a student's file is compiled against: worker, vocabulary and glam, built once by cargo and found again later.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::SystemTime;

use serde_json::{Value as Json, json};

/// The libraries that a student's file is compiled against.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Libraries {
    /// The compiler itself, not rustup's proxy, which would search for it at every start.
    pub(crate) rustc: PathBuf,
    /// `libworker-….rlib`.
    worker: PathBuf,
    /// `libvocabulary-….rlib`.
    vocabulary: PathBuf,
    /// `libglam-….rlib`.
    glam: PathBuf,
    /// The compiler's sysroot.
    pub(crate) sysroot: PathBuf,
    /// The folder with the libraries' own dependencies.
    pub(crate) dependencies: Option<PathBuf>,
    /// Every library file that rustc may read. None of them contains a solution.
    pub(crate) files: Vec<PathBuf>,
}

/// What cargo is asked to build.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Build {
    /// A package of the workspace that has the libraries among its dependencies: that of the running program, since the same library may
    /// be built with other features for another one.
    pub package: &'static str,
    /// The profile, "release", "grading" or "dev": that of the running program.
    pub profile: &'static str,
    /// The arguments that ask cargo for the features of the running program: none for the default ones.
    pub features: &'static [&'static str],
}

impl Build {
    /// For a program of this package, with the profile that this library was built with.
    pub fn of(package: &'static str) -> Self {
        Self { package, profile: profile(), features: &[] }
    }

    /// For tests: the libraries as `cargo test` of the whole workspace builds them, so that they are not built a second time. The features of
    /// `lab` count, but its programs are not built.
    pub fn of_the_workspace() -> Self {
        Self { features: &["--package", "lab", "--lib"], ..Self::of("worker") }
    }
}

/// Why there are no libraries.
#[derive(Debug, thiserror::Error)]
pub enum LibrariesError {
    /// Cargo did not start.
    #[error("cargo does not start: {0}")]
    Cargo(io::Error),
    /// Cargo could not build the libraries.
    #[error("the libraries for students' code cannot be built:\n{0}")]
    Build(String),
    /// Cargo built, but not all that was wanted.
    #[error("cargo built no library `{0}`")]
    Missing(&'static str),
}

impl Libraries {
    /// Builds the libraries in the workspace at `root`, or finds them already built.
    ///
    /// They are those of `build`: the libraries that the running program itself is made with need not be built again.
    ///
    /// # Errors
    /// [`LibrariesError`]: cargo is not there, or fails.
    pub fn build(root: &Path, build: Build) -> Result<Self, LibrariesError> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let output = Command::new(cargo)
            .current_dir(root)
            .args(["build", "--package", build.package, "--profile", build.profile])
            .args(build.features)
            .args(["--message-format", "json-render-diagnostics"])
            .stdin(Stdio::null())
            .output()
            .map_err(LibrariesError::Cargo)?;
        if !output.status.success() {
            return Err(LibrariesError::Build(String::from_utf8_lossy(&output.stderr).into_owned()));
        }
        let messages: Vec<Json> = String::from_utf8_lossy(&output.stdout)
            .lines()
            .filter_map(|line| serde_json::from_str(line).ok())
            .collect();
        let library = |name| library(&messages, name).ok_or(LibrariesError::Missing(name));
        let (rustc, sysroot) = rustc(root);
        let worker = library("worker")?;
        Ok(Self {
            rustc,
            sysroot,
            dependencies: worker.parent().map(deps_beside),
            files: files(&messages),
            worker,
            vocabulary: library("vocabulary")?,
            glam: library("glam")?,
        })
    }

    /// The libraries that `memory` remembers, or a fresh one, which it then remembers. What is remembered counts as long as its files are
    /// there and the running program has not changed.
    ///
    /// # Errors
    /// [`LibrariesError`], from building.
    pub fn remembered(root: &Path, build: Build, memory: &Path) -> Result<Self, LibrariesError> {
        let program = this_program();
        if let Some(libraries) = recall(memory, &program) {
            return Ok(libraries);
        }
        let libraries = Self::build(root, build)?;
        // A libraries that cannot be remembered is built again next time: slower, not wrong.
        let _ = libraries.remember(memory, &program);
        Ok(libraries)
    }

    /// Forgets what `memory` remembers: after an update of Rust the libraries must be built again.
    pub fn forget(memory: &Path) {
        let _ = fs::remove_file(memory);
    }

    /// The arguments that make rustc find the libraries.
    pub(crate) fn arguments(&self) -> Vec<std::ffi::OsString> {
        let mut arguments = Vec::new();
        for (name, path) in [("worker", &self.worker), ("vocabulary", &self.vocabulary), ("glam", &self.glam)]
        {
            let mut library = std::ffi::OsString::from(format!("{name}="));
            library.push(path);
            arguments.extend(["--extern".into(), library]);
        }
        if let Some(folder) = &self.dependencies {
            let mut dependencies = std::ffi::OsString::from("dependency=");
            dependencies.push(folder);
            arguments.extend(["-L".into(), dependencies]);
        }
        arguments
    }

    fn remember(&self, memory: &Path, program: &str) -> io::Result<()> {
        let text = json!({
            "program": program,
            "rustc": self.rustc.to_string_lossy(),
            "worker": self.worker.to_string_lossy(),
            "vocabulary": self.vocabulary.to_string_lossy(),
            "glam": self.glam.to_string_lossy(),
            "sysroot": self.sysroot.to_string_lossy(),
            "dependencies": self.dependencies.as_ref().map(|folder| folder.to_string_lossy()),
            "files": self.files.iter().map(|file| file.to_string_lossy()).collect::<Vec<_>>(),
        });
        fs::write(memory, text.to_string())
    }
}

fn recall(memory: &Path, program: &str) -> Option<Libraries> {
    let remembered: Json = serde_json::from_str(&fs::read_to_string(memory).ok()?).ok()?;
    if remembered["program"].as_str()? != program {
        return None;
    }
    let path = |name: &str| remembered[name].as_str().map(PathBuf::from).filter(|path| path.is_file());
    let files = remembered["files"].as_array()?.iter().map(|file| Some(PathBuf::from(file.as_str()?)));
    Some(Libraries {
        rustc: path("rustc")?,
        worker: path("worker")?,
        vocabulary: path("vocabulary")?,
        glam: path("glam")?,
        sysroot: remembered["sysroot"].as_str()?.into(),
        dependencies: remembered["dependencies"].as_str().map(PathBuf::from),
        files: files.collect::<Option<_>>()?,
    })
}

/// The profile of the running program, by the folder that it lies in.
fn profile() -> &'static str {
    let folder = std::env::current_exe().ok();
    let folder = folder.as_deref().and_then(Path::parent).and_then(Path::file_name);
    match folder.and_then(|name| name.to_str()) {
        Some("grading") => "grading",
        _ if cfg!(debug_assertions) => "dev",
        _ => "release",
    }
}

/// The running program and when it was built.
fn this_program() -> String {
    let path = std::env::current_exe().unwrap_or_default();
    let built =
        fs::metadata(&path).and_then(|metadata| metadata.modified()).unwrap_or(SystemTime::UNIX_EPOCH);
    format!("{} {built:?}", path.display())
}

fn library(messages: &[Json], name: &str) -> Option<PathBuf> {
    let artifact = messages
        .iter()
        .find(|message| message["reason"] == "compiler-artifact" && message["target"]["name"] == name)?;
    let files = artifact["filenames"].as_array()?;
    files.iter().filter_map(Json::as_str).find(|file| file.ends_with(".rlib")).map(PathBuf::from)
}

/// The files of all libraries from elsewhere, and of the two of this workspace that a student's file sees.
fn files(messages: &[Json]) -> Vec<PathBuf> {
    let ours = |name: &Json| name == "worker" || name == "vocabulary";
    messages
        .iter()
        .filter(|message| message["reason"] == "compiler-artifact")
        .filter(|message| {
            let elsewhere = message["package_id"].as_str().is_some_and(|id| !id.starts_with("path+"));
            elsewhere || ours(&message["target"]["name"])
        })
        .filter_map(|message| message["filenames"].as_array())
        .flatten()
        .filter_map(Json::as_str)
        .map(PathBuf::from)
        .filter(|file| file.extension().is_some_and(|kind| kind == "rlib" || kind == "rmeta" || kind == "so"))
        .collect()
}

/// The compiler that cargo takes, and its folder: `RUSTC` if somebody chose one; else the one in the toolchain's own folder.
fn rustc(root: &Path) -> (PathBuf, PathBuf) {
    let chosen = std::env::var_os("RUSTC").map(PathBuf::from);
    let asked = chosen.clone().unwrap_or_else(|| "rustc".into());
    let sysroot = Command::new(&asked).current_dir(root).args(["--print", "sysroot"]).output().ok();
    let sysroot = sysroot.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    let sysroot = PathBuf::from(sysroot.trim());
    let found = sysroot.join("bin").join(format!("rustc{}", std::env::consts::EXE_SUFFIX));
    (chosen.unwrap_or(if found.is_file() { found } else { asked }), sysroot)
}

/// Where cargo puts the libraries that others need: `deps`, in which a registry's library lies itself.
fn deps_beside(folder: &Path) -> PathBuf {
    if folder.ends_with("deps") { folder.to_owned() } else { folder.join("deps") }
}
