//! Does every sentence of the lecture come to the verdict that is expected of it?

use std::collections::BTreeSet;

use canvas::{Image, difference};
use claims::{Claim, Evidence, Examination, Report, Verdict, all, find};
use figures::{Content, Drawing};

/// One line for each report whose verdict is not the expected one.
fn unexpected(reports: &[Report]) -> Vec<String> {
    let line = |report: &Report| {
        let evidence: Vec<_> = report.examination.evidence.iter().map(ToString::to_string).collect();
        let (stem, expected) = (report.claim.stem(), report.claim.expected);
        let right = if report.examination.right_holds { "" } else { "; the right version fails" };
        format!(
            "{stem}: {}, expected: {expected}{right}. {}",
            report.examination.verdict,
            evidence.join(" | ")
        )
    };
    reports.iter().filter(|report| !report.is_as_expected()).map(line).collect()
}

#[test]
fn every_claim_reaches_its_expected_verdict() {
    let reports: Vec<Report> = all().into_iter().map(Claim::run).collect();
    let failing = unexpected(&reports);
    assert!(failing.is_empty(), "{} claims:\n{}", failing.len(), failing.join("\n"));
}

#[test]
fn a_claim_with_a_wrong_expectation_is_reported() {
    static WRONG: Claim = Claim {
        number: "L54",
        name: "wrong-on-purpose",
        quote: "1 = 2",
        translation: "1 = 2",
        truth: figures::Text { en: "It is not.", nl: "Dat is niet zo." },
        expected: Verdict::Holds,
        code: &[],
        examine: || Examination { verdict: Verdict::Refuted, evidence: Vec::new(), right_holds: true },
        pictures: None,
        versions: None,
    };
    let lines = unexpected(&[WRONG.run()]);
    assert_eq!(lines.len(), 1);
    assert!(lines[0].starts_with("L54-claim-wrong-on-purpose: refuted, expected: holds"), "{lines:?}");
}

#[test]
fn every_error_of_the_slides_shows_the_slides_result_beside_the_right_one() {
    for number in 1..=18 {
        let claims = find(&format!("E{number}"));
        assert!(!claims.is_empty(), "E{number} has no claim");
        for claim in claims {
            let evidence = claim.run().examination.evidence;
            let shows_both = evidence
                .iter()
                .any(|piece| matches!(piece, Evidence::Comparison { slide, right, .. } if slide != right));
            assert!(shows_both, "{} shows no two results", claim.stem());
        }
    }
}

#[test]
fn an_error_is_never_free_of_conditions() {
    // E2's statement about OpenGL is ours, not the slide's.
    for claim in all().into_iter().filter(|claim| claim.number.starts_with('E')) {
        let is_ours = claim.name == "opengl-but-for-signs";
        assert_eq!(claim.expected == Verdict::Holds, is_ours, "{}", claim.stem());
    }
}

/// The numbers that inventory and slides give, each found in the evidence of its claim.
#[test]
fn known_numbers_come_out() {
    for (name, numbers) in [
        ("h-n-always-positive", &["-0.971", "0.748"][..]),
        ("e-r-leaks-too", &["n·l = -0.17", "e·r = 0.97"]),
        ("e-r-or-h-n", &["0.137", "0.613", "0.141"]),
        ("normal-too-short", &["0.707", "1.5e-5"]),
        ("between-0-and-1", &["1.96"]),
        ("camera-depth-interpolated", &["-26.00", "-3.85"]),
        ("opposite-handedness", &["-1"]),
        ("shading-in-the-loop", &["2.4500 colours", "= 2.4500"]),
        ("worked-example", &["0.333", "0.667"]),
    ] {
        let claim = find(name)[0];
        let evidence: Vec<_> = claim.run().examination.evidence.iter().map(ToString::to_string).collect();
        let evidence = evidence.join(" | ");
        for number in numbers {
            assert!(evidence.contains(number), "{number} is not in the evidence of {name}: {evidence}");
        }
    }
}

fn picture(drawing: &Drawing) -> &Image {
    match &drawing.content {
        Content::Picture(image) => image,
        Content::Diagram(_) => panic!("{} is a diagram", drawing.name),
    }
}

#[test]
fn what_can_be_seen_is_shown_as_two_pictures_that_differ() {
    for number in ["E2", "E3", "E7", "E9", "E10", "E12", "E14"] {
        let pictures = find(number).into_iter().filter_map(|claim| claim.pictures);
        let mut count = 0;
        for draw in pictures {
            let drawings = draw().expect("a pair of pictures");
            let names: Vec<_> = drawings.iter().map(|drawing| drawing.name.as_str()).collect();
            assert_eq!(names, ["slide", "right"], "{number}");
            for drawing in &drawings {
                assert!(!drawing.alt.en.is_empty() && !drawing.alt.nl.is_empty(), "{number}");
            }
            let found = difference(picture(&drawings[0]), picture(&drawings[1]), 0.1).expect("one size");
            // To be seen at a glance: more than one pixel in a hundred clearly differs.
            let pixels = picture(&drawings[0]).pixels().len();
            assert!(100 * found.over_threshold > pixels, "{number}: {} of {pixels}", found.over_threshold);
            count += 1;
        }
        assert!(count > 0, "{number} has no pictures");
    }
}

#[test]
fn every_error_can_be_switched_between_the_slides_version_and_ours() {
    for claim in all().into_iter().filter(|claim| claim.number.starts_with('E')) {
        let stem = claim.stem();
        assert!(claim.pictures.is_some() != claim.versions.is_some(), "{stem}: either pictures or versions");
        let Some(versions) = claim.versions else { continue };
        let [slide, right] = versions();
        for (a, b) in [(&slide.says, &right.says), (&slide.gives, &right.gives)] {
            assert!(a.en != b.en && a.nl != b.nl, "{stem}: twice {}", a.en);
        }
        for words in [&slide.says, &slide.gives, &right.says, &right.gives] {
            assert!(!words.en.is_empty() && !words.nl.is_empty(), "{stem}");
        }
        // What is computed is the same in both languages.
        for gives in [&slide.gives, &right.gives] {
            assert_eq!(digits(&gives.en), digits(&gives.nl), "{stem}");
        }
    }
}

fn digits(words: &str) -> String {
    words.chars().filter(char::is_ascii_digit).collect()
}

/// The two results of some errors, as they must come out.
#[test]
fn known_versions_come_out() {
    for (name, slide, right) in [
        ("r-minus-one", "becomes 5.0 wide", "becomes 2.0 wide"),
        ("opposite-handedness", "det M = -1", "det M = 1"),
        ("e-r-or-h-n", "0.613", "0.141"),
        ("proportional-to-the-angle", "0.667", "0.500"),
        ("no-falloff", "1.000", "0.250"),
        ("between-0-and-1", "c = 1.96", "1.00 is shown"),
        ("inclusive-inside-test", "14 hits", "7 hits"),
        ("parallel-ray", ": hit", ": no hit"),
        ("returns-no-t", "true and true", "t = 3 and t = 5"),
        ("shadow-from-beyond-the-lamp", "in shadow", "lit"),
        ("viewing-rays-from-zero", ": seen by rays, not seen", ": not seen by rays, not seen"),
        ("saved-depth-never-set", "of 1600", ": 0 of 1600"),
        ("shading-in-the-loop", "computed: 6", "computed: 1"),
        ("one-letter-many-meanings", "8 letters for 21", "21 names for 21"),
        ("matt-is-absorbed", "0.00 of the light", "0.80 of the light"),
        ("grid-lost-a-row", "4 rows", "5 rows"),
        ("rows-run-down", "row 0", "row 3"),
    ] {
        let versions = find(name)[0].versions.expect("two versions")();
        for (version, expected) in versions.iter().zip([slide, right]) {
            assert!(version.gives.en.contains(expected), "{name}: {} without {expected}", version.gives.en);
        }
    }
}

#[test]
fn items_of_the_lecture_that_state_something_have_a_claim() {
    let items = [
        1, 2, 6, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 24, 25, 26, 27, 28, 29, 30, 31, 33, 35, 38,
        39, 40, 41, 42, 43, 44, 46, 47, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58,
    ];
    for item in items {
        assert!(!find(&format!("L{item}")).is_empty(), "L{item}");
    }
    assert_eq!(find("L19").len(), 6, "six pros and cons");
}

#[test]
fn names_are_unique_quotes_short_and_texts_there() {
    let mut names = BTreeSet::new();
    for claim in all() {
        assert!(names.insert(claim.name), "{} twice", claim.name);
        assert!(
            claim.name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'),
            "{}",
            claim.name
        );
        assert!(claim.quote.chars().count() <= 120, "{}: a long quotation", claim.stem());
        for words in [claim.quote, claim.translation, claim.truth.en, claim.truth.nl] {
            assert!(!words.is_empty(), "{}", claim.stem());
        }
        assert!(!claim.code.is_empty(), "{} names no code", claim.stem());
    }
}

#[test]
fn runs_are_repeatable_but_for_times() {
    let timed = ["r-is-expensive", "three-solvers"];
    for claim in all().into_iter().filter(|claim| !timed.contains(&claim.name)) {
        assert_eq!(claim.run().examination, claim.run().examination, "{}", claim.stem());
    }
}
