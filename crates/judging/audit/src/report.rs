//! What came of an audit, as a table for a person and as JSON for a machine?

use std::fmt::Write;

use serde_json::{Value as Json, json};

use crate::mutants::Change;

/// Of the mutants that are not equivalent, so many in a hundred at least must be rejected.
const TARGET: usize = 95;

/// The audit of some exercises.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// One an exercise.
    pub exercises: Vec<Audited>,
    /// Mistakes in the list of equivalent mutants, and what else could not be looked at.
    pub errors: Vec<String>,
}

/// The audit of one exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Audited {
    /// Its name.
    pub name: &'static str,
    /// Right programs: the slide's and the others.
    pub variants: Share,
    /// Wrong programs that people write.
    pub misconceptions: Recognized,
    /// Wrong programs made from the slide's.
    pub mutants: Mutants,
    /// The worked examples, then the laws.
    pub laws: Vec<Caught>,
}

/// So many of so many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// Accepted with every seed.
    pub accepted: usize,
    /// Of these.
    pub total: usize,
}

/// How misconceptions fared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Recognized {
    /// Rejected with every seed.
    pub rejected: usize,
    /// Taken for themselves with every seed.
    pub diagnosed: usize,
    /// Of these.
    pub total: usize,
}

/// How mutants fared.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mutants {
    /// Rejected by a law.
    pub rejected: usize,
    /// Of those that compile.
    pub total: usize,
    /// Those that every law accepts, equivalent ones too.
    pub survivors: Vec<Survivor>,
    /// Of the rejected ones those that the first seed accepts, with the seed that rejects: a student with that first seed would have passed.
    pub late: Vec<(u64, Survivor)>,
}

/// A mutant that every law accepts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survivor {
    /// The line in the exercise's file.
    pub line: usize,
    /// What was changed.
    pub change: Change,
    /// Why it is as right as the original; `None` if it is not.
    pub reason: Option<String>,
}

/// What a law caught.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caught {
    /// Its name.
    pub name: &'static str,
    /// So many wrong programs.
    pub catches: usize,
    /// So many of these no other law caught.
    pub alone: usize,
}

impl Mutants {
    /// Survivors that are as right as the original.
    pub fn equivalent(&self) -> usize {
        self.survivors.iter().filter(|survivor| survivor.reason.is_some()).count()
    }

    /// Whether enough of those that are wrong are rejected.
    fn enough(&self) -> bool {
        100 * self.rejected >= TARGET * (self.total - self.equivalent())
    }
}

impl Audited {
    /// Whether all targets are met: every right program accepted, every misconception rejected as itself, of the mutants enough.
    pub fn met(&self) -> bool {
        let Recognized { rejected, diagnosed, total } = self.misconceptions;
        self.variants.accepted == self.variants.total
            && rejected == total
            && diagnosed == total
            && self.mutants.enough()
    }

    /// Survivors that are wrong.
    fn holes(&self) -> impl Iterator<Item = &Survivor> {
        self.mutants.survivors.iter().filter(|survivor| survivor.reason.is_none())
    }

    /// Laws that catch nothing that no other law catches.
    fn never_alone(&self) -> Vec<&'static str> {
        self.laws.iter().filter(|law| law.alone == 0).map(|law| law.name).collect()
    }
}

impl Report {
    /// Whether every exercise meets all targets, and the list of equivalent mutants is right.
    pub fn met(&self) -> bool {
        self.errors.is_empty() && self.exercises.iter().all(Audited::met)
    }

    /// For machines.
    pub fn json(&self) -> Json {
        let exercises: Vec<Json> = self.exercises.iter().map(exercise).collect();
        json!({ "exercises": exercises, "errors": self.errors, "met": self.met() })
    }

    /// For a person: a line an exercise, then what deserves a look.
    pub fn table(&self) -> String {
        let mut table = format!(
            "{:26}{:>14}{:>18}{:>18}{:>12}{:>12}\n",
            "exercise", "right programs", "misconceptions", "mutants", "equivalent", "survivors"
        );
        for audited in &self.exercises {
            line(&mut table, audited);
        }
        for audited in &self.exercises {
            remarks(&mut table, audited);
        }
        for error in &self.errors {
            let _ = writeln!(table, "\nerror: {error}");
        }
        table
    }
}

fn exercise(audited: &Audited) -> Json {
    let Share { accepted, total } = audited.variants;
    let Recognized { rejected, diagnosed, total: of } = audited.misconceptions;
    let survivors: Vec<Json> = audited.mutants.survivors.iter().map(survivor).collect();
    let law = |law: &Caught| json!({ "name": law.name, "catches": law.catches, "alone": law.alone });
    json!({
        "name": audited.name,
        "variants": { "accepted": accepted, "total": total },
        "misconceptions": { "rejected": rejected, "diagnosed": diagnosed, "total": of },
        "mutants": {
            "rejected": audited.mutants.rejected,
            "equivalent": audited.mutants.equivalent(),
            "total": audited.mutants.total,
            "survivors": survivors,
        },
        "laws": audited.laws.iter().map(law).collect::<Vec<Json>>(),
    })
}

fn survivor(survivor: &Survivor) -> Json {
    let Survivor { line, change, reason } = survivor;
    let mut json =
        json!({ "line": line, "change": change.kind, "before": change.before, "after": change.after });
    if let Some(reason) = reason {
        json["equivalent"] = json!(reason);
    }
    json
}

fn line(table: &mut String, audited: &Audited) {
    let Recognized { rejected, diagnosed, total } = audited.misconceptions;
    let misconceptions = if rejected == diagnosed {
        format!("{rejected}/{total}")
    } else {
        format!("{rejected}, {diagnosed}/{total}")
    };
    let wrong = audited.mutants.total - audited.mutants.equivalent();
    let _ = writeln!(
        table,
        "{:26}{:>14}{:>18}{:>18}{:>12}{:>12}{}",
        audited.name,
        format!("{}/{}", audited.variants.accepted, audited.variants.total),
        misconceptions,
        format!("{}/{wrong}", audited.mutants.rejected),
        audited.mutants.equivalent(),
        audited.holes().count(),
        if audited.met() { "" } else { "  falls short" }
    );
}

fn remarks(table: &mut String, audited: &Audited) {
    for survivor in audited.holes() {
        shown(table, audited.name, survivor, "accepted");
    }
    for (seed, survivor) in &audited.mutants.late {
        shown(
            table,
            audited.name,
            survivor,
            &format!("rejected with seed {seed} only, not with those before"),
        );
    }
    let never_alone = audited.never_alone();
    if !never_alone.is_empty() {
        let _ = writeln!(table, "\n{}: catch nothing alone: {}", audited.name, never_alone.join(", "));
    }
}

/// A mutant as a small difference.
fn shown(table: &mut String, exercise: &str, Survivor { line, change, .. }: &Survivor, how: &str) {
    let _ = writeln!(table, "\n{exercise}: line {line}: {}: {how}", change.kind);
    for (mark, lines) in [("-", &change.before), ("+", &change.after)] {
        for text in lines {
            let _ = writeln!(table, "  {mark} {text}");
        }
    }
}
