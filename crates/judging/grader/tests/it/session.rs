//! Can a student's function be asked anything, and does whatever it does stay in its own process?

use std::time::Duration;

use crate::bench::{Bench, in_function};
use course::{Answerer, Exercise, InProcess, Late, Loss, Reply, Value};
use grader::{CompiledFunction, Outcome, Unreadable};

/// What `rotate_about_point` is asked here.
fn exercise() -> &'static Exercise {
    course::find("rotate_about_point").expect("the exercise")
}

/// All of the exercise's worked examples, so many times.
fn questions(times: usize) -> Vec<Vec<Value>> {
    let examples = exercise().examples.iter().map(|example| example.arguments.clone());
    examples.cycle().take(times).collect()
}

/// A compiled function of this body, and the folder that it lies in.
fn opened(body: &str) -> (CompiledFunction, Bench) {
    let bench = Bench::new();
    let opened = bench.open(exercise(), &in_function(body)).unwrap_or_else(|outcome| panic!("{outcome:?}"));
    (opened, bench)
}

const RIGHT: &str = "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";

#[test]
fn a_right_function_answers_as_the_reference_does() {
    let questions = questions(500);
    let right = InProcess(exercise().reference.function).ask(&questions);
    let (opened, _bench) = opened(RIGHT);
    assert_eq!(opened.ask().ask(&questions), right);
    assert_eq!(opened.ask().ask(&questions), right, "a second conversation");
}

#[test]
fn a_wrong_function_answers_what_it_computes() {
    let (opened, _bench) = opened("Mat3::ZERO");
    let replies = opened.ask().ask(&questions(3)).expect("replies");
    assert_eq!(replies, vec![Reply::Value(Value::Matrix(vec![0.0; 9])); 3]);
}

#[test]
fn the_file_as_it_was_handed_out_is_not_started_and_not_compiled() {
    let bench = Bench::that_cannot_compile();
    let handed_out = bench.open(exercise(), exercise().stub.as_bytes()).map(|_| ());
    assert_eq!(handed_out, Err(Outcome::NotStarted));
    let begun = bench.open(exercise(), &in_function(RIGHT)).map(|_| ());
    assert!(matches!(begun, Err(Outcome::GraderError(_))), "{begun:?}");
}

#[test]
fn thousands_of_small_questions_are_answered_in_order() {
    let (opened, _bench) = opened("Mat3::from_diagonal(glam::vec3(theta, p.x, p.y))");
    let question = |n: usize| vec![Value::Number(n as f32), Value::Vector(vec![1.0, 2.0])];
    let replies = opened.ask().ask(&(0..20_000).map(question).collect::<Vec<_>>()).expect("replies");
    assert_eq!(replies.len(), 20_000, "the last: {:?}", replies.last());
    for (n, reply) in replies.iter().enumerate() {
        let right = vec![n as f32, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0];
        assert_eq!(*reply, Reply::Value(Value::Matrix(right)));
    }
}

#[test]
fn a_panic_is_one_reply_among_others() {
    let body = "if theta == 0.0 { Mat3::ZERO } else { panic!(\"no turns\") }";
    let (opened, _bench) = opened(body);
    let turn = |theta: f32| vec![Value::Number(theta), Value::Vector(vec![0.0, 0.0])];
    let replies = opened.ask().ask(&[turn(0.0), turn(1.0), turn(0.0)]).expect("replies");
    let [Reply::Value(_), Reply::Panicked(panic), Reply::Value(_)] = &replies[..] else {
        panic!("{replies:?}")
    };
    assert_eq!(panic.message, "no turns");
}

#[test]
fn a_function_that_hangs_is_lost_in_time_and_the_next_one_is_asked() {
    let (opened, _bench) = opened("if theta == 0.0 { loop {} } else { Mat3::IDENTITY }");
    let turn = |theta: f32| vec![Value::Number(theta), Value::Vector(vec![0.0, 0.0])];
    let mut asked = opened.ask_for(Duration::from_millis(100));
    let replies = asked.ask(&[turn(1.0), turn(0.0), turn(1.0)]).expect("replies");
    assert_eq!(replies.len(), 2, "{replies:?}");
    assert_eq!(replies[1], Reply::Lost(Loss::TimedOut(Late::Together(100))));
    let replies = opened.ask().ask(&[turn(1.0), turn(0.0)]).expect("replies");
    assert_eq!(replies[1], Reply::Lost(Loss::TimedOut(Late::Computing(200))));
    let replies = opened.ask().ask(&[turn(1.0)]).expect("replies");
    assert!(matches!(replies[..], [Reply::Value(_)]), "{replies:?}");
}

#[test]
fn a_function_that_ends_its_process_ends_no_other() {
    let (opened, _bench) = opened("std::process::exit(3)");
    let replies = opened.ask().ask(&questions(2)).expect("replies");
    assert_eq!(replies, [Reply::Lost(Loss::Exited(3))]);
}

#[test]
fn what_cannot_be_asked_says_why() {
    let bench = Bench::new();
    let outcome = |source: &[u8]| bench.open(exercise(), source).map(|_| ()).expect_err("an outcome");
    assert!(matches!(outcome(&in_function("5")), Outcome::DoesNotCompile { .. }));
    assert_eq!(outcome(b" \n"), Outcome::Unreadable(Unreadable::Empty));
    assert_eq!(outcome(b"// \xff"), Outcome::Unreadable(Unreadable::NotUtf8 { line: 1 }));
    let gone = bench.judge_itself().open(exercise(), &bench.folder().join("gone.rs")).map(|_| ());
    assert_eq!(gone, Err(Outcome::Unreadable(Unreadable::Missing)));
}

#[test]
fn the_program_goes_with_the_last_one_who_may_ask_it() {
    let bench = Bench::new();
    let programs = || std::fs::read_dir(&bench.judge_itself().scratch).expect("the folder").count();
    let opened = bench.open(exercise(), &in_function(RIGHT)).expect("compiled");
    assert_eq!(programs(), 1);
    drop(opened);
    assert_eq!(programs(), 0);
}

#[cfg(target_os = "linux")]
#[test]
fn no_worker_outlives_the_one_who_asks() {
    use std::io::Write;
    use std::os::fd::OwnedFd;
    use std::os::unix::net::UnixStream;
    use std::process::{Command, Stdio};
    use std::time::Instant;

    for body in ["loop {}", "loop { std::thread::sleep(std::time::Duration::from_secs(9)) }"] {
        let (opened, _bench) = opened(body);
        let (mut ours, theirs) = UnixStream::pair().expect("a channel");
        let mut child = Command::new(opened.program())
            .args(["stdin", "0"])
            .stdin(OwnedFd::from(theirs))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the worker starts");
        let mut question = Vec::new();
        worker::wire::ask(&mut question, 0, &exercise().examples[0].arguments).expect("bytes");
        ours.write_all(&question).expect("asked");
        assert!(child.try_wait().expect("a status").is_none(), "{body}: it computes");
        // As if the process that asks had been killed: nobody ends the worker, but the channel's other end is gone.
        drop(ours);
        let begun = Instant::now();
        while child.try_wait().expect("a status").is_none() {
            if begun.elapsed() > Duration::from_secs(20) {
                let _ = child.kill();
                panic!("{body}: it still runs");
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}
