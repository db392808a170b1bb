//! Where in the file is it, and is it known there? Tables of a TOML text that refuse keys nobody reads.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeTable;

use super::nearest::nearest;
use super::value::{Value, plain};
use crate::SceneError;

/// The text of a scene file and its name in messages.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) file: &'a str,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// The error at a place of the text.
    pub(crate) fn fault(
        &self,
        span: &Range<usize>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> SceneError {
        // An end of the parser's span may lie inside a character or behind the text when the text is cut off.
        let mut start = span.start.min(self.text.len());
        while !self.text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &self.text[..start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        SceneError {
            file: self.file.to_owned(),
            line: Some(before.matches('\n').count() + 1),
            column: Some(before[line_start..].chars().count() + 1),
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }
}

/// A table and its place; its keys are known ones.
#[derive(Clone)]
pub(super) struct Table<'a> {
    pub(super) source: Source<'a>,
    pub(super) path: String,
    pub(super) entries: &'a DeTable<'a>,
    pub(super) span: Range<usize>,
}

impl<'a> Table<'a> {
    /// The table at the root of a file.
    pub(super) fn root(
        source: Source<'a>,
        root: &'a Spanned<DeTable<'a>>,
        known: &[&str],
    ) -> Result<Self, SceneError> {
        // The span of the root is the whole text; what is missing in it is missing at its start.
        let table = Self { source, path: String::new(), entries: root.get_ref(), span: 0..0 };
        table.check_keys(known)?;
        Ok(table)
    }

    /// The value of `key`, if it is there.
    pub(super) fn get(&self, key: &str) -> Option<Value<'a>> {
        let value = self.entries.get(key)?;
        Some(Value {
            source: self.source,
            path: self.path_of(key),
            value: value.get_ref(),
            span: value.span(),
        })
    }

    /// The value of `key`, which must be there; `remedy` says what to write.
    pub(super) fn need(&self, key: &str, remedy: &str) -> Result<Value<'a>, SceneError> {
        self.get(key).ok_or_else(|| self.fault(format!("`{}` is missing", self.path_of(key)), remedy))
    }

    /// All keys and values, in the alphabetical order of the keys.
    pub(super) fn entries(&self) -> impl Iterator<Item = (String, Value<'a>)> + '_ {
        let keys = self.entries.iter().map(|(key, _)| key.get_ref().to_string());
        keys.filter_map(|key| self.get(&key).map(|value| (key, value)))
    }

    /// The error about the table as a whole.
    pub(super) fn fault(&self, problem: impl Into<String>, remedy: impl Into<String>) -> SceneError {
        self.source.fault(&self.span, problem, remedy)
    }

    /// Refuses keys other than the `known` ones.
    pub(super) fn check_keys(&self, known: &[&str]) -> Result<(), SceneError> {
        for (key, _) in self.entries {
            let name: &str = key.get_ref();
            if !known.contains(&name) {
                let problem = format!("unknown key `{}`", self.path_of(name));
                let remedy = nearest(name, known).map_or_else(
                    || format!("the keys here are {}", known.join(", ")),
                    |near| format!("did you mean `{near}`?"),
                );
                return Err(self.source.fault(&key.span(), problem, remedy));
            }
        }
        Ok(())
    }

    fn path_of(&self, key: &str) -> String {
        let key = plain(key);
        if self.path.is_empty() { key } else { format!("{}.{key}", self.path) }
    }
}
