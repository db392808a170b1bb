//! What comes of the course's own programs, judged in this process, as results have it.

use std::sync::LazyLock;

use class::results::{
    Call, Counterexample, Course, LawResult, LawVerdict, LooksLike, Outcome, Picture, Verdict,
};
use course::diagnosis::diagnose;
use course::trial::{self, Examination, examine};
use course::{InProcess, Program, Reply, Value};

pub(crate) const SEED: u64 = 7;

/// How the exercises are outlined in results, whatever version they are.
pub(crate) fn outline() -> Course {
    Course { version: "0123456789abcdef".into(), ..class::course() }
}

/// What comes of each exercise's reference and of its misconceptions, by exercise: the reference first.
pub(crate) static JUDGED: LazyLock<Vec<Vec<Verdict>>> = LazyLock::new(|| {
    let of = |it: &course::Exercise| {
        let wrong = it.misconceptions.iter().take(testkit::effort(3, usize::MAX));
        let programs = std::iter::once(&it.reference).chain(wrong.map(|it| &it.program));
        programs.map(|program| judged(it, program)).collect()
    };
    course::all().iter().map(of).collect()
});

fn judged(exercise: &course::Exercise, program: &Program) -> Verdict {
    let examination =
        examine(exercise, SEED, &mut InProcess(program.function)).expect("our own programs answer");
    let law = |it: &trial::Tried| LawVerdict {
        name: it.name.into(),
        points: if matches!(it.outcome, trial::Outcome::Kept(_)) { it.points } else { 0 },
        of: it.points,
        result: result(exercise, &it.outcome),
    };
    let looks_like = (!examination.passed())
        .then(|| diagnose(exercise, &examination.answered))
        .flatten()
        .map(|it| LooksLike {
            misconception: it.misconception.program.name.into(),
            what: it.misconception.looks_like.into(),
            help: it.misconception.help.into(),
            agreeing: it.agreeing,
            telling: it.telling,
        });
    Verdict {
        outcome: if examination.passed() { Outcome::Passed } else { Outcome::Wrong },
        points: examination.points(),
        laws: examination.laws.iter().map(law).collect(),
        looks_like,
        picture: picture(exercise, program, &examination),
        ..nothing(exercise, Outcome::Passed)
    }
}

fn result(exercise: &course::Exercise, outcome: &trial::Outcome) -> LawResult {
    let call = |(arguments, reply): &(Vec<Value>, Reply)| {
        let named: Vec<String> =
            exercise.signature.parameters.iter().zip(arguments).map(|(p, a)| format!("{p} = {a}")).collect();
        Call { call: format!("{}({})", exercise.name, named.join(", ")), gave: grader::gave(reply) }
    };
    match outcome {
        trial::Outcome::Kept(inputs) => LawResult::Kept(*inputs),
        trial::Outcome::NotRun => LawResult::NotRun,
        trial::Outcome::Failed(it) => LawResult::Failed(Counterexample {
            example: it.example.map(str::to_owned),
            calls: it.calls.iter().map(call).collect(),
            broken: it.broken.as_ref().map(ToString::to_string),
            help: it.help.into(),
        }),
    }
}

fn picture(exercise: &course::Exercise, program: &Program, examination: &Examination) -> Option<Picture> {
    let (_, counterexample) = examination.counterexample()?;
    let (arguments, reply) = counterexample.calls.last()?;
    let Reply::Value(given) = reply else { return None };
    let picture = exercise.picture(arguments, Some(given), &mut InProcess(program.function))?;
    Some(Picture { svg: picture.svg, text: picture.text })
}

pub(super) fn nothing(exercise: &course::Exercise, outcome: Outcome) -> Verdict {
    Verdict {
        exercise: exercise.name.into(),
        token: grader::Token::new(exercise, SEED).to_string(),
        outcome,
        sentence: None,
        compiler: None,
        line: None,
        points: 0,
        of: exercise.points(),
        laws: Vec::new(),
        looks_like: None,
        picture: None,
        printed: String::new(),
    }
}
