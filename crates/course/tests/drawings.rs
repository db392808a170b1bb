//! Can every counterexample be drawn, however wrong the answer? And does the drawing fit where it is shown?

use course::trial::{Counterexample, examine};
use course::{Calls, Exercise, InProcess, Picture, Program, Reply, Seen, Value};

/// What a terminal has room for.
const COLUMNS: usize = 76;
const LINES: usize = 20;

fn answers(program: &Program, questions: &[Vec<Value>]) -> Vec<Option<Value>> {
    let reply = |question: &Vec<Value>| match InProcess(program.function).reply(question) {
        Ok(Reply::Value(value)) => Some(value),
        _ => None,
    };
    questions.iter().map(reply).collect()
}

/// The drawing of a program's last call in a counterexample.
fn drawn(exercise: &Exercise, program: &Program, counterexample: &Counterexample) -> Option<Picture> {
    let (arguments, reply) = counterexample.calls.last().expect("a counterexample has a call");
    let right =
        answers(&exercise.reference, std::slice::from_ref(arguments)).remove(0).expect("a right answer");
    let given = match reply {
        Reply::Value(value) => Some(value),
        _ => None,
    };
    let yours: &Calls<'_> = &|questions| answers(program, questions);
    let reference: &Calls<'_> = &|questions| answers(&exercise.reference, questions);
    (exercise.draw)(&Seen { arguments, given, right: &right, yours, reference })
}

#[test]
fn every_drawing_is_svg_without_strange_numbers_and_fits_a_terminal() {
    let mut drawings = 0;
    for exercise in course::all() {
        for misconception in &exercise.misconceptions {
            let program = &misconception.program;
            let who = format!("{} by {}", exercise.name, program.name);
            let examination = examine(&exercise, 1, &mut InProcess(program.function)).expect("no fault");
            let (_, counterexample) = examination.counterexample().expect("a misconception fails");
            let Some(picture) = drawn(&exercise, program, counterexample) else { continue };
            drawings += 1;
            assert!(picture.svg.starts_with("<svg") && picture.svg.ends_with("</svg>"), "{who}: no SVG");
            // Words may say that an answer is NaN, tags may not.
            let tags = picture.svg.split('<').filter_map(|part| part.split('>').next());
            let strange = tags.filter(|tag| tag.contains("NaN") || tag.contains("inf")).count();
            assert_eq!(strange, 0, "{who}: a number that is none");
            if let Some(text) = &picture.text {
                assert!(text.lines().count() <= LINES, "{who}: more than {LINES} lines\n{text}");
                assert!(text.lines().all(|line| line.chars().count() <= COLUMNS), "{who}: too wide\n{text}");
            }
        }
    }
    assert!(drawings > 50, "only {drawings} drawings");
}
