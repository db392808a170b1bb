//! How does a program run with less than it could do, without root and without a container?
//!
//! - [`Confinement`]: what it may read, run and write, which system calls it may make, how much it may take.
//! - [`Launcher`]: starts it so. The running program starts itself again, takes everything from itself that the confinement does not grant, and
//!   then becomes the program that was asked for: nothing of that one runs before.
//! - [`launched`]: the first thing in the main function of a program that launches.
//! - [`end`], [`finish`]: end a program with all that it started.
//! - [`doctor`]: which of this the system enforces, each tried; [`missing`]: what of it is needed and not there.
//!
//! Linux enforces it, on x86-64 and aarch64. Elsewhere [`Launcher::this_program`] gives nothing and [`doctor`] says so.

#![forbid(unsafe_code)]

mod checkup;
mod confinement;
#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
#[path = "linux/mod.rs"]
mod here;
#[cfg(not(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64"))))]
#[path = "elsewhere.rs"]
mod here;
mod launcher;

pub use checkup::{Check, Finding, doctor, missing};
pub use confinement::{Calls, Confinement, ResourceLimits, libraries, loaders, programs};
pub use here::{end, finish};
pub use launcher::{Launcher, NOT_LAUNCHED, launched};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
