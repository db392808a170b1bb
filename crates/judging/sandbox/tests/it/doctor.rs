//! Does the doctor tell what this system enforces?

use std::path::Path;

use sandbox::{Finding, Launcher, doctor};

#[test]
fn without_a_launcher_nothing_is_enforced() {
    let checks = doctor(None);
    assert!(checks.iter().any(|check| check.needed && !check.enforced()), "{checks:?}");
}

#[test]
fn a_system_with_landlock_enforces_all_that_is_needed_and_one_without_says_what_to_do() {
    let launcher = Launcher::at(Path::new(env!("CARGO_BIN_EXE_sandbox-launcher")));
    let checks = doctor(launcher.as_ref());
    let missing: Vec<_> = checks.iter().filter(|check| check.needed && !check.enforced()).collect();
    for check in &missing {
        eprintln!("NOT ENFORCED HERE: {check:?}");
        assert!(
            matches!(&check.finding, Finding::Missing { why, remedy } if !why.is_empty() && !remedy.is_empty())
        );
    }
    // A launcher that cannot confine starts nothing: then nothing at all is enforced.
    assert!(missing.is_empty() || checks.iter().all(|check| !check.enforced()), "{checks:#?}");
}

#[test]
fn a_launcher_that_does_not_launch_enforces_nothing() {
    let launcher = Launcher::at(Path::new("/bin/true"));
    let checks = doctor(launcher.as_ref());
    assert!(checks.iter().any(|check| check.needed && !check.enforced()), "{checks:?}");
}
