//! How does a string that a stranger chose come into a report? Without anything that moves a cursor, turns the line around, or is no
//! character of XML; and cut to a length.
//!
//! What is special in HTML, Markdown, XML or CSV is escaped where that format is written; this is what none of them can show.

/// The text in lines, with every character harmless: escape sequences of terminals are taken out, what is left of control characters
/// becomes U+FFFD, what turns the direction of the line is named, and lines end in LF.
pub fn plain(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '\u{1b}' | '\u{9b}' => skip_sequence(c, &mut rest),
            '\r' => {
                if rest.peek() != Some(&'\n') {
                    shown.push('\n');
                }
            }
            '\n' | '\t' => shown.push(c),
            '\u{2028}' | '\u{2029}' => shown.push('\n'),
            _ if turns_the_line(c) => shown.push_str(&format!("⟨U+{:04X}⟩", u32::from(c))),
            // The last two of every plane are no characters; XML 1.0 forbids two of them.
            _ if c.is_control() || u32::from(c) & 0xfffe == 0xfffe => shown.push('\u{fffd}'),
            _ => shown.push(c),
        }
    }
    shown
}

/// Whether letters after it may stand before it: what made "Trojan source" possible.
fn turns_the_line(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Skips what belongs to an escape sequence that began with `first`: ECMA-48's control sequences and control strings.
fn skip_sequence(first: char, rest: &mut std::iter::Peekable<std::str::Chars<'_>>) {
    let introducer = if first == '\u{9b}' { Some('[') } else { rest.next_if(|c| matches!(c, ' '..='~')) };
    match introducer {
        Some('[') => {
            while rest.next_if(|c| matches!(c, ' '..='?')).is_some() {}
            rest.next_if(|c| matches!(c, '@'..='~'));
        }
        // A control string ends with BEL or ESC \; one that ends with neither is dropped to the end of its line.
        Some(']' | 'P' | 'X' | '^' | '_') => {
            while rest.next_if(|c| !matches!(c, '\u{7}' | '\u{1b}' | '\n')).is_some() {}
            if rest.next_if_eq(&'\u{1b}').is_some() {
                rest.next_if_eq(&'\\');
            } else {
                rest.next_if_eq(&'\u{7}');
            }
        }
        Some(' '..='/') => {
            rest.next_if(|c| matches!(c, ' '..='~'));
        }
        _ => {}
    }
}

/// The text as one line, for names: whatever is blank becomes one space.
pub fn line(text: &str) -> String {
    let words = plain(text);
    let line = words.split_whitespace().collect::<Vec<_>>().join(" ");
    cut(&line, MOST_OF_A_LINE)
}

/// A name need not be longer.
const MOST_OF_A_LINE: usize = 400;

/// The beginning of the text, at most so many bytes, what was left out included: "… (12 more bytes)".
pub fn cut(text: &str, most: usize) -> String {
    if text.len() <= most {
        return text.to_owned();
    }
    let more = |kept: usize| format!("… ({} more bytes)", text.len() - kept);
    // The remark is longest where nothing is kept.
    let mut end = most.saturating_sub(more(0).len());
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    let remark = more(end);
    if end + remark.len() <= most { format!("{}{remark}", &text[..end]) } else { String::new() }
}

/// The beginning of what [`plain`] makes of a text, at most so many bytes and a remark. Of megabytes only the beginning is looked at.
pub fn beginning(text: &str, most: usize) -> String {
    // Escape sequences vanish: a few times as much is looked at.
    let mut end = text.len().min(4 * most);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    let shown = plain(&text[..end]);
    let shown = cut(shown.trim_end(), most);
    let left_out = text.len() - end;
    if left_out > 0 { format!("{shown}\n… ({left_out} more bytes)") } else { shown }
}

/// Whether it is SVG that may become a part of a page: well-formed, and without anything that runs or loads.
pub fn is_harmless_svg(svg: &str) -> bool {
    let Ok(document) = roxmltree::Document::parse(svg) else { return false };
    if document.root_element().tag_name().name() != "svg" {
        return false;
    }
    document.root_element().descendants().filter(roxmltree::Node::is_element).all(|element| {
        let runs = matches!(
            element.tag_name().name(),
            "script" | "foreignObject" | "image" | "use" | "a" | "animate" | "set" | "iframe"
        );
        let loads = element.attributes().any(|attribute| {
            attribute.name().starts_with("on")
                || attribute.name().ends_with("href")
                || attribute.value().contains("url(")
        });
        !runs && !loads
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_moves_a_cursor_is_gone_and_what_was_written_stays() {
        assert_eq!(plain("\x1b[1;31merror\x1b[0m: a\x1b]0;title\x07b\x1b(Bc\u{9b}2Jd"), "error: abcd");
        assert_eq!(plain("\x1b]8;;https://example.org\x1b\\link\x1b]8;;\x1b\\"), "link");
        assert_eq!(plain("a\r\nb\rc\u{2028}d"), "a\nb\nc\nd");
        assert_eq!(plain("\x1b"), "");
        assert_eq!(plain("\x1b]never ends\nnext"), "\nnext");
    }

    #[test]
    fn no_character_is_left_that_xml_forbids_or_that_turns_the_line() {
        let every: String = (0..0x1_1000).filter_map(char::from_u32).collect();
        for text in [every.clone(), plain(&every)] {
            let xml = format!("<a>{}</a>", text.replace('&', "&amp;").replace('<', "&lt;"));
            let is_xml = roxmltree::Document::parse(&xml).is_ok();
            assert_eq!(is_xml, text != every);
        }
        assert!(plain(&every).chars().all(|c| !turns_the_line(c)));
        assert_eq!(plain("a\u{202e}b\0"), "a⟨U+202E⟩b\u{fffd}");
    }

    #[test]
    fn a_line_is_one_line() {
        assert_eq!(line(" O'Neil\n\t\"Bobby\"  \r\n"), "O'Neil \"Bobby\"");
        assert!(line(&"é".repeat(10_000)).len() <= MOST_OF_A_LINE);
    }

    #[test]
    fn a_text_is_cut_between_characters_and_says_how_much_is_missing() {
        assert_eq!(cut("short", 5), "short");
        for most in 0..80 {
            let text = "é€𝄞".repeat(50);
            let short = cut(&text, most);
            assert!(short.len() <= most, "{short:?} is over {most} bytes");
            if let Some((kept, remark)) = short.split_once('…') {
                assert_eq!(remark, format!(" ({} more bytes)", text.len() - kept.len()));
                assert!(text.starts_with(kept));
            }
        }
    }

    #[test]
    fn of_megabytes_the_beginning_is_shown_and_the_rest_is_counted() {
        let text = "abc\x1b[1m".repeat(1_000_000);
        let shown = beginning(&text, 100);
        assert!(shown.starts_with("abcabc") && shown.len() < 200, "{shown}");
        assert!(shown.ends_with(&format!("… ({} more bytes)", text.len() - 400)), "{shown}");
        assert_eq!(beginning("abc\n\n", 100), "abc");
    }

    #[test]
    fn only_a_drawing_may_become_a_part_of_a_page() {
        let svg = |inside: &str| format!("<svg xmlns='http://www.w3.org/2000/svg'>{inside}</svg>");
        assert!(is_harmless_svg(&svg("<path d='M0 0L1 1'/><text>1 &lt; 2</text>")));
        for bad in [
            "<script>1</script>",
            "<g onload='1'/>",
            "<a href='https://example.org'/>",
            "<path fill='url(#x)'/>",
            "<b>",
            "<foreignObject/>",
        ] {
            assert!(!is_harmless_svg(&svg(bad)), "{bad}");
        }
        assert!(!is_harmless_svg("<html/>") && !is_harmless_svg("NaN"));
    }
}
