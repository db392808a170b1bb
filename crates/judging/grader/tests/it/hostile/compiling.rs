//! What is done to the compiler, and by it.

use grader::{Judgement, Outcome};

use crate::bench::{Bench, in_function, root};
use crate::hostile::{RIGHT, assert_outcomes, judged};

/// A file with something beside a right function.
fn beside(something: &str) -> Vec<u8> {
    [something.as_bytes(), b"\n", &in_function(RIGHT)[..]].concat()
}

/// Asserts that rustc refuses each of these, whatever it says.
fn assert_refused(sources: &[Vec<u8>]) -> Vec<String> {
    let judgements: Vec<Judgement> = judged(sources);
    let said = |(judgement, source): (&Judgement, &Vec<u8>)| match &judgement.outcome {
        Outcome::DoesNotCompile { message, .. } => {
            assert_eq!(judgement.points, 0);
            message.clone()
        }
        other => panic!("{}: {other:?}", String::from_utf8_lossy(source)),
    };
    judgements.iter().zip(sources).map(said).collect()
}

#[test]
fn no_file_outside_is_included() {
    let references = root().join("crates/judging/course/src/transforms/rotate_about_point.rs");
    let other = tempfile::NamedTempFile::new().expect("a file");
    let libraries = libraries_of_the_course();
    let mut paths = vec![references.display().to_string(), other.path().display().to_string()];
    paths.extend(
        ["/etc/passwd", "/etc/hostname", "/proc/self/environ", "/proc/self/maps", "/dev/zero"]
            .map(str::to_owned),
    );
    paths.extend(libraries);
    let sources: Vec<Vec<u8>> = paths
        .iter()
        .map(|path| beside(&format!("const STOLEN: &[u8] = include_bytes!({path:?});")))
        .collect();
    for message in assert_refused(&sources) {
        assert!(message.contains("`include_bytes` reaches other files"), "{message}");
    }
    // The sandbox refuses it too, where a word is hidden from who looks for it.
    let hidden = |path: &String| {
        let macros = "macro_rules! call { ($i:ident, $path:expr) => { mod taken { $i!($path); } } }";
        beside(&format!("{macros}\ncall!(include, {path:?});"))
    };
    for message in assert_refused(&paths.iter().map(hidden).collect::<Vec<_>>()) {
        assert!(message.contains("couldn't read"), "{message}");
    }
    let references = references.display();
    assert_refused(&[
        beside(&format!("const STOLEN: &str = include_str!(\"{references}\");")),
        beside(&format!("mod stolen {{ include!(\"{references}\"); }}")),
        beside(&format!("#[path = \"{references}\"] mod stolen;")),
        beside("extern crate course;"),
        beside("extern crate raytrace;"),
        beside("extern crate serde;"),
        beside("const HOME: &str = env!(\"HOME\");"),
        beside("const FOLDER: &str = env!(\"CARGO_MANIFEST_DIR\");"),
        beside("const _: () = assert!(option_env!(\"HOME\").is_some());"),
        beside("unsafe extern \"C\" { safe fn getppid() -> i32; }"),
        beside("#[unsafe(no_mangle)] pub fn malloc() {}"),
    ]);
}

/// The libraries with the solutions, as cargo built them for these tests.
fn libraries_of_the_course() -> Vec<String> {
    let program = std::env::current_exe().expect("the path of these tests");
    let folder = program.parent().expect("deps");
    let entries = std::fs::read_dir(folder).expect("deps is readable");
    let libraries: Vec<String> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| {
            let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            name.starts_with("libcourse-") && name.ends_with(".rlib")
        })
        .map(|path| path.display().to_string())
        .take(1)
        .collect();
    assert!(!libraries.is_empty(), "these tests are linked with it");
    libraries
}

#[test]
fn the_compiler_knows_nothing_that_a_file_could_tell() {
    let home = std::env::var("HOME").unwrap_or_default();
    let ask = |name: &str| {
        format!("macro_rules! ask {{ ($i:ident) => {{ $i!(\"{name}\") }} }}\n    panic!(\"{{}}\", ask!(env))")
    };
    assert_outcomes(&[&ask("PATH"), &ask("TMPDIR")], |outcome| match outcome {
        Outcome::Panicked(panic) => {
            panic.message == "." || !panic.message.contains(&home) && !panic.message.contains("target")
        }
        _ => false,
    });
}

#[test]
fn what_a_program_is_made_of_beside_rust_is_refused() {
    let naked = "#[unsafe(naked)] extern \"C\" fn naked() { core::arch::naked_asm!(\"ret\") }";
    let sources = [
        beside(naked),
        beside("core::arch::global_asm!(\".incbin \\\"/etc/passwd\\\"\");"),
        beside("#[macro_export] macro_rules! stringify { ($($it:tt)*) => { 7 } }"),
        beside("#[unsafe(link_section = \".init_array\")] static BEGIN: fn() = || std::process::exit(0);"),
        beside("unsafe extern \"C\" { safe fn there_is_none(); } pub fn call() { there_is_none() }"),
    ];
    for message in assert_refused(&sources) {
        assert!(message.starts_with("error: `") && message.contains("submission.rs:1:"), "{message}");
    }
}

#[test]
fn evaluation_without_end_is_stopped() {
    let messages = assert_refused(&[beside(
        "#![allow(long_running_const_eval)]\nconst N: u64 = { let mut i = 0; while i < u64::MAX { i += 1; } i };",
    )]);
    for message in messages {
        assert!(message.contains("stopped after 2 s"), "{message}");
    }
}

#[test]
fn macros_types_and_constants_that_explode_are_stopped() {
    let grow = "fn grow<T: Clone>(n: u32, t: T) { if n > 0 { grow(n - 1, (t.clone(), t)) } }";
    let pairs: String = (0..60).map(|at| format!("let x{} = (x{at}, x{at});", at + 1)).collect();
    assert_refused(&[
        beside("macro_rules! more { ($($t:tt)*) => { more!{ $($t)* $($t)* } } }\nmore!{a}"),
        beside(&format!("fn explode() {{ let x0 = 1_u8; {pairs} std::hint::black_box(&x60); }}")),
        in_function(&format!("{grow}\n    if theta > 1e9 {{ grow(9, 1_u8) }}\n    {RIGHT}")),
        beside("static MUCH: [u64; 1 << 36] = [1; 1 << 36];"),
        beside(&format!("const DEEP: i32 = {}1{};", "(".repeat(100_000), ")".repeat(100_000))),
    ]);
}

#[test]
fn a_message_that_looks_like_our_fault_is_the_files_own() {
    for text in [
        "error[E0514]: found crate `worker` compiled by an incompatible version of rustc",
        "E0460",
        "main.rs",
    ] {
        let source = beside(&format!("compile_error!({:?});", format!("\n{text}\n{text}")));
        for judgement in judged(&[source]) {
            assert!(
                matches!(judgement.outcome, Outcome::DoesNotCompile { note: None, .. }),
                "{:?}",
                judgement.outcome
            );
        }
    }
}

#[test]
fn thousands_of_errors_are_not_passed_on() {
    let errors: String = (0..3000).map(|at| format!("fn e{at}() -> u8 {{ \"no number\" }}\n")).collect();
    let source = beside(&errors);
    for message in assert_refused(&[source]) {
        assert!(message.len() < 70 << 10, "{} bytes", message.len());
        assert!(message.contains("The compiler says more"), "{}", &message[message.len() - 200..]);
    }
}

#[test]
fn the_judge_says_beforehand_whether_it_can_compile_and_start_anything() {
    let Some(bench) = Bench::confined() else { return };
    assert_eq!(bench.judge_itself().rehearse(), Ok(()));
}

#[test]
fn what_a_file_makes_the_compiler_say_does_not_make_it_our_fault() {
    let body = "compile_error!(\"could not exec the linker `cc`\"); Mat3::IDENTITY";
    assert_outcomes(&[body], |outcome| matches!(outcome, Outcome::DoesNotCompile { .. }));
}
