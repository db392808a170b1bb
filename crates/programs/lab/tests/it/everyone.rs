//! Does everyone in a made-up class get what they should, whatever the others do, and however busy the machine is?

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value as Json;

use crate::grade::{Lecturer, files};
use crate::made_up_class::{Points, Student, Work, hand_in, honest, hostile, hostile_together};

/// Grades a made-up class and holds every verdict against what is known.
fn everyone_gets_what_they_should(students: &[Student]) {
    let lecturer = Lecturer::new(&[]);
    hand_in(&lecturer.path("class"), students);
    let begun = Instant::now();
    let said = lecturer.says("grade @class --out @report --quiet");
    println!("{} submissions in {:.1} s", students.len(), begun.elapsed().as_secs_f32());
    assert_eq!(said.code, Some(0), "{said:?}");
    let results = lecturer.results("report");
    let submissions = results["submissions"].as_array().expect("a list");
    assert_eq!(submissions.len(), students.len());
    let mut mistaken = Vec::new();
    for student in students {
        let submission = submissions.iter().find(|it| it["student"] == student.name);
        let submission = submission.unwrap_or_else(|| panic!("{:?} is missing", student.name));
        for verdict in submission["verdicts"].as_array().expect("a list") {
            let work = student.works.iter().find(|work| verdict["exercise"] == work.exercise.name);
            if !is_right(verdict, work) {
                mistaken.push(format!("{:?} in {}: {verdict:#}", student.name, verdict["exercise"]));
            }
        }
    }
    assert!(mistaken.is_empty(), "{} verdicts:\n{}", mistaken.len(), mistaken.join("\n"));
    for left in ["/tmp/lightlab-was-here", "/dev/shm/lightlab-was-here"] {
        assert!(!Path::new(left).exists(), "{left}");
    }
}

/// Whether a verdict is what is known of the work, or that there is none.
fn is_right(verdict: &Json, work: Option<&Work>) -> bool {
    let outcomes = work.map_or(&["missing"][..], |work| work.outcomes);
    let looks_like = work.and_then(|work| work.looks_like);
    let points = match work.map_or(Points::None, |work| work.points) {
        Points::All => verdict["points"] == verdict["of"],
        Points::None => verdict["points"] == 0,
        Points::Some => verdict["points"].as_u64() < verdict["of"].as_u64(),
    };
    outcomes.iter().any(|outcome| verdict["outcome"] == *outcome)
        && points
        && looks_like.is_none_or(|name| verdict["looks_like"]["misconception"] == name)
}

#[test]
fn in_a_class_of_eight_everyone_gets_what_they_should_and_harms_nobody() {
    let students: Vec<Student> =
        hostile_together().into_iter().chain((0..4).map(|number| few_of(honest(number * 11)))).collect();
    assert_eq!(students.len(), 8);
    everyone_gets_what_they_should(&students);
}

/// A student who has handed in a part of the course, so that all four together have most of it.
fn few_of(student: Student) -> Student {
    let at: usize = student.name.bytes().map(usize::from).sum();
    let works = student.works.into_iter().enumerate().filter(|(place, _)| (place + at).is_multiple_of(3));
    Student { name: student.name, works: works.map(|(_, work)| work).collect() }
}

#[test]
#[ignore = "takes minutes: the nightly script runs it with --profile grading"]
fn in_a_class_of_thirty_six_everyone_gets_what_they_should() {
    let students: Vec<Student> =
        hostile().into_iter().chain((0..4).map(|number| honest(number * 11))).collect();
    everyone_gets_what_they_should(&students);
}

#[test]
#[ignore = "takes minutes: the nightly script runs it with --profile grading"]
fn in_a_class_of_two_hundred_everyone_gets_what_they_should() {
    let hostile = hostile();
    let honest = (0..200 - hostile.len()).map(honest);
    let students: Vec<Student> = honest.chain(hostile).collect();
    everyone_gets_what_they_should(&students);
}

/// By hand: `cargo test --profile grading -p lab --test it class_of_sixty -- --ignored --nocapture`.
#[test]
#[ignore = "takes many minutes: the nightly script runs it with --profile grading"]
fn a_class_of_sixty_gets_the_same_report_idle_and_beside_sixteen_endless_loops() {
    let lecturer = Lecturer::new(&[]);
    let hostile = hostile();
    let honest = (0..60 - hostile.len()).map(|number| honest(3 * number));
    let students: Vec<Student> = honest.chain(hostile).collect();
    hand_in(&lecturer.path("class"), &students);
    let formats = "gradescope,codegrade-v1,codegrade-v2,junit,exercism,github-classroom,prairielearn";
    let grade = |report: &str| {
        let begun = Instant::now();
        lecturer.grades(&format!("grade @class --out @{report} --quiet --format {formats}"));
        println!("{report}: {} submissions in {:.0} s", students.len(), begun.elapsed().as_secs_f32());
    };
    grade("idle");
    let loops = Loops::start(16);
    grade("loaded");
    drop(loops);
    let differences = differences(&lecturer.path("idle"), &lecturer.path("loaded"));
    assert!(differences.is_empty(), "{} files:\n{}", differences.len(), differences.join("\n"));
}

/// What differs between two reports: of a submission's verdicts which, of other files their names. No file holds a time, so none is left out.
fn differences(one: &Path, other: &Path) -> Vec<String> {
    let (one, other) = (files(one), files(other));
    assert!(one.len() > 60, "only {} files", one.len());
    let mut names: Vec<&String> = one.keys().chain(other.keys()).collect();
    names.sort();
    names.dedup();
    let differ = names.into_iter().filter(|name| one.get(*name) != other.get(*name));
    differ.map(|name| format!("{name}: {}", verdicts(one.get(name), other.get(name)))).collect()
}

/// Which verdicts of two files in `judged` differ, and how.
fn verdicts(one: Option<&Vec<u8>>, other: Option<&Vec<u8>>) -> String {
    let parsed = |bytes: Option<&Vec<u8>>| serde_json::from_slice::<Json>(bytes?).ok();
    let (Some(one), Some(other)) = (parsed(one), parsed(other)) else { return "differs".to_owned() };
    let (Some(one), Some(other)) = (one["verdicts"].as_array(), other["verdicts"].as_array()) else {
        return "differs".to_owned();
    };
    let pairs = one.iter().zip(other).filter(|(a, b)| a != b);
    let words = pairs.map(|(a, b)| {
        let said = |it: &Json| format!("{} {} {}", it["outcome"], it["points"], it["sentence"]);
        format!("{}: {} / {}", a["exercise"], said(a), said(b))
    });
    words.collect::<Vec<_>>().join("; ")
}

/// Says to a program that it is one of the loops: started by anybody else, it does nothing.
const LOOP: &str = "LIGHTLAB_TEST_LOOP";

/// Programs that keep processors busy until this is dropped.
struct Loops(Vec<Child>);

impl Loops {
    fn start(count: usize) -> Self {
        let tests = std::env::current_exe().expect("the path of these tests");
        let start = |_| {
            let mut command = Command::new(&tests);
            command.args(["--exact", "everyone::keeps_a_processor_busy", "--ignored"]).env(LOOP, "");
            // They end with these tests, however these end: their input ends then.
            command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null());
            command.spawn().expect("a loop starts")
        };
        Self((0..count).map(start).collect())
    }
}

impl Drop for Loops {
    fn drop(&mut self) {
        for child in &mut self.0 {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

#[test]
#[ignore = "no test: the one above starts it as a program of its own"]
fn keeps_a_processor_busy() {
    const AT_MOST: Duration = Duration::from_secs(3600);
    if std::env::var_os(LOOP).is_none() {
        return;
    }
    std::thread::spawn(|| {
        let _ = std::io::copy(&mut std::io::stdin(), &mut std::io::sink());
        std::process::exit(0);
    });
    let begun = Instant::now();
    while begun.elapsed() < AT_MOST {
        std::hint::spin_loop();
    }
}
