//! Whose is it, and which attempt? What the names say that learning platforms give to folders and files.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use regex_lite::{Captures, Regex};

/// What a name in the class's folder says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Named {
    /// What tells students apart: two of one name have different numbers.
    pub(super) key: String,
    /// The student's name, or what there is of it.
    pub(super) student: String,
    /// Orders the attempts of one student; a later one is greater.
    pub(super) attempt: String,
    /// Whether the name says that it came late.
    pub(super) late: bool,
    /// A loose file's own name, without what the platform put before it.
    pub(super) own_name: Option<String>,
}

/// What bears a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Folder,
    /// A file, archives among them.
    File,
}

type Reading = fn(&Captures<'_>) -> Named;

/// What platforms write, each with what it means.
static PLATFORMS: LazyLock<Vec<(Kind, Regex, Reading)>> = LazyLock::new(|| {
    let forms: [(Kind, &str, Reading); 4] = [
        // Moodle, a folder: "Ada Lovelace_123456_assignsubmission_file_".
        (Kind::Folder, r"(?s)^(.+)_(\d+)_assignsubmission_([a-z]+)_?$", |found| Named {
            key: format!("{}_{}", &found[1], &found[2]),
            // Beside files there may be a text that was typed into the page.
            attempt: u8::from(&found[3] == "file").to_string(),
            ..plain(&found[1])
        }),
        // Brightspace, a folder: "12345-67890 - Ada Lovelace - Nov 20, 2026 1011 AM".
        (
            Kind::Folder,
            r"(?s)^(\d+)-\d+ - (.+?) - ([A-Z][a-z]{2})[a-z]* (\d{1,2}), (\d{4}) (\d{1,2})(\d{2}) ([AP])M$",
            |found| Named {
                key: format!("{}_{}", &found[2], &found[1]),
                attempt: moment(found),
                ..plain(&found[2])
            },
        ),
        // Blackboard, loose: "Lab 1_s123456_attempt_2026-11-20-10-11-12_lambert.rs".
        // What comes first was written by the platform; a student's own file name comes last, whatever it looks like. A user's name may hold the
        // separator, so that all before the attempt tells students apart.
        (
            Kind::File,
            r"(?s)^(.*?)_attempt_(\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d)(?:_(.+)|(?:\.[a-z0-9]+)?)$",
            |found| Named {
                key: found[1].to_owned(),
                attempt: found[2].to_owned(),
                own_name: found.get(3).map(|it| it.as_str().to_owned()),
                ..plain(found[1].rsplit('_').next().unwrap_or(&found[1]))
            },
        ),
        // Canvas, loose: "lovelaceada_LATE_12345_67890_lambert.rs".
        (Kind::File, r"(?s)^([^_]+)(_LATE)?_(\d+)_(\d+)_(.+)$", |found| Named {
            key: format!("{}_{}", &found[1], &found[3]),
            // The number is that of the file: of two with the same name the greater is the newer.
            attempt: format!("{:0>20}", &found[4]),
            late: found.get(2).is_some(),
            own_name: Some(found[5].to_owned()),
            ..plain(&found[1])
        }),
    ];
    forms
        .into_iter()
        .filter_map(|(kind, form, reading)| Some((kind, Regex::new(form).ok()?, reading)))
        .collect()
});

/// What people and browsers append: "(2)", "attempt 2", "late".
static ENDINGS: LazyLock<Option<Regex>> = LazyLock::new(|| {
    Regex::new(r"(?is)^(.+?)(?:[ _-]+(late|te laat)|[ _-]*\((\d+)\)|[ _-]+(?:attempt|poging)[ _-]?(\d+))$")
        .ok()
});

/// Reads what a platform wrote; `None` where it is a name that a person chose.
pub(super) fn of_a_platform(name: &str, kind: Kind) -> Option<Named> {
    PLATFORMS
        .iter()
        .filter(|(of, _, _)| *of == kind)
        .find_map(|(_, form, reading)| form.captures(name).map(|it| reading(&it)))
}

/// A name that a person chose, perhaps with "(2)", "attempt 2", "late" behind it. These say something only where `others` has the name without
/// them, or they are words: "Group (1)" and "Group (2)" are two.
pub(super) fn of_a_person(name: &str, others: &BTreeSet<String>) -> Named {
    let mut named = plain(name);
    let mut attempt = 0;
    while let Some(found) = ENDINGS.as_ref().and_then(|endings| endings.captures(&named.student)) {
        if found.get(3).is_some() && !others.contains(&found[1]) {
            break;
        }
        named.late |= found.get(2).is_some();
        let number = found.get(3).or(found.get(4)).and_then(|number| number.as_str().parse().ok());
        attempt = attempt.max(number.unwrap_or(0_u64));
        let student = found[1].to_owned();
        named.student = student;
    }
    named.key.clone_from(&named.student);
    named.attempt = format!("{}{attempt:0>20}", u8::from(named.late));
    named
}

pub(super) fn plain(name: &str) -> Named {
    Named {
        key: name.to_owned(),
        student: name.to_owned(),
        attempt: String::new(),
        late: false,
        own_name: None,
    }
}

/// A date such as "Nov 20, 2026 1011 AM" in an order that sorts.
fn moment(found: &Captures<'_>) -> String {
    const MONTHS: &str = "JanFebMarAprMayJunJulAugSepOctNovDec";
    let month = MONTHS.find(&found[3]).unwrap_or(0) / 3 + 1;
    let hour = found[6].parse::<u32>().unwrap_or(0) % 12 + if &found[8] == "P" { 12 } else { 0 };
    format!("{}-{month:02}-{:0>2}-{hour:02}-{}", &found[5], &found[4], &found[7])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> (String, String, String, bool) {
        let others = BTreeSet::from(["Ada".to_owned()]);
        let named = of_a_platform(name, Kind::Folder).unwrap_or_else(|| of_a_person(name, &others));
        (named.key, named.student, named.attempt, named.late)
    }

    #[test]
    fn a_plain_name_is_the_student() {
        for name in ["Ada Lovelace", "group-2", "=cmd()\n<script>", "Group (1)", "2026_11_20_ada"] {
            assert_eq!(folder(name).0, name);
            assert_eq!(folder(name).1, name);
        }
    }

    #[test]
    fn moodle_numbers_tell_namesakes_apart_and_files_count_more_than_words() {
        let [one, other] = ["1", "2"].map(|n| folder(&format!("Ada_Lovelace_{n}_assignsubmission_file_")));
        assert_eq!(one.1, "Ada_Lovelace");
        assert_eq!(one.1, other.1);
        assert_ne!(one.0, other.0);
        let words = folder("Ada_Lovelace_1_assignsubmission_onlinetext_");
        assert!(words.0 == one.0 && words.2 < one.2);
    }

    #[test]
    fn of_two_attempts_the_later_is_greater() {
        let names = [
            ("1-2 - Ada - Nov 9, 2026 1011 AM", "1-3 - Ada - Nov 10, 2026 912 AM"),
            ("1-2 - Ada - Nov 10, 2026 912 AM", "1-3 - Ada - Nov 10, 2026 112 PM"),
            ("Ada", "Ada (2)"),
            ("Ada attempt 9", "Ada attempt 10"),
            ("Ada_attempt_9", "Ada-late"),
            ("Ada", "Ada_late"),
        ];
        for (earlier, later) in names {
            let (a, b) = (folder(earlier), folder(later));
            assert_eq!((&a.0, &a.1), (&b.0, &b.1), "{earlier}, {later}");
            assert!(a.2 < b.2, "{earlier}, {later}");
        }
        assert!(folder("Ada_late").3 && !folder("Ada").3);
    }

    #[test]
    fn loose_files_know_their_own_name() {
        let file = |name| of_a_platform(name, Kind::File);
        let canvas = file("lovelaceada_LATE_123_456_ray_color.rs").unwrap();
        assert_eq!(canvas.own_name.as_deref(), Some("ray_color.rs"));
        assert!(canvas.late && canvas.key == "lovelaceada_123");
        let blackboard = file("Lab 1_s123_attempt_2026-11-20-10-11-12_ray_color.rs").unwrap();
        assert_eq!(
            (blackboard.student.as_str(), blackboard.own_name.as_deref()),
            ("s123", Some("ray_color.rs"))
        );
        assert_eq!(file("Lab_s123_attempt_2026-11-20-10-11-12.txt").unwrap().own_name, None);
        assert_eq!(file("lambert.rs"), None);
    }

    #[test]
    fn a_student_cannot_name_a_file_into_anothers_submission() {
        let name = "Lab_eve_attempt_2026-01-01-00-00-00_x_ada_attempt_2099-01-01-00-00-00_lambert.rs";
        let named = of_a_platform(name, Kind::File).unwrap();
        assert_eq!((named.key.as_str(), named.student.as_str()), ("Lab_eve", "eve"));
    }
}
