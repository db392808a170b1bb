//! What can be typed after the commands that grade a class?

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};
use class::Partition;
use class::format::Format;

const GRADE_EXAMPLES: &str = "\
Examples:
  A class, with the inputs that students can try at home; the report opens in any browser:
    cargo lab grade submissions --out report
  After the deadline, with inputs that nobody has seen, other ones for each student:
    cargo lab grade submissions --out final --seed fresh --seeds per-student
  Go on where a run was ended; what has not changed is not judged again:
    cargo lab grade submissions --out final --resume
  The second of eight shares, on the second of eight machines; then all together:
    cargo lab grade submissions --out part2 --partition 2/8
    cargo lab merge part1 part2 part3 part4 part5 part6 part7 part8 --out report
  Whose points have changed?
    cargo lab grade submissions --out new --compare old

Exit code: 0 done, 1 done, but a person has to look (the grader failed at something, or points changed), 2 error.";

const AUDIT_EXAMPLES: &str = "\
Examples:
  All exercises, which takes some minutes:
    cargo lab audit
  One of them, soon:
    cargo lab audit ray_sphere --seeds 20

Exit code: 0 all targets are met, 1 an exercise falls short, 2 error.";

const DOCTOR_HELP: &str = "\
Each line is tried: a program is confined like a student's, and does what it should not be able to do. Takes a second or two.

Exit code: 0 all that grading needs is enforced, 1 something is missing, 2 error.";

/// The commands for lecturers.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Judge a folder of submissions, and write the reports
    #[command(after_help = GRADE_EXAMPLES)]
    Grade(GradeArgs),
    /// Put the parts of a partitioned grading together
    Merge(MergeArgs),
    /// Write the students' edition: tasks, stubs and worked examples, without solutions
    Handout(HandoutArgs),
    /// Audit the exercises' laws: right programs must be accepted, wrong ones rejected
    #[command(after_help = AUDIT_EXAMPLES)]
    Audit(AuditArgs),
    /// Write an autograder for a course platform
    Export(ExportArgs),
    /// Say what this system can keep from students' code
    #[command(after_help = DOCTOR_HELP)]
    Doctor(DoctorArgs),
}

/// `cargo lab grade`.
#[derive(Args, Debug)]
pub(crate) struct GradeArgs {
    /// The class: a folder with a folder or zip archive for each student, or as a learning platform exports it
    #[arg(value_name = "DIR")]
    pub(crate) submissions: PathBuf,

    /// DIR is itself the submission of one student
    #[arg(long)]
    pub(crate) single: bool,

    /// Where the reports go: a new or empty folder
    #[arg(long, value_name = "REPORT")]
    pub(crate) out: PathBuf,

    /// Go on with the run that was ended in REPORT; what has not changed is not judged again
    #[arg(long)]
    pub(crate) resume: bool,

    /// The inputs: those of this number, or of a `fresh` one [default: 1, which students have; with --resume: that of the run]
    #[arg(long, value_name = "N", value_parser = seed)]
    pub(crate) seed: Option<Seed>,

    /// Whether all students are asked the same
    #[arg(long, value_name = "WHICH")]
    pub(crate) seeds: Option<Which>,

    /// Judge only this share: 2/8 is the second of eight; count:2/8, slice:2/8, hash:2/8 say how to share
    #[arg(long, value_name = "K/N")]
    pub(crate) partition: Option<Partition>,

    /// List whose points differ from those of an older report, and by which law
    #[arg(long, value_name = "OLD_REPORT")]
    pub(crate) compare: Option<PathBuf>,

    /// A file for each student in what a platform reads, too: gradescope, codegrade-v1, codegrade-v2, junit, exercism,
    /// github-classroom, prairielearn; several with commas
    #[arg(long, value_name = "FORMAT", value_delimiter = ',')]
    pub(crate) format: Vec<Format>,

    /// So many submissions at a time [default: the number of processors]
    #[arg(long, value_name = "N")]
    pub(crate) jobs: Option<usize>,

    /// Run students' code with all that you may do yourself
    #[arg(long)]
    pub(crate) unsafe_no_sandbox: bool,

    /// Say nothing while it runs
    #[arg(long)]
    pub(crate) quiet: bool,
}

/// `cargo lab merge`.
#[derive(Args, Debug)]
pub(crate) struct MergeArgs {
    /// The reports of all shares
    #[arg(value_name = "PART", required = true)]
    pub(crate) parts: Vec<PathBuf>,

    /// Where the report goes: a new or empty folder
    #[arg(long, value_name = "REPORT")]
    pub(crate) out: PathBuf,

    /// A file for each student in what a platform reads, too: gradescope, codegrade-v1, codegrade-v2, junit, exercism,
    /// github-classroom, prairielearn; several with commas
    #[arg(long, value_name = "FORMAT", value_delimiter = ',')]
    pub(crate) format: Vec<Format>,
}

/// `cargo lab export`.
#[derive(Args, Debug)]
pub(crate) struct ExportArgs {
    /// Which platform
    #[arg(value_name = "PLATFORM")]
    pub(crate) platform: Platform,

    /// Where the autograder goes: a new or empty folder
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,

    /// Let students' code run without the sandbox there, for a container that does not have what it is made of
    #[arg(long)]
    pub(crate) unsafe_no_sandbox: bool,
}

/// `cargo lab doctor`.
#[derive(Args, Debug)]
pub(crate) struct DoctorArgs {
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// A platform that runs autograders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Platform {
    /// A zip to upload
    Gradescope,
    /// A workflow for the students' repository
    GithubClassroom,
    /// Scripts for AutoTest V1 and V2
    Codegrade,
}

/// `cargo lab handout`.
#[derive(Args, Debug)]
pub(crate) struct HandoutArgs {
    /// Where it goes: a new or empty folder
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,

    /// With the three hints of each exercise
    #[arg(long)]
    pub(crate) hints: bool,
}

/// `cargo lab audit`.
#[derive(Args, Debug)]
pub(crate) struct AuditArgs {
    /// Names of exercises [default: all]
    #[arg(value_name = "EXERCISE")]
    pub(crate) names: Vec<String>,

    /// So many seeds for every right program
    #[arg(long, value_name = "N", default_value_t = audit::SEEDS, value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) seeds: u64,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// Which inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seed {
    /// Those of this number.
    Given(u64),
    /// Those of a number that nobody knows yet.
    Fresh,
}

/// Who is asked what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Which {
    /// All students the same
    Same,
    /// Each student something else, made from the seed and the student's id
    PerStudent,
}

fn seed(text: &str) -> Result<Seed, String> {
    if text == "fresh" {
        return Ok(Seed::Fresh);
    }
    text.parse().map(Seed::Given).map_err(|_| "expected a number, or the word fresh".to_owned())
}
