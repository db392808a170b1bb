//! A class that was never taught: two hundred students who hand in the course's own solutions and wrong programs, and one who is hostile.

#![allow(dead_code)] // Each test needs some of it.

use std::sync::LazyLock;

use class::results::{
    Audience, Call, Counterexample, Course, Exercise, Law, LawResult, LawVerdict, LooksLike, Misconception,
    Notice, Outcome, Picture, Results, SCHEMA, Seeds, Submission, VERSION, Verdict,
};
use course::diagnosis::diagnose;
use course::trial::{self, Examination, examine};
use course::{InProcess, Program, Reply, Value};

const SEED: u64 = 7;

/// How the exercises are outlined in results.
pub(crate) fn outline() -> Course {
    let law =
        |name: &str, statement: &str, points| Law { name: name.into(), statement: statement.into(), points };
    let exercise = |it: &course::Exercise| Exercise {
        name: it.name.into(),
        concept: it.concept.name().into(),
        title: it.title.english.into(),
        items: it.items.into(),
        points: it.points(),
        laws: std::iter::once(law(trial::EXAMPLES, "The worked examples come out as they should.", 1))
            .chain(it.laws.iter().map(|it| law(it.name(), it.statement(), it.points())))
            .collect(),
        misconceptions: it
            .misconceptions
            .iter()
            .map(|it| Misconception { name: it.program.name.into(), looks_like: it.looks_like.into() })
            .collect(),
    };
    Course { version: "0123456789abcdef".into(), exercises: course::all().iter().map(exercise).collect() }
}

/// What comes of each exercise's reference and of its misconceptions, by exercise: the reference first.
pub(crate) static JUDGED: LazyLock<Vec<Vec<Verdict>>> = LazyLock::new(|| {
    let of = |it: &course::Exercise| {
        let programs = std::iter::once(&it.reference).chain(it.misconceptions.iter().map(|it| &it.program));
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
    let looks_like =
        diagnose(exercise, &examination.answered).filter(|_| !examination.passed()).map(|it| LooksLike {
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

fn nothing(exercise: &course::Exercise, outcome: Outcome) -> Verdict {
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

/// Numbers that look thrown, always the same.
pub(crate) struct Dice(u64);

impl Dice {
    /// The next, 0 ≤ number < 1.
    fn throw(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, end: usize) -> usize {
        ((self.throw() * end as f64) as usize).min(end - 1)
    }
}

const FIRST: [&str; 20] = [
    "Anouk", "Bram", "Chloé", "Daan", "Emma", "Fatima", "Gijs", "Hanna", "Ishaan", "Julia", "Kees", "Lotte",
    "Mehmet", "Noor", "Olivier", "Priya", "Quinten", "Roos", "Søren", "Zoë",
];
const LAST: [&str; 16] = [
    "de Vries",
    "Jansen",
    "van den Berg",
    "Bakker",
    "Yılmaz",
    "Smit",
    "Nguyễn",
    "Mulder",
    "El Amrani",
    "O'Neill",
    "Visser",
    "Peeters",
    "Maes",
    "Wójcik",
    "Dubois",
    "García",
];

/// A class of so many, of the whole course.
pub(crate) fn class(students: usize) -> Results {
    let mut dice = Dice(2026);
    let submissions = (0..students).map(|at| student(at, &mut dice)).collect();
    Results {
        schema: SCHEMA.into(),
        version: VERSION,
        course: outline(),
        seeds: Seeds { seed: SEED, per_student: false },
        sandboxed: true,
        submissions,
    }
}

fn student(at: usize, dice: &mut Dice) -> Submission {
    let name = format!("{} {}", FIRST[dice.below(FIRST.len())], LAST[dice.below(LAST.len())]);
    let ability = (dice.throw() + dice.throw()) / 2.0;
    // Some stop half-way.
    let diligence = 0.4 + dice.throw();
    let mut verdicts = Vec::new();
    for (k, exercise) in course::all().iter().enumerate() {
        let hardness = 0.15 + 0.55 * ((k * 7) % 10) as f64 / 10.0;
        verdicts.push(if k as f64 > diligence * course::all().len() as f64 {
            without_answer(exercise, Outcome::NotStarted, "")
        } else if dice.throw() < ability + 0.5 - hardness {
            JUDGED[k][0].clone()
        } else {
            wrong(exercise, k, dice)
        });
    }
    let mut notices = Vec::new();
    if dice.throw() < 0.06 {
        notices.push(Notice {
            audience: Audience::Student,
            text: "Cargo.toml was ignored: only the exercises' files count.".into(),
        });
    }
    if dice.throw() < 0.03 {
        notices.push(Notice {
            audience: Audience::Staff,
            text: "Handed in twice; the later attempt counts.".into(),
        });
    }
    submission(&format!("s{:04}", 1000 + 7 * at), &name, notices, verdicts)
}

fn wrong(exercise: &course::Exercise, k: usize, dice: &mut Dice) -> Verdict {
    let other = [Outcome::DoesNotCompile, Outcome::Panicked, Outcome::TimedOut, Outcome::Missing];
    if dice.throw() < 0.15 {
        let at = (dice.throw() * dice.throw() * other.len() as f64) as usize;
        return without_answer(exercise, other[at], "index out of bounds: the len is 3 but the index is 3");
    }
    // The first misconceptions are the frequent ones.
    let at = (dice.throw() * dice.throw() * (JUDGED[k].len() - 1) as f64) as usize;
    JUDGED[k][1 + at].clone()
}

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
