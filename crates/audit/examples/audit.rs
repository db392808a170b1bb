//! Audits exercises and prints the table.
use grader::{Build, Compiler, Judge, Kit, Limits};
use std::path::Path;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crates/audit").to_owned();
    let kit = Kit::build(&root, Build::of("worker")).expect("the libraries");
    let folder = tempfile::tempdir().expect("a folder");
    let judge = Judge {
        compiler: Compiler { kit, root: folder.path().to_owned(), colour: false },
        limits: Limits::default(),
        scratch: folder.path().join("scratch"),
        memory: None,
    };
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    let seeds = names.pop().expect("seeds").parse().expect("seeds");
    let chosen: Vec<_> =
        course::all().iter().filter(|e| names.is_empty() || names.iter().any(|n| n == e.name)).collect();
    let begun = std::time::Instant::now();
    let report =
        audit::audit(&chosen, &judge, seeds, &|done| eprintln!("{:7.1?} {}", begun.elapsed(), done.name))
            .expect("a report");
    println!("{}", report.table());
    std::fs::write("/tmp/audit.json", format!("{:#}", report.json())).unwrap();
    eprintln!("{:?}", begun.elapsed());
}
