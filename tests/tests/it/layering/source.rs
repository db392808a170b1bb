//! What does a crate use of the world around it? Its sources say it, without tests and comments.

use std::fs;
use std::path::{Path, PathBuf};

/// Every Rust file of a crate's library or program, without its tests and examples.
pub(crate) fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut folders = vec![folder.join("src")];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a source folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                files.push(path);
            }
        }
    }
    files
}

/// Modules of the standard library through which a program touches the world or keeps threads.
const WORLD: [&str; 6] = ["env", "fs", "net", "os", "process", "thread"];

/// Of `std::io`, what works in memory.
const IN_MEMORY: [&str; 2] = ["io::Cursor", "io::Write"];

const MACROS: [&str; 6] = ["println!", "eprintln!", "print!", "eprint!", "dbg!", "thread_local!"];

/// What a concept crate may not have: use of the world around it, printing, global state. One entry an offence.
pub(crate) fn offences(text: &str) -> Vec<String> {
    let lines = without_tests_and_comments(text);
    let mut found: Vec<String> =
        lines.iter().filter(|line| is_static(line)).map(|line| line.trim().to_owned()).collect();
    let code = lines.join("\n");
    let is_forbidden = |path: &String| {
        let module = path.split("::").next().unwrap_or_default();
        WORLD.contains(&module)
            || module == "io" && !IN_MEMORY.iter().any(|allowed| path.starts_with(allowed))
            || module == "*"
    };
    found.extend(paths_in_std(&code).into_iter().filter(is_forbidden).map(|path| format!("std::{path}")));
    found.extend(MACROS.iter().filter(|name| has_word(&code, name)).map(|name| (*name).to_owned()));
    found.extend(code.contains("use std as").then(|| "std by another name".to_owned()));
    found
}

/// A `static` is global state, or might as well be a `const`.
fn is_static(line: &str) -> bool {
    let line = line.trim_start();
    let item = match line.strip_prefix("pub") {
        Some(rest) if rest.starts_with('(') => rest.split_once(')').map_or(rest, |(_, item)| item),
        Some(rest) => rest,
        None => line,
    };
    item.trim_start().starts_with("static ")
}

/// The lines of a file that is formatted by rustfmt, so that an item ends with a bracket below its beginning.
pub(crate) fn without_tests_and_comments(text: &str) -> Vec<&str> {
    let mut lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let mut rest = Vec::new();
    while let Some(line) = lines.next() {
        if line.trim() != "#[cfg(test)]" {
            rest.push(line);
            continue;
        }
        let indent = &line[..line.len() - line.trim_start().len()];
        let is_end = |line: &&str| {
            line.strip_prefix(indent)
                .is_some_and(|line| line == "}" || !line.starts_with(' ') && line.ends_with(';'))
        };
        lines.find(is_end);
    }
    rest
}

/// The paths below `std` (and `core`, `alloc`): those of `std::{fmt, io::{self, Write}}` are fmt, io::self, io::Write.
fn paths_in_std(code: &str) -> Vec<String> {
    let code: String = code.chars().filter(|c| !c.is_whitespace()).collect();
    code.match_indices("std::").flat_map(|(at, _)| paths(&code[at + "std::".len()..])).collect()
}

/// The paths that a text without spaces begins with.
fn paths(text: &str) -> Vec<String> {
    let Some(group) = text.strip_prefix('{') else {
        let end = text.find(|c: char| !(c.is_alphanumeric() || "_:*".contains(c))).unwrap_or(text.len());
        let (path, rest) = text.split_at(end);
        // `io::{…}` goes on in a group.
        return match path.strip_suffix("::") {
            Some(head) if rest.starts_with('{') => {
                paths(rest).into_iter().map(|tail| format!("{head}::{tail}")).collect()
            }
            _ => vec![path.to_owned()],
        };
    };
    let (mut depth, mut start, mut found) = (0, 0, Vec::new());
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                found.extend(paths(&group[start..at]).into_iter().filter(|path| !path.is_empty()));
                start = at + 1;
                if c == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    found
}

/// Whether the code calls a macro of this name, and not one whose name ends like it.
fn has_word(code: &str, name: &str) -> bool {
    let before = |at: usize| code[..at].chars().next_back().unwrap_or(' ');
    code.match_indices(name).any(|(at, _)| !(before(at).is_alphanumeric() || before(at) == '_'))
}

#[test]
fn what_is_forbidden_is_found_however_it_is_written() {
    for text in [
        "use std::fs;",
        "use std::{fmt, fs};",
        "use std::{\n    fmt,\n    io::{self, Write},\n};",
        "use std::{collections::{HashMap, HashSet}, env};",
        "fn f() {\n    std::process::exit(1);\n}",
        "use std::io::stdout;",
        "use std::io;",
        "use std::*;",
        "use std as other;",
        "static COUNT: AtomicUsize = AtomicUsize::new(0);",
        "pub(crate) static TABLE: LazyLock<Vec<f32>> = LazyLock::new(Vec::new);",
        "    pub static mut LAST: u32 = 0;",
        "thread_local! {\n}",
        "fn f() {\n    eprint!(\"x\");\n}",
        "#[cfg(test)]\nmod tests {\n    use std::fs;\n}\n\nfn f() {\n    println!();\n}",
        "#[cfg(test)]\nuse std::fs;\nuse std::net;",
    ] {
        assert_eq!(offences(text).len(), 1, "{text}: {:?}", offences(text));
    }
}

#[test]
fn what_is_allowed_is_let_pass() {
    for text in [
        "// use std::fs;\nuse std::io::{Cursor, Write};",
        "use std::sync::{Arc, OnceLock};\nstruct S {\n    traced: OnceLock<u32>,\n}",
        "fn f(x: &'static str) {}",
        "impl S {\n    #[cfg(test)]\n    fn f() {\n        println!();\n    }\n\n    fn g() {}\n}",
        "#[cfg(test)]\nmod tests;\nuse std::fmt;",
        "my_println!();",
    ] {
        assert!(offences(text).is_empty(), "{text}: {:?}", offences(text));
    }
}
