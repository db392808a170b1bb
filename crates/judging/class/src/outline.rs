//! What was judged by? The course in outline, so that a report can be read without it.

use course::trial::EXAMPLES;

use crate::results::{Course, Exercise, Law, Misconception};
use crate::sum::Sum;

/// The course as it is now.
pub fn course() -> Course {
    let exercises = course::all();
    let versions: Vec<String> = exercises
        .iter()
        .map(|exercise| format!("{} {:08x}", exercise.name, grader::version(exercise)))
        .collect();
    Course {
        version: Sum::of(versions.iter().map(String::as_bytes)).hexadecimal()[..16].to_owned(),
        exercises: exercises.iter().map(exercise).collect(),
    }
}

fn exercise(exercise: &course::Exercise) -> Exercise {
    let examples = Law {
        name: EXAMPLES.to_owned(),
        statement: "The worked examples come out as they should.".to_owned(),
        points: course::Exercise::EXAMPLE_POINTS,
    };
    let laws = exercise.laws.iter().map(|law| Law {
        name: law.name().to_owned(),
        statement: law.statement().to_owned(),
        points: law.points(),
    });
    Exercise {
        name: exercise.name.to_owned(),
        concept: exercise.concept.name().to_owned(),
        title: exercise.title.english.to_owned(),
        items: exercise.items.to_owned(),
        points: exercise.points(),
        laws: [examples].into_iter().chain(laws).collect(),
        misconceptions: exercise
            .misconceptions
            .iter()
            .map(|misconception| Misconception {
                name: misconception.program.name.to_owned(),
                looks_like: misconception.looks_like.to_owned(),
            })
            .collect(),
    }
}
