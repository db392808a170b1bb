//! Whatever a file holds, does it get the outcome that is its own, and are the others judged all the same?

use crate::bench::{Bench, LOOPS, SLEEPS, in_function};
use course::Late;
use course::trial::Outcome as LawOutcome;
use grader::{Forfeit, Outcome, Unreadable};

/// Judges a body of `rotate_about_point` and gives the outcome: the same one confined and not.
fn of_body(body: &str) -> Outcome {
    let outcome = Bench::new().judge(&in_function(body)).outcome;
    if let Some(bench) = Bench::confined() {
        assert_eq!(bench.judge(&in_function(body)).outcome, outcome, "confined, and not: {body}");
    }
    outcome
}

#[test]
fn the_slides_solution_passes_with_all_points() {
    let body = "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";
    let judgement = Bench::new().judge(&in_function(body));
    assert_eq!(judgement.outcome, Outcome::Passed, "{judgement:#?}");
    assert_eq!(judgement.points, judgement.of);
}

#[test]
fn a_stub_is_not_started() {
    assert_eq!(of_body("todo!()"), Outcome::NotStarted);
    assert_eq!(of_body("todo!(\"after lunch\")"), Outcome::NotStarted);
}

#[test]
fn a_wrong_answer_gets_points_for_the_laws_it_keeps_and_a_diagnosis() {
    let judgement = Bench::new().judge(&in_function("Mat3::from_angle(theta) * Mat3::from_translation(-p)"));
    assert_eq!(judgement.outcome, Outcome::Wrong);
    assert!(0 < judgement.points && judgement.points < judgement.of, "{} points", judgement.points);
    let looks_like = judgement.looks_like.expect("a misconception");
    assert_eq!(looks_like.misconception, "not_moved_back");
    assert!(looks_like.agreeing == looks_like.telling && looks_like.telling > 20, "{looks_like:?}");
}

#[test]
fn a_wrong_answer_is_shrunk_to_one_that_can_be_checked_by_hand() {
    let judgement = Bench::new().judge(&in_function("Mat3::from_angle(theta) * Mat3::from_translation(-p)"));
    let law = judgement.laws.iter().find(|law| law.name == "the_centre_stays").expect("the law");
    let course::trial::Outcome::Failed(counterexample) = &law.outcome else { panic!("{law:?}") };
    let (arguments, _) = counterexample.calls.last().expect("a call");
    // Any centre but the origin moves, even without a turn; the smallest such one is a step of the grid away.
    let smallest = ["(0, 0.25)", "(0, -0.25)", "(0.25, 0)", "(-0.25, 0)"];
    let call = judgement.call(arguments);
    assert!(smallest.iter().any(|p| call == format!("rotate_about_point(theta = 0, p = {p})")), "{call}");
}

#[test]
fn an_endless_loop_is_timed_out() {
    assert_eq!(of_body("loop { std::hint::spin_loop() }"), LOOPS);
}

#[test]
fn a_program_that_waits_is_timed_out_and_told_so() {
    let outcome = of_body("std::thread::sleep(std::time::Duration::from_secs(1000));\n    Mat3::IDENTITY");
    assert_eq!(outcome, SLEEPS);
    assert!(outcome.sentence().expect("words").contains("most of which it waited"), "{outcome:?}");
}

/// A right function whose every call computes for about so many milliseconds.
fn slow(milliseconds: u32) -> Vec<u8> {
    in_function(&format!(
        "let mut x = p.x;\n    for _ in 0..{} {{ x = std::hint::black_box(x + 1.0); }}\n    \
         Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)",
        milliseconds * 50_000
    ))
}

#[test]
fn many_slow_answers_are_timed_out_as_a_whole_and_no_law_counts() {
    let mut bench = Bench::new();
    bench.limit_whole(std::time::Duration::from_millis(150));
    let judgement = bench.judge(&slow(5));
    assert_eq!(judgement.outcome, Outcome::TimedOut(Late::Together(150)));
    assert_eq!(judgement.points, 0);
    // How far it came is chance, and so it is not said.
    assert!(judgement.laws.iter().all(|law| law.outcome == LawOutcome::NotRun), "{:?}", judgement.laws);
}

#[test]
fn endless_recursion_fills_the_stack() {
    let body = "fn deep(n: u64) -> u64 { if n == u64::MAX { 0 } else { 1 + deep(n + 1) } }\n    Mat3::IDENTITY * deep(0) as f32";
    assert_eq!(of_body(body), Outcome::StackOverflow);
}

#[cfg(target_os = "linux")]
#[test]
fn a_terabyte_is_too_much_memory() {
    let body = "let much = vec![0_u8; 1 << 40];\n    Mat3::IDENTITY * f32::from(much[7])";
    assert_eq!(of_body(body), Outcome::OutOfMemory);
    let body = "let much = vec![1_u8; 1 << 31];\n    Mat3::IDENTITY * f32::from(much[7])";
    assert_eq!(of_body(body), Outcome::OutOfMemory);
}

#[test]
fn ending_the_process_is_no_answer() {
    assert_eq!(of_body("std::process::exit(0)"), Outcome::Exited(0));
    assert_eq!(of_body("std::process::exit(3)"), Outcome::Exited(3));
}

#[cfg(unix)]
#[test]
fn an_abort_is_a_crash() {
    assert!(matches!(of_body("std::process::abort()"), Outcome::Crashed(_)));
}

#[test]
fn a_panic_says_what_and_where() {
    let Outcome::Panicked(panic) = of_body("let none: Option<Mat3> = None;\n    none.unwrap()") else {
        panic!("no panic")
    };
    assert!(panic.message.contains("`Option::unwrap()` on a `None` value"), "{}", panic.message);
    assert!(panic.file.ends_with("submission.rs") && !panic.elsewhere, "{panic:?}");
    assert_eq!(panic.line, crate::bench::FIRST_LINE + 1);
}

#[test]
fn a_panic_in_a_thread_is_seen_even_if_nobody_waits_for_it() {
    for wait in ["", ".join().unwrap()", ".join().ok()"] {
        let body = format!(
            "let thread = std::thread::spawn(|| panic!(\"in the thread\"));\n    while !thread.is_finished() {{}}\n    let _ = thread{wait};\n    Mat3::IDENTITY"
        );
        let Outcome::Panicked(panic) = of_body(&body) else { panic!("no panic with {wait:?}") };
        assert!(panic.elsewhere && panic.message == "in the thread", "{wait:?}: {panic:?}");
    }
}

#[test]
fn a_half_done_solution_has_panicked_and_is_not_unstarted() {
    let body = "if theta == std::f32::consts::FRAC_PI_2 { Mat3::IDENTITY } else { todo!() }";
    assert!(matches!(of_body(body), Outcome::Wrong | Outcome::Panicked(_)));
}

#[test]
fn printing_a_megabyte_changes_nothing_and_is_shown_apart() {
    let source = in_function(&format!(
        "static ONCE: std::sync::Once = std::sync::Once::new();\n    ONCE.call_once(|| {{ {} }});\n    {}",
        "for i in 0..4000 { println!(\"line {i} {}\", \"x\".repeat(250)); eprintln!(\"to err\"); }",
        "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)"
    ));
    let judgement = Bench::new().judge(&source);
    assert_eq!(judgement.outcome, Outcome::Passed);
    assert!(
        judgement.printed.out.text.starts_with("line 0 xxx"),
        "{:?}",
        judgement.printed.out.text.get(..20)
    );
    assert!(judgement.printed.out.dropped > 900_000, "{} bytes dropped", judgement.printed.out.dropped);
    assert!(judgement.printed.err.text.starts_with("to err\n"));
}

#[test]
fn nan_and_infinity_come_back_as_they_are_and_are_wrong() {
    for number in ["f32::NAN", "f32::INFINITY", "-f32::INFINITY"] {
        let judgement = Bench::new().judge(&in_function(&format!("Mat3::from_cols_array(&[{number}; 9])")));
        assert_eq!(judgement.outcome, Outcome::Wrong, "{number}");
        assert_eq!(judgement.points, 0, "{number}");
        let (_, counterexample) = judgement.counterexample().expect("a counterexample");
        let shown = grader::gave(&counterexample.calls[0].1);
        assert!(shown.contains("NaN") || shown.contains("inf"), "{shown}");
    }
}

#[test]
fn what_does_not_compile_comes_with_rustcs_own_message() {
    let Outcome::DoesNotCompile { message, note } = of_body("let x: Mat3 = 5;\n    x") else { panic!() };
    assert!(message.contains("error[E0308]: mismatched types"), "{message}");
    assert!(
        message.contains("submission.rs") && message.contains("expected `Mat3`, found integer"),
        "{message}"
    );
    assert_eq!(note, None);
}

#[test]
fn another_signature_is_said_in_our_words_too() {
    let source = "pub fn rotate_about_point(theta: f64) -> f64 { theta }\n";
    let Outcome::DoesNotCompile { note: Some(note), .. } = Bench::new().judge(source.as_bytes()).outcome
    else {
        panic!("no note")
    };
    assert!(note.contains("theta: f32, p: Vec2"), "{note}");
    let judgement = Bench::new().judge(b"fn something_else() {}\n");
    assert!(matches!(judgement.outcome, Outcome::DoesNotCompile { note: Some(_), .. }), "{judgement:?}");
}

#[test]
fn unsafe_code_is_refused() {
    let Outcome::DoesNotCompile { message, .. } = of_body("unsafe { std::mem::zeroed() }") else { panic!() };
    assert!(message.contains("unsafe"), "{message}");
}

#[test]
fn files_that_are_no_text_or_not_there_say_so() {
    let bench = Bench::new();
    assert_eq!(bench.judge(b"").outcome, Outcome::Unreadable(Unreadable::Empty));
    assert_eq!(bench.judge(b"\xef\xbb\xbf \r\n").outcome, Outcome::Unreadable(Unreadable::Empty));
    let torn = b"// one\n// two \xff\n";
    assert_eq!(bench.judge(torn).outcome, Outcome::Unreadable(Unreadable::NotUtf8 { line: 2 }));
    assert_eq!(bench.judge(&[b' '; 2 << 20]).outcome, Outcome::Unreadable(Unreadable::TooLong));
    assert_eq!(
        bench.judge_path(&bench.folder().join("gone.rs")).outcome,
        Outcome::Unreadable(Unreadable::Missing)
    );
    assert_eq!(bench.judge_path(bench.folder()).outcome, Outcome::Unreadable(Unreadable::NotAFile));
}

#[test]
fn a_byte_order_mark_and_windows_line_ends_are_welcome() {
    let body = "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";
    let text = String::from_utf8(in_function(body)).expect("text").replace('\n', "\r\n");
    let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    assert_eq!(Bench::new().judge(&marked).outcome, Outcome::Passed);
}

#[test]
fn a_forged_answer_is_no_answer() {
    // The channel is not the student's; whoever finds it and writes nonsense has not solved anything.
    let body = "use std::io::Write; use std::os::fd::AsFd;\n    \
                let own = std::io::stdin().as_fd().try_clone_to_owned().unwrap();\n    \
                let mut socket = std::os::unix::net::UnixStream::from(own);\n    \
                let _ = socket.write_all(&[255; 64]);\n    Mat3::IDENTITY";
    if cfg!(unix) {
        let outcome = of_body(body);
        assert!(matches!(outcome, Outcome::Crashed(_)), "{outcome:?}");
    }
}

#[test]
fn the_same_token_gives_the_same_bytes() {
    let bench = Bench::new();
    let source = in_function("Mat3::from_angle(theta)");
    let judged = |seed| bench.judge_with(&source, seed).json().to_string();
    assert_eq!(judged(5), judged(5));
    assert_ne!(judged(5), judged(6));
}

#[test]
fn a_function_that_remembers_is_unsteady_and_gains_nothing() {
    // Right at every first call of its process, and at every second one wrong by a little.
    let body = "use std::sync::atomic::{AtomicUsize, Ordering};\n    static ASKED: AtomicUsize = AtomicUsize::new(0);\n    \
        let p = if ASKED.fetch_add(1, Ordering::Relaxed) < 3 { p } else { Vec2::ZERO };\n    \
        Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";
    let judgement = Bench::new().judge(&in_function(body));
    assert!(matches!(judgement.outcome, Outcome::Unsteady(_)), "{:?}", judgement.outcome);
    assert!(judgement.laws.iter().any(|law| matches!(law.outcome, LawOutcome::Kept(_))));
    assert_eq!((judgement.points, judgement.forfeit), (0, Some(Forfeit::Unsteady)));
}

#[test]
fn a_constant_gains_nothing_by_failing_or_varying_in_some_calls() {
    let bodies = [
        "if theta > 3.0 { panic!(\"sometimes\") }\n    Mat3::IDENTITY",
        "if theta > 3.0 { loop {} }\n    Mat3::IDENTITY",
        "fn deep(n: u64) -> u64 { if n == u64::MAX { 0 } else { 1 + deep(n + 1) } }\n    if theta > 3.0 { deep(0); }\n    Mat3::IDENTITY",
        "if theta.to_bits() % 41 == 3 { Mat3::ZERO } else { Mat3::IDENTITY }",
        "if p.x.to_bits() % 31 == 3 { Mat3::from_angle(theta) } else { Mat3::IDENTITY }",
    ];
    let bench = Bench::new();
    for (judgement, body) in bench.judge_bodies(&bodies).iter().zip(bodies) {
        assert!(!matches!(judgement.outcome, Outcome::GraderError(_) | Outcome::Passed), "{judgement:?}");
        assert_eq!((judgement.points, judgement.forfeit), (0, Some(Forfeit::Constant)), "{body}");
    }
}

/// While the grader judges, somebody stops it and lets it go on: Ctrl-Z and `fg`, again and again.
#[cfg(target_os = "linux")]
#[test]
fn a_grader_that_is_stopped_and_goes_on_takes_nobodys_points() {
    let script = format!(
        "for i in $(seq 30); do kill -STOP {0}; sleep 0.02; kill -CONT {0}; sleep 0.02; done",
        std::process::id()
    );
    let bench = Bench::new();
    // It is never ended from here: that might leave this process stopped.
    let mut stopping = std::process::Command::new("/bin/sh").args(["-c", &script]).spawn().expect("a shell");
    let judgement = bench.judge(&slow(4));
    stopping.wait().expect("it ends");
    assert_eq!(judgement.outcome, Outcome::Passed, "{judgement:?}");
    assert_eq!(judgement.points, judgement.of);
}

#[test]
fn a_neighbour_that_burns_processors_takes_nobodys_time() {
    use course::{Answerer, Reply};
    use std::sync::atomic::{AtomicBool, Ordering};

    let mut bench = Bench::new();
    // By the clock each call takes far longer, beside so many threads.
    bench.limit_call(std::time::Duration::from_millis(400));
    let exercise = course::find("rotate_about_point").expect("the exercise");
    let opened = bench.open(exercise, &slow(60)).expect("compiled");
    let questions: Vec<_> = exercise.examples.iter().take(2).map(|it| it.arguments.clone()).collect();
    let over = AtomicBool::new(false);
    let replies = std::thread::scope(|scope| {
        for _ in 0..16 {
            scope.spawn(|| {
                while !over.load(Ordering::Relaxed) {
                    std::hint::spin_loop();
                }
            });
        }
        let replies = opened.ask().ask(&questions);
        over.store(true, Ordering::Relaxed);
        replies.expect("replies")
    });
    assert!(replies.iter().all(|reply| matches!(reply, Reply::Value(_))), "{replies:?}");
}

#[test]
fn answers_that_together_take_too_much_memory_are_not_kept() {
    let exercise = course::find("rasterize").expect("the exercise");
    let body = "(0..3500).map(|at| Pixel { i: at, j: 7 }).collect()";
    let mut bench = Bench::new();
    bench.limit_answers(1 << 20);
    let judgement = bench.judge_exercise(exercise, exercise.stub.replace("todo!()", body).as_bytes(), 1);
    let Outcome::Crashed(how) = &judgement.outcome else { panic!("{:?}", judgement.outcome) };
    assert!(how.contains("over 1 MiB"), "{how}");
    assert_eq!(judgement.points, 0);
}

#[test]
fn a_constant_keeps_laws_and_gains_nothing() {
    let judgement = Bench::new().judge(&in_function("Mat3::IDENTITY"));
    assert_eq!(judgement.outcome, Outcome::Wrong);
    assert!(judgement.laws.iter().any(|law| matches!(law.outcome, LawOutcome::Kept(_))));
    assert_eq!((judgement.points, judgement.forfeit), (0, Some(Forfeit::Constant)));
}
