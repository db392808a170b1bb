//! A class that nobody taught: students who are right in several ways, wrong in every known way, have not begun, or mean harm. What each should get is known beforehand.

use std::fs;
use std::path::Path;

use course::{Exercise, Program};

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

/// Students who mean harm, by what they do in `rotate_about_point`; `lambert`, handed in beside it, is right and must stay so.
pub(crate) fn hostile() -> Vec<Student> {
    let bodies = BODIES.iter().map(|(name, outcomes, body)| {
        let stub = course::find("rotate_about_point").expect("the exercise").stub;
        student(name, outcomes, stub.replace("todo!()", body))
    });
    let files = FILES.iter().map(|(name, outcomes, before)| {
        let exercise = course::find("rotate_about_point").expect("the exercise");
        let text = exercise.submission(&exercise.reference).expect("its text");
        student(name, outcomes, format!("{text}\n{before}\n"))
    });
    bodies.chain(files).collect()
}

fn student(name: &str, outcomes: &'static [&'static str], text: String) -> Student {
    let lambert = course::find("lambert").expect("the exercise");
    let works = vec![
        Work {
            exercise: course::find("rotate_about_point").expect("the exercise"),
            text,
            outcomes,
            looks_like: None,
            points: Points::None,
        },
        Work {
            exercise: lambert,
            text: lambert.submission(&lambert.reference).expect("its text"),
            outcomes: &["passed"],
            looks_like: None,
            points: Points::All,
        },
    ];
    Student { name: name.to_owned(), works }
}

/// Name, outcomes, body of the function.
type Case = (&'static str, &'static [&'static str], &'static str);

/// What a function can do while it runs.
const BODIES: [Case; 24] = [
    ("=cmd()|' ' !A0", &["wrong"], "println!(\"{{\\\"points\\\": 1000}}\"); Mat3::IDENTITY"),
    ("<script>alert(1)<script>", &["exited"], "std::process::exit(0)"),
    ("quotes\"'` and\nlines", &["crashed"], "std::process::abort()"),
    ("loops", &["timed_out"], "loop { std::hint::spin_loop() }"),
    ("sleeps", &["timed_out"], "std::thread::sleep(std::time::Duration::from_secs(1000)); Mat3::IDENTITY"),
    (
        "recurses",
        &["stack_overflow"],
        "fn deep(n: u64) -> u64 { if n == 0 { 0 } else { 1 + deep(n + 1) } } if deep(1) > 0 { panic!() } Mat3::IDENTITY",
    ),
    (
        "allocates",
        &["out_of_memory"],
        "let all = vec![1_u8; 1 << 40]; Mat3::IDENTITY * f32::from(all[theta as usize])",
    ),
    ("prints without end", &["timed_out"], "loop { println!(\"{}\", \"x\".repeat(1000)) }"),
    (
        "reads passwords",
        &["panicked"],
        "Mat3::IDENTITY * std::fs::read(\"/etc/passwd\").unwrap().len() as f32",
    ),
    (
        "reads its memory",
        &["panicked"],
        "Mat3::IDENTITY * std::fs::read(\"/proc/self/mem\").unwrap().len() as f32",
    ),
    (
        "reads environments",
        &["panicked"],
        "Mat3::IDENTITY * std::fs::read(\"/proc/1/environ\").unwrap().len() as f32",
    ),
    (
        "reads solutions",
        &["panicked"],
        concat!(
            "Mat3::IDENTITY * std::fs::read_dir(\"",
            env!("CARGO_MANIFEST_DIR"),
            "/../course\").unwrap().count() as f32"
        ),
    ),
    ("writes here", &["panicked"], "std::fs::write(\"here\", [1; 1000]).unwrap(); Mat3::IDENTITY"),
    (
        "writes to tmp",
        &["panicked"],
        "std::fs::write(\"/tmp/lightlab-was-here\", [1; 1000]).unwrap(); Mat3::IDENTITY",
    ),
    (
        "fills the memory disk",
        &["panicked"],
        "loop { std::fs::write(\"/dev/shm/lightlab-was-here\", vec![1; 1 << 24]).unwrap() }",
    ),
    (
        "connects",
        &["panicked"],
        "std::net::TcpStream::connect(\"127.0.0.1:80\").map_err(|e| assert!(e.kind() == std::io::ErrorKind::ConnectionRefused)).ok(); std::net::TcpListener::bind(\"127.0.0.1:0\").unwrap(); Mat3::IDENTITY",
    ),
    ("sends", &["panicked"], "std::net::UdpSocket::bind(\"0.0.0.0:0\").unwrap(); Mat3::IDENTITY"),
    (
        "starts a shell",
        &["panicked"],
        "std::process::Command::new(\"/bin/sh\").args([\"-c\", \"kill -9 $PPID\"]).status().unwrap(); Mat3::IDENTITY",
    ),
    (
        "starts itself",
        &["timed_out"],
        "loop { let _ = std::process::Command::new(\"/proc/self/exe\").spawn(); }",
    ),
    (
        "starts threads",
        &["too_many_threads"],
        "loop { std::thread::spawn(|| loop { std::thread::park() }); }",
    ),
    (
        "answers by itself",
        &["crashed"],
        "use std::io::Write; use std::os::fd::AsFd; let fd = std::io::stdin().as_fd().try_clone_to_owned().unwrap(); std::fs::File::from(fd).write_all(&[255; 64]).unwrap(); Mat3::IDENTITY",
    ),
    (
        "remembers",
        &["unsteady"],
        "use std::sync::atomic::{AtomicUsize, Ordering}; static ASKED: AtomicUsize = AtomicUsize::new(0); let p = if ASKED.fetch_add(1, Ordering::Relaxed) < 3 { p } else { Vec2::ZERO }; Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)",
    ),
    ("says one thing", &["wrong"], "let _ = (theta, p); Mat3::from_angle(1.0)"),
    ("uses unsafe", &["does_not_compile"], "unsafe { std::mem::zeroed() }"),
];

/// What a file can do while it is compiled; it stands below a right solution.
const FILES: [Case; 8] = [
    ("includes passwords", &["does_not_compile"], "pub const SECRET: &str = include_str!(\"/etc/passwd\");"),
    (
        "includes solutions",
        &["does_not_compile"],
        concat!("include!(\"", env!("CARGO_MANIFEST_DIR"), "/../course/src/lib.rs\");"),
    ),
    ("asks for the environment", &["does_not_compile"], "pub const HOME: &str = env!(\"HOME\");"),
    (
        "takes a path",
        &["does_not_compile"],
        concat!("#[path = \"", env!("CARGO_MANIFEST_DIR"), "/../vocabulary/src/lighting.rs\"] mod taken;"),
    ),
    (
        "computes without end",
        &["does_not_compile"],
        "#[allow(long_running_const_eval)] pub const N: u64 = { let mut n = 0; loop { n += 1; if n == u64::MAX { break } } n };",
    ),
    (
        "expands without end",
        &["does_not_compile"],
        "macro_rules! more { ($($it:tt)*) => { more!($($it)* $($it)*); } }\nmore!(a b c d);",
    ),
    (
        "fills the compiler",
        &["does_not_compile"],
        "pub const MUCH: [[u64; 1 << 20]; 1 << 14] = [[7; 1 << 20]; 1 << 14]; pub static ALL: [[u64; 1 << 20]; 1 << 14] = MUCH;",
    ),
    (
        "grows a type",
        &["does_not_compile"],
        "const fn grow<T: Copy>(t: T, n: u32) -> usize { if n > 0 { grow((t, t), n - 1) } else { size_of::<T>() } }\nconst _: usize = grow(1_u8, 1000);",
    ),
];

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
