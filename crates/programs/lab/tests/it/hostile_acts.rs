//! What a hostile file can do, while it runs and while it is compiled, and which outcome that should have.

/// A thing that is done.
pub(crate) struct Case {
    /// What it is.
    pub(crate) name: &'static str,
    /// Any of these outcomes is the right one.
    pub(crate) outcomes: &'static [&'static str],
    /// How.
    pub(crate) act: Act,
    /// Whether it goes on until a limit of time or of the compiler's memory ends it: for seconds, whatever the machine.
    pub(crate) is_slow: bool,
}

/// How something is done in a file.
#[derive(Clone, Copy)]
pub(crate) enum Act {
    /// By another body of `rotate_about_point`.
    Instead(&'static str),
    /// By a statement in front of a right body, in any exercise.
    First(&'static str),
    /// By an item below a right function, in any exercise.
    Beside(&'static str),
}

const fn case(name: &'static str, outcomes: &'static [&'static str], act: Act) -> Case {
    Case { name, outcomes, act, is_slow: false }
}

const fn slow(name: &'static str, outcomes: &'static [&'static str], act: Act) -> Case {
    Case { name, outcomes, act, is_slow: true }
}

use Act::{Beside, First, Instead};

/// All that is done.
pub(crate) const ACTS: [Case; 32] = [
    case("prints points", &["wrong"], Instead("println!(\"{{\\\"points\\\": 1000}}\"); Mat3::IDENTITY")),
    case("exits", &["exited"], First("std::process::exit(0)")),
    case("aborts", &["crashed"], First("std::process::abort()")),
    slow("loops", &["timed_out"], First("loop { std::hint::spin_loop() }")),
    slow("sleeps", &["timed_out"], First("std::thread::sleep(std::time::Duration::from_secs(1000))")),
    case(
        "recurses",
        &["stack_overflow"],
        First(
            "fn deep(n: u64) -> u64 { if n == 0 { 0 } else { 1 + deep(n + 1) } } if deep(1) > 0 { panic!() }",
        ),
    ),
    case(
        "allocates",
        &["out_of_memory"],
        First("std::hint::black_box(vec![1_u8; std::hint::black_box(1 << 40)])"),
    ),
    slow("prints without end", &["timed_out"], First("loop { println!(\"{}\", \"x\".repeat(1000)) }")),
    case("reads passwords", &["panicked"], First("let _ = std::fs::read(\"/etc/passwd\").unwrap()")),
    case("reads its memory", &["panicked"], First("let _ = std::fs::read(\"/proc/self/mem\").unwrap()")),
    case("reads environments", &["panicked"], First("let _ = std::fs::read(\"/proc/1/environ\").unwrap()")),
    case(
        "reads solutions",
        &["panicked"],
        First(concat!(
            "let _ = std::fs::read_dir(\"",
            env!("CARGO_MANIFEST_DIR"),
            "/../course\").unwrap().count()"
        )),
    ),
    case("writes here", &["panicked"], First("std::fs::write(\"here\", [1; 1000]).unwrap()")),
    case(
        "writes to tmp",
        &["panicked"],
        First("std::fs::write(\"/tmp/lightlab-was-here\", [1; 1000]).unwrap()"),
    ),
    case(
        "fills the memory disk",
        &["panicked"],
        First("loop { std::fs::write(\"/dev/shm/lightlab-was-here\", vec![1; 1 << 24]).unwrap() }"),
    ),
    case(
        "connects",
        &["panicked"],
        First(
            "std::net::TcpStream::connect(\"127.0.0.1:80\").map_err(|e| assert!(e.kind() == std::io::ErrorKind::ConnectionRefused)).ok(); \
             std::net::TcpListener::bind(\"127.0.0.1:0\").unwrap()",
        ),
    ),
    case("sends", &["panicked"], First("std::net::UdpSocket::bind(\"0.0.0.0:0\").unwrap()")),
    case(
        "starts a shell",
        &["panicked"],
        First("std::process::Command::new(\"/bin/sh\").args([\"-c\", \"kill -9 $PPID\"]).status().unwrap()"),
    ),
    slow(
        "starts itself",
        &["timed_out"],
        First("loop { let _ = std::process::Command::new(\"/proc/self/exe\").spawn(); }"),
    ),
    case(
        "starts threads",
        &["too_many_threads"],
        First("loop { std::thread::spawn(|| loop { std::thread::park() }); }"),
    ),
    case(
        "answers by itself",
        &["crashed"],
        First(
            "{ use std::io::Write; use std::os::fd::AsFd; let fd = std::io::stdin().as_fd().try_clone_to_owned().unwrap(); \
             std::fs::File::from(fd).write_all(&[255; 64]).unwrap() }",
        ),
    ),
    case(
        "remembers",
        &["unsteady"],
        Instead(
            "use std::sync::atomic::{AtomicUsize, Ordering}; static ASKED: AtomicUsize = AtomicUsize::new(0); \
             let p = if ASKED.fetch_add(1, Ordering::Relaxed) < 3 { p } else { Vec2::ZERO }; \
             Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)",
        ),
    ),
    case("says one thing", &["wrong"], Instead("let _ = (theta, p); Mat3::from_angle(1.0)")),
    case("uses unsafe", &["does_not_compile"], First("let _: u8 = unsafe { std::mem::zeroed() }")),
    case(
        "includes passwords",
        &["does_not_compile"],
        Beside("pub const SECRET: &str = include_str!(\"/etc/passwd\");"),
    ),
    case(
        "includes solutions",
        &["does_not_compile"],
        Beside(concat!("include!(\"", env!("CARGO_MANIFEST_DIR"), "/../course/src/lib.rs\");")),
    ),
    case("asks for the environment", &["does_not_compile"], Beside("pub const HOME: &str = env!(\"HOME\");")),
    case(
        "takes a path",
        &["does_not_compile"],
        Beside(concat!(
            "#[path = \"",
            env!("CARGO_MANIFEST_DIR"),
            "/../vocabulary/src/lighting.rs\"] mod taken;"
        )),
    ),
    slow(
        "computes without end",
        &["does_not_compile"],
        Beside(
            "#[allow(long_running_const_eval)] pub const N: u64 = { let mut n = 0; loop { n += 1; if n == u64::MAX { break } } n };",
        ),
    ),
    slow(
        "expands without end",
        &["does_not_compile"],
        Beside("macro_rules! more { ($($it:tt)*) => { more!($($it)* $($it)*); } }\nmore!(a b c d);"),
    ),
    case(
        "fills the compiler",
        &["does_not_compile"],
        Beside(
            "pub const MUCH: [[u64; 1 << 20]; 1 << 14] = [[7; 1 << 20]; 1 << 14]; pub static ALL: [[u64; 1 << 20]; 1 << 14] = MUCH;",
        ),
    ),
    slow(
        "grows a type",
        &["does_not_compile"],
        Beside(
            "const fn grow<T: Copy>(t: T, n: u32) -> usize { if n > 0 { grow((t, t), n - 1) } else { size_of::<T>() } }\n\
             const _: usize = grow(1_u8, 1000);",
        ),
    ),
];
