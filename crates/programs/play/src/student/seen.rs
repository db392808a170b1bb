//! Is every misconception seen in the pictures, and no right solution taken for a wrong one?

use course::{Exercise, InProcess, Program};
use figures::{Figure, Values};

use super::drawing::{self, Drawn};
use super::knobs::Knobs;
use super::{StudentPictures, calls, which};

/// Every figure that an exercise draws.
fn figures_of(exercise: &Exercise) -> Vec<&'static Figure> {
    let draws = |figure: &&Figure| {
        StudentPictures::exercises_of(figure).iter().any(|other| other.name == exercise.name)
    };
    figures::all().into_iter().filter(draws).collect()
}

/// A figure by a program of ours, as if it were a student's.
fn drawn(figure: &Figure, exercise: &Exercise, program: &Program) -> Drawn {
    let values = Values::of(figure);
    let knobs = Knobs::new(figure, &values);
    let panels = which::panels(exercise, &knobs);
    let mut yours = InProcess(program.function);
    if panels.is_empty() {
        calls::of_a_call(exercise, &knobs, &mut yours)
    } else {
        drawing::of_panels(exercise, &panels, &mut yours)
    }
}

/// How many pixels or examples differ; what panics differs too.
fn differing(drawn: &Drawn) -> usize {
    drawn.differs.as_ref().map_or(usize::from(drawn.trouble.is_some()), |(_, differing, _)| *differing)
}

#[test]
fn right_solutions_differ_in_no_pixel() {
    let mut wrong = Vec::new();
    for exercise in course::all() {
        for figure in figures_of(exercise) {
            // By day the slide's solution, at night every right one.
            let others = exercise.variants.iter().take(testkit::effort(0, usize::MAX));
            for program in [&exercise.reference].into_iter().chain(others) {
                let drawn = drawn(figure, exercise, program);
                let who = format!("{} by {} on {}", exercise.name, program.name, figure.name);
                assert!(drawn.trouble.is_none() && !drawn.drawings.is_empty(), "{who}: {:?}", drawn.trouble);
                let (_, differing, of) = drawn.differs.expect("counted");
                assert!(of > 0, "{who}");
                if differing > 0 {
                    wrong.push(format!("{who}: {differing} of {of}"));
                }
            }
        }
    }
    assert_eq!(wrong, [] as [&str; 0]);
}

#[test]
fn misconceptions_are_seen() {
    // It shows only where gaze and up are almost parallel, which no worked example is.
    const HIDDEN: &str = "compared_with_exactly_zero";
    let of_each = testkit::effort(2, usize::MAX);
    let mut hidden = Vec::new();
    for exercise in course::all() {
        let figures = figures_of(exercise);
        for (place, misconception) in exercise.misconceptions.iter().enumerate() {
            if place >= of_each && misconception.program.name != HIDDEN {
                continue;
            }
            let is_seen = |figure: &&Figure| differing(&drawn(figure, exercise, &misconception.program)) > 0;
            if !figures.iter().any(is_seen) {
                hidden.push(format!("{}: {}", exercise.name, misconception.program.name));
            }
        }
    }
    assert_eq!(hidden, [format!("camera_frame: {HIDDEN}")]);
}
