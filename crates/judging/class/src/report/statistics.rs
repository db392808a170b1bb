//! What do the numbers of a class say? How hard an exercise was, whether it tells the strong from the weak, and which laws are kept.
//!
//! Where the grader itself failed, nothing is known of the student: such verdicts are left out.

use std::collections::BTreeMap;

use crate::results::{Exercise, Law, LawResult, Outcome, Results, Verdict};

/// One exercise, over the whole class.
#[derive(Debug)]
pub(crate) struct Item<'a> {
    /// The exercise.
    pub(crate) exercise: &'a Exercise,
    /// How many were judged.
    pub(crate) judged: usize,
    /// How many have all points.
    pub(crate) passed: usize,
    /// The mean share of its points, 0 ≤ share ≤ 1: the classical difficulty. `None` where nobody was judged.
    pub(crate) share: Option<f64>,
    /// The correlation of its points with the points of all other exercises, −1 ≤ r ≤ 1: the corrected item-total correlation. `None`
    /// where either does not differ between students.
    pub(crate) discrimination: Option<f64>,
    /// Its laws.
    pub(crate) laws: Vec<LawCount<'a>>,
    /// How often each outcome came.
    pub(crate) outcomes: BTreeMap<Outcome, usize>,
}

/// One law, over the whole class.
#[derive(Debug)]
pub(crate) struct LawCount<'a> {
    /// The law.
    pub(crate) law: &'a Law,
    /// So many keep it.
    pub(crate) kept: usize,
    /// So many break it; it was tried on no others.
    pub(crate) failed: usize,
}

/// Every exercise, in the course's order.
pub(crate) fn items(results: &Results) -> Vec<Item<'_>> {
    results.course.exercises.iter().map(|exercise| item(results, exercise)).collect()
}

fn item<'a>(results: &'a Results, exercise: &'a Exercise) -> Item<'a> {
    let mut outcomes = BTreeMap::new();
    let mut judged: Vec<(&Verdict, f64)> = Vec::new();
    for submission in &results.submissions {
        for verdict in submission.verdicts.iter().filter(|it| it.exercise == exercise.name) {
            *outcomes.entry(verdict.outcome).or_insert(0) += 1;
            if verdict.outcome != Outcome::GraderError {
                judged.push((verdict, f64::from(submission.points) - f64::from(verdict.points)));
            }
        }
    }
    let points: Vec<f64> = judged.iter().map(|(verdict, _)| f64::from(verdict.points)).collect();
    let rest: Vec<f64> = judged.iter().map(|(_, rest)| *rest).collect();
    let law = |law: &'a Law| law_count(law, judged.iter().map(|(verdict, _)| *verdict));
    Item {
        exercise,
        judged: judged.len(),
        passed: judged.iter().filter(|(verdict, _)| verdict.outcome == Outcome::Passed).count(),
        share: mean(&points).filter(|_| exercise.points > 0).map(|mean| mean / f64::from(exercise.points)),
        discrimination: correlation(&points, &rest),
        laws: exercise.laws.iter().map(law).collect(),
        outcomes,
    }
}

fn law_count<'a, 'v>(law: &'a Law, verdicts: impl Iterator<Item = &'v Verdict>) -> LawCount<'a> {
    let mut count = LawCount { law, kept: 0, failed: 0 };
    for result in verdicts.flat_map(|it| &it.laws).filter(|it| it.name == law.name).map(|it| &it.result) {
        match result {
            LawResult::Kept(_) => count.kept += 1,
            LawResult::Failed(_) => count.failed += 1,
            LawResult::NotRun => {}
        }
    }
    count
}

/// What part of all points each submission has, 0 ≤ share ≤ 1, in the order of the submissions.
pub(crate) fn shares(results: &Results) -> Vec<f64> {
    let share = |points: u32, of: u32| if of == 0 { 0.0 } else { f64::from(points) / f64::from(of) };
    results.submissions.iter().map(|it| share(it.points, it.of)).collect()
}

/// The mean; `None` of nothing.
pub(crate) fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The value below which a share of the values lies, 0 ≤ share ≤ 1, between two of them by a straight line; `None` of nothing.
pub(crate) fn quantile(values: &[f64], share: f64) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = share * sorted.len().checked_sub(1)? as f64;
    let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    Some(below + (above - below) * place.fract())
}

/// Pearson's r; `None` where either side does not differ.
pub(crate) fn correlation(a: &[f64], b: &[f64]) -> Option<f64> {
    let (mean_a, mean_b) = (mean(a)?, mean(b)?);
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        a.iter().zip(b).map(|(a, b)| f(a - mean_a, b - mean_b)).sum()
    };
    let (aa, bb, ab) = (sum(&|a, _| a * a), sum(&|_, b| b * b), sum(&|a, b| a * b));
    // Points are whole numbers: what does not differ has deviations of rounding alone, far below this.
    const NONE: f64 = 1e-9;
    (aa > NONE && bb > NONE).then(|| ab / (aa * bb).sqrt())
}

/// How hard, in a word. The borders are those that test theory usually takes.
pub(crate) fn difficulty_in_words(share: f64) -> &'static str {
    match share {
        s if s >= 0.85 => "easy",
        s if s >= 0.5 => "middling",
        s if s >= 0.25 => "hard",
        _ => "very hard",
    }
}

/// Whether it tells the strong from the weak, in words. The borders are those of Ebel.
pub(crate) fn discrimination_in_words(r: Option<f64>) -> &'static str {
    match r {
        None => "nobody differs",
        Some(r) if r >= 0.4 => "separates well",
        Some(r) if r >= 0.2 => "separates",
        Some(r) if r >= 0.0 => "hardly separates",
        Some(_) => "against the rest",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantile_lies_between_its_neighbours() {
        assert_eq!(quantile(&[4.0, 1.0, 2.0], 0.5), Some(2.0));
        assert_eq!(quantile(&[4.0, 1.0, 2.0, 8.0], 0.5), Some(3.0));
        assert_eq!(quantile(&[4.0, 1.0, 2.0, 8.0], 1.0), Some(8.0));
        assert_eq!(quantile(&[], 0.5), None);
    }

    #[test]
    fn correlation_knows_the_sign_and_says_nothing_of_constants() {
        let rising = correlation(&[1.0, 2.0, 4.0], &[2.0, 4.0, 8.0]);
        assert!((rising.expect("both differ") - 1.0).abs() < 1e-12);
        let falling = correlation(&[1.0, 2.0, 4.0], &[-2.0, -4.0, -8.0]);
        assert!((falling.expect("both differ") + 1.0).abs() < 1e-12);
        // By hand: deviations (−1, 0, 1) and (−2, 1, 1), so 3/√(2·6).
        let some = correlation(&[1.0, 2.0, 3.0], &[0.0, 3.0, 3.0]).expect("both differ");
        assert!((some - 3.0 / 12_f64.sqrt()).abs() < 1e-12);
        assert_eq!(correlation(&[0.1, 0.1, 0.1], &[1.0, 2.0, 3.0]), None);
    }
}
