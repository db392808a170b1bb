//! The help text: its examples run as they stand.

use crate::desk::{Desk, MESH};

#[test]
fn the_help_text_names_the_commands_and_the_exit_codes() {
    let help = Desk::new().lab("--help").done().out;
    for words in ["check", "watch", "render", "compare", "scenes", "play", "Exit codes", "130", "board"] {
        assert!(help.contains(words), "no {words:?} in {help}");
    }
}

#[test]
fn no_line_of_help_is_wider_than_a_page() {
    let desk = Desk::new();
    for command in ["", "check", "watch", "hint", "solution", "reset", "render", "compare", "scenes", "play"]
    {
        for line in desk.lab(&format!("{command} --help")).done().out.lines() {
            assert!(line.chars().count() <= 100, "{line}");
        }
    }
}

/// A desk with what the examples speak of: a mesh, and two pictures that are the same.
fn desk() -> Desk {
    let desk = Desk::new();
    desk.put("spot.obj", MESH);
    desk.put("mesh.obj", MESH);
    desk.lab("render --renderer zbuffer --size 40x30 -o before.png").done();
    desk.lab("render --renderer zbuffer --size 40x30 -o after.png").done();
    desk
}

/// Runs every line of `text` that is a command, as it stands but for a small size, and gives their number.
fn run_examples(desk: &Desk, text: &str) -> usize {
    let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("    cargo lab ")).collect();
    for line in &lines {
        let (typed, _remark) = line.split_once('#').unwrap_or((line, ""));
        let typed = typed.trim().replacen("cargo lab", "$LAB", 1);
        // The last size counts: a small picture shows as well that the example runs.
        let small = if typed.starts_with("$LAB render") { " --size 40x30" } else { "" };
        desk.shell(&format!("{typed}{small}")).done();
    }
    lines.len()
}

#[test]
fn every_example_of_the_help_text_runs() {
    let desk = desk();
    for (command, examples) in [("render", 7), ("compare", 3), ("scenes", 3)] {
        let help = desk.lab(&format!("{command} --help")).done().out;
        assert_eq!(run_examples(&desk, &help), examples, "{help}");
    }
    let pictures = ["teapot.png", "glass.png", "spot.png", "two-spheres.png", "mine.png", "difference.png"];
    for picture in pictures {
        assert_eq!(desk.picture(picture).height(), 30, "{picture}");
    }
}

#[test]
fn every_example_of_the_readme_runs() {
    assert_eq!(run_examples(&desk(), include_str!("../../README.md")), 9);
}
