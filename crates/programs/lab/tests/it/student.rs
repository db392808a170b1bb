//! The student's loop: board, check, watch, hint, solution, reset.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

use serde_json::Value as Json;
use tempfile::TempDir;

use crate::desk::{LAB, Said, root};

const NAME: &str = "rotate_about_point";

const RIGHT: &str = "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";

const WRONG: &str = "Mat3::from_angle(theta) * Mat3::from_translation(-p)";

/// A copy of the exercises as they are handed out.
struct Student {
    folder: TempDir,
}

impl Student {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        for exercise in course::all() {
            let file = folder.path().join(exercise.path());
            fs::create_dir_all(file.parent().expect("a folder")).expect("made");
            fs::write(file, exercise.stub).expect("written");
        }
        Self { folder }
    }

    fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(course::find(name).expect("an exercise").path())
    }

    /// Writes this in place of `todo!()`.
    fn solves(&self, name: &str, body: &str) {
        let stub = course::find(name).expect("an exercise").stub;
        fs::write(self.file(name), stub.replace("todo!()", body)).expect("written");
    }

    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(LAB);
        command
            .args(line.split_whitespace())
            .current_dir(root())
            .env("LIGHTLAB_EXERCISES", self.folder.path())
            .stdin(Stdio::null());
        command
    }

    fn lab(&self, line: &str) -> Said {
        Said::from(self.command(line).output().expect("it runs"))
    }

    fn json(&self, line: &str) -> (Option<i32>, Json) {
        let said = self.lab(line);
        let json = serde_json::from_str(&said.out).unwrap_or_else(|e| panic!("{e}: {said:?}"));
        (said.code, json)
    }
}

#[test]
fn the_board_fits_on_a_screen_and_says_what_is_next() {
    let student = Student::new();
    let board = student.lab("").done().out;
    assert!(board.lines().count() <= 24, "{} lines:\n{board}", board.lines().count());
    assert!(board.lines().all(|line| line.chars().count() <= 80), "{board}");
    assert!(!board.contains('\x1b'), "colours without a terminal");
    for exercise in course::all() {
        assert!(board.contains(exercise.name), "no {} in\n{board}", exercise.name);
    }
    assert!(board.contains("next: Rotate about a point") && board.contains("cargo lab watch"), "{board}");
}

#[test]
fn solving_the_first_exercise_moves_the_board_on() {
    let student = Student::new();
    student.solves(NAME, RIGHT);
    let (code, board) = student.json("--json");
    assert_eq!(code, Some(0));
    let first = &board["exercises"][0];
    assert_eq!((first["name"].as_str(), first["outcome"].as_str()), (Some(NAME), Some("passed")));
    assert_eq!(first["points"], first["of"]);
    assert_ne!(board["next"], NAME);
    assert!(student.lab("").done().out.contains(&format!("✓ {NAME}")));
}

#[test]
fn a_wrong_answer_is_explained_and_the_exit_code_says_so() {
    let student = Student::new();
    student.solves(NAME, WRONG);
    let said = student.lab(&format!("check {NAME}"));
    assert_eq!(said.code, Some(1));
    for part in [
        "✗ wrong",
        "M·p is",
        "should be",
        "This looks like: p is brought to the origin, but not back",
        "--token",
    ] {
        assert!(said.out.contains(part), "no {part:?} in\n{}", said.out);
    }
    let drawn = said.out.lines().find_map(|line| line.trim().strip_prefix("Drawn: ")).expect("a picture");
    assert!(fs::read_to_string(root().join(drawn)).expect("the picture").contains("<svg"));
    // Paths are as long as they are.
    let mut ours =
        said.out.lines().filter(|line| !line.contains("Drawn: ") && !line.contains("The same again: "));
    assert!(ours.all(|line| line.chars().count() <= 80), "{}", said.out);
    student.solves(NAME, RIGHT);
    let said = student.lab(&format!("check {NAME}")).done();
    assert!(said.out.contains("✓ passed") && said.out.contains("10 of 10 points"), "{}", said.out);
}

#[test]
fn what_is_asked_for_decides_the_exit_code() {
    let student = Student::new();
    assert_eq!(student.lab("check").code, Some(1), "nothing begun");
    student.solves(NAME, RIGHT);
    assert_eq!(student.lab("check").code, Some(0), "what was begun passes");
    assert_eq!(student.lab("check --all").code, Some(1), "the others are not started");
    assert_eq!(student.lab("check transforms").code, Some(1));
    let (_, json) = student.json("check --all --json");
    let words: Vec<&str> =
        json["verdicts"].as_array().expect("a list").iter().filter_map(|v| v["outcome"].as_str()).collect();
    assert_eq!(words.iter().filter(|word| **word == "passed").count(), 1);
    assert_eq!(words.iter().filter(|word| **word == "not started").count(), words.len() - 1);
}

#[test]
fn one_broken_file_costs_no_other_its_verdict() {
    let student = Student::new();
    student.solves(NAME, RIGHT);
    student.solves("change_of_basis", "this is not Rust");
    fs::write(student.file("camera_frame"), b"// \xff\n").expect("written");
    fs::write(student.file("perspective"), b"").expect("written");
    fs::remove_file(student.file("lambert")).expect("removed");
    student.solves("halfway", "loop {}");
    let (code, json) = student.json("check --all --limit 1 --json");
    assert_eq!(code, Some(1));
    let outcome = |name: &str| {
        let verdicts = json["verdicts"].as_array().expect("a list");
        verdicts.iter().find(|v| v["exercise"] == name).and_then(|v| v["outcome"].as_str()).map(str::to_owned)
    };
    assert_eq!(outcome(NAME).as_deref(), Some("passed"));
    assert_eq!(outcome("change_of_basis").as_deref(), Some("does not compile"));
    assert_eq!(outcome("camera_frame").as_deref(), Some("unreadable"));
    assert_eq!(outcome("perspective").as_deref(), Some("empty"));
    assert_eq!(outcome("lambert").as_deref(), Some("missing"));
    assert_eq!(outcome("halfway").as_deref(), Some("timed out"));
    assert_eq!(outcome("reflection").as_deref(), Some("not started"));
}

#[test]
fn a_token_repeats_a_verdict_to_the_byte() {
    let student = Student::new();
    student.solves(NAME, WRONG);
    let (_, json) = student.json(&format!("check {NAME} --seed 77 --json"));
    let token = json["verdicts"][0]["token"].as_str().expect("a token").to_owned();
    let once = student.lab(&format!("check --token {token} --json"));
    let again = student.lab(&format!("check --token {token} --json"));
    assert_eq!(once.out, again.out);
    assert_eq!(serde_json::from_str::<Json>(&once.out).expect("JSON"), json);
    student.lab("check --token rotate_about_point.1.00000000").refused(&["version"]);
    student.lab("check --token nonsense").refused(&["a token looks like"]);
}

#[test]
fn with_order_an_exercise_waits_for_those_before_it() {
    let student = Student::new();
    let (before, after) = course::all()
        .iter()
        .find_map(|exercise| exercise.prerequisites.first().map(|before| (*before, exercise.name)))
        .expect("an exercise with a prerequisite");
    let (_, json) = student.json(&format!("check {after} --in-order --json"));
    assert_eq!(json["verdicts"][0]["outcome"], "blocked");
    assert!(json["verdicts"][0]["sentence"].as_str().is_some_and(|text| text.contains(before)));
}

#[test]
fn a_mistyped_name_gets_the_nearest() {
    let student = Student::new();
    student.lab("check rotate-about-piont").refused(&["no exercise or concept", NAME]);
    student.lab("hint lamberd").refused(&["lambert"]);
    student.lab("check some/where/else.rs").refused(&["not called like an exercise"]);
}

#[test]
fn a_file_from_elsewhere_is_judged_by_its_name() {
    let student = Student::new();
    let elsewhere = tempfile::tempdir().expect("a folder");
    let file = elsewhere.path().join("rotate_about_point.rs");
    let stub = course::find(NAME).expect("the exercise").stub;
    fs::write(&file, stub.replace("todo!()", RIGHT)).expect("written");
    student.lab(&format!("check {}", file.display())).done();
    assert_eq!(student.json("--json").1["exercises"][0]["outcome"], "not started", "not the student's own");
}

#[test]
fn files_and_folders_are_meant_as_a_shell_completes_them() {
    let student = Student::new();
    let verdicts = |line: &str| student.json(line).1["verdicts"].as_array().expect("a list").len();
    let folder = student.folder.path().join("zbuffer");
    assert_eq!(verdicts(&format!("check {}/ --json", folder.display())), 6);
    assert_eq!(verdicts("check zbuffer --json"), 6, "the concept, not the exercise of that name");
    assert_eq!(verdicts("check zbuffer/zbuffer --json"), 1);
    let (_, json) = student.json("check lambert.rs --json");
    assert_eq!(json["verdicts"][0]["outcome"], "not started");
    let (_, json) = student.json("hint zbuffer --json");
    assert_eq!(json["exercise"], "zbuffer");
}

#[cfg(target_os = "linux")]
#[test]
fn what_never_ends_is_no_file_of_a_student() {
    let student = Student::new();
    let file = student.file("reflection");
    fs::remove_file(&file).expect("removed");
    std::os::unix::fs::symlink("/dev/zero", &file).expect("linked");
    let (_, json) = student.json("check reflection --json");
    assert_eq!(json["verdicts"][0]["outcome"], "unreadable");
    student.lab("").done();
}

#[test]
fn the_line_that_repeats_a_verdict_does() {
    let student = Student::new();
    let elsewhere = tempfile::tempdir().expect("a folder");
    let file = elsewhere.path().join("rotate_about_point.rs");
    fs::write(&file, course::find(NAME).expect("it").stub.replace("todo!()", WRONG)).expect("written");
    let said = student.lab(&format!("check {}", file.display()));
    let again =
        said.out.lines().find_map(|line| line.trim().strip_prefix("The same again: cargo lab ")).expect("it");
    assert_eq!(student.lab(again).out, said.out);
}

#[test]
fn nan_gets_words_of_its_own_and_a_hang_no_laws_help() {
    let student = Student::new();
    student.solves(NAME, "Mat3::from_cols_array(&[f32::NAN; 9])");
    assert!(student.lab("check").out.contains("NaN and inf are no numbers"));
    student.solves(NAME, "loop {}");
    let out = student.lab("check --limit 0.2").out;
    assert!(
        out.contains("No answer to the call below after 0.2 s of computing") && !out.contains("smallest"),
        "{out}"
    );
}

#[test]
fn a_reader_of_the_board_may_leave() {
    let student = Student::new();
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let run = student.command("").stdout(writer).output().expect("it runs");
    assert_eq!((run.status.code(), run.stderr.as_slice()), (Some(0), &b""[..]));
}

#[test]
fn hints_come_one_at_a_time() {
    let student = Student::new();
    let hints = course::find(NAME).expect("the exercise").hints;
    for (number, hint) in (1..).zip(hints).chain([(3, hints[2])]) {
        let (_, json) = student.json(&format!("hint {NAME} --json"));
        assert_eq!((json["level"].as_u64(), json["hint"].as_str()), (Some(number), Some(hint)));
    }
    assert!(student.lab(&format!("hint {NAME} --level 1")).done().out.contains("hint 1 of 3"));
    student.lab(&format!("hint {NAME} --level 4")).refused(&["1, 2 or 3"]);
}

#[test]
fn the_solution_is_told_after_ones_own_or_to_who_insists() {
    let student = Student::new();
    student.lab(&format!("solution {NAME}")).refused(&["not passed", "--reveal"]);
    let revealed = student.lab(&format!("solution {NAME} --reveal")).done().out;
    assert!(revealed.contains("pub fn rotate_about_point") && revealed.contains("from_angle"), "{revealed}");
    student.solves(NAME, RIGHT);
    assert_eq!(student.lab(&format!("solution {NAME}")).done().out, revealed);
}

#[test]
fn reset_keeps_what_was_there() {
    let student = Student::new();
    let stub = fs::read(student.file(NAME)).expect("the stub");
    for round in 1..=2 {
        student.solves(NAME, &format!("/* {round} */ {WRONG}"));
        let mine = fs::read(student.file(NAME)).expect("mine");
        let (_, json) = student.json(&format!("reset {NAME} --json"));
        assert_eq!(fs::read(student.file(NAME)).expect("reset"), stub);
        let backup = json["reset"][0]["backup"].as_str().expect("a backup");
        assert!(backup.ends_with(&format!("rotate_about_point.rs.{round}.bak")), "{backup}");
        assert_eq!(fs::read(backup).expect("the backup"), mine);
    }
    fs::remove_file(student.file(NAME)).expect("removed");
    student.lab(&format!("reset {NAME}")).done();
    assert_eq!(fs::read(student.file(NAME)).expect("back again"), stub);
    assert_eq!(fs::read_dir(student.folder.path().join("transforms")).expect("the folder").count(), 9 + 2);
}

#[test]
fn outside_of_a_project_it_says_where_to_go() {
    let nowhere = tempfile::tempdir().expect("a folder");
    let output = Command::new(LAB).current_dir(nowhere.path()).output().expect("it runs");
    Said::from(output).refused(&["no exercises in", "change to the project's folder"]);
}

/// Follows `cargo lab watch --json` while the file is changed: a verdict for each save.
fn watched(options: &str) {
    let student = Student::new();
    let mut child = student
        .command(&format!("watch {NAME} --json {options}"))
        .stdout(Stdio::piped())
        .stderr(Stdio::inherit())
        .spawn()
        .expect("it runs");
    let (to, lines) = channel();
    let out = BufReader::new(child.stdout.take().expect("a pipe"));
    let reading = thread::spawn(move || {
        for line in out.lines().map_while(Result::ok) {
            if to.send(line).is_err() {
                break;
            }
        }
    });
    let next = || {
        // The libraries may have to be built first.
        let line = lines.recv_timeout(Duration::from_secs(240)).expect("a verdict");
        let json: Json = serde_json::from_str(&line).expect("JSON");
        (json["exercise"].as_str().map(str::to_owned), json["outcome"].as_str().map(str::to_owned))
    };
    let is = |exercise: &str, outcome: &str| (Some(exercise.to_owned()), Some(outcome.to_owned()));
    assert_eq!(next(), is(NAME, "not started"));
    student.solves(NAME, WRONG);
    assert_eq!(next(), is(NAME, "wrong"));
    student.solves(NAME, RIGHT);
    assert_eq!(next(), is(NAME, "passed"));
    // As many editors save: another file takes the name.
    let file = student.file("reflection");
    let beside = file.with_extension("swp");
    fs::write(&beside, course::find("reflection").expect("it").stub.replace("todo!()", "n"))
        .expect("written");
    fs::rename(&beside, &file).expect("renamed");
    assert_eq!(next(), is("reflection", "wrong"));
    child.kill().expect("it runs");
    let _ = child.wait();
    let _ = reading.join();
}

#[test]
fn watch_gives_a_verdict_on_every_save() {
    watched("");
}

#[test]
fn watch_can_look_again_and_again() {
    watched("--poll");
}
