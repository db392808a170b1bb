//! What does a student do all day? Look at the board, edit a file, read a verdict, ask for a hint.
//!
//! [`board`] is `cargo lab` alone; [`check`], [`watch`], [`hint`], [`solution`] and [`reset`] are the commands of their names. Beneath
//! them: [`workbench`] knows where everything lies, [`which`] what a name means, [`memory`] what was judged before, [`verdict`] how a
//! judgement reads, [`ink`] whether there are colours, [`changes`] when a file was saved, [`keys`] which key was pressed.

pub(crate) mod board;
mod changes;
pub(crate) mod check;
pub(crate) mod hint;
mod ink;
mod keys;
mod memory;
pub(crate) mod reset;
pub(crate) mod solution;
mod verdict;
pub(crate) mod watch;
pub(crate) mod which;
pub(crate) mod workbench;

// Only signals ask for it.
#[cfg(unix)]
pub(crate) use keys::restore as restore_terminal;
