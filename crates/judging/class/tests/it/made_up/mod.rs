//! A class that was never taught: two hundred students who hand in the course's own solutions and wrong programs, and one who is hostile.

#![allow(dead_code, unused_imports, reason = "an example uses a part of it")]

mod judged;
mod people;

pub(crate) use judged::{JUDGED, outline};
pub(crate) use people::class;

use class::results::{
    Audience, Call, Counterexample, LawResult, LawVerdict, Notice, Outcome, Results, Submission, Verdict,
};

use judged::{SEED, nothing};

/// An outcome that is no answer, as the grader tells it. `words` stands wherever the student decides what is said.
pub(crate) fn without_answer(exercise: &course::Exercise, outcome: Outcome, words: &str) -> Verdict {
    let sentence = match outcome {
        Outcome::Panicked => Some(format!("The code panicked at {}:12: {words}", exercise.path())),
        Outcome::TimedOut => {
            Some("No answer to the call below within 2 s: is there a loop without end?".into())
        }
        Outcome::DoesNotCompile => Some("Rust does not accept the file; the compiler says why.".into()),
        Outcome::GraderError => Some(format!("Something is wrong with the grader: {SECRET} {words}")),
        Outcome::NotStarted => Some("`todo!()` still stands where the solution goes.".into()),
        outcome => Some(format!("The call below ended otherwise ({}).", outcome.word())),
    };
    let mut verdict = Verdict { sentence, ..nothing(exercise, outcome) };
    if outcome == Outcome::DoesNotCompile {
        verdict.line = Some(12);
        verdict.compiler = Some(format!(
            "\x1b[1;31merror[E0308]\x1b[0m: mismatched types\n  \x1b[34m-->\x1b[0m {}:12:5\n   |\n12 |     {words}\n   |     ^^^^^ expected `Vec3`, found `f32`\n",
            exercise.path()
        ));
    }
    if matches!(outcome, Outcome::Panicked | Outcome::TimedOut | Outcome::OutOfMemory | Outcome::Crashed) {
        verdict.laws = broken_off(exercise, words);
        verdict.printed = format!("called\n{words}\n");
    }
    verdict
}

/// The first law shows the call, the others were not tried.
fn broken_off(exercise: &course::Exercise, words: &str) -> Vec<LawVerdict> {
    let tried = &JUDGED
        [course::all().iter().position(|it| it.name == exercise.name).expect("one of the course")][0]
        .laws;
    let law = |(at, law): (usize, &LawVerdict)| LawVerdict {
        points: 0,
        result: if at > 0 {
            LawResult::NotRun
        } else {
            LawResult::Failed(Counterexample {
                example: None,
                calls: vec![Call {
                    call: format!("{}(…)", exercise.name),
                    gave: format!("a panic: {words}"),
                }],
                broken: None,
                help: String::new(),
            })
        },
        ..law.clone()
    };
    tried.iter().enumerate().map(law).collect()
}

/// What no student may read.
pub(crate) const SECRET: &str = "/home/staff/grader/secret";

/// A submission, its points added up.
pub(crate) fn submission(
    id: &str,
    student: &str,
    notices: Vec<Notice>,
    verdicts: Vec<Verdict>,
) -> Submission {
    Submission {
        id: id.into(),
        student: student.into(),
        source: format!("{student}_{id}"),
        fingerprint: "00".into(),
        seed: SEED,
        points: verdicts.iter().map(|it| it.points).sum(),
        of: verdicts.iter().map(|it| it.of).sum(),
        notices,
        verdicts,
    }
}

/// Everything that a string might do to a report, in one string.
pub(crate) const NASTY: &str = "<script>alert(1)</script> \" ' & ]]> <!-- --> =cmd()|' /C calc'!A0 `x` ``` **b** [l](javascript:1) {{7*7}} ${x} %s \\ \
    \u{202e}turned\u{2066} \u{0}\u{1}\u{7}\u{8}\u{b}\u{c}\u{1b}[2J\u{1b}]0;title\u{7}\u{9b}31m \u{fffe}\u{ffff} \r\n\n# heading\n- item\n~~~\n````\n\
    </pre></textarea></svg></style><img src=x onerror=alert(1)> \u{2028} é €𝄞";

/// A student who means harm: every outcome, every nasty string, megabytes of printed output.
pub(crate) fn hostile() -> Submission {
    let nasty = NASTY.repeat(3);
    let endless = format!("{}{}", NASTY, "```\u{1b}[31mflood <b>\n".repeat(150_000));
    let mut verdicts: Vec<Verdict> = Vec::new();
    for (k, exercise) in course::all().iter().enumerate() {
        let outcome = Outcome::ALL[k % Outcome::ALL.len()];
        let mut verdict = match outcome {
            Outcome::Passed => JUDGED[k][0].clone(),
            Outcome::Wrong | Outcome::Unsteady => Verdict { outcome, ..JUDGED[k][1].clone() },
            outcome => without_answer(exercise, outcome, &nasty),
        };
        verdict.printed.clone_from(&endless);
        if outcome != Outcome::Passed && outcome != Outcome::GraderError {
            verdict.sentence = Some(nasty.repeat(40));
        }
        for law in &mut verdict.laws {
            if let LawResult::Failed(it) = &mut law.result {
                it.calls.push(Call { call: nasty.clone(), gave: format!("a panic: {}", nasty.repeat(100)) });
            }
        }
        if let Some(picture) = &mut verdict.picture {
            picture.text = Some(format!("```\n{nasty}"));
            if k % 2 == 0 {
                picture.svg = format!("<svg>{nasty}");
            }
        }
        verdicts.push(verdict);
    }
    let notices = vec![
        Notice { audience: Audience::Student, text: format!("{NASTY} was ignored") },
        Notice { audience: Audience::Staff, text: format!("{SECRET} {NASTY}") },
    ];
    submission("hostile", &format!("=cmd() {NASTY}"), notices, verdicts)
}

/// Whoever handed in nothing.
pub(crate) fn absent() -> Submission {
    let verdicts = course::all().iter().map(|it| without_answer(it, Outcome::Missing, "")).collect();
    submission("absent", "Nobody", Vec::new(), verdicts)
}

/// Whoever has everything right.
pub(crate) fn perfect() -> Submission {
    submission("perfect", "Ada Lovelace", Vec::new(), JUDGED.iter().map(|it| it[0].clone()).collect())
}

/// A class with everyone: two hundred ordinary students, the hostile one, one who is absent, one with all points.
pub(crate) fn everyone() -> Results {
    let mut results = class(200);
    results.submissions.extend([absent(), hostile(), perfect()]);
    results
}
