//! What comes out: a table for people, or one record a line for programs.

use std::io::{self, Write};
use std::time::Duration;

/// One entry of a row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    /// A number, and how many digits after the point the table shows.
    Number(f64, usize),
    /// A name.
    Word(String),
    /// A yes or no.
    Verdict(bool),
    /// Nothing is known or asked.
    Empty,
}

/// Milliseconds.
pub(crate) fn ms(time: Duration) -> Cell {
    Cell::Number(time.as_secs_f64() * 1e3, 2)
}

/// A count.
pub(crate) fn count(n: usize) -> Cell {
    Cell::Number(n as f64, 0)
}

/// Where rows go.
pub(crate) struct Report {
    out: Box<dyn Write + Send>,
    json: bool,
    header: Vec<&'static str>,
}

/// The column of the case's name in characters; the others are as wide as their title, and at least as this.
const NAME: usize = 24;
const COLUMN: usize = 9;

impl Report {
    /// A report that writes to `out`.
    pub(crate) fn new(out: Box<dyn Write + Send>, json: bool) -> Self {
        Self { out, json, header: Vec::new() }
    }

    /// A sentence for people; programs do not see it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(crate) fn say(&mut self, sentence: &str) -> io::Result<()> {
        if self.json {
            return Ok(());
        }
        self.header.clear();
        writeln!(self.out, "{sentence}")
    }

    /// One row, shown at once: measuring takes long. Where its columns differ from those of the row before, a header
    /// comes first.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(crate) fn row(&mut self, case: &str, cells: &[(&'static str, Cell)]) -> io::Result<()> {
        if self.json {
            writeln!(self.out, "{}", record(case, cells))?;
        } else {
            self.table_row(case, cells)?;
        }
        self.out.flush()
    }

    fn table_row(&mut self, case: &str, cells: &[(&'static str, Cell)]) -> io::Result<()> {
        if !self.header.iter().eq(cells.iter().map(|(title, _)| title)) {
            self.header = cells.iter().map(|(title, _)| *title).collect();
            write!(self.out, "\n{:NAME$}", "case")?;
            for title in &self.header {
                write!(self.out, "  {title:>width$}", width = width(title))?;
            }
            writeln!(self.out)?;
        }
        write!(self.out, "{case:NAME$}")?;
        for (title, cell) in cells {
            write!(self.out, "  {:>width$}", shown(cell), width = width(title))?;
        }
        writeln!(self.out)
    }
}

fn width(title: &str) -> usize {
    title.chars().count().max(COLUMN)
}

fn shown(cell: &Cell) -> String {
    match cell {
        Cell::Number(x, digits) => format!("{x:.digits$}"),
        Cell::Word(word) => word.clone(),
        Cell::Verdict(true) => "yes".to_owned(),
        Cell::Verdict(false) => "no".to_owned(),
        Cell::Empty => "–".to_owned(),
    }
}

/// The row as one JSON object, its fields named as the columns, with _ for a space.
fn record(case: &str, cells: &[(&'static str, Cell)]) -> String {
    let mut fields = serde_json::Map::new();
    fields.insert("case".to_owned(), case.into());
    for (title, cell) in cells {
        let value = match cell {
            Cell::Number(x, 0) => (*x as u64).into(),
            Cell::Number(x, _) => (*x).into(),
            Cell::Word(word) => word.as_str().into(),
            Cell::Verdict(verdict) => (*verdict).into(),
            Cell::Empty => serde_json::Value::Null,
        };
        fields.insert(title.replace(' ', "_"), value);
    }
    serde_json::Value::Object(fields).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_one_line_of_json_with_full_precision() {
        let cells = [
            ("ours ms", ms(Duration::from_micros(1234))),
            ("reached", Cell::Verdict(true)),
            ("target", Cell::Empty),
        ];
        let text = record("draw \"x\"", &cells);
        let value: serde_json::Value = text.parse().expect("JSON");
        assert!(!text.contains('\n'));
        assert_eq!(value["case"], "draw \"x\"");
        assert_eq!(value["ours_ms"], 1.234);
        assert_eq!((value["reached"].as_bool(), value["target"].is_null()), (Some(true), true));
    }

    #[test]
    fn columns_stand_under_their_titles() {
        let cell = Cell::Number(2.0, 1);
        assert_eq!(shown(&cell), "2.0");
        assert_eq!(width("ours ms"), COLUMN);
        assert_eq!(width("a long title"), 12);
    }
}
