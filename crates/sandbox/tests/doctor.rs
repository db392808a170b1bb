//! Does the doctor tell what this system enforces?

use std::path::Path;

use sandbox::{Finding, Launcher, doctor};

#[test]
fn without_a_launcher_nothing_is_enforced() {
    let checks = doctor(None);
    assert!(checks.iter().any(|check| check.needed && !check.enforced()), "{checks:?}");
}

#[test]
fn every_needed_thing_is_enforced_here_or_the_doctor_says_what_to_do() {
    let launcher = Launcher::at(Path::new(env!("CARGO_BIN_EXE_sandbox-launcher")));
    for check in doctor(launcher.as_ref()) {
        println!("{:?} {}", check.finding, check.name);
        if let Finding::Missing { why, remedy } = &check.finding {
            assert!(!why.is_empty() && !remedy.is_empty(), "{check:?}");
            if check.needed {
                eprintln!("NOT ENFORCED HERE: {}: {why}; {remedy}", check.name);
            }
        }
    }
}
