//! What is wrong with a file, where, and what to do about it?

/// Why a file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {problem}; {remedy}", place(file, *line))]
pub struct ObjError {
    /// The OBJ or MTL file.
    pub file: String,
    /// The line, counted from 1; `None` if it is about the file as a whole.
    pub line: Option<usize>,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

/// What was left out or replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjWarning {
    /// The OBJ or MTL file.
    pub file: String,
    /// The first line that it is about, counted from 1; `None` if it is about the file as a whole.
    pub line: Option<usize>,
    /// What there was and what became of it.
    pub message: String,
    /// How many lines have the same fate.
    pub count: usize,
}

impl ObjError {
    pub(super) fn new(
        file: &str,
        line: Option<usize>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self { file: file.to_owned(), line, problem: problem.into(), remedy: remedy.into() }
    }
}

impl std::fmt::Display for ObjWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", place(&self.file, self.line), self.message)?;
        match self.count {
            1 => Ok(()),
            count => write!(f, " ({count} times)"),
        }
    }
}

fn place(file: &str, line: Option<usize>) -> String {
    line.map_or_else(|| file.to_owned(), |line| format!("{file}:{line}"))
}

/// Text from a file, fit for a message: quoted, without control characters and not endless.
pub(super) fn quoted(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown: String =
        text.chars().take(LONGEST).map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    format!("'{shown}'")
}

/// The warnings so far; those with the same words are counted, not repeated.
#[derive(Default)]
pub(super) struct Warnings {
    list: Vec<ObjWarning>,
    places: std::collections::HashMap<(String, String), usize>,
}

impl Warnings {
    /// More different warnings than this help nobody; the rest is only counted.
    const MOST: usize = 100;

    pub(super) fn add(&mut self, file: &str, line: Option<usize>, message: impl Into<String>) {
        let mut message = message.into();
        let is_known = self.places.contains_key(&(file.to_owned(), message.clone()));
        let (file, line) = if is_known || self.list.len() < Self::MOST {
            (file.to_owned(), line)
        } else {
            message = "further warnings are left out".to_owned();
            (String::from("…"), None)
        };
        let place = *self.places.entry((file.clone(), message.clone())).or_insert_with(|| {
            self.list.push(ObjWarning { file, line, message, count: 0 });
            self.list.len() - 1
        });
        self.list[place].count += 1;
    }

    pub(super) fn into_vec(self) -> Vec<ObjWarning> {
        self.list
    }
}
