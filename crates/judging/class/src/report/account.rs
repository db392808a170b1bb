//! What is a student told about an exercise, in plain text? The same words wherever they are shown.
//!
//! Every text is harmless ([`plain`](super::foreign::plain)) and of a bounded length, but nothing is escaped yet.

use crate::results::{Counterexample, LawResult, LawVerdict, LooksLike, Outcome, Verdict};

use super::foreign::{beginning, plain};

/// So many bytes of what rustc says are shown.
const MOST_OF_THE_COMPILER: usize = 12_000;
/// So many bytes of what the student's code printed are shown…
const MOST_PRINTED: usize = 4_000;
/// …and so many of a sentence or of a value.
const MOST_OF_A_SENTENCE: usize = 2_000;

/// "wrong, 6 of 10 points".
pub(crate) fn headline(verdict: &Verdict) -> String {
    format!("{}, {} of {} points", verdict.outcome.word(), verdict.points, verdict.of)
}

/// What happened, in a sentence or two. What went wrong inside of the grader is the staff's business.
pub(crate) fn sentence(verdict: &Verdict) -> Option<String> {
    if verdict.outcome == Outcome::GraderError {
        return Some(GRADER_ERROR.to_owned());
    }
    verdict.sentence.as_deref().map(|text| beginning(text, MOST_OF_A_SENTENCE))
}

/// What a student is told where the grader failed.
pub(crate) const GRADER_ERROR: &str = "Something went wrong in the grader, not in your file. A person has to look at it; it shall cost you no points.";

/// What rustc says.
pub(crate) fn compiler(verdict: &Verdict) -> Option<String> {
    let text = beginning(verdict.compiler.as_deref()?, MOST_OF_THE_COMPILER);
    (!text.is_empty()).then_some(text)
}

/// What the student's code printed.
pub(crate) fn printed(verdict: &Verdict) -> Option<String> {
    let text = beginning(&verdict.printed, MOST_PRINTED);
    (!text.is_empty()).then_some(text)
}

/// "This looks like: …", and what would help.
pub(crate) fn looks_like(it: &LooksLike) -> (String, String) {
    let surely = format!("the same answer on {} of {} inputs that tell", it.agreeing, it.telling);
    (format!("This looks like: {} ({surely}).", plain(&it.what)), plain(&it.help))
}

/// "held for 256 inputs".
pub(crate) fn law_in_words(law: &LawVerdict) -> String {
    match &law.result {
        LawResult::Kept(inputs) => format!("held for {inputs} inputs"),
        LawResult::Failed(Counterexample { example: Some(_), .. }) => "a worked example fails".to_owned(),
        LawResult::Failed(_) => "does not hold".to_owned(),
        LawResult::NotRun => "not tried".to_owned(),
    }
}

/// What a counterexample begins with: which it is.
pub(crate) fn which_counterexample(it: &Counterexample) -> String {
    match &it.example {
        Some(caption) => format!("In the worked example “{}”:", plain(caption)),
        None if it.broken.is_some() => "The smallest input found that breaks it:".to_owned(),
        None => "The call:".to_owned(),
    }
}

/// The calls and what they gave, and what is wrong about it, in lines.
pub(crate) fn calls(it: &Counterexample) -> String {
    let short = |text: &str| beginning(text, MOST_OF_A_SENTENCE);
    let mut lines: Vec<String> = Vec::new();
    for call in &it.calls {
        lines.push(short(&call.call));
        lines.push(format!("  gave {}", short(&call.gave)));
    }
    lines.extend(it.broken.iter().map(|broken| under_each_other(&short(broken))));
    lines.join("\n")
}

/// "x is 1, should be 2" in two lines whose values stand under each other, so that the eye can compare.
fn under_each_other(broken: &str) -> String {
    let parts = broken.rsplit_once(", should be ");
    let Some(((what, given), wanted)) = parts.and_then(|(is, be)| Some((is.split_once(" is ")?, be))) else {
        return broken.to_owned();
    };
    let is = format!("{what} is");
    let width = is.chars().count().max("should be".len());
    format!("{is:>width$} {given}\n{:>width$} {wanted}", "should be")
}

/// The law whose counterexample is shown first, and which is drawn: the first that fails, a worked example only if all others hold.
pub(crate) fn shown_first(laws: &[LawVerdict]) -> Option<&LawVerdict> {
    let (examples, laws) = laws.split_at(laws.len().min(1));
    laws.iter().chain(examples).find(|law| matches!(law.result, LawResult::Failed(_)))
}

/// What would help, if it is about a value: where a call gave none, the sentence says all.
pub(crate) fn help(it: &Counterexample) -> Option<String> {
    it.broken.as_ref().map(|_| plain(&it.help)).filter(|help| !help.is_empty())
}

/// A counterexample, whole.
pub(crate) fn counterexample(it: &Counterexample) -> String {
    let mut text = format!("{}\n{}", which_counterexample(it), calls(it));
    if let Some(help) = help(it) {
        text.push_str(&format!("\n{help}"));
    }
    text
}

/// What is to say of an exercise beside its laws: what happened, rustc's words, the misconception.
pub(crate) fn beside_the_laws(verdict: &Verdict) -> String {
    let mut parts: Vec<String> = Vec::new();
    parts.extend(sentence(verdict));
    parts.extend(compiler(verdict));
    parts.extend(verdict.looks_like.as_ref().map(|it| {
        let (what, help) = looks_like(it);
        format!("{what}\n{help}")
    }));
    parts.join("\n\n")
}

/// Repeats the verdict.
pub(crate) fn again(verdict: &Verdict) -> String {
    format!("cargo lab check --token {}", plain(&verdict.token))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_and_what_should_be_stand_under_each_other() {
        assert_eq!(
            under_each_other("M·p is (0, 0, 1), should be (0, -0.25, 1)"),
            "   M·p is (0, 0, 1)\nshould be (0, -0.25, 1)"
        );
        assert_eq!(under_each_other("the order is not the same"), "the order is not the same");
    }
}
