//! Words that no solution needs, and with which a file could reach what is not its own: the linker, machine code, the compiler's surroundings.
//!
//! `-F unsafe_code` refuses most of it, but not all. A refused word costs a student nothing unnoticed: `cargo lab check` refuses it too.

use crate::tokens::{Token, tokens};

/// A word that was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Forbidden<'a> {
    pub(crate) word: &'a str,
    /// What it could reach.
    pub(crate) reaches: &'static str,
    /// Where it stands, both from 1.
    pub(crate) line: usize,
    pub(crate) column: usize,
}

/// The first word of a file that is refused.
pub(crate) fn first(text: &str) -> Option<Forbidden<'_>> {
    // The compiler ignores a first line that names an interpreter, whatever quotes stand in it.
    let body =
        if text.trim_start_matches('\u{feff}').starts_with("#!") { text.find('\n').unwrap_or(0) } else { 0 };
    [0, body].into_iter().find_map(|from| {
        let tokens = tokens(&text[from..]);
        let (at, reaches) = tokens
            .iter()
            .enumerate()
            .find_map(|(at, token)| Some((at, reaches(token.text, tokens.get(at + 1))?)))?;
        let Token { text: word, at } = tokens[at];
        let before = &text[..from + at];
        let line = 1 + before.matches('\n').count();
        let column = 1 + before.rsplit('\n').next().unwrap_or_default().chars().count();
        Some(Forbidden { word, reaches, line, column })
    })
}

/// What a word reaches, if it is refused where it stands.
fn reaches(word: &str, next: Option<&Token<'_>>) -> Option<&'static str> {
    let next = next.map_or("", |token| token.text);
    Some(match word {
        "asm" | "global_asm" | "naked_asm" | "naked" => "machine code",
        "extern" | "no_mangle" | "export_name" | "link_section" | "link_name" | "linkage" => "the linker",
        "unsafe" if next == "(" => "what the compiler cannot check",
        "macro_export" | "macro_use" => "the names of other files",
        "include_str" | "include_bytes" => "other files",
        "option_env" => "the environment of the compiler",
        // Modules and variables have such names too.
        "include" if next == "!" || next == "as" => "other files",
        "env" if next == "!" || next == "as" => "the environment of the compiler",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn refused(text: &str, word: &str) {
        assert_eq!(first(text).map(|found| found.word), Some(word), "{text}");
    }

    #[test]
    fn words_that_reach_beyond_the_file_are_refused() {
        for (text, word) in [
            ("#[unsafe(naked)] fn f() {}", "unsafe"),
            ("#[cfg_attr(all(), r#unsafe /* */ (naked))] fn f() {}", "unsafe"),
            ("fn f() { core::arch::naked_asm!(\"ret\") }", "naked_asm"),
            ("use std::arch::{global_asm as g}; g!(\".incbin \\\"/etc/passwd\\\"\");", "global_asm"),
            ("macro_rules! m { () => { r#asm!(\"\") } }", "asm"),
            (
                "macro_rules! m { ($a:ident) => { #[$a = \"x\"] static S: u8 = 1; } } m!(link_section);",
                "link_section",
            ),
            ("unsafe extern \"C\" { safe fn missing(); }", "extern"),
            ("#[macro_export] macro_rules! stringify { () => {} }", "macro_export"),
            ("const P: Option<&str> = option_env!(\"PATH\");", "option_env"),
            ("const P: &str = env /**/ !(\"PATH\");", "env"),
            ("use std::env as e; const P: &str = e!(\"PATH\");", "env"),
            ("const B: &[u8] = include_bytes!(\"x\");", "include_bytes"),
            ("include!(\"x\");", "include"),
            ("#!/bin/sh \"\nextern crate x; // \"", "extern"),
        ] {
            refused(text, word);
        }
    }

    #[test]
    fn the_place_is_that_of_the_word() {
        let found = first("// é\n  let é = asm!(\"\");").expect("refused");
        assert_eq!((found.line, found.column), (2, 11));
    }

    #[test]
    fn solutions_and_harmless_words_are_accepted() {
        for exercise in course::all() {
            for program in [&exercise.reference].into_iter().chain(&exercise.variants) {
                let text = exercise.submission(program).expect("its text");
                assert_eq!(first(&text), None, "{}", exercise.name);
            }
            assert_eq!(first(exercise.stub), None, "{}", exercise.name);
        }
        for text in [
            "let env = 1; let include = env;",
            "std::env::args()",
            "// asm!\nlet s = \"extern\";",
            "#![allow(dead_code)]",
        ] {
            assert_eq!(first(text), None, "{text}");
        }
    }
}
