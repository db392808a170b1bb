//! Time, memory, threads, disk.

use grader::Outcome;

use crate::bench::{Bench, LOOPS, in_function};
use crate::hostile::{RIGHT, assert_outcomes, assert_refused};

#[test]
fn an_endless_loop_is_timed_out_with_one_thread_and_with_many() {
    let bodies = [
        "loop { std::hint::spin_loop() }",
        "std::thread::spawn(|| loop { std::hint::spin_loop() });\n    loop { std::thread::park() }",
        "loop { println!(\"{}\", \"x\".repeat(1000)); eprintln!(\"y\"); }",
    ];
    assert_outcomes(&bodies, |outcome| *outcome == LOOPS);
}

#[test]
fn endless_recursion_fills_the_stack_also_where_the_process_cannot_read_where_its_stack_ends() {
    let deep = "fn deep(n: u64) -> u64 { if n == u64::MAX { 0 } else { 1 + deep(n + 1) } }";
    let body = format!("{deep}\n    Mat3::IDENTITY * deep(0) as f32");
    let thread = format!("{deep}\n    std::thread::spawn(|| deep(0)).join().unwrap(); Mat3::IDENTITY");
    assert_outcomes(&[&body, &thread], |outcome| *outcome == Outcome::StackOverflow);
}

#[test]
fn too_much_memory_is_refused() {
    let bodies = [
        "let much = vec![0_u8; 1 << 40];\n    Mat3::IDENTITY * f32::from(much[7])",
        "let mut much = Vec::new();\n    loop { much.push(vec![0_u8; 1 << 20]); }",
        "std::thread::spawn(|| { let mut much = Vec::new(); loop { much.push(vec![0_u8; 1 << 20]); } });\n    loop { std::thread::park() }",
    ];
    assert_outcomes(&bodies, |outcome| *outcome == Outcome::OutOfMemory);
}

#[test]
fn data_of_the_program_itself_that_do_not_fit_are_too_much_memory() {
    let Some(mut bench) = Bench::confined() else { return };
    bench.limit_memory(128 << 20);
    // To write so much takes the compiler a while.
    bench.limit_compiling(std::time::Duration::from_secs(10));
    assert_eq!(bench.judge(&in_function(RIGHT)).outcome, Outcome::Passed, "it is enough for an exercise");
    let body = format!(
        "static MUCH: std::sync::Mutex<[u8; 256 << 20]> = std::sync::Mutex::new([0; 256 << 20]);\n    \
         MUCH.lock().unwrap()[theta.abs() as usize] = 1;\n    {RIGHT}"
    );
    assert_eq!(bench.judge(&in_function(&body)).outcome, Outcome::OutOfMemory);
}

#[test]
fn forty_threads_a_call_are_welcome() {
    let Some(mut bench) = Bench::confined() else { return };
    bench.limit_whole(std::time::Duration::from_secs(60));
    let body = format!(
        "std::thread::scope(|scope| {{ for _ in 0..40 {{ scope.spawn(|| std::hint::black_box(vec![1_u8; 5000])); }} }});\n    {RIGHT}"
    );
    assert_eq!(bench.judge(&in_function(&body)).outcome, Outcome::Passed);
}

#[test]
fn threads_without_end_are_refused_in_one_way_however_they_are_started() {
    let park = "|| loop { std::thread::park() }";
    let bodies = [
        format!("loop {{ std::thread::spawn({park}); }}"),
        format!("std::thread::scope(|scope| loop {{ scope.spawn({park}); }})"),
        format!("std::thread::spawn(|| loop {{ std::thread::spawn({park}); }}).join().unwrap(); {RIGHT}"),
        "fn bomb() { loop { std::thread::spawn(bomb); } }\n    bomb();\n    Mat3::IDENTITY".to_owned(),
        "loop { std::thread::spawn(|| { let much = vec![1_u8; 3000]; std::thread::park(); drop(much); }); }"
            .to_owned(),
    ];
    assert_outcomes(&bodies.each_ref().map(String::as_str), |outcome| *outcome == Outcome::TooManyThreads);
}

#[test]
fn threads_are_bounded_by_memory_whatever_stack_they_ask_for() {
    let many = |stack: &str| {
        let attack = format!(
            "(0..2000).all(|_| std::thread::Builder::new().stack_size({stack}).spawn(|| loop {{ std::thread::park() }}).is_ok())"
        );
        format!("if {attack} {{ return {RIGHT}; }}\n    panic!(\"refused\")")
    };
    let bodies = [many("1"), many("1 << 16"), many("1 << 21")];
    // Where the memory ends while a thread with a small stack is already beginning, the thread ends the worker.
    assert_outcomes(&bodies.each_ref().map(String::as_str), |outcome| match outcome {
        Outcome::Panicked(panic) => panic.message == "refused",
        Outcome::TooManyThreads | Outcome::OutOfMemory => true,
        _ => false,
    });
}

#[test]
fn no_process_is_started_by_a_bomb_of_processes() {
    let processes = "(0..100).any(|_| std::process::Command::new(\"/proc/self/exe\").spawn().is_ok())";
    assert_refused(&[processes.to_owned()]);
}

#[test]
fn files_without_end_are_refused() {
    let body = "use std::os::fd::AsFd;\n    let mut all = Vec::new();\n    \
                loop { all.push(std::io::stdin().as_fd().try_clone_to_owned().unwrap()); }";
    assert_outcomes(
        &[body],
        |outcome| matches!(outcome, Outcome::Panicked(panic) if panic.message.contains("Too many open files")),
    );
}

#[test]
fn no_disk_is_filled() {
    let fill = |folder: &str| {
        format!(
            "std::fs::File::create(\"{folder}/lightlab-fill\").is_ok_and(|mut file| std::io::Write::write_all(&mut file, &[0; 4096]).is_ok())"
        )
    };
    assert_refused(&["/tmp", "/dev/shm", "/var/tmp", "."].map(fill));
}

#[test]
fn ending_the_process_is_no_answer_before_one_or_after_some() {
    let after = |end: &str| {
        format!(
            "static CALLS: std::sync::atomic::AtomicU32 = std::sync::atomic::AtomicU32::new(0);\n    \
             if CALLS.fetch_add(1, std::sync::atomic::Ordering::Relaxed) == 0 {{ std::thread::spawn(|| {{ {end} }}); }}\n    \
             if CALLS.load(std::sync::atomic::Ordering::Relaxed) > 1 {{ loop {{}} }}\n    {RIGHT}"
        )
    };
    let exits = ["std::process::exit(0)".to_owned(), after("std::process::exit(0)")];
    assert_outcomes(&exits.each_ref().map(String::as_str), |outcome| *outcome == Outcome::Exited(0));
    let aborts = ["std::process::abort()".to_owned(), after("std::process::abort()")];
    assert_outcomes(&aborts.each_ref().map(String::as_str), |outcome| matches!(outcome, Outcome::Crashed(_)));
}
