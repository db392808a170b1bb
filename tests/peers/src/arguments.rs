//! What was asked for on the command line.

/// What `--help` prints.
pub(crate) const HELP: &str = "\
Draws and traces the same scenes with lightlab and with other renderers in Rust, and prints how many times as fast ours is.

usage: cargo run --release -p lightlab-peers [-- [--json] [--quick] [FILTER]]

  FILTER    only cases with these words in their name, such as `draw`, `1M`, `rays 69k`, `memory`
  --quick   fewer rounds and smaller scenes: less than a minute
  --json    one record a case a line
  --help    this page

exit code: 0 if all see the same, 1 if somebody sees something else, 2 if the arguments make no sense
";

/// The arguments, understood.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Arguments {
    /// Records instead of a table.
    pub(crate) json: bool,
    /// Fewer rounds.
    pub(crate) quick: bool,
    /// Only `--help`.
    pub(crate) help: bool,
    /// Words in the names of cases.
    pub(crate) filter: Option<String>,
    /// Not for people: the process is a child that measures its own memory.
    pub(crate) memory_of: Option<String>,
}

impl Arguments {
    /// Reads them.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub(crate) fn parse(words: impl IntoIterator<Item = String>) -> Result<Self, String> {
        let mut arguments = Self::default();
        let mut words = words.into_iter();
        while let Some(word) = words.next() {
            match word.as_str() {
                "--json" => arguments.json = true,
                "--quick" => arguments.quick = true,
                "--help" | "-h" => arguments.help = true,
                crate::memory::CHILD => {
                    arguments.memory_of = Some(words.next().ok_or("the memory of what?")?);
                }
                option if option.starts_with('-') => return Err(format!("there is no option {option}")),
                _ if arguments.filter.is_some() => {
                    return Err(format!("one filter is enough, «{word}» is a second"));
                }
                _ => arguments.filter = Some(word),
            }
        }
        Ok(arguments)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<Arguments, String> {
        Arguments::parse(line.split_whitespace().map(str::to_owned))
    }

    #[test]
    fn options_and_a_filter_come_in_any_order() {
        let expected =
            Arguments { json: true, quick: true, filter: Some("1M".to_owned()), ..Arguments::default() };
        assert_eq!(parse("1M --json --quick"), Ok(expected.clone()));
        assert_eq!(parse("--quick --json 1M"), Ok(expected));
        assert_eq!(parse(""), Ok(Arguments::default()));
    }

    #[test]
    fn what_makes_no_sense_is_named() {
        assert!(parse("--jsn").unwrap_err().contains("--jsn"));
        assert!(parse("draw rays").unwrap_err().contains("rays"));
        assert!(parse(crate::memory::CHILD).is_err());
    }
}
