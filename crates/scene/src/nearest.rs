//! Which word was meant? The known one that takes the fewest strokes to mend.

/// The word of `known` nearest to `word`, if it is near: at most a third of its letters wrong.
pub(crate) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    // A word far longer than all known ones is near to none; do not spend time on it.
    let longest = known.iter().map(|k| k.len()).max().unwrap_or(0);
    if word.len() > 2 * longest {
        return None;
    }
    let near = known.iter().map(|k| (edits(word, k), *k)).min()?;
    (3 * near.0 <= near.1.chars().count().max(3)).then_some(near.1)
}

/// Levenshtein's distance: how many letters must be put in, left out or changed.
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for j in 0..b.len() {
            let changed = diagonal + usize::from(letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_pen_is_recognized_and_another_word_is_not() {
        let known = ["diffuse", "specular", "exponent"];
        assert_eq!(nearest("difuse", &known), Some("diffuse"));
        assert_eq!(nearest("exponnet", &known), Some("exponent"));
        assert_eq!(nearest("roughness", &known), None);
        assert_eq!(nearest("", &known), None);
    }

    #[test]
    fn edits_are_counted_as_by_hand() {
        assert_eq!(edits("kitten", "sitting"), 3);
        assert_eq!(edits("", "abc"), 3);
    }
}
