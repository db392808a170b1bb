//! How does a judgement read? The laws first, then the smallest input that breaks one, then what would help.

use course::trial::{Counterexample, Outcome as LawOutcome, Tried};
use course::{Exercise, Reply};
use grader::{Judgement, Outcome, Output, gave};

use super::ink::{bad, faint, good, strong, typed};

/// Lines of a compiler's message and of what was printed are shown as they are; of the latter so many.
const MOST_LINES_PRINTED: usize = 8;

/// What helps where NaN or infinity came back, whichever law noticed it.
const STRANGE: &str = "NaN and inf are no numbers to go on with: is something divided by 0, a zero vector brought to length 1, or the root of a \
    negative number taken?";

/// A line is at most so long where we break it ourselves.
const WIDTH: usize = 78;

/// The judgement as text, many lines.
///
/// `file` is what was judged, as the user would type it.
pub(crate) fn text(judgement: &Judgement, exercise: &Exercise, picture: Option<&str>, file: &str) -> String {
    let mut lines = vec![headline(judgement)];
    if let Outcome::DoesNotCompile { message, note } = &judgement.outcome {
        lines.extend(note.iter().map(|note| wrapped(note, "  ")));
        lines.push(message.trim_end().to_owned());
    } else if let Some(sentence) = judgement.outcome.sentence() {
        lines.push(wrapped(&sentence, "  "));
    }
    if judgement.outcome != Outcome::NotStarted {
        lines.extend(judgement.laws.iter().map(law_line));
    }
    lines.extend(judgement.forfeit.map(|forfeit| wrapped(forfeit.sentence(), "  ")));
    if let Outcome::Unsteady(twice) = &judgement.outcome {
        lines.push("  The call:".to_owned());
        lines.push(call(judgement, &twice.arguments, &Reply::Value(twice.first.clone())));
    }
    if let Some((law, counterexample)) = judgement.counterexample() {
        lines.extend(shown(judgement, law, counterexample));
    }
    if let Some(looks_like) = &judgement.looks_like {
        let surely = format!(
            "This looks like: {} (the same answer on {} of {} inputs that tell).",
            looks_like.what, looks_like.agreeing, looks_like.telling
        );
        lines.push(String::new());
        lines.push(strong(&wrapped(&surely, "  ")));
        lines.push(wrapped(looks_like.help, "  "));
    }
    lines.extend(printed("printed", &judgement.printed.out));
    lines.extend(printed("printed on standard error", &judgement.printed.err));
    if let Some(text) = judgement.picture.as_ref().and_then(|picture| picture.text.as_deref()) {
        lines.push(String::new());
        lines.push(text.trim_end().to_owned());
    }
    lines.extend(picture.map(|path| format!("  Drawn: {path}")));
    lines.extend(ending(judgement, exercise, file));
    lines.join("\n")
}

pub(crate) fn headline(judgement: &Judgement) -> String {
    let Judgement { path, points, of, .. } = judgement;
    let word = judgement.outcome.word();
    let word = if judgement.passed() { good(&format!("✓ {word}")) } else { bad(&format!("✗ {word}")) };
    format!("{word}  {}  {points} of {of} points", strong(path))
}

fn law_line(law: &Tried) -> String {
    let mark = match law.outcome {
        LawOutcome::Kept(_) => good("✓"),
        LawOutcome::Failed(_) => bad("✗"),
        LawOutcome::NotRun => faint("–"),
    };
    let note = if law.outcome == LawOutcome::NotRun { faint(" (not tried)") } else { String::new() };
    let points = format!("{:>2}", law.points);
    let statement = wrapped(law.statement, "       ");
    format!("  {mark} {points} {}{note}", statement.trim_start())
}

/// The counterexample: calls, what they gave, what is wrong with it, what would help.
fn shown(judgement: &Judgement, law: &Tried, counterexample: &Counterexample) -> Vec<String> {
    let mut lines = vec![String::new()];
    match counterexample.example {
        Some(caption) => lines.push(format!("  In the worked example “{caption}”:")),
        None if counterexample.broken.is_some() => {
            lines.push(format!("  The smallest input found that breaks {}:", strong(law.name)));
        }
        None => lines.push("  The call:".to_owned()),
    }
    for (arguments, reply) in &counterexample.calls {
        lines.push(call(judgement, arguments, reply));
    }
    if let Some(broken) = &counterexample.broken {
        lines.push(match &broken.values {
            Some((given, wanted)) => {
                // Under each other, so that the eye can compare.
                let is = format!("{} is", broken.what);
                let width = is.chars().count().max("should be".len());
                let (given, wanted) = (bad(&given.to_string()), good(&wanted.to_string()));
                format!("    {is:>width$} {given}\n    {:>width$} {wanted}", "should be")
            }
            None => wrapped(&broken.what, "    "),
        });
    }
    // A law's help is for values, not for calls that gave none.
    if counterexample.broken.is_some() {
        let strange = counterexample
            .calls
            .iter()
            .any(|(_, reply)| matches!(reply, Reply::Value(value) if value.has_strange_numbers()));
        lines.push(wrapped(if strange { STRANGE } else { counterexample.help }, "  "));
    }
    lines
}

fn call(judgement: &Judgement, arguments: &[course::Value], reply: &Reply) -> String {
    let call = typed(&wrapped(&judgement.call(arguments), "    "));
    format!("{call}\n      gave {}", wrapped(&gave(reply), "           ").trim_start())
}

fn printed(name: &str, output: &Output) -> Vec<String> {
    if output.text.is_empty() {
        return Vec::new();
    }
    let lines: Vec<&str> = output.text.lines().collect();
    let mut shown = vec![String::new(), format!("  Your code {name}:")];
    shown.extend(lines.iter().take(MOST_LINES_PRINTED).map(|line| faint(&format!("    {}", plain(line)))));
    let more = lines.len().saturating_sub(MOST_LINES_PRINTED);
    if more > 0 || output.dropped > 0 {
        let bytes = if output.dropped > 0 { format!(" and {} bytes", output.dropped) } else { String::new() };
        shown.push(faint(&format!("    … {more} more lines{bytes}")));
    }
    shown
}

/// Without what moves a terminal's cursor, and not endlessly long.
fn plain(line: &str) -> String {
    line.chars().filter(|c| !c.is_control() || *c == '\t').take(160).collect()
}

fn ending(judgement: &Judgement, exercise: &Exercise, file: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    if judgement.passed() {
        lines.push(wrapped(exercise.explanation, "  "));
        lines.push(format!(
            "  The slide's solution: {}",
            typed(&format!("cargo lab solution {}", exercise.name))
        ));
    } else {
        lines.push(format!("  A hint: {}", typed(&format!("cargo lab hint {}", exercise.name))));
    }
    if !judgement.laws.is_empty() && !judgement.passed() {
        // A file that lies elsewhere is named beside the token.
        let elsewhere = if file.ends_with(&format!("exercises/{}", judgement.path)) {
            String::new()
        } else {
            format!(" {file}")
        };
        lines.push(faint(&format!(
            "  The same again: cargo lab check --token {}{elsewhere}",
            judgement.token
        )));
    }
    lines
}

/// The text in lines of at most [`WIDTH`] columns, each begun with `indent`.
pub(crate) fn wrapped(text: &str, indent: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for paragraph in text.lines() {
        let mut line = indent.to_owned();
        for word in paragraph.split_whitespace() {
            let empty = line.trim().is_empty();
            if !empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
                lines.push(std::mem::replace(&mut line, indent.to_owned()));
            } else if !empty {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_broken_between_words_and_no_word_is_lost() {
        let text = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen";
        let broken = wrapped(text, "    ");
        assert!(broken.lines().count() == 2 && broken.lines().all(|line| line.chars().count() <= WIDTH));
        assert!(
            broken.lines().all(|line| line.starts_with("    o") || line.starts_with("    f")),
            "{broken}"
        );
        assert_eq!(
            broken.split_whitespace().collect::<Vec<_>>(),
            text.split_whitespace().collect::<Vec<_>>()
        );
    }

    #[test]
    fn a_word_that_is_too_long_stands_on_its_own() {
        let long = "x".repeat(100);
        assert_eq!(wrapped(&format!("a {long} b"), ""), format!("a\n{long}\nb"));
    }

    #[test]
    fn what_was_printed_cannot_move_the_cursor() {
        assert_eq!(plain("a\x1b[2Jb\tc\r"), "a[2Jb\tc");
    }
}
