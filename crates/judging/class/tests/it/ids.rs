//! Is a student's id the same in every file of a report, whatever the student is called?

use std::collections::BTreeSet;
use std::fs;

use class::format::Format;
use class::intake::Class;
use class::results::{Results, Submission};

use crate::made_up::{class, perfect};
use crate::reports::csv::strict_csv;

/// Names that spreadsheets compute, shells take for flags, and file systems refuse.
const NAMES: [&str; 14] =
    ["-1+1", "-1", "+1", "=1+1", "@sum", "-", "--", "-rf", "-ada", "'-1", "1-1", "_1", "\t-1", "con"];

/// A report of students with these names, as their folders would make it.
fn results() -> Results {
    let folder = tempfile::tempdir().expect("a folder");
    for name in NAMES {
        fs::create_dir(folder.path().join(name)).expect("made");
    }
    let entries = Class::read(folder.path()).expect("a class").entries;
    let submissions = entries.into_iter().map(|it| Submission {
        id: it.id,
        student: it.student,
        source: it.source,
        ..perfect()
    });
    Results { submissions: submissions.collect(), ..class(0) }
}

#[test]
fn the_id_in_every_table_is_the_id_in_the_names_of_files() {
    let results = results();
    let ids: BTreeSet<&str> = results.submissions.iter().map(|it| it.id.as_str()).collect();
    assert_eq!(ids.len(), NAMES.len());
    let files: Vec<(String, String)> = class::files(&results, &Format::ALL)
        .map(|(path, bytes)| {
            (path.to_str().expect("a path").to_owned(), String::from_utf8(bytes).expect("text"))
        })
        .collect();
    let text = |name: &str| &files.iter().find(|(path, _)| path == name).expect(name).1;

    let rows = strict_csv(text("grades.csv").trim_start_matches('\u{feff}'));
    assert_eq!(rows[1..].iter().map(|row| row[0].as_str()).collect::<BTreeSet<_>>(), ids);
    let page = text("class.html");
    for id in &ids {
        assert!(page.contains(&format!("<td class=\"id\">{id}</td>")), "{id} in the page");
        assert!(page.contains(&format!("href=\"feedback/{id}.html\"")), "{id} is linked");
    }
    let folders: Vec<String> =
        Format::ALL.iter().map(|it| it.name().to_owned()).chain(["feedback".to_owned()]).collect();
    for folder in folders {
        let names: BTreeSet<&str> = files
            .iter()
            .filter_map(|(path, _)| path.strip_prefix(&format!("{folder}/"))?.split('.').next())
            .collect();
        assert_eq!(names, ids, "{folder}");
    }
    let json: serde_json::Value = serde_json::from_str(text("results.json")).expect("JSON");
    let listed: BTreeSet<&str> = json["submissions"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|it| it["id"].as_str().expect("an id"))
        .collect();
    assert_eq!(listed, ids);
}
