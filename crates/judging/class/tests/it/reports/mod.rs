//! Do the reports say what the results say, whatever a student's strings hold?

mod class_page;
pub(crate) mod csv;
mod feedback;

use crate::made_up::{SECRET, class, everyone, hostile, outline, perfect};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use class::report::{class_page, feedback_markdown, feedback_page, grades_csv};
use sha2::{Digest, Sha256};

/// Pages that hold the hostile student's strings.
fn hostile_pages() -> [(&'static str, String); 2] {
    let results = everyone();
    [("class", class_page(&results)), ("feedback", feedback_page(&results.course, &hostile()))]
}

#[test]
fn the_same_results_give_the_same_bytes() {
    let (one, other) = (everyone(), everyone());
    assert_eq!(class_page(&one), class_page(&other));
    assert_eq!(grades_csv(&one), grades_csv(&other));
    for (a, b) in one.submissions.iter().zip(&other.submissions).rev().take(5) {
        assert_eq!(feedback_page(&one.course, a), feedback_page(&other.course, b));
        assert_eq!(feedback_markdown(&one.course, a), feedback_markdown(&other.course, b));
    }
}

#[test]
fn no_string_of_a_student_becomes_a_part_of_a_page() {
    for (name, page) in hostile_pages() {
        let scripts = page.matches("<script").count();
        assert_eq!(scripts, usize::from(name == "class"), "{name}: {scripts} scripts");
        for tag in ["<img", "<b>", "<!-- ", "</textarea", "<a href=\"javascript"] {
            assert!(!page.contains(tag), "{name} holds {tag}");
        }
        assert!(page.contains("&lt;script&gt;alert(1)"), "{name}: the name is not shown");
        // Ours end with the page; a student's would be before.
        assert_eq!(page.matches("</body>").count(), 1, "{name}");
        assert_eq!(page.matches("</style>").count(), 1, "{name}");
        assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count(), "{name}");
        assert_eq!(page.matches("<pre").count(), page.matches("</pre>").count(), "{name}");
    }
}

#[test]
fn no_character_moves_a_cursor_or_turns_a_line() {
    let results = everyone();
    let hostile = hostile();
    let pages = hostile_pages().into_iter().map(|(_, page)| page);
    let others = [feedback_markdown(&results.course, &hostile), grades_csv(&results).replace('\r', "")];
    for text in pages.chain(others) {
        let strange = text.chars().find(|c| {
            (c.is_control() && *c != '\n' && *c != '\t')
                || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{fffe}' | '\u{ffff}')
        });
        assert_eq!(strange, None);
    }
}

#[test]
fn what_is_for_the_staff_is_read_by_the_staff_alone() {
    let results = everyone();
    let page = class_page(&results);
    // The notice, and the two grader errors.
    assert!(page.matches(SECRET).count() >= 3);
    for text in [feedback_page(&results.course, &hostile()), feedback_markdown(&results.course, &hostile())] {
        assert!(!text.contains("/home/staff") && !text.contains("home/staff"), "the staff's words are shown");
        assert!(text.contains("was ignored"), "the student's notice is missing");
        assert!(
            text.contains("Something went wrong in the grader, not in your file"),
            "no word of the grader's error"
        );
    }
}

#[test]
fn the_class_page_admits_its_own_script_and_no_other() {
    let page = class_page(&class(3));
    let script =
        page.split_once("<script>").and_then(|(_, rest)| rest.split_once("</script>")).expect("a script").0;
    let fingerprint = STANDARD.encode(Sha256::digest(script.replace("\r\n", "\n")));
    assert!(
        page.contains(&format!(
            "default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src 'sha256-{fingerprint}'"
        )),
        "FINGERPRINT in class_page.rs should be sha256-{fingerprint}"
    );
    let feedback = feedback_page(&outline(), &perfect());
    assert!(feedback.contains("default-src 'none'") && !feedback.contains("script-src"));
}

#[test]
fn pages_ask_nothing_of_a_network() {
    for (name, page) in hostile_pages() {
        for asks in [" src=", "@import", "url(", "<iframe", "<object", "srcset"] {
            let asked = page.replace("&lt;img src=x", "");
            assert!(!asked.contains(asks), "{name}: {asks}");
        }
        for link in page.split(" href=\"").skip(1) {
            let inside = ["#", "feedback/", "data:,"].iter().any(|start| link.starts_with(start));
            assert!(inside, "{name} leads to {}", link.split('"').next().unwrap_or_default());
        }
    }
}

#[test]
fn two_hundred_students_and_thirty_five_exercises_stay_below_two_megabytes() {
    let results = class(200);
    assert_eq!((results.submissions.len(), results.course.exercises.len()), (200, 35));
    let page = class_page(&results);
    assert!(page.len() < 2_000_000, "{} bytes", page.len());
    // However much a student prints.
    let feedback = feedback_page(&results.course, &hostile());
    assert!(feedback.len() < 1_000_000, "{} bytes", feedback.len());
}

#[test]
fn every_drawing_of_the_course_may_stand_in_a_page() {
    let pictures = crate::made_up::JUDGED.iter().flatten().filter_map(|it| it.picture.as_ref());
    let mut drawn = 0;
    for picture in pictures {
        drawn += 1;
        assert!(class::report::foreign::is_harmless_svg(&picture.svg), "{}", picture.svg);
        assert!(!picture.svg.contains(" id=\""), "two drawings in a page would share a name");
    }
    assert!(drawn > 30, "only {drawn} drawings");
}
