//! Who made the same mistake? Submissions with the same misconception, and submissions that break exactly the same laws.

use std::collections::{BTreeMap, BTreeSet};

use crate::results::{LawResult, Outcome, Results, Submission, Verdict};

/// A misconception and whose answers are its answers.
#[derive(Debug)]
pub(crate) struct Diagnosis<'a> {
    /// The exercise.
    pub(crate) exercise: &'a str,
    /// The misconception's name.
    pub(crate) name: &'a str,
    /// To be read after "This looks like: ".
    pub(crate) what: &'a str,
    /// Whose.
    pub(crate) members: Vec<&'a Submission>,
}

/// Misconceptions, the most frequent first; among equals in the course's order.
pub(crate) fn misconceptions(results: &Results) -> Vec<Diagnosis<'_>> {
    let mut found: Vec<Diagnosis<'_>> = Vec::new();
    for exercise in &results.course.exercises {
        let mut of_exercise: BTreeMap<&str, Diagnosis<'_>> = BTreeMap::new();
        for (submission, verdict) in verdicts(results, &exercise.name) {
            if let Some(it) = &verdict.looks_like {
                let new = || Diagnosis {
                    exercise: &exercise.name,
                    name: &it.misconception,
                    what: &it.what,
                    members: Vec::new(),
                };
                of_exercise.entry(&it.misconception).or_insert_with(new).members.push(submission);
            }
        }
        found.extend(of_exercise.into_values());
    }
    found.sort_by_key(|it| std::cmp::Reverse(it.members.len()));
    found
}

/// Submissions that break exactly the same laws.
#[derive(Debug)]
pub(crate) struct Cluster<'a> {
    /// Exercise and law, in the course's order; of the whole course also exercises where no law was tried, with the outcome's word.
    pub(crate) failures: Vec<(&'a str, &'a str)>,
    /// Who, at least two.
    pub(crate) members: Vec<&'a Submission>,
}

/// Clusters within each exercise, the largest first; among equals in the course's order.
pub(crate) fn clusters_by_exercise(results: &Results) -> Vec<Cluster<'_>> {
    let mut found = Vec::new();
    for exercise in &results.course.exercises {
        let failed = verdicts(results, &exercise.name).map(|(submission, verdict)| {
            (submission, broken(verdict).map(|law| (verdict.exercise.as_str(), law)).collect())
        });
        found.extend(clusters(failed));
    }
    found.sort_by_key(|it| std::cmp::Reverse(it.members.len()));
    found
}

/// Clusters over the whole course, the largest first. Whoever has no fault is in none.
pub(crate) fn clusters_of_the_course(results: &Results) -> Vec<Cluster<'_>> {
    let mut found = clusters(results.submissions.iter().map(|submission| (submission, faults(submission))));
    found.sort_by_key(|it| std::cmp::Reverse(it.members.len()));
    found
}

fn faults(submission: &Submission) -> Vec<(&str, &str)> {
    let mut faults = Vec::new();
    for verdict in &submission.verdicts {
        let before = faults.len();
        faults.extend(broken(verdict).map(|law| (verdict.exercise.as_str(), law)));
        if faults.len() == before && verdict.outcome != Outcome::Passed {
            faults.push((verdict.exercise.as_str(), verdict.outcome.word()));
        }
    }
    faults
}

fn broken(verdict: &Verdict) -> impl Iterator<Item = &str> {
    verdict.laws.iter().filter(|law| matches!(law.result, LawResult::Failed(_))).map(|law| law.name.as_str())
}

/// Those who have the same failures, and at least one.
fn clusters<'a>(all: impl Iterator<Item = (&'a Submission, Vec<(&'a str, &'a str)>)>) -> Vec<Cluster<'a>> {
    let mut by_failures: BTreeMap<BTreeSet<(&str, &str)>, Cluster<'_>> = BTreeMap::new();
    for (submission, failures) in all.filter(|(_, failures)| !failures.is_empty()) {
        let key = failures.iter().copied().collect();
        let cluster = by_failures.entry(key).or_insert_with(|| Cluster { failures, members: Vec::new() });
        cluster.members.push(submission);
    }
    by_failures.into_values().filter(|cluster| cluster.members.len() > 1).collect()
}

fn verdicts<'a>(
    results: &'a Results,
    exercise: &'a str,
) -> impl Iterator<Item = (&'a Submission, &'a Verdict)> {
    results.submissions.iter().flat_map(move |submission| {
        submission.verdicts.iter().filter(move |it| it.exercise == exercise).map(move |it| (submission, it))
    })
}
