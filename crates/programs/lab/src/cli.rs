//! What can be typed after `cargo lab`?

use clap::{Args, Parser, Subcommand};

/// What ended well, for the exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The command did what it was asked: 0.
    Done,
    /// Not all that was to be checked passes: 1.
    Unexpected,
    /// `compare` found a difference, or a verdict of `claims` did not come out as recorded: 1.
    #[cfg(feature = "pictures")]
    Differs,
}

const EXIT_CODES: &str = "\
Exit codes:
  0    done; for compare: the pictures are the same
  1    check: not everything passes; compare: the pictures differ; claims: a verdict did not come out as recorded
  2    error
  130  interrupted by Ctrl-C; 143: told to terminate. No half-written file stays behind.

Environment:
  LIGHTLAB_EXERCISES  another folder of exercises than the project's
  NO_COLOR            no colours";

const CHECK_EXAMPLES: &str = "\
Examples:
  The exercises that you have begun:
    cargo lab check
  One of them, those of a concept, all:
    cargo lab check rotate_about_point
    cargo lab check zbuffer
    cargo lab check --all
  A file that lies elsewhere; its name says which exercise it is:
    cargo lab check ~/Downloads/lambert.rs
  A verdict again, to the byte:
    cargo lab check --token rotate_about_point.1.0123abcd

Exit code: 0 all that was asked for passes, 1 something does not, 2 error.";

/// A lecture on lighting and ray tracing, taught by code. Without a command: the board of the exercises, and which one is next.
#[derive(Debug, Parser)]
#[command(
    name = "lab",
    bin_name = "cargo lab",
    version,
    after_help = EXIT_CODES,
    max_term_width = 100
)]
#[command(args_conflicts_with_subcommands = true)]
pub(crate) struct Cli {
    /// Without one: the board.
    #[command(subcommand)]
    pub(crate) command: Option<Command>,

    /// What the board takes.
    #[command(flatten)]
    pub(crate) board: BoardArgs,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Check exercises: which laws hold, and the smallest input that breaks one
    #[command(after_help = CHECK_EXAMPLES)]
    Check(CheckArgs),
    /// Check an exercise on every save; keys for hints, the next exercise, the board
    Watch(WatchArgs),
    /// Print the next hint for an exercise
    Hint(HintArgs),
    /// Print the slide's solution of an exercise that has passed
    Solution(SolutionArgs),
    /// Put an exercise's file back as it was handed out; what stood there is kept beside it
    Reset(ResetArgs),
    /// What draws.
    #[command(flatten)]
    Pictures(crate::pictures::Command),
    /// What a browser shows.
    #[command(flatten)]
    Live(crate::live::Command),
    /// What a lecturer needs.
    #[command(flatten)]
    Class(crate::class::Command),
}

/// `cargo lab` alone.
#[derive(Args, Debug)]
pub(crate) struct BoardArgs {
    /// Print the board as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// `cargo lab check`.
#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// Names of exercises, files, or concepts: transforms, zbuffer, lighting, shading, raytrace [default: the exercises
    /// that you have begun]
    #[arg(value_name = "EXERCISE")]
    pub(crate) names: Vec<String>,

    /// Check all exercises
    #[arg(long, conflicts_with_all = ["names", "token"])]
    pub(crate) all: bool,

    /// Try other inputs: those of this seed [default: 1]
    #[arg(long, value_name = "N", conflicts_with = "token")]
    pub(crate) seed: Option<u64>,

    /// Repeat the verdict with this token: its exercise, its inputs
    #[arg(long, value_name = "TOKEN")]
    pub(crate) token: Option<grader::Token>,

    /// Let exercises wait for those that come before them: one whose prerequisites have not passed is blocked
    #[arg(long)]
    pub(crate) in_order: bool,

    /// How long a call may take, in seconds
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) limit: Option<f32>,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// `cargo lab watch`.
#[derive(Args, Debug)]
pub(crate) struct WatchArgs {
    /// The exercise to begin with [default: the next one to do]
    #[arg(value_name = "EXERCISE")]
    pub(crate) name: Option<String>,

    /// Look for changes again and again instead of being told by the system: for network drives
    #[arg(long)]
    pub(crate) poll: bool,

    /// Print each verdict as a line of JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// `cargo lab hint`.
#[derive(Args, Debug)]
pub(crate) struct HintArgs {
    /// The exercise
    #[arg(value_name = "EXERCISE")]
    pub(crate) name: String,

    /// This hint, 1 to 3 [default: the next one]
    #[arg(long, value_name = "N", value_parser = level)]
    pub(crate) level: Option<usize>,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// `cargo lab solution`.
#[derive(Args, Debug)]
pub(crate) struct SolutionArgs {
    /// The exercise
    #[arg(value_name = "EXERCISE")]
    pub(crate) name: String,

    /// Show it although the exercise has not passed
    #[arg(long)]
    pub(crate) reveal: bool,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// `cargo lab reset`.
#[derive(Args, Debug)]
pub(crate) struct ResetArgs {
    /// Exercises, or concepts
    #[arg(value_name = "EXERCISE", required = true)]
    pub(crate) names: Vec<String>,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// A time limit: more than nothing, at most an hour.
fn seconds(text: &str) -> Result<f32, String> {
    let seconds = text.parse().ok().filter(|seconds| (0.01..=3600.0).contains(seconds));
    seconds.ok_or_else(|| "expected a number of seconds from 0.01 to 3600".to_owned())
}

/// The number of a hint.
fn level(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|level| (1..=3).contains(level)).ok_or_else(|| "expected 1, 2 or 3".to_owned())
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_definition_holds_together() {
        Cli::command().debug_assert();
    }
}
