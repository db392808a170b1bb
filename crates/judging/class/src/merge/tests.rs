use std::fs;

use tempfile::TempDir;

use super::*;
use crate::checkpoint::Conditions;
use crate::report_folder::files;
use crate::results::{Course, Outcome, Picture, Seeds, Verdict};

/// A class of five in the folder of a test, judged in parts.
struct Machines(TempDir);

impl Machines {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// Writes the part of a class that falls to `share`, as a machine that has these submissions does: id and what was handed in.
    fn grades(&self, folder: &str, class: &[(&str, &str)], share: &str) -> PathBuf {
        let report = self.0.path().join(folder);
        let results = part(class, share.parse().unwrap());
        for submission in &results.submissions {
            let path = checkpoint::path(&report, &submission.id);
            write(&path, &kept_of(submission).bytes().unwrap());
        }
        for (name, bytes) in files(&results, &[]).filter(|(name, _)| name.as_os_str() == RESULTS) {
            write(&report.join(name), &bytes);
        }
        report
    }

    /// The parts of a whole class.
    fn grade_all(&self, class: &[(&str, &str)], of: usize) -> Vec<PathBuf> {
        (1..=of).map(|k| self.grades(&format!("part{k}"), class, &format!("{k}/{of}"))).collect()
    }
}

const CLASS: [(&str, &str); 5] = [("ada", "1f"), ("bob", "2e"), ("cleo", "3d"), ("dan", "4c"), ("zoe", "5b")];

fn part(class: &[(&str, &str)], share: Partition) -> Results {
    let listed = class.iter().map(|(id, sum)| Listed { id: (*id).into(), fingerprint: (*sum).into() });
    let mut results = Results {
        schema: SCHEMA.into(),
        version: VERSION,
        partition: Some(share.to_string()),
        course: Course { version: "0123456789abcdef".into(), exercises: Vec::new() },
        seeds: Seeds { seed: 7, per_student: false },
        sandboxed: true,
        remarks: vec!["nobody's submission, and ignored: notes.txt".into()],
        roster: listed.clone().collect(),
        submissions: listed
            .enumerate()
            .filter(|(place, it)| share.holds(&it.id, *place, class.len()))
            .map(|(place, it)| submission(&it, place as u32))
            .collect(),
        digest: None,
    };
    results.digest = Some(results.digest_of_content());
    results
}

fn submission(listed: &Listed, points: u32) -> Submission {
    let verdict = Verdict {
        exercise: "lambert".into(),
        token: "lambert.7.0123abcd".into(),
        outcome: Outcome::Wrong,
        sentence: None,
        compiler: None,
        line: None,
        points,
        of: 10,
        laws: Vec::new(),
        looks_like: None,
        picture: Some(Picture { svg: "<svg/>".into(), text: None }),
        printed: String::new(),
    };
    Submission {
        id: listed.id.clone(),
        student: listed.id.clone(),
        source: listed.id.clone(),
        fingerprint: listed.fingerprint.clone(),
        seed: 7,
        points,
        of: 10,
        notices: Vec::new(),
        verdicts: vec![verdict],
    }
}

fn kept_of(submission: &Submission) -> Checkpoint {
    let conditions = Conditions {
        course: "0123456789abcdef".into(),
        fingerprint: submission.fingerprint.clone(),
        seed: 7,
        sandboxed: true,
        limits: String::new(),
    };
    Checkpoint::new(conditions, submission.verdicts.clone())
}

fn write(path: &Path, bytes: &[u8]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, bytes).unwrap();
}

/// Replaces the one occurrence of a text in a file, as somebody with an editor does.
fn edit(path: &Path, old: &str, new: &str) {
    let text = fs::read_to_string(path).unwrap();
    assert_eq!(text.matches(old).count(), 1, "{old} in {text}");
    fs::write(path, text.replace(old, new)).unwrap();
}

/// The parts do not become a class; the error says all of these.
#[track_caller]
fn refused(parts: &[PathBuf], says: &[&str]) {
    let error = merge(parts).expect_err("merged");
    for part in says {
        assert!(error.to_string().contains(part), "no {part:?} in: {error}");
    }
    assert!(!error.remedy().is_empty());
}

#[test]
fn the_whole_holds_everybody_and_nothing_of_the_parts() {
    let machines = Machines::new();
    for share in ["", "slice:", "hash:"] {
        let parts: Vec<PathBuf> = [2, 1, 3]
            .map(|k| machines.grades(&format!("{share}{k}"), &CLASS, &format!("{share}{k}/3")))
            .into();
        let whole = merge(&parts).unwrap();
        assert_eq!(
            whole.submissions.iter().map(|it| it.id.as_str()).collect::<Vec<_>>(),
            CLASS.map(|it| it.0)
        );
        assert!(whole.submissions.iter().all(|it| it.verdicts[0].picture.is_some()));
        assert_eq!((whole.partition, whole.roster, whole.digest), (None, Vec::new(), None));
        assert_eq!(whole.remarks, ["nobody's submission, and ignored: notes.txt"]);
    }
}

#[test]
fn parts_of_different_folders_are_refused_and_the_student_is_named() {
    let machines = Machines::new();
    let one = machines.grades("one", &CLASS, "slice:1/2");
    // The second machine lacks ada: bob … zoe are judged by somebody, or so it seems.
    let late = machines.grades("late", &CLASS[1..], "slice:2/2");
    refused(&[one.clone(), late.clone()], &["one lists ada"]);
    refused(&[late, one.clone()], &["one lists ada"]);
    let mut other = CLASS;
    other[0].1 = "99";
    let newer = machines.grades("newer", &other, "slice:2/2");
    refused(&[one, newer], &["newer", "what ada handed in differs"]);
}

#[test]
fn shares_that_do_not_fit_together_are_refused() {
    let machines = Machines::new();
    let parts = machines.grade_all(&CLASS, 2);
    refused(&parts[1..], &["of 2 parts, these are missing: 1"]);
    refused(&[parts[0].clone(), parts[1].clone(), parts[0].clone()], &["both hold ada"]);
    for other in ["slice:2/2", "2/3"] {
        let strange = machines.grades("strange", &CLASS, other);
        refused(&[parts[0].clone(), strange], &["the way of sharing (--partition) differs"]);
    }
}

#[test]
fn a_report_that_is_no_part_is_refused() {
    let machines = Machines::new();
    let parts = machines.grade_all(&CLASS, 1);
    let mut whole = merge(&parts).unwrap();
    for partition in [None, Some("count:1/1".to_owned())] {
        whole.partition = partition;
        write(&parts[0].join(RESULTS), &serde_json::to_vec(&whole).unwrap());
        refused(&parts, &["part1/results.json is not a part of a class"]);
    }
}

#[test]
fn points_changed_by_hand_are_refused_and_the_file_is_named() {
    let machines = Machines::new();
    for (old, new) in [
        ("\"id\": \"bob\",\n      \"student\": \"bob\"", "\"id\": \"bob\",\n      \"student\": \"Bob\""),
        ("      \"points\": 1,\n      \"of\"", "      \"points\": 10,\n      \"of\""),
        ("          \"points\": 1,\n          \"of\"", "          \"points\": 10,\n          \"of\""),
        ("\"fingerprint\": \"1f\"", "\"fingerprint\": \"1e\""),
        ("\"sandboxed\": true", "\"sandboxed\": false"),
    ] {
        let parts = machines.grade_all(&CLASS, 2);
        edit(&parts[1].join(RESULTS), old, new);
        refused(&parts, &["part2/results.json was changed after it was written"]);
    }
    for (old, new) in [("\"points\":1,", "\"points\":10,"), ("<svg/>", "<svg>10 of 10</svg>")] {
        let parts = machines.grade_all(&CLASS, 2);
        edit(&parts[1].join("judged/bob.json"), old, new);
        refused(&parts, &["part2/judged/bob.json was changed after it was written"]);
        assert!(Checkpoint::read(&parts[1], "bob").is_none(), "--resume takes it");
        assert!(Checkpoint::read(&parts[1], "dan").is_some());
    }
    let parts = machines.grade_all(&CLASS, 2);
    let crlf = fs::read_to_string(parts[1].join(RESULTS)).unwrap().replace('\n', "\r\n");
    fs::write(parts[1].join(RESULTS), crlf).unwrap();
    assert!(merge(&parts).is_ok(), "line ends are no content");
}

#[test]
fn a_submission_that_changed_while_it_was_judged_is_refused() {
    let machines = Machines::new();
    let parts = machines.grade_all(&CLASS, 2);
    let mut results = read(&parts[0]).unwrap();
    results.submissions[0].fingerprint = "77".into();
    results.digest = Some(results.digest_of_content());
    write(&parts[0].join(RESULTS), &serde_json::to_vec(&results).unwrap());
    refused(&parts, &["the submission ada changed while", "part1"]);
    results.submissions.remove(0);
    results.digest = Some(results.digest_of_content());
    write(&parts[0].join(RESULTS), &serde_json::to_vec(&results).unwrap());
    refused(&parts, &["ada is in the class, but in none of the parts"]);
}
