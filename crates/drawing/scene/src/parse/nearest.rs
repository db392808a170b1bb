//! Which word was meant? The known one that takes the fewest strokes to mend.

/// The word of `known` nearest to `word`, if it is near: at most a third of its letters wrong.
pub(super) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    // A word far longer than all known ones is near to none; do not spend time on it.
    let longest = known.iter().map(|k| k.len()).max().unwrap_or(0);
    if word.len() > 2 * longest {
        return None;
    }
    let near = known.iter().map(|k| (edits(word, k), *k)).min()?;
    (3 * near.0 <= near.1.chars().count().max(3)).then_some(near.1)
}

/// How many letters must be put in, left out, changed or swapped with their neighbour (Damerau and Levenshtein).
fn edits(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    // Row i has the numbers of edits from the first i letters of a to the first 0, 1, 2… of b.
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let changed = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let put_in_or_left_out = 1 + rows[i - 1][j].min(row[j - 1]);
            let is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            let swapped = if is_swapped { 1 + rows[i - 2][j - 2] } else { usize::MAX };
            row.push(changed.min(put_in_or_left_out).min(swapped));
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
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
        assert_eq!(edits("eey", "eye"), 1);
    }
}
