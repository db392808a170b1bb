//! Two hundred ordinary students, always the same.

use class::results::{Audience, Notice, Outcome, Results, SCHEMA, Seeds, Submission, VERSION, Verdict};

use super::judged::{JUDGED, SEED, outline};
use super::{submission, without_answer};

/// Numbers that look thrown, always the same.
struct Dice(u64);

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
        partition: None,
        sandboxed: true,
        remarks: Vec::new(),
        roster: Vec::new(),
        submissions,
        digest: None,
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
