//! Whose is it, and which attempt? What the names say that learning platforms give to folders and files.

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

type Reading = fn(&Captures<'_>) -> Named;

/// What platforms write, each with what it means.
static PLATFORMS: LazyLock<Vec<(Regex, Reading)>> = LazyLock::new(|| {
    let forms: [(&str, Reading); 4] = [
        // Moodle, a folder: "Ada Lovelace_123456_assignsubmission_file_".
        (r"(?s)^(.+)_(\d+)_assignsubmission_[a-z]+_?$", |found| Named {
            key: format!("{}_{}", &found[1], &found[2]),
            ..plain(&found[1])
        }),
        // Brightspace, a folder: "12345-67890 - Ada Lovelace - Nov 20, 2026 1011 AM".
        (
            r"(?s)^(\d+)-\d+ - (.+?) - ([A-Z][a-z]{2})[a-z]* (\d{1,2}), (\d{4}) (\d{1,2})(\d{2}) ([AP])M$",
            |found| Named {
                key: format!("{}_{}", &found[2], &found[1]),
                attempt: moment(found),
                ..plain(&found[2])
            },
        ),
        // Blackboard, loose: "Lab 1_s123456_attempt_2026-11-20-10-11-12_lambert.rs".
        (r"(?s)^.*_([^_]+)_attempt_(\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d)(?:_(.+)|(?:\.[a-z0-9]+)?)$", |found| {
            Named {
                attempt: found[2].to_owned(),
                own_name: found.get(3).map(|it| it.as_str().to_owned()),
                ..plain(&found[1])
            }
        }),
        // Canvas, loose: "lovelaceada_LATE_12345_67890_lambert.rs".
        (r"(?s)^([^_]+)(_LATE)?_(\d+)_(\d+)_(.+)$", |found| Named {
            key: format!("{}_{}", &found[1], &found[3]),
            // The number is that of the file: of two with the same name the greater is the newer.
            attempt: format!("{:0>20}", &found[4]),
            late: found.get(2).is_some(),
            own_name: Some(found[5].to_owned()),
            ..plain(&found[1])
        }),
    ];
    forms.into_iter().filter_map(|(form, reading)| Some((Regex::new(form).ok()?, reading))).collect()
});

/// What people and browsers append: "(2)", "attempt 2", "late".
static ENDINGS: LazyLock<Option<Regex>> = LazyLock::new(|| {
    Regex::new(r"(?is)^(.+?)(?:[ _-]+(late|te laat)|[ _-]*\((\d+)\)|[ _-]+(?:attempt|poging)[ _-]?(\d+))$")
        .ok()
});

/// Reads a name; `loose` says that it is a file's, neither a folder's nor an archive's.
pub(super) fn read(name: &str, loose: bool) -> Named {
    for (form, reading) in PLATFORMS.iter() {
        if let Some(found) = form.captures(name) {
            return reading(&found);
        }
    }
    if loose { plain(name) } else { with_endings(name) }
}

/// A person's folder, perhaps with "(2)", "attempt 2", "late" behind the name.
fn with_endings(name: &str) -> Named {
    let mut named = plain(name);
    let mut attempt = 0;
    while let Some(found) = ENDINGS.as_ref().and_then(|endings| endings.captures(&named.student)) {
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

fn plain(name: &str) -> Named {
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
        let named = read(name, false);
        (named.key, named.student, named.attempt, named.late)
    }

    #[test]
    fn a_plain_name_is_the_student() {
        assert_eq!(read("Ada Lovelace", false).student, "Ada Lovelace");
        assert_eq!(read("group-2", false).key, "group-2");
        assert_eq!(read("=cmd()\n<script>", false).student, "=cmd()\n<script>");
    }

    #[test]
    fn moodle_numbers_tell_namesakes_apart() {
        let [one, other] = ["1", "2"].map(|n| folder(&format!("Ada_Lovelace_{n}_assignsubmission_file_")));
        assert_eq!(one.1, "Ada_Lovelace");
        assert_eq!(one.1, other.1);
        assert_ne!(one.0, other.0);
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
        let canvas = read("lovelaceada_LATE_123_456_ray_color.rs", true);
        assert_eq!(canvas.own_name.as_deref(), Some("ray_color.rs"));
        assert!(canvas.late && canvas.key == "lovelaceada_123");
        let blackboard = read("Lab 1_s123_attempt_2026-11-20-10-11-12_ray_color.rs", true);
        assert_eq!(
            (blackboard.student.as_str(), blackboard.own_name.as_deref()),
            ("s123", Some("ray_color.rs"))
        );
        assert_eq!(read("Lab_s123_attempt_2026-11-20-10-11-12.txt", true).own_name, None);
        assert_eq!(read("lambert.rs", true).own_name, None);
    }
}
