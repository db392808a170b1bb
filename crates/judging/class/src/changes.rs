//! Whose points have changed since an older report, and by which law?

use std::collections::BTreeMap;

use crate::results::{LawVerdict, Results, Submission, Verdict};

/// What has changed for one student in one exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The student's id.
    pub id: String,
    /// The exercise.
    pub exercise: String,
    /// Points before and after.
    pub points: (u32, u32),
    /// What the outcome was, and is.
    pub outcome: (&'static str, &'static str),
    /// Laws whose points have changed: name, before, after.
    pub laws: Vec<(String, u32, u32)>,
}

/// What differs between two reports.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Verdicts whose points or outcome have changed, in the order of ids and of the course.
    pub changed: Vec<Change>,
    /// Students who are only in the newer one.
    pub come: Vec<String>,
    /// Students who are only in the older one.
    pub gone: Vec<String>,
}

/// Compares two reports.
pub fn changes(old: &Results, new: &Results) -> Changes {
    let before = by_id(old);
    let after = by_id(new);
    let mut changes = Changes {
        come: after.keys().filter(|id| !before.contains_key(*id)).map(ToString::to_string).collect(),
        gone: before.keys().filter(|id| !after.contains_key(*id)).map(ToString::to_string).collect(),
        changed: Vec::new(),
    };
    for (id, submission) in &after {
        let Some(earlier) = before.get(id) else { continue };
        for verdict in &submission.verdicts {
            let old = earlier.verdicts.iter().find(|old| old.exercise == verdict.exercise);
            changes.changed.extend(old.and_then(|old| change(id, old, verdict)));
        }
    }
    changes
}

fn by_id(results: &Results) -> BTreeMap<&str, &Submission> {
    results.submissions.iter().map(|submission| (submission.id.as_str(), submission)).collect()
}

fn change(id: &str, old: &Verdict, new: &Verdict) -> Option<Change> {
    if (old.points, old.outcome) == (new.points, new.outcome) {
        return None;
    }
    let points = |laws: &[LawVerdict], name: &str| {
        laws.iter().find(|law| law.name == name).map_or(0, |law| law.points)
    };
    let mut names: Vec<&String> = new.laws.iter().map(|law| &law.name).collect();
    names.extend(
        old.laws.iter().map(|law| &law.name).filter(|name| !new.laws.iter().any(|law| law.name == **name)),
    );
    let laws = names.into_iter().map(|name| (name.clone(), points(&old.laws, name), points(&new.laws, name)));
    Some(Change {
        id: id.to_owned(),
        exercise: new.exercise.clone(),
        points: (old.points, new.points),
        outcome: (old.outcome.word(), new.outcome.word()),
        laws: laws.filter(|(_, before, after)| before != after).collect(),
    })
}

impl std::fmt::Display for Changes {
    /// One line a change: student, exercise, points, laws.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for Change { id, exercise, points: (before, after), outcome, laws } in &self.changed {
            write!(f, "{id}  {exercise}  {before} -> {after}")?;
            if outcome.0 != outcome.1 {
                write!(f, "  {} -> {}", outcome.0, outcome.1)?;
            }
            for (law, before, after) in laws {
                write!(f, "  {law} {before} -> {after}")?;
            }
            writeln!(f)?;
        }
        for id in &self.come {
            writeln!(f, "{id}  only in the newer report")?;
        }
        for id in &self.gone {
            writeln!(f, "{id}  only in the older report")?;
        }
        Ok(())
    }
}
