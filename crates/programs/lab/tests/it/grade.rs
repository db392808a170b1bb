//! A class graded: reports, going on after the end, shares put together, changes.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value as Json;
use tempfile::TempDir;

use crate::desk::{LAB, Said, root};

/// A class of small submissions, and a place for reports.
pub(crate) struct Lecturer {
    folder: TempDir,
}

impl Lecturer {
    /// Students with one exercise each: the body of `rotate_about_point`.
    pub(crate) fn new(students: &[(&str, &str)]) -> Self {
        let lecturer = Self { folder: tempfile::tempdir().expect("a folder") };
        for (name, body) in students {
            lecturer.hands_in(name, body);
        }
        lecturer
    }

    fn hands_in(&self, student: &str, body: &str) {
        let exercise = course::find("rotate_about_point").expect("the exercise");
        let file = self.path("class").join(student).join("rotate_about_point.rs");
        fs::create_dir_all(file.parent().expect("a folder")).expect("made");
        fs::write(file, exercise.stub.replace("todo!()", body)).expect("written");
    }

    pub(crate) fn path(&self, name: &str) -> std::path::PathBuf {
        self.folder.path().join(name)
    }

    fn command(&self, line: &str) -> Command {
        let here = self.folder.path().display().to_string();
        let mut command = Command::new(LAB);
        command.args(line.split_whitespace().map(|word| word.replace('@', &format!("{here}/"))));
        command.current_dir(root()).stdin(Stdio::null());
        command
    }

    pub(crate) fn says(&self, line: &str) -> Said {
        Said::from(self.command(line).output().expect("it runs"))
    }

    /// It went well; what was said, if it did not.
    #[track_caller]
    pub(crate) fn grades(&self, line: &str) {
        let said = self.says(line);
        assert_eq!(said.code, Some(0), "{line}: {said:?}");
    }

    /// It is refused, and the words tell why and what to do.
    #[track_caller]
    fn refuses(&self, line: &str, words: &[&str]) {
        let said = self.says(line);
        assert_eq!(said.code, Some(2), "{line}: {said:?}");
        for word in words.iter().chain(&["\nhelp: "]) {
            assert!(said.err.contains(word), "no {word:?}: {said:?}");
        }
    }

    pub(crate) fn results(&self, report: &str) -> Json {
        let bytes = fs::read(self.path(report).join("results.json")).expect("results");
        serde_json::from_slice(&bytes).expect("JSON")
    }
}

const RIGHT: &str = "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";
const NOT_MOVED_BACK: &str = "Mat3::from_angle(theta) * Mat3::from_translation(-p)";

/// Every file of a folder, by its path.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        if path.is_dir() {
            all.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            all.insert(name, fs::read(&path).expect("read"));
        }
    }
    all
}

fn same(one: &Path, other: &Path) {
    let (one, other) = (files(one), files(other));
    assert_eq!(one.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
    for (name, bytes) in &one {
        assert!(bytes == &other[name], "{name} differs");
    }
}

#[test]
fn a_class_is_graded_and_every_outcome_is_its_own() {
    let lecturer = Lecturer::new(&[
        ("ada", RIGHT),
        ("bob", NOT_MOVED_BACK),
        ("cleo", "loop {}"),
        ("dan", "does not compile"),
        ("eve", "std::process::exit(0)"),
        ("fay", "todo!()"),
    ]);
    let said = lecturer.says("grade @class --out @report");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(said.out.contains("6 submissions"), "{said:?}");
    let results = lecturer.results("report");
    let outcomes: Vec<(&str, &str, u64)> = results["submissions"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|it| {
            let verdict = &it["verdicts"][0];
            (
                it["id"].as_str().expect("an id"),
                verdict["outcome"].as_str().expect("a word"),
                it["points"].as_u64().expect("points"),
            )
        })
        .collect();
    let expected = [
        ("ada", "passed", 10),
        ("bob", "wrong", 6),
        ("cleo", "timed_out", 0),
        ("dan", "does_not_compile", 0),
        ("eve", "exited", 0),
        ("fay", "not_started", 0),
    ];
    assert_eq!(outcomes, expected);
    let bob = &results["submissions"][1]["verdicts"][0];
    assert_eq!(bob["looks_like"]["misconception"], "not_moved_back");
    assert!(bob["picture"].is_null(), "pictures stand in the feedback");
    for name in ["class.html", "grades.csv", "feedback/bob.html", "feedback/bob.md", "judged/bob.json"] {
        assert!(lecturer.path("report").join(name).is_file(), "{name}");
    }
    let feedback = fs::read_to_string(lecturer.path("report/feedback/bob.html")).expect("feedback");
    assert!(feedback.contains("<svg") && feedback.contains("not back"), "{feedback}");
}

#[test]
fn a_second_run_gives_the_same_bytes_and_another_seed_other_inputs() {
    let lecturer = Lecturer::new(&[("ada", RIGHT), ("bob", NOT_MOVED_BACK)]);
    lecturer.grades("grade @class --out @one");
    lecturer.grades("grade @class --out @two --jobs 1 --quiet");
    same(&lecturer.path("one"), &lecturer.path("two"));
    lecturer.grades("grade @class --out @three --seeds per-student --seed 7");
    let three = lecturer.results("three");
    assert_eq!(three["seeds"], serde_json::json!({ "seed": 7, "per_student": true }));
    assert_ne!(three["submissions"][0]["seed"], three["submissions"][1]["seed"]);
    assert_eq!(three["submissions"][0]["points"], 10);
}

#[test]
fn shares_put_together_are_the_whole_to_the_byte_and_nothing_else_is_put_together() {
    let lecturer =
        Lecturer::new(&[("ada", RIGHT), ("bob", NOT_MOVED_BACK), ("cleo", "todo!()"), ("dan", "{")]);
    fs::create_dir(lecturer.path("class/.eve")).expect("made");
    lecturer.grades("grade @class --out @whole");
    for part in 1..=3 {
        let said = lecturer.says(&format!("grade @class --out @part{part} --partition {part}/3"));
        assert_eq!(said.code, Some(0), "{said:?}");
    }
    assert_eq!(lecturer.results("part2")["partition"], "count:2/3");
    let said = lecturer.says("merge @part3 @part1 @part2 --out @merged");
    assert_eq!(said.code, Some(0), "{said:?}");
    same(&lecturer.path("whole"), &lecturer.path("merged"));
    let remark = lecturer.results("merged")["remarks"][0].to_string();
    assert!(remark.contains("hidden") && remark.contains(".eve"), "{remark}");

    lecturer.refuses("merge @part1 @part3 --out @torn", &["of 3 parts, these are missing: 2"]);
    lecturer.refuses("merge @part1 @part2 @part3 @part1 --out @torn", &["both hold ada", "each part once"]);
    lecturer.refuses("merge @whole --out @torn", &["whole/results.json is not a part", "--partition K/N"]);
    // Another machine has the submissions as they were before ada handed in.
    fs::rename(lecturer.path("class/ada"), lecturer.path("ada")).expect("moved");
    lecturer.grades("grade @class --out @early --partition 2/3 --quiet");
    lecturer.refuses("merge @part1 @early @part3 --out @torn", &["part1 lists ada", "early", "--resume"]);
    let judged = lecturer.path("part2/judged/bob.json");
    let text = fs::read_to_string(&judged).expect("read");
    let raised = text.replacen("\"points\":6", "\"points\":10", 1);
    assert_ne!(raised, text);
    fs::write(&judged, raised).expect("written");
    lecturer
        .refuses("merge @part1 @part2 @part3 --out @torn", &["part2/judged/bob.json was changed", "again"]);
    assert!(!lecturer.path("torn").exists());
}

#[test]
fn a_run_that_was_killed_goes_on_and_judges_nothing_twice() {
    let lecturer = Lecturer::new(&[("ada", RIGHT), ("bob", NOT_MOVED_BACK), ("cleo", RIGHT)]);
    // Judging it takes so long that the run is still at it when it is killed.
    lecturer.hands_in("zoe", "loop {}");
    let mut run =
        lecturer.command("grade @class --out @killed --seed 5 --jobs 1 --quiet").spawn().expect("started");
    while !lecturer.path("killed/judged/cleo.json").is_file() {
        assert!(run.try_wait().expect("asked").is_none(), "it was over too soon");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    run.kill().expect("killed");
    run.wait().expect("ended");
    assert!(!lecturer.path("killed/results.json").exists());

    lecturer.hands_in("zoe", "{");
    lecturer.grades("grade @class --out @whole --seed 5");
    let said = lecturer.says("grade @class --out @killed");
    assert!(said.code == Some(2) && said.err.contains("--resume"), "{said:?}");
    let said = lecturer.says("grade @class --out @killed --resume");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(said.err.matches(", known").count() >= 3, "{said:?}");
    same(&lecturer.path("whole"), &lecturer.path("killed"));

    lecturer.hands_in("ada", NOT_MOVED_BACK);
    let said = lecturer.says("grade @class --out @killed --resume");
    assert_eq!(said.err.matches(", known").count(), 3, "{said:?}");
    let results = lecturer.results("killed");
    assert_eq!(results["submissions"][0]["verdicts"][0]["outcome"], "wrong");
}

#[test]
fn changes_are_listed_with_the_laws_that_made_them() {
    let lecturer = Lecturer::new(&[("ada", NOT_MOVED_BACK), ("bob", RIGHT)]);
    lecturer.grades("grade @class --out @old");
    lecturer.hands_in("ada", RIGHT);
    let said = lecturer.says("grade @class --out @new --compare @old");
    assert_eq!(said.code, Some(1), "{said:?}");
    let line = said.out.lines().find(|line| line.starts_with("ada ")).expect("a line");
    assert!(
        line.contains("6 -> 10")
            && line.contains("wrong -> passed")
            && line.contains("the_centre_stays 0 -> 3"),
        "{line}"
    );
    assert!(!said.out.contains("bob"), "{said:?}");
    let said = lecturer.says("grade @class --out @newer --compare @class");
    assert!(said.code == Some(2) && said.err.contains("results.json"), "{said:?}");
}

#[test]
fn what_cannot_be_graded_is_said() {
    let lecturer = Lecturer::new(&[("ada", RIGHT)]);
    for (line, words) in [
        ("grade @nowhere --out @report", "cannot read"),
        ("grade @class/ada --out @report", "no submission"),
        ("grade @class --out @class/report", "among the submissions"),
        ("grade @class --out @report --partition 3/2", "a share is K/N"),
        ("grade @class --out @report --seed soon", "the word fresh"),
        ("merge @class --out @report", "results.json"),
    ] {
        let said = lecturer.says(line);
        assert_eq!(said.code, Some(2), "{line}: {said:?}");
        assert!(said.err.contains(words), "{line}: {said:?}");
    }
    assert!(!lecturer.path("class/report").exists());
}

#[test]
fn a_report_that_cannot_be_written_is_an_error_and_what_was_judged_is_kept() {
    let lecturer = Lecturer::new(&[("ada", RIGHT)]);
    // A folder of the file's name is in the way, as a full disk would be.
    fs::create_dir_all(lecturer.path("report/grades.csv/in-the-way")).expect("made");
    let said = lecturer.says("grade @class --out @report --resume");
    assert!(
        said.code == Some(2) && said.err.contains("cannot write") && said.err.contains("grades.csv"),
        "{said:?}"
    );
    assert!(said.err.contains("--resume"), "{said:?}");
    assert!(!lecturer.path("report/results.json").exists());
    assert!(files(&lecturer.path("report")).keys().all(|name| !name.ends_with(".tmp")));

    fs::remove_dir_all(lecturer.path("report/grades.csv")).expect("removed");
    let said = lecturer.says("grade @class --out @report --resume");
    assert!(said.code == Some(0) && said.err.contains(", known"), "{said:?}");

    fs::create_dir_all(lecturer.path("other/judged/ada.json/in-the-way")).expect("made");
    let said = lecturer.says("grade @class --out @other --resume");
    assert!(
        said.code == Some(2) && said.err.contains("ada.json") && said.err.contains("--resume"),
        "{said:?}"
    );
}

#[test]
fn an_autograder_and_the_students_edition_are_written_into_new_folders() {
    let lecturer = Lecturer::new(&[]);
    for platform in ["gradescope", "github-classroom", "codegrade"] {
        lecturer.grades(&format!("export {platform} @{platform}"));
        assert!(lecturer.path(platform).join("README.md").is_file(), "{platform}");
    }
    lecturer.grades("handout @handout");
    let stub = fs::read_to_string(lecturer.path("handout/exercises/lighting/lambert.rs")).expect("a stub");
    assert_eq!(stub, course::find("lambert").expect("the exercise").stub);
    let said = lecturer.says("handout @handout");
    assert!(said.code == Some(2) && said.err.contains("is not empty"), "{said:?}");

    #[cfg(unix)]
    for (script, runs) in [("gradescope/autograder/run_autograder", true), ("gradescope/README.md", false)] {
        use std::os::unix::fs::PermissionsExt;
        let mode = fs::metadata(lecturer.path(script)).expect("there").permissions().mode();
        assert_eq!(mode & 0o111 != 0, runs, "{script}");
    }
}
