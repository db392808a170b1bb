//! The words of a Rust file, without what stands in comments and literals. Enough to find a word wherever the compiler would see it, in macros and as a
//! raw identifier too.

use std::iter::Peekable;
use std::str::CharIndices;

/// A word or a sign of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Token<'a> {
    /// An identifier or keyword without its `r#`, or one sign.
    pub(crate) text: &'a str,
    /// Where it begins, in bytes.
    pub(crate) at: usize,
}

/// All tokens of a file but its numbers, lifetimes and literals.
pub(crate) fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut reader = Reader { text, rest: text.char_indices().peekable() };
    std::iter::from_fn(|| reader.next()).collect()
}

struct Reader<'a> {
    text: &'a str,
    rest: Peekable<CharIndices<'a>>,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Option<Token<'a>> {
        loop {
            let (at, c) = self.rest.next()?;
            match c {
                '/' if self.takes('/') => self.skip_while(|c| c != '\n'),
                '/' if self.takes('*') => self.comment(),
                '"' => self.string(),
                '\'' => self.quote(),
                c if c.is_ascii_digit() => self.skip_while(continues),
                c if begins(c) => {
                    self.skip_while(continues);
                    if let Some(token) = self.word(at) {
                        return Some(token);
                    }
                }
                c if c.is_whitespace() => {}
                c => return Some(Token { text: &self.text[at..at + c.len_utf8()], at }),
            }
        }
    }

    /// The word that was just read; `None` if it only introduces a literal.
    fn word(&mut self, at: usize) -> Option<Token<'a>> {
        let text = &self.text[at..self.at()];
        match (text, self.rest.peek().map(|(_, c)| *c)) {
            ("b" | "c", Some('"')) => {
                self.rest.next();
                self.string();
            }
            ("b", Some('\'')) => {
                self.rest.next();
                self.quote();
            }
            ("r" | "br" | "cr", Some('"' | '#')) => return self.raw(),
            _ => return Some(Token { text, at }),
        }
        None
    }

    /// A raw string, which is skipped, or a raw identifier.
    fn raw(&mut self) -> Option<Token<'a>> {
        let mut hashes = 0;
        while self.takes('#') {
            hashes += 1;
        }
        let at = self.at();
        if self.takes('"') {
            let end = format!("\"{}", "#".repeat(hashes));
            let end = self.text[self.at()..]
                .find(&end)
                .map_or(self.text.len(), |found| self.at() + found + end.len());
            while self.rest.next_if(|(at, _)| *at < end).is_some() {}
            return None;
        }
        self.skip_while(continues);
        Some(Token { text: &self.text[at..self.at()], at }).filter(|token| !token.text.is_empty())
    }

    /// The rest of a character, or of a lifetime.
    fn quote(&mut self) {
        match self.rest.next() {
            Some((_, '\\')) => {
                self.rest.next();
                self.skip_while(|c| c != '\'');
                self.rest.next();
            }
            // One sign between two quotes is a character; a lifetime ends without one.
            Some((_, c)) if !self.takes('\'') && begins(c) => {
                self.skip_while(continues);
                if self.takes('#') {
                    self.skip_while(continues);
                }
            }
            _ => {}
        }
    }

    fn string(&mut self) {
        while let Some((_, c)) = self.rest.next() {
            match c {
                '"' => return,
                '\\' => drop(self.rest.next()),
                _ => {}
            }
        }
    }

    /// The rest of a comment; comments nest.
    fn comment(&mut self) {
        let mut open = 1;
        while open > 0 {
            match self.rest.next() {
                Some((_, '*')) if self.takes('/') => open -= 1,
                Some((_, '/')) if self.takes('*') => open += 1,
                Some(_) => {}
                None => return,
            }
        }
    }

    fn takes(&mut self, wanted: char) -> bool {
        self.rest.next_if(|(_, c)| *c == wanted).is_some()
    }

    fn skip_while(&mut self, skipped: impl Fn(char) -> bool) {
        while self.rest.next_if(|(_, c)| skipped(*c)).is_some() {}
    }

    /// Where the next character begins.
    fn at(&mut self) -> usize {
        self.rest.peek().map_or(self.text.len(), |(at, _)| *at)
    }
}

fn begins(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn continues(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        tokens(text).into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn words_are_found_wherever_the_compiler_sees_them() {
        assert_eq!(words("r#asm /* ! */ !(x)"), ["asm", "!", "(", "x", ")"]);
        assert_eq!(words("macro_rules! m{($t:tt)=>{$t!()}}").len(), 20);
        assert_eq!(words("a::/* /* */ \" */b"), ["a", ":", ":", "b"]);
        assert_eq!(words("r##\"x\"#\"##asm"), ["asm"]);
        assert_eq!(words("br\"\\\" asm"), ["asm"], "a raw string has no escapes");
        assert_eq!(words("1.0e5f32..asm"), [".", ".", ".", "asm"]);
    }

    #[test]
    fn what_stands_in_literals_comments_and_lifetimes_is_no_word() {
        assert_eq!(words("\"asm\" b\"asm\" c\"asm\" r\"asm\" cr#\"asm\"# br##\"asm\"##"), [] as [&str; 0]);
        assert_eq!(words("// asm\n/* asm /* asm */ asm */ /// asm"), [] as [&str; 0]);
        assert_eq!(words("'asm 'r#asm 'a' '\\'' '\"' b'\\\\' b'\"' '\\u{61}' 'é'"), [] as [&str; 0]);
        assert_eq!(words("\"\\\\\" asm \"\\\" asm\""), ["asm"]);
    }
}
