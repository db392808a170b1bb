//! What can be typed after the command that serves the page?

use clap::{Args, Subcommand};

const EXAMPLES: &str = "\
Examples:
  All figures, with sliders and things to drag:
    cargo lab play
  One of them, as prepared for the lecture:
    cargo lab play 'L31?p=64'
  The scene by painter, z-buffer and ray tracer side by side:
    cargo lab play loops
  Nothing opens; the address is for a browser of your choice:
    cargo lab play --no-open --port 8000
  How fast are the pictures, on this machine, in this browser?
    cargo lab play --measure

The server answers this machine alone, and ends with Ctrl-C. The printed address holds a key: with it, and only with it, the page
may run the functions in exercises/.";

/// The command that serves the page.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Show the lecture live in a browser: every figure moves, also with your own functions
    #[command(after_help = EXAMPLES)]
    Play(PlayArgs),
}

/// `cargo lab play`.
#[derive(Args, Debug)]
pub(crate) struct PlayArgs {
    /// What to show first: a figure by number or name, with values if need be ('L31?p=64'); a claim (E3); loops, steps or
    /// claims [default: the list of all]
    #[arg(value_name = "FIGURE")]
    pub(crate) figure: Option<String>,

    /// Listen on this port, or the next free one; 0: on any
    #[arg(long, value_name = "N", default_value_t = play::FIRST_PORT)]
    pub(crate) port: u16,

    /// Do not open the browser, only print the address
    #[arg(long)]
    pub(crate) no_open: bool,

    /// Measure frames a second and the time from drag to picture in the page, print both, and end
    #[arg(long, conflicts_with = "figure")]
    pub(crate) measure: bool,
}
