//! How does a student read the results as text? As Markdown: CommonMark with GitHub's tables.

use crate::results::{Audience, Course, Exercise, LawResult, LawVerdict, Outcome, Submission, Verdict};

use super::account;
use super::foreign::{line, plain};

/// What a student gets back, as Markdown. What is for the staff alone is not in it.
pub fn feedback_markdown(course: &Course, submission: &Submission) -> String {
    let mut text = format!(
        "# Feedback: {}\n\n**{} of {} points**\n",
        escaped(&submission.student),
        submission.points,
        submission.of
    );
    for notice in submission.notices.iter().filter(|it| it.audience == Audience::Student) {
        text.push_str(&format!("\n> {}\n", escaped(&line(&notice.text))));
    }
    text.push_str(&board(submission));
    for verdict in &submission.verdicts {
        text.push_str(&section(course.exercise(&verdict.exercise), verdict));
    }
    text
}

fn board(submission: &Submission) -> String {
    let mut text = String::from("\n| | exercise | outcome | points |\n|---|---|---|---|\n");
    for verdict in &submission.verdicts {
        let (mark, name, word) =
            (super::mark(verdict.outcome), code(&verdict.exercise), verdict.outcome.word());
        text.push_str(&format!("| {mark} | {name} | {word} | {} of {} |\n", verdict.points, verdict.of));
    }
    text
}

fn section(exercise: Option<&Exercise>, verdict: &Verdict) -> String {
    let title = exercise.map_or(String::new(), |it| format!(": {}", escaped(&it.title)));
    let mut parts = vec![
        format!("## {}{title}", code(&verdict.exercise)),
        format!("{} **{}**", super::mark(verdict.outcome), account::headline(verdict)),
    ];
    parts.extend(account::sentence(verdict).map(|text| escaped(&text)));
    parts.extend(verdict.line.map(|line| format!("It is about line {line} of your file.")));
    parts.extend(account::compiler(verdict).map(|text| fence(&text)));
    if !verdict.laws.is_empty() {
        let laws: Vec<String> = verdict.laws.iter().map(|law| law_item(exercise, law)).collect();
        parts.push(laws.join("\n"));
    }
    if let Some(it) = &verdict.looks_like {
        let (what, help) = account::looks_like(it);
        parts.push(format!("**{}** {}", escaped(&what), escaped(&help)));
    }
    let first = account::shown_first(&verdict.laws);
    parts.extend(first.and_then(counterexample));
    let drawn = verdict.picture.as_ref().and_then(|picture| picture.text.as_deref());
    parts.extend(drawn.map(|text| fence(plain(text).trim_end())));
    let others = verdict.laws.iter().filter(|law| !first.is_some_and(|first| std::ptr::eq(first, *law)));
    parts.extend(others.filter_map(counterexample));
    parts.extend(account::printed(verdict).map(|text| format!("Your code printed:\n\n{}", fence(&text))));
    if verdict.outcome != Outcome::Passed && !verdict.laws.is_empty() {
        parts.push(format!("The same again: {}", code(&account::again(verdict))));
    }
    format!("\n{}\n", parts.join("\n\n"))
}

fn law_item(exercise: Option<&Exercise>, law: &LawVerdict) -> String {
    let statement = exercise.and_then(|it| it.law(&law.name)).map_or(&law.name, |it| &it.statement);
    let mark = super::law_mark(&law.result);
    let result = account::law_in_words(law);
    format!("- {mark} {} of {}: {} ({result})", law.points, law.of, escaped(statement))
}

fn counterexample(law: &LawVerdict) -> Option<String> {
    let LawResult::Failed(it) = &law.result else { return None };
    let help = account::help(it).map_or(String::new(), |help| format!("\n\n{}", escaped(&help)));
    Some(format!(
        "### {}\n\n{}\n\n{}{help}",
        code(&law.name),
        escaped(&account::which_counterexample(it)),
        fence(&account::calls(it))
    ))
}

/// The text as one line of words, without anything that Markdown or HTML in it would understand.
pub(crate) fn escaped(text: &str) -> String {
    let line = line_of_any_length(text);
    let mut escaped = String::with_capacity(line.len());
    for (at, c) in line.char_indices() {
        let rest = &line[at + c.len_utf8()..];
        let special = match c {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '&' | '~' | '|' | '$' => true,
            // At the beginning of a line: headings, lists, what underlines a heading.
            '#' | '+' | '-' | '=' => at == 0,
            // A number with a point or a bracket would begin a list.
            '.' | ')' => line[..at].bytes().all(|byte| byte.is_ascii_digit()) || line[..at].ends_with("www"),
            // Addresses become links by themselves.
            ':' => rest.starts_with("//"),
            '@' => true,
            _ => false,
        };
        if special {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

fn line_of_any_length(text: &str) -> String {
    plain(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The text as code within a line: between more backticks than it has beside each other.
pub(crate) fn code(text: &str) -> String {
    let text = line(text).replace('|', "\\|");
    let ticks = "`".repeat(longest_run(&text) + 1);
    let space = if text.starts_with('`') || text.ends_with('`') || text.is_empty() { " " } else { "" };
    format!("{ticks}{space}{text}{space}{ticks}")
}

/// The text as a block of code: between more backticks than it has beside each other.
pub(crate) fn fence(text: &str) -> String {
    let ticks = "`".repeat(longest_run(text).max(2) + 1);
    format!("{ticks}text\n{text}\n{ticks}")
}

fn longest_run(text: &str) -> usize {
    text.split(|c| c != '`').map(str::len).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_markdown_would_understand_is_escaped() {
        assert_eq!(escaped("# *a* <b> [c](d) `e`"), "\\# \\*a\\* \\<b\\> \\[c\\](d) \\`e\\`");
        assert_eq!(escaped("1. one"), "1\\. one");
        assert_eq!(escaped("- a\n- b"), "\\- a - b");
        assert_eq!(escaped("see http://x.org, www.x.org"), "see http\\://x.org, www\\.x.org");
        assert_eq!(escaped("a plain sentence. And 1.5 more."), "a plain sentence. And 1.5 more.");
    }

    #[test]
    fn backticks_cannot_end_a_block() {
        assert_eq!(fence("a\n```\n# b"), "````text\na\n```\n# b\n````");
        assert_eq!(fence("plain"), "```text\nplain\n```");
        assert_eq!(code("a``b"), "```a``b```");
        assert_eq!(code("`a"), "`` `a ``");
    }
}
