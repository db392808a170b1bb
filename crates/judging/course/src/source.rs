//! How does a program of an exercise's file become a student's file? Its function is cut out and stands where `todo!()` stood; functions of the
//! same file that it calls come along.

use crate::exercise::{Exercise, Program};

impl Exercise {
    /// A student's file with this program: the handed-out file, its function replaced. `None` if the program's function is not in
    /// the exercise's file, beginning in the first column.
    pub fn submission(&self, program: &Program) -> Option<String> {
        let function = cut_out(self.source, program.name)?;
        let signature = self.stub.find(&format!("pub fn {}", self.name))?;
        let named = format!("pub fn {}{}", self.name, &function[function.find('(')?..]);
        let called: String =
            called(self.source, program.name, function).map(|text| format!("\n{text}\n")).collect();
        Some(format!("{}{named}\n{called}", &self.stub[..signature]))
    }
}

/// The text of a top-level function, from `fn` to the brace that closes it, which stands alone in the first column.
fn cut_out<'a>(source: &'a str, name: &str) -> Option<&'a str> {
    let begin = source.find(&format!("\nfn {name}("))? + 1;
    let end = begin + source[begin..].find("\n}\n")? + 2;
    Some(&source[begin..end])
}

/// The other top-level functions that a function calls, and that these call, in the order in which they are met.
fn called<'a>(source: &'a str, name: &str, function: &'a str) -> impl Iterator<Item = &'a str> {
    let names: Vec<&str> = source
        .lines()
        .filter_map(|line| line.strip_prefix("fn ")?.split_once('(').map(|(name, _)| name))
        .collect();
    let mut met: Vec<&str> = vec![name];
    let mut texts: Vec<&'a str> = vec![function];
    let mut at = 0;
    while at < texts.len() {
        for name in &names {
            if !met.contains(name)
                && calls(texts[at], name)
                && let Some(text) = cut_out(source, name)
            {
                met.push(name);
                texts.push(text);
            }
        }
        at += 1;
    }
    texts.into_iter().skip(1)
}

/// Whether the name stands in the text as a word of its own, before a parenthesis.
fn calls(text: &str, name: &str) -> bool {
    text.match_indices(&format!("{name}(")).any(|(at, _)| {
        !text[..at].ends_with(|before: char| before.is_alphanumeric() || "_.:".contains(before))
    })
}
