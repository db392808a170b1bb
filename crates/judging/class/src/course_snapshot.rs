//! A summary of the course as it judged, stored in every report so that the report can be read without the course.

use course::trial::EXAMPLES;

use crate::digest::Digest;
use crate::results::{Course, Exercise, Law, Misconception};

/// Returns the summary of the course as it is now.
pub fn course() -> Course {
    let exercises = course::all();
    let versions: Vec<String> = exercises
        .iter()
        .map(|exercise| format!("{} {:08x}", exercise.name, grader::version(exercise)))
        .collect();
    Course {
        version: Digest::of(versions.iter().map(String::as_bytes)).hexadecimal()[..16].to_owned(),
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
