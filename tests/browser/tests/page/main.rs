//! Does the live page do what a person expects of it? A browser opens it, drags, types and clicks, and looks at what became of it.
//!
//! Needs Chromium and its driver (`apt-get install chromium chromium-driver`), so these tests are not among those of plain `cargo test`:
//! `cargo test -p lightlab-browser` runs them. With `LIGHTLAB_SCREENSHOTS=folder` pictures of the page are kept for a look.

mod claims;
mod figures;
mod keyboard;
mod looks;
mod loops;
mod stage;
mod student;
mod visit;
