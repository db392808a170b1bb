//! Does `cargo lab` do what its help text says? The program is run here as a user runs it.

mod compare;
mod desk;
mod figures;
mod flags;
mod grade;
mod help;
mod interruption;
#[cfg(target_os = "linux")]
mod made_up_class;
mod play;
mod render;
mod scenes;
mod student;
mod terminal;
mod writing;
