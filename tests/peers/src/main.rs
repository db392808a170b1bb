//! How fast are we? The same scenes drawn and traced by other renderers in Rust, and the ratios. The README says what
//! is compared, and how fair it is.

#![forbid(unsafe_code)]

mod arguments;
mod drawing;
mod live;
mod memory;
mod ours;
mod report;
mod run;
mod scaling;
mod scenes;
mod targets;
mod threads;
mod timing;
mod tracing;

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use arguments::Arguments;
use report::Report;
use run::{Run, Verdict};

fn main() -> ExitCode {
    let arguments = match Arguments::parse(std::env::args().skip(1)) {
        Ok(arguments) => arguments,
        Err(why) => return complain(2, &format!("{why}; --help says what there is")),
    };
    let done = if arguments.help {
        io::stdout().write_all(arguments::HELP.as_bytes()).map(|()| Verdict::Fine)
    } else if let Some(what) = &arguments.memory_of {
        memory::child(what).map(|()| Verdict::Fine)
    } else {
        measure(&arguments)
    };
    match done {
        Ok(Verdict::Fine) => ExitCode::SUCCESS,
        Ok(Verdict::Disagree(why)) => complain(1, &format!("not everybody sees the same\n{why}")),
        Ok(Verdict::NoCase(why)) => complain(2, &why),
        // Whoever reads has read enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => complain(1, &error.to_string()),
    }
}

/// A message where errors go; if nobody listens there either, the code must do.
fn complain(code: u8, why: &str) -> ExitCode {
    let _ = writeln!(io::stderr(), "error: {why}");
    ExitCode::from(code)
}

/// All cases, one section after the other, on one thread unless a case says otherwise.
fn measure(arguments: &Arguments) -> io::Result<Verdict> {
    let mut run = Run::new(arguments, Report::new(Box::new(io::stdout()), arguments.json));
    run.report.say(&conditions())?;
    threads::pinned(1).install(|| {
        drawing::run(&mut run)?;
        live::run(&mut run)?;
        tracing::run(&mut run)?;
        scaling::run(&mut run)?;
        memory::run(&mut run)?;
        let seconds = run.elapsed().as_secs();
        run.report.say(&format!("\n{seconds} s"))?;
        Ok(run.verdict())
    })
}

/// Under which conditions the numbers hold.
fn conditions() -> String {
    let compiled = if cfg!(all(target_arch = "x86_64", not(target_feature = "fma"))) {
        "compiled for any x86-64 processor: peers are slower than they could be, ours chooses its instructions when it runs; \
         RUSTFLAGS=\"-C target-cpu=native\" gives them theirs, at another --target-dir"
    } else {
        "compiled for this processor"
    };
    format!(
        "ratio: a peer's median time over ours, from the same rounds. One thread, {}.\nours: {}\n{compiled}",
        threads::pinning(),
        ours::VERSION
    )
}
