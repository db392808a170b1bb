//! Where does a line end? At LF, CR LF or CR, unless a backslash continues it. A comment is never continued.

use std::borrow::Cow;

use super::message::{ObjError, quoted};

/// A line of text with the numbers and words on it.
pub(super) struct Line<'a> {
    /// Counted from 1; of the first line, where a backslash continued it.
    pub(super) number: usize,
    pub(super) text: Cow<'a, str>,
}

/// The text in `bytes`.
///
/// # Errors
/// If it is not UTF-8: with the line where it stops being so.
pub(super) fn decode<'a>(bytes: &'a [u8], file: &str) -> Result<&'a str, ObjError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    std::str::from_utf8(bytes).map_err(|error| {
        let good = &bytes[..error.valid_up_to()];
        let line = 1 + good.iter().filter(|byte| **byte == b'\n').count();
        let byte = bytes[error.valid_up_to()];
        let problem = format!("byte {byte:#04x} is not UTF-8 text");
        ObjError::new(file, Some(line), problem, "save the file as UTF-8 (a binary format is not read)")
    })
}

/// The lines of `text`, continued ones joined.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    // Old Macintosh files end lines with CR alone; elsewhere a CR before the LF counts as white space.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let mut rest = text.split(end).zip(1..);
    std::iter::from_fn(move || {
        let (first, number) = rest.next()?;
        let has_comments = !is_name(first);
        let Some(start) = continued(first, has_comments) else {
            return Some(Line { number, text: Cow::Borrowed(first) });
        };
        let mut joined = start.to_owned();
        for (next, _) in rest.by_ref() {
            joined.push(' ');
            let Some(start) = continued(next, has_comments) else {
                joined.push_str(next);
                break;
            };
            joined.push_str(start);
        }
        Some(Line { number, text: Cow::Owned(joined) })
    })
}

/// Returns the part before the backslash that continues the line. A backslash at the end of a comment, as in
/// `# D:\models\`, continues nothing.
fn continued(line: &str, has_comments: bool) -> Option<&str> {
    let is_comment = has_comments && line.contains('#');
    line.trim_end_matches('\r').strip_suffix('\\').filter(|_| !is_comment)
}

/// Whether the line holds the name of a material or a file, in which '#' is a letter.
fn is_name(line: &str) -> bool {
    matches!(line.split_whitespace().next(), Some("usemtl" | "mtllib" | "newmtl"))
}

/// The number that `word` is, within the range of f32 and with the digits of f64.
pub(super) fn number(word: &str, file: &str, line: usize) -> Result<f64, ObjError> {
    let error = |problem: &str, remedy: &str| {
        ObjError::new(file, Some(line), format!("{} {problem}", quoted(word)), remedy)
    };
    match word.parse::<f64>() {
        Ok(value) if (value as f32).is_finite() => Ok(value),
        Ok(value) if value.is_nan() => Err(error("is not a number", "write a finite number such as 0.25")),
        Ok(_) => Err(error("is out of range", "write a number between -3.4e38 and 3.4e38")),
        Err(_) if word.contains(',') => Err(error(
            "is not a number",
            "write decimals with a point, as in 0.25, and spaces between numbers",
        )),
        Err(_) => Err(error("is not a number", "write a number such as 0.25 or -1e-3")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<(usize, String)> {
        lines(text).map(|line| (line.number, line.text.trim().to_owned())).collect()
    }

    #[test]
    fn lines_end_as_on_every_system() {
        let want = vec![(1, "v 1".to_owned()), (2, "f 2".to_owned())];
        for text in ["v 1\nf 2", "v 1\r\nf 2", "v 1\rf 2"] {
            assert_eq!(all(text), want, "{text:?}");
        }
    }

    #[test]
    fn continued_line_has_the_number_of_its_first() {
        let want = vec![(1, "f 1  2  3".to_owned()), (4, "v 7".to_owned())];
        assert_eq!(all("f 1 \\\n2 \\\r\n3\nv 7"), want);
        assert_eq!(all("f 1\\"), vec![(1, "f 1".to_owned())]);
    }

    #[test]
    fn comment_is_never_continued() {
        let face = (2, "f 1".to_owned());
        for text in ["# D:\\models\\\nf 1", "# D:\\models\\\r\nf 1", "# D:\\models\\\rf 1"] {
            assert_eq!(all(text)[1], face, "{text:?}");
        }
        // Nor is one behind numbers, or on a line that continues another.
        assert_eq!(all("v 1 # \\\nf 1")[1], face);
        assert_eq!(all("v \\\n1 # \\\nf 1")[1], (3, "f 1".to_owned()));
        // In a name '#' is a letter.
        assert_eq!(all("usemtl a#\\\nb"), [(1, "usemtl a# b".to_owned())]);
    }

    #[test]
    fn bad_bytes_are_found_on_their_line() {
        let error = decode(b"v 1\nv \xff 2\n", "x.obj").unwrap_err();
        assert_eq!(error.line, Some(2));
        assert_eq!(decode(b"\xef\xbb\xbfv 1", "x.obj"), Ok("v 1"));
    }

    #[test]
    fn numbers_out_of_range_or_none_are_errors() {
        assert_eq!(number("-2.5e-3", "x", 7), Ok(-0.0025));
        for bad in ["1e999", "-1e39", "inf", "nan", "1,5", "0x10", "", "1.0.0", "--1"] {
            assert_eq!(number(bad, "x", 7).unwrap_err().line, Some(7), "{bad}");
        }
    }
}
