//! Does `cargo lab` do what its help text says? The program is run here as a user runs it.

mod checkout;
mod compare;
mod desk;
#[cfg(target_os = "linux")]
mod everyone;
mod figures;
mod flags;
mod grade;
mod help;
#[cfg(target_os = "linux")]
mod hostile_acts;
mod interruption;
#[cfg(target_os = "linux")]
mod made_up_class;
mod play;
mod render;
mod scenes;
mod student;
mod terminal;
mod writing;
