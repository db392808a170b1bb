//! The channel of answers. Whoever finds it, writes to it, or calls what the worker itself is made of has not solved anything.

use grader::Outcome;

use crate::bench::{Bench, SLEEPS, in_function};
use crate::hostile::{RIGHT, assert_outcomes, judged};

/// A body that holds the channel and does something with it, and then returns the right answer.
fn with_channel(act: &str) -> String {
    format!(
        "use std::io::Write; use std::os::fd::AsFd;\n    \
         let own = std::io::stdin().as_fd().try_clone_to_owned().unwrap();\n    \
         let mut channel = std::os::unix::net::UnixStream::from(own);\n    {act};\n    {RIGHT}"
    )
}

/// Sends an answer of one's own.
fn forged(answer: &str) -> String {
    with_channel(&format!(
        "let answer = worker::wire::Answer::{answer}; \
         worker::wire::send(&mut channel, &worker::wire::Answered {{ answer, computed: std::time::Duration::ZERO }}).unwrap()"
    ))
}

#[test]
fn bytes_that_no_honest_worker_sends_are_a_crash() {
    let bodies = [
        // A message that is longer than any.
        with_channel("channel.write_all(&[255; 64]).unwrap()"),
        // The beginning of one, which the honest answer completes.
        with_channel("channel.write_all(&[9, 0, 0, 0, 3]).unwrap()"),
        // Another beginning of all.
        with_channel(
            "worker::wire::send(&mut channel, &worker::wire::Ready { computed: std::time::Duration::ZERO }).unwrap()",
        ),
        // Eight megabytes of nonsense.
        with_channel("channel.write_all(&vec![7; 8 << 20]).unwrap()"),
        // The fault of whoever asked, it says.
        forged("Misasked(\"argument theta\".to_owned())"),
        // More than a message can hold, it says.
        forged("TooLong(usize::MAX)"),
    ];
    let bodies: Vec<&str> = bodies.iter().map(String::as_str).collect();
    assert_outcomes(&bodies, |outcome| matches!(outcome, Outcome::Crashed(_)));
}

#[test]
fn more_answers_than_questions_are_a_crash_also_if_every_one_is_right() {
    let right = format!("Value(worker::Plain::into_value({RIGHT}))");
    // At the last question of all nobody reads what is too much, until the worker ends.
    let bodies = [
        forged(&right),
        forged(&right).replace("Mat3::from_translation(p) * Mat3::from_angle", "Mat3::from_angle"),
    ];
    assert!(bodies[0] != bodies[1]);
    let bodies: Vec<&str> = bodies.iter().map(String::as_str).collect();
    let sources: Vec<Vec<u8>> = bodies.iter().map(|body| in_function(body)).collect();
    for judgement in judged(&sources) {
        assert!(
            !matches!(judgement.outcome, Outcome::Passed | Outcome::GraderError(_)),
            "{:?}",
            judgement.outcome
        );
        assert_eq!(judgement.points, 0, "{judgement:?}");
    }
    // Answers that agree whatever was asked: only their number tells.
    let same = "let answer = worker::wire::Answer::Panicked(worker::wire::Panic { message: \"m\".to_owned(), file: String::new(), line: 0, elsewhere: false });\n    let computed = std::time::Duration::ZERO;\n    worker::wire::send(&mut channel, &worker::wire::Answered { answer, computed }).unwrap()";
    assert_outcomes(&[&with_channel(same)], |outcome| {
        matches!(outcome, Outcome::Panicked(_) | Outcome::Crashed(_))
    });
}

#[test]
fn one_answer_too_many_at_the_very_end_is_noticed() {
    // It is sent when the thread of the student's code ends, after the last question.
    let body = format!(
        "struct Last(std::os::unix::net::UnixStream);\n    \
         impl Drop for Last {{ fn drop(&mut self) {{ worker::wire::send(&mut self.0, &worker::wire::Ready {{ computed: std::time::Duration::ZERO }}).unwrap(); }} }}\n    \
         thread_local! {{ static LAST: Last = {{\n        \
             use std::os::fd::AsFd;\n        \
             Last(std::io::stdin().as_fd().try_clone_to_owned().unwrap().into())\n    \
         }} }}\n    LAST.with(|_| ());\n    {RIGHT}"
    );
    assert_outcomes(&[&body], |outcome| matches!(outcome, Outcome::Crashed(_)));
}

#[test]
fn a_second_server_in_the_same_process_serves_nobody() {
    let body = format!("let _ = worker::serve(&[]);\n    {RIGHT}");
    for judgement in judged(&[in_function(&body)]) {
        assert_eq!(judgement.outcome, Outcome::Passed, "it does nothing");
    }
}

#[test]
fn verdicts_on_standard_output_are_only_printed() {
    let body =
        "println!(\"{{\\\"outcome\\\":\\\"passed\\\",\\\"points\\\":100}}\");\n    panic!(\"no idea\")";
    assert_outcomes(&[body], |outcome| matches!(outcome, Outcome::Panicked(_)));
}

#[test]
fn a_panic_that_says_very_much_is_shortened() {
    let Some(bench) = Bench::confined() else { return };
    let Outcome::Panicked(panic) = bench.judge(&in_function("panic!(\"{}\", \"ä\".repeat(20_000))")).outcome
    else {
        panic!("no panic")
    };
    assert!(panic.message.chars().count() < 3000 && panic.message.ends_with('…'));
}

#[test]
fn an_answer_byte_by_byte_is_late() {
    let drip = |pause: u32| {
        with_channel(&format!(
            "channel.write_all(&[96, 234, 0, 0]).unwrap(); \
             loop {{ channel.write_all(&[0]).unwrap(); std::thread::sleep(std::time::Duration::from_millis({pause})) }}"
        ))
    };
    assert_outcomes(&[&drip(40), &drip(1)], |outcome| *outcome == SLEEPS);
}

#[test]
fn an_answer_of_another_type_is_the_files_own_fault() {
    // The right answer follows; only at the very first question is it read instead of the forged one.
    let wrong = forged("Value(worker::Value::Truth(true))").replace(RIGHT, "loop {}");
    assert_outcomes(&[&wrong], |outcome| !matches!(outcome, Outcome::GraderError(_) | Outcome::Passed));
}
