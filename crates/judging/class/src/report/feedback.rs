//! What does one student get back? A page with the points, a board, and for each exercise what happened, shown and drawn.

use maud::{Markup, PreEscaped, html};

use crate::results::{
    Audience, Counterexample, Course, Exercise, LawResult, LawVerdict, Outcome, Submission, Verdict,
};

use super::account;
use super::foreign::{beginning, is_harmless_svg, line, plain};
use super::{law_mark, mark, page, prose, tone};

/// So many bytes of a notice are shown.
const MOST_OF_A_NOTICE: usize = 2_000;

/// A student's page. What is for the staff alone is not in it; nothing on it runs.
pub fn feedback_page(course: &Course, submission: &Submission) -> String {
    let student = line(&submission.student);
    let body = html! {
        a.skip href="#exercises" { "Skip to the exercises" }
        header {
            h1 { "Feedback for " bdi { (student) } }
            (points(submission))
            @for notice in submission.notices.iter().filter(|it| it.audience == Audience::Student) {
                p.notice { (beginning(&notice.text, MOST_OF_A_NOTICE)) }
            }
        }
        main {
            (board(course, submission))
            div #exercises {
                @for verdict in &submission.verdicts {
                    (article(course.exercise(&verdict.exercise), verdict))
                }
            }
        }
    };
    let style = format!("{}{}{}", include_str!("feedback.css"), sheet::STYLE, ".fig .nl{display:none}");
    page(&format!("Feedback for {student}"), &style, ("", ""), &body)
}

fn points(submission: &Submission) -> Markup {
    let passed = submission.verdicts.iter().filter(|it| it.outcome == Outcome::Passed).count();
    html! {
        p.points { strong { (submission.points) } " of " (submission.of) " points" }
        (bar(submission.points, submission.of))
        p.soft { (passed) " of " (submission.verdicts.len()) " exercises pass all their laws." }
    }
}

/// What part of the whole it is. The numbers stand beside it, so it is hidden from those who hear the page.
fn bar(part: u32, whole: u32) -> Markup {
    let percent = if whole == 0 { 0.0 } else { 100.0 * f64::from(part) / f64::from(whole) };
    html! { div.bar aria-hidden="true" { span style={ "width:" (format!("{percent:.1}")) "%" } {} } }
}

fn board(course: &Course, submission: &Submission) -> Markup {
    let concept = |verdict: &Verdict| course.exercise(&verdict.exercise).map_or("", |it| it.concept.as_str());
    html! {
        nav.board aria-label="Exercises" {
            @for group in submission.verdicts.chunk_by(|a, b| concept(a) == concept(b)) {
                section {
                    h2 { (concept(&group[0])) }
                    ul {
                        @for verdict in group {
                            li {
                                a class=(tone(verdict.outcome)) href={ "#" (verdict.exercise) } {
                                    span.mark aria-hidden="true" { (mark(verdict.outcome)) }
                                    span.name { (verdict.exercise) }
                                    span.score { (verdict.points) "/" (verdict.of) }
                                    span.heard { ", " (verdict.outcome.word()) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn article(exercise: Option<&Exercise>, verdict: &Verdict) -> Markup {
    let passed = verdict.outcome == Outcome::Passed;
    html! {
        article id=(verdict.exercise) class=(tone(verdict.outcome)) {
            h2 {
                @if let Some(exercise) = exercise { (exercise.title) " " }
                code { (verdict.exercise) }
                @if let Some(exercise) = exercise { " " small { (exercise.items) } }
            }
            p.outcome {
                strong.badge { span aria-hidden="true" { (mark(verdict.outcome)) " " } (verdict.outcome.word()) }
                " " (verdict.points) " of " (verdict.of) " points"
            }
            @if let Some(text) = account::sentence(verdict) { p.sentence { (text) } }
            @if let Some(line) = verdict.line { p { "It is about line " (line) " of your file." } }
            @if let Some(text) = account::compiler(verdict) { (block("What the compiler says", &text)) }
            @if passed {
                details { summary { "All " (verdict.laws.len()) " laws hold" } (laws(exercise, verdict)) }
            } @else {
                (laws(exercise, verdict))
            }
            @if let Some(it) = &verdict.looks_like {
                @let (what, help) = account::looks_like(it);
                div.looks-like { p { strong { (prose(&what)) } } p { (prose(&help)) } }
            }
            (failures(exercise, verdict))
            @if let Some(text) = account::printed(verdict) { (block("Your code printed", &text)) }
            @if !passed && !verdict.laws.is_empty() {
                p.soft { "The same again: " code { (account::again(verdict)) } }
            }
        }
    }
}

fn laws(exercise: Option<&Exercise>, verdict: &Verdict) -> Markup {
    html! {
        @if !verdict.laws.is_empty() {
            ul.laws {
                @for law in &verdict.laws {
                    @let class = match law.result {
                        LawResult::Kept(_) => "good",
                        LawResult::Failed(_) => "bad",
                        LawResult::NotRun => "soft",
                    };
                    li class=(class) {
                        span.mark aria-hidden="true" { (law_mark(&law.result)) }
                        span.score { (law.points) "/" (law.of) }
                        span { (prose(statement(exercise, law))) " " span.soft { "(" (account::law_in_words(law)) ")" } }
                    }
                }
            }
        }
    }
}

fn statement<'a>(exercise: Option<&'a Exercise>, law: &'a LawVerdict) -> &'a str {
    exercise.and_then(|it| it.law(&law.name)).map_or(&law.name, |it| &it.statement)
}

/// The counterexample to begin with and its drawing; those of other laws where they are asked for.
fn failures(exercise: Option<&Exercise>, verdict: &Verdict) -> Markup {
    let first = account::shown_first(&verdict.laws);
    let is_first = |law: &LawVerdict| first.is_some_and(|first| std::ptr::eq(first, law));
    html! {
        @if let Some(LawVerdict { result: LawResult::Failed(it), .. }) = first {
            section.counterexample {
                @if let Some(law) = first { h3 { (prose(statement(exercise, law))) } }
                (counterexample(it))
                (picture(verdict))
            }
        }
        @for law in verdict.laws.iter().filter(|law| !is_first(law)) {
            @if let LawResult::Failed(it) = &law.result {
                details.counterexample {
                    summary { (prose(statement(exercise, law))) }
                    (counterexample(it))
                }
            }
        }
    }
}

fn counterexample(it: &Counterexample) -> Markup {
    html! {
        p { (account::which_counterexample(it)) }
        pre.calls tabindex="0" { (account::calls(it)) }
        @if let Some(help) = account::help(it) { p.help { (prose(&help)) } }
    }
}

/// The drawing as part of the page, with the page's colours; where it is no drawing, its text.
fn picture(verdict: &Verdict) -> Markup {
    let Some(picture) = &verdict.picture else { return html! {} };
    if is_harmless_svg(&picture.svg) {
        let said = said(&picture.svg).unwrap_or_else(|| format!("{}, drawn", verdict.exercise));
        let inside = sheet::inside_a_page(&picture.svg, &sheet::Words::new(said.clone(), said));
        return html! { figure { (PreEscaped(inside)) } };
    }
    html! { @if let Some(text) = &picture.text { pre tabindex="0" { (plain(text).trim_end()) } } }
}

/// What a drawing says to those who cannot see it.
fn said(svg: &str) -> Option<String> {
    let document = roxmltree::Document::parse(svg).ok()?;
    document.root_element().attribute("aria-label").map(str::to_owned)
}

fn block(title: &str, text: &str) -> Markup {
    html! { section.block { h3 { (title) } pre tabindex="0" { (text) } } }
}
