//! Do the reports say what the results say, whatever a student's strings hold?

mod made_up;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use class::report::{class_page, feedback_markdown, feedback_page, grades_csv};
use class::results::{Audience, LawResult, Notice, Outcome, Results, Submission};
use made_up::{SECRET, absent, class, everyone, hostile, outline, perfect, submission, without_answer};
use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag};
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
fn every_student_is_found_in_the_table_with_points_and_feedback() {
    let results = everyone();
    let page = class_page(&results);
    let table = page.split_once("<table class=\"sortable\" id=\"class\">").expect("the table").1;
    let rows: Vec<&str> = table.split("<tr data-words=").skip(1).collect();
    assert_eq!(rows.len(), results.submissions.len());
    for (row, submission) in rows.iter().zip(&results.submissions) {
        assert!(row.contains(&format!("href=\"feedback/{}.html\"", submission.id)), "{}", submission.id);
        assert!(
            row.contains(&format!("<td class=\"number\">{}</td>", submission.points)),
            "{}",
            submission.id
        );
    }
    assert_eq!(
        table.matches("<th scope=\"col\"").count() + table.matches("<th class=\"heat\"").count(),
        6 + 35
    );
}

#[test]
fn a_grader_error_stands_on_top() {
    let page = class_page(&everyone());
    let (warning, numbers) = (page.find("The grader failed on 2 exercises"), page.find("class=\"facts\""));
    assert!(warning.is_some() && warning < numbers);
    assert!(!class_page(&class(3)).contains("The grader failed"));
    let unguarded = Results { sandboxed: false, ..class(1) };
    assert!(class_page(&unguarded).contains("Not every submission was judged in the sandbox"));
}

#[test]
fn misconceptions_are_counted_and_lead_to_the_students() {
    let page = class_page(&same_mistake());
    let listed = section(&page, "misconceptions");
    let looks_like = made_up::JUDGED[0][1].looks_like.as_ref().expect("a diagnosis");
    let groups: Vec<&str> = listed.split("<li><details>").skip(1).collect();
    let group = groups.iter().find(|it| it.contains(&looks_like.misconception)).expect("the group");
    assert!(group.contains("<span class=\"size\">3</span>") && group.contains(&looks_like.what), "{group}");
    for id in ["a", "b", "c"] {
        assert!(group.contains(&format!("feedback/{id}.html")), "{id} is missing");
    }
    assert!(!group.contains("feedback/d.html") && !listed.contains("feedback/e.html"));
}

#[test]
fn those_who_break_the_same_laws_are_one_cluster_and_others_are_not_in_it() {
    let page = class_page(&same_mistake());
    let listed = section(&page, "clusters");
    // Once over the whole course, once in the exercise.
    assert_eq!(listed.matches("<span class=\"size\">3</span>").count(), 2, "{listed}");
    assert_eq!(listed.matches("<span class=\"size\">").count(), 2, "{listed}");
    assert!(!listed.contains("feedback/d.html") && !listed.contains("feedback/e.html"));
}

/// Three with the same misconception in the first exercise, one with another, one without fault.
fn same_mistake() -> Results {
    let judged = &made_up::JUDGED[0];
    let failed = |at: usize| -> Vec<bool> {
        judged[at].laws.iter().map(|law| matches!(law.result, LawResult::Failed(_))).collect()
    };
    let other =
        (2..judged.len()).find(|at| failed(*at) != failed(1)).expect("another one that breaks other laws");
    let student = |(id, at): (&str, usize)| submission(id, id, Vec::new(), vec![judged[at].clone()]);
    let submissions = [("a", 1), ("b", 1), ("c", 1), ("d", other), ("e", 0)].map(student).to_vec();
    let mut results = class(0);
    results.course.exercises.truncate(1);
    Results { submissions, ..results }
}

fn section<'a>(page: &'a str, id: &str) -> &'a str {
    let start = page.find(&format!("<section aria-labelledby=\"{id}\"")).expect("the section");
    let end = page[start..].find("</section>").expect("its end");
    &page[start..start + end]
}

#[test]
fn a_class_of_nobody_has_a_page_too() {
    let page = class_page(&class(0));
    assert!(page.contains("The class: 0 submissions") && !page.contains("NaN %"));
}

/// Reads a table as RFC 4180 has it, and nothing else.
fn strict_csv(text: &str) -> Vec<Vec<String>> {
    let mut rows = vec![vec![String::new()]];
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let row = rows.last_mut().expect("at least one");
        let cell = row.last_mut().expect("at least one");
        match c {
            '"' => {
                assert!(cell.is_empty(), "a quote within {cell:?}");
                loop {
                    match rest.next().expect("a quote ends") {
                        '"' if rest.peek() == Some(&'"') => cell.push(rest.next().expect("a quote")),
                        '"' => break,
                        c => cell.push(c),
                    }
                }
                assert!(matches!(rest.peek(), Some(',' | '\r')), "something after {cell:?}");
            }
            ',' => row.push(String::new()),
            '\r' => {
                assert_eq!(rest.next(), Some('\n'));
                rows.push(vec![String::new()]);
            }
            '\n' => panic!("a line feed alone"),
            c => cell.push(c),
        }
    }
    assert_eq!(rows.pop(), Some(vec![String::new()]), "the last line ends too");
    rows
}

#[test]
fn the_table_of_points_is_read_by_a_strict_reader() {
    let results = everyone();
    let text = grades_csv(&results);
    let rows = strict_csv(text.strip_prefix('\u{feff}').expect("a byte order mark"));
    let exercises: Vec<&str> = results.course.exercises.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(rows[0], ["id", "student", "points", "of"].into_iter().chain(exercises).collect::<Vec<_>>());
    assert_eq!(rows.len(), 1 + results.submissions.len());
    for (row, submission) in rows[1..].iter().zip(&results.submissions) {
        assert_eq!(row.len(), 4 + 35);
        assert_eq!(
            (&row[0], &row[2], &row[3]),
            (&submission.id, &submission.points.to_string(), &submission.of.to_string())
        );
        let sum: u32 = row[4..].iter().map(|points| points.parse::<u32>().expect("a number")).sum();
        assert_eq!(sum, submission.points);
    }
}

#[test]
fn no_cell_is_a_formula() {
    let mut results = class(0);
    for (at, start) in
        ["=", "+", "-", "@", "\t=", "\r=", "\n=", " =", "\u{1b}[m=", "\u{ff1d}"].iter().enumerate()
    {
        results.submissions.push(submission(
            &format!("-{at}"),
            &format!("{start}cmd()"),
            Vec::new(),
            Vec::new(),
        ));
    }
    results.course.exercises.clear();
    for row in &strict_csv(grades_csv(&results).trim_start_matches('\u{feff}'))[1..] {
        for cell in row {
            assert!(!cell.starts_with(['=', '+', '-', '@', '\t', '\r', '\n', '\u{ff1d}']), "{cell:?}");
        }
    }
}

/// What a reader makes of Markdown: its headings with their levels, and whether there is anything but text.
fn read(markdown: &str) -> (Vec<(HeadingLevel, String)>, Vec<String>) {
    let (mut headings, mut strange, mut open) = (Vec::new(), Vec::new(), None);
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH) {
        match event {
            Event::Start(Tag::Heading { level, .. }) => open = Some((level, String::new())),
            Event::End(pulldown_cmark::TagEnd::Heading(_)) => headings.extend(open.take()),
            Event::Text(text) | Event::Code(text) => {
                if let Some((_, heading)) = &mut open {
                    heading.push_str(&text);
                }
            }
            Event::Html(text) | Event::InlineHtml(text) => strange.push(text.to_string()),
            Event::Start(
                tag @ (Tag::Link { .. } | Tag::Image { .. } | Tag::HtmlBlock | Tag::Strikethrough),
            ) => {
                strange.push(format!("{tag:?}"));
            }
            _ => {}
        }
    }
    (headings, strange)
}

#[test]
fn no_string_of_a_student_becomes_markdown() {
    let hostile = hostile();
    let course = outline();
    let (headings, strange) = read(&feedback_markdown(&course, &hostile));
    assert_eq!(strange, Vec::<String>::new());
    let of_level = |wanted| {
        headings
            .iter()
            .filter(|(level, _)| *level == wanted)
            .map(|(_, text)| text.as_str())
            .collect::<Vec<_>>()
    };
    assert_eq!(of_level(HeadingLevel::H1).len(), 1);
    let wanted: Vec<String> =
        course.exercises.iter().map(|it| format!("{}: {}", it.name, it.title)).collect();
    assert_eq!(of_level(HeadingLevel::H2), wanted);
    let failed = hostile
        .verdicts
        .iter()
        .flat_map(|it| &it.laws)
        .filter(|it| matches!(it.result, LawResult::Failed(_)));
    let failed: Vec<&str> = failed.map(|it| it.name.as_str()).collect();
    assert_eq!(of_level(HeadingLevel::H3).len(), failed.len());
    assert!(of_level(HeadingLevel::H3).iter().all(|name| failed.contains(name)));
}

#[test]
fn feedback_shows_law_counterexample_diagnosis_and_drawing() {
    let verdict = made_up::JUDGED.iter().flatten().find(|it| it.looks_like.is_some() && it.picture.is_some());
    let verdict = verdict.expect("a misconception that is drawn").clone();
    let course = outline();
    let student = submission("x", "X", Vec::new(), vec![verdict.clone()]);
    let (html, markdown) = (feedback_page(&course, &student), feedback_markdown(&course, &student));
    let looks_like = verdict.looks_like.as_ref().expect("one");
    for text in [&html, &markdown] {
        let text = text.replace("&gt;", ">").replace("<code>", "`").replace("</code>", "`").replace('\\', "");
        assert!(text.contains(&format!("This looks like: {}", looks_like.what)), "{text}");
        assert!(text.contains(&looks_like.help) && text.contains(&verdict.token));
        assert!(text.contains(&format!("{} of {} points", student.points, student.of)));
    }
    assert_eq!(html.matches("<svg").count(), 1);
    // One style for all drawings, so that they cannot disturb each other.
    assert_eq!(html.matches("<style>").count(), 1);
    let drawn = verdict.picture.as_ref().and_then(|it| it.text.as_deref());
    assert!(drawn.is_none_or(|text| markdown.contains(text.trim_end())));
}

#[test]
fn every_drawing_of_the_course_may_stand_in_a_page() {
    let pictures = made_up::JUDGED.iter().flatten().filter_map(|it| it.picture.as_ref());
    let mut drawn = 0;
    for picture in pictures {
        drawn += 1;
        assert!(class::report::foreign::is_harmless_svg(&picture.svg), "{}", picture.svg);
        assert!(!picture.svg.contains(" id=\""), "two drawings in a page would share a name");
    }
    assert!(drawn > 30, "only {drawn} drawings");
}

#[test]
fn every_outcome_is_said_in_a_word() {
    let exercise = &course::all()[0];
    let student =
        |outcome| submission("x", "X", Vec::new(), vec![without_answer(exercise, outcome, "words")]);
    for outcome in Outcome::ALL {
        let student = student(outcome);
        let texts = [feedback_page(&outline(), &student), feedback_markdown(&outline(), &student)];
        assert!(texts.iter().all(|text| text.contains(outcome.word())), "{outcome:?}");
    }
    let compiler = feedback_page(&outline(), &student(Outcome::DoesNotCompile));
    assert!(compiler.contains("error[E0308]: mismatched types") && compiler.contains("about line 12"));
}

#[test]
fn a_notice_for_a_student_is_in_the_feedback() {
    let notice = |audience, text: &str| Notice { audience, text: text.to_owned() };
    let notices =
        vec![notice(Audience::Student, "build.rs was ignored."), notice(Audience::Staff, "Handed in late.")];
    let student = Submission { notices, ..absent() };
    for text in [feedback_page(&outline(), &student), feedback_markdown(&outline(), &student)] {
        assert!(text.contains("build.rs was ignored") && !text.contains("Handed in late"), "{text}");
    }
    let page = class_page(&Results { submissions: vec![student], ..class(0) });
    assert!(page.contains("build.rs was ignored.") && page.contains("Handed in late."));
}
