//! How does a judgement become part of the results?

use course::trial::{Counterexample as Found, Outcome as LawOutcome, Tried};
use grader::{Forfeit, Judgement, Outcome as Judged, Output, Unreadable, gave};

use crate::results::{Call, Counterexample, LawResult, LawVerdict, LooksLike, Outcome, Picture, Verdict};

/// The verdict that a judgement comes to.
pub(crate) fn verdict(judgement: &Judgement) -> Verdict {
    let compiler = compiler(&judgement.outcome);
    Verdict {
        exercise: judgement.exercise.to_owned(),
        token: judgement.token.to_string(),
        outcome: outcome(&judgement.outcome),
        sentence: sentence(judgement),
        line: line(judgement, compiler.as_deref()),
        compiler,
        points: judgement.points,
        of: judgement.of,
        laws: if judgement.outcome == Judged::NotStarted {
            Vec::new()
        } else {
            judgement.laws.iter().map(|law| law_verdict(judgement, law)).collect()
        },
        looks_like: judgement.looks_like.map(|it| LooksLike {
            misconception: it.misconception.to_owned(),
            what: it.what.to_owned(),
            help: it.help.to_owned(),
            agreeing: it.agreeing,
            telling: it.telling,
        }),
        picture: judgement
            .picture
            .as_ref()
            .map(|picture| Picture { svg: picture.svg.clone(), text: picture.text.clone() }),
        printed: printed(&judgement.printed.out),
    }
}

fn outcome(outcome: &Judged) -> Outcome {
    match outcome {
        Judged::Passed => Outcome::Passed,
        Judged::Wrong => Outcome::Wrong,
        Judged::Unsteady(_) => Outcome::Unsteady,
        Judged::Panicked(_) => Outcome::Panicked,
        Judged::TimedOut(_) => Outcome::TimedOut,
        Judged::OutOfMemory => Outcome::OutOfMemory,
        Judged::TooManyThreads => Outcome::TooManyThreads,
        Judged::StackOverflow => Outcome::StackOverflow,
        Judged::Exited(_) => Outcome::Exited,
        Judged::Crashed(_) => Outcome::Crashed,
        Judged::DoesNotCompile { .. } => Outcome::DoesNotCompile,
        Judged::NotStarted => Outcome::NotStarted,
        Judged::Unreadable(Unreadable::Missing) => Outcome::Missing,
        Judged::Unreadable(Unreadable::Empty) => Outcome::Empty,
        Judged::Unreadable(_) => Outcome::Unreadable,
        // Exercises do not wait for one another here.
        Judged::Blocked { .. } | Judged::GraderError(_) => Outcome::GraderError,
    }
}

fn sentence(judgement: &Judgement) -> Option<String> {
    let parts: Vec<String> = [
        match &judgement.outcome {
            Judged::DoesNotCompile { note: Some(note), .. } => Some(note.clone()),
            // The usual words tell a student at the keyboard what to type.
            Judged::Unreadable(Unreadable::Missing) => {
                Some("There is no such file in the submission.".to_owned())
            }
            Judged::Unreadable(Unreadable::Empty) => Some("The file is empty.".to_owned()),
            other => other.sentence(),
        },
        judgement.forfeit.map(Forfeit::sentence).map(str::to_owned),
    ]
    .into_iter()
    .flatten()
    .collect();
    if parts.is_empty() { None } else { Some(parts.join(" ")) }
}

fn compiler(outcome: &Judged) -> Option<String> {
    if let Judged::DoesNotCompile { message, .. } = outcome { Some(message.clone()) } else { None }
}

/// The line in the student's file that it is about.
fn line(judgement: &Judgement, compiler: Option<&str>) -> Option<u32> {
    if let Judged::Panicked(panic) = &judgement.outcome {
        return (panic.file == judgement.path).then_some(panic.line);
    }
    let (_, after) = compiler?.split_once(&format!("--> {}:", judgement.path))?;
    after.split(':').next()?.parse().ok()
}

fn law_verdict(judgement: &Judgement, law: &Tried) -> LawVerdict {
    let kept = matches!(law.outcome, LawOutcome::Kept(_)) && judgement.forfeit.is_none();
    LawVerdict {
        name: law.name.to_owned(),
        points: if kept { law.points } else { 0 },
        of: law.points,
        result: match &law.outcome {
            LawOutcome::Kept(inputs) => LawResult::Kept(*inputs),
            LawOutcome::Failed(found) => LawResult::Failed(counterexample(judgement, found)),
            LawOutcome::NotRun => LawResult::NotRun,
        },
    }
}

fn counterexample(judgement: &Judgement, found: &Found) -> Counterexample {
    Counterexample {
        example: found.example.map(str::to_owned),
        calls: found
            .calls
            .iter()
            .map(|(arguments, reply)| Call { call: judgement.call(arguments), gave: gave(reply) })
            .collect(),
        broken: found.broken.as_ref().map(ToString::to_string),
        help: found.help.to_owned(),
    }
}

fn printed(output: &Output) -> String {
    match output.dropped {
        0 => output.text.clone(),
        // How many more is a matter of when it was stopped.
        _ => format!("{}\n… and more", output.text),
    }
}
