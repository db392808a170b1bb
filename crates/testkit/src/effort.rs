//! How much a test tries: little in `cargo test`, much in the nightly script.

/// The environment variable that asks tests for their nightly effort.
pub const NIGHTLY: &str = "LIGHTLAB_NIGHTLY";

/// Returns `nightly` if the environment variable [`NIGHTLY`] is set, else `quick`.
///
/// Both are inputs of the same test: the quick ones are few enough that everybody runs them, the nightly ones many enough
/// to meet what is rare.
///
/// ```
/// let seeds = testkit::effort(5, 1000);
/// assert!(seeds == 5 || seeds == 1000);
/// ```
#[must_use]
pub fn effort<T>(quick: T, nightly: T) -> T {
    if std::env::var_os(NIGHTLY).is_some() { nightly } else { quick }
}
