//! How does a platform come to grade by itself? By a folder that is ready to be uploaded: scripts, the project's sources, and what to click.
//!
//! | function | platform | what is in the folder |
//! |---|---|---|
//! | [`gradescope`] | Gradescope | `autograder.zip`, and the same as files |
//! | [`github_classroom`] | GitHub Classroom | a workflow for the students' repository |
//! | [`codegrade`] | CodeGrade AutoTest V1 and V2 | scripts, and the project as `lightlab.zip` |
//!
//! The same project gives the same bytes: archives are sorted and bear no dates. Each folder has a `README.md` for the lecturer.

mod archive;
mod sources;

use std::path::Path;

pub use sources::SourcesError;

use archive::archive;
use sources::{sources, toolchain};

/// A file of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Where it lies in the folder, with `/`.
    pub path: String,
    /// What is in it.
    pub bytes: Vec<u8>,
    /// Whether it may be run.
    pub executable: bool,
}

impl File {
    fn text(path: &str, text: String) -> Self {
        Self { path: path.to_owned(), bytes: text.into_bytes(), executable: false }
    }

    fn script(path: &str, text: String) -> Self {
        Self { executable: true, ..Self::text(path, text) }
    }

    /// The same in a folder.
    fn under(self, folder: &str) -> Self {
        Self { path: format!("{folder}/{}", self.path), ..self }
    }
}

/// How an export shall grade.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Whether students' code may run without the sandbox, where the platform's container does not have what it is made of. Off, grading
    /// refuses there.
    pub unsafe_no_sandbox: bool,
}

/// Gradescope's autograder: the zip, and what is in it as files.
///
/// # Errors
/// [`SourcesError`]: the project at `root` cannot be read.
pub fn gradescope(root: &Path, options: Options) -> Result<Vec<File>, SourcesError> {
    let toolchain = toolchain(root)?;
    let fill = |template: &str| filled(template, options, &toolchain);
    let mut inside = vec![
        File::script("setup.sh", fill(include_str!("gradescope/setup.sh"))),
        File::script("run_autograder", fill(include_str!("gradescope/run_autograder"))),
    ];
    inside.extend(sources(root)?.into_iter().map(|file| file.under("lightlab")));
    let mut files = vec![
        File { path: "autograder.zip".to_owned(), bytes: archive(&inside), executable: false },
        File::text("README.md", fill(include_str!("gradescope/README.md"))),
    ];
    files.extend(inside.into_iter().map(|file| file.under("autograder")));
    Ok(sorted(files))
}

/// GitHub Classroom's workflow. The project itself is not in it: students can read everything that is in their repositories.
///
/// # Errors
/// [`SourcesError`]: the project at `root` cannot be read.
pub fn github_classroom(root: &Path, options: Options) -> Result<Vec<File>, SourcesError> {
    let toolchain = toolchain(root)?;
    let fill = |template: &str| filled(template, options, &toolchain);
    Ok(sorted(vec![
        File::text(".github/workflows/classroom.yml", fill(include_str!("github_classroom/classroom.yml"))),
        File::text("README.md", fill(include_str!("github_classroom/README.md"))),
    ]))
}

/// CodeGrade's scripts for AutoTest V1 and V2, with the project.
///
/// # Errors
/// [`SourcesError`]: the project at `root` cannot be read.
pub fn codegrade(root: &Path, options: Options) -> Result<Vec<File>, SourcesError> {
    let toolchain = toolchain(root)?;
    let fill = |template: &str| filled(template, options, &toolchain);
    Ok(sorted(vec![
        File::script("cg-setup", fill(include_str!("codegrade/cg-setup"))),
        File::script("cg-run-v1", fill(include_str!("codegrade/cg-run-v1"))),
        File::script("cg-run-v2", fill(include_str!("codegrade/cg-run-v2"))),
        File { path: "lightlab.zip".to_owned(), bytes: archive(&sources(root)?), executable: false },
        File::text("README.md", fill(include_str!("codegrade/README.md"))),
    ]))
}

fn sorted(mut files: Vec<File>) -> Vec<File> {
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

/// A template with what differs from project to project. Scripts have Unix line ends whatever this was built on.
fn filled(template: &str, options: Options, toolchain: &str) -> String {
    let flag = if options.unsafe_no_sandbox { " --unsafe-no-sandbox" } else { "" };
    let about = if options.unsafe_no_sandbox { WITHOUT_SANDBOX } else { WITH_SANDBOX };
    template
        .replace("\r\n", "\n")
        .replace("@FLAGS@", flag)
        .replace("@TOOLCHAIN@", toolchain)
        .replace("@SANDBOX@", about)
}

const WITH_SANDBOX: &str = "Students' code runs in lightlab's own sandbox (Landlock, seccomp, limits), inside of the platform's container. The kernel under \
the container decides whether the sandbox can be had. Where it cannot, grading refuses and says so; nothing runs unguarded.\n\nIf it refuses: export \
again with `--unsafe-no-sandbox`. Then the platform's container is all there is between a submission and the grader beside it: it can read the \
reference solutions, and with some effort write results of its own. Do so where results are looked at, not for an exam.";

const WITHOUT_SANDBOX: &str = "**This export was made with `--unsafe-no-sandbox`.** The platform's container is all there is between a submission and the \
grader beside it: it can read the reference solutions, and with some effort write results of its own. Use it where results are looked at, not for an \
exam. An export without the flag refuses to grade where the sandbox cannot be had.";
