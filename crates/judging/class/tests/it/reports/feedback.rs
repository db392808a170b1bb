//! What a student gets back, as a page and as Markdown.

use class::report::{class_page, feedback_markdown, feedback_page};
use class::results::{Audience, LawResult, Notice, Outcome, Results, Submission};
use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag};

use crate::made_up::{JUDGED, absent, class, hostile, outline, submission, without_answer};

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
    let verdict = JUDGED.iter().flatten().find(|it| it.looks_like.is_some() && it.picture.is_some());
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
