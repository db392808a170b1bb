//! A class that nobody taught: students who are right in several ways, wrong in every known way, have not begun, or mean harm. What each should get is known beforehand.

use std::fs;
use std::path::Path;

use course::{Exercise, Program};

use crate::hostile_acts::{ACTS, Act, Case};

/// What a student hands in, and what should come of it.
pub(crate) struct Student {
    /// The folder's name.
    pub(crate) name: String,
    /// Each exercise that is handed in.
    pub(crate) works: Vec<Work>,
}

/// One exercise of a student.
pub(crate) struct Work {
    pub(crate) exercise: &'static Exercise,
    pub(crate) text: String,
    /// Any of these outcomes is the right one.
    pub(crate) outcomes: &'static [&'static str],
    /// The misconception that is to be recognized.
    pub(crate) looks_like: Option<&'static str>,
    /// All points, none, or whatever the laws say.
    pub(crate) points: Points,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Points {
    All,
    None,
    Some,
}

/// Students who mean well: each exercise by another program, so that all programs of the course occur in a class that is large enough. Those with
/// the same number are the same in classes of any size.
pub(crate) fn honest(number: usize) -> Student {
    let works =
        course::all().iter().enumerate().filter_map(|(place, exercise)| work(exercise, number + place));
    // No two files are alike, as in life.
    let works = works.map(|work| Work { text: format!("{}\n// {number}\n", work.text), ..work });
    Student { name: format!("student {number:03}"), works: works.collect() }
}

/// The program of this number: right ones and stubs come round more often than wrong ones.
fn work(exercise: &'static Exercise, number: usize) -> Option<Work> {
    let right: Vec<&Program> = [&exercise.reference].into_iter().chain(&exercise.variants).collect();
    let wrong = &exercise.misconceptions;
    let right_of = |number: usize| Work {
        exercise,
        text: exercise.submission(right[number % right.len()]).expect("its text"),
        outcomes: &["passed"],
        looks_like: None,
        points: Points::All,
    };
    match number % 5 {
        0 | 1 => Some(right_of(number / 5)),
        2 | 3 => {
            let misconception = &wrong[(number / 5 * 2 + number % 2) % wrong.len()];
            Some(Work {
                exercise,
                text: exercise.submission(&misconception.program).expect("its text"),
                outcomes: &["wrong"],
                looks_like: Some(misconception.program.name),
                points: Points::Some,
            })
        }
        _ if number.is_multiple_of(2) => None,
        _ => Some(Work {
            exercise,
            // What follows a stub keeps it from being recognized by its text alone.
            text: exercise.stub.to_owned(),
            outcomes: &["not_started"],
            looks_like: None,
            points: Points::None,
        }),
    }
}

/// Students who mean harm, one for each thing that can be done; what each hands in beside it is right and must stay so.
pub(crate) fn hostile() -> Vec<Student> {
    let alone = |case: &'static Case| Student {
        name: case.name.to_owned(),
        works: vec![of(case, ROTATE), right("lambert")],
    };
    ACTS.iter().map(alone).collect()
}

/// Where what is done depends on the function's signature.
const ROTATE: &str = "rotate_about_point";

/// The same in as few submissions as possible: each does something else in each of its files, and one of them is right.
///
/// What is slow is left out: an endless loop is in another test's class, the grader's own tests have all of it, and so have larger classes.
pub(crate) fn hostile_together() -> Vec<Student> {
    /// As many as need a certain function: a submission has one of each.
    const SUBMISSIONS: usize = 4;
    let quick: Vec<&Case> = ACTS.iter().filter(|case| !case.is_slow).collect();
    let (instead, others): (Vec<&Case>, Vec<&Case>) =
        quick.into_iter().partition(|case| matches!(case.act, Act::Instead(_)));
    assert!(instead.len() <= SUBMISSIONS, "{} things are done in {ROTATE}", instead.len());
    let student = |number: usize| {
        let own = instead.get(number).map(|case| of(case, ROTATE));
        let dealt = others.iter().skip(number).step_by(SUBMISSIONS);
        let elsewhere =
            course::all().iter().map(|it| it.name).filter(|name| ![ROTATE, "lambert"].contains(name));
        let works = dealt.zip(elsewhere).map(|(case, exercise)| of(case, exercise));
        Student {
            name: NAMES[number].to_owned(),
            works: own.into_iter().chain(works).chain([right("lambert")]).collect(),
        }
    };
    (0..SUBMISSIONS).map(student).collect()
}

/// Names that mean something to a spreadsheet, a browser, a shell.
const NAMES: [&str; 4] = ["=cmd()|' ' !A0", "<script>alert(1)<script>", "quotes\"'` and\nlines", "-1+1"];

/// A right solution.
fn right(exercise: &str) -> Work {
    let exercise = course::find(exercise).expect("the exercise");
    Work {
        exercise,
        text: exercise.submission(&exercise.reference).expect("its text"),
        outcomes: &["passed"],
        looks_like: None,
        points: Points::All,
    }
}

/// A right solution, but for what is done in it.
fn of(case: &'static Case, exercise: &str) -> Work {
    let right = right(exercise);
    let text = match case.act {
        Act::Instead(body) => right.exercise.stub.replace("todo!()", body),
        Act::First(statement) => {
            let function = right.text.find(&format!("pub fn {exercise}")).expect("the function");
            let body = function + right.text[function..].find('{').expect("its body") + 1;
            format!("{}\n    {statement};{}", &right.text[..body], &right.text[body..])
        }
        Act::Beside(item) => format!("{}\n{item}\n", right.text),
    };
    Work { text, outcomes: case.outcomes, points: Points::None, ..right }
}

/// Writes what the students hand in, each in a folder of their name.
pub(crate) fn hand_in(class: &Path, students: &[Student]) {
    for student in students {
        let folder = class.join(&student.name);
        fs::create_dir_all(&folder).expect("made");
        for work in &student.works {
            fs::write(folder.join(format!("{}.rs", work.exercise.name)), &work.text).expect("written");
        }
    }
}
