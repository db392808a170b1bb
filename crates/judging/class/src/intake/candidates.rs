//! Which of a submission's files is the solution of which exercise?

use std::collections::BTreeMap;
use std::sync::LazyLock;

use course::Exercise;
use regex_lite::Regex;

use crate::results::{Audience, Notice};

/// So many names are listed in one notice; of the rest only the number.
const LISTED: usize = 8;

/// The file's name again and again: "lambert (1).rs", "lambert-2.rs", "lambert - Copy.rs".
static COPIES: LazyLock<Option<Regex>> =
    LazyLock::new(|| Regex::new(r"(?i)^(.+?)(?:[ _-]*(?:\(\d+\)|copy|kopie)|-\d+)*\.rs$").ok());

/// Folders that nobody means to hand in.
const STRAY: [&str; 4] = ["__MACOSX", "target", "node_modules", ".git"];

/// A file of a submission: where it lies, and how its bytes are found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Found<Place> {
    /// Its path in the submission, with `/`.
    pub(super) path: String,
    /// A platform's number or date; of two files of one exercise the greater one is the newer.
    pub(super) attempt: String,
    pub(super) place: Place,
}

/// How well a file fits its exercise; the best is the greatest.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Fit {
    exact: bool,
    attempt: String,
    in_its_folder: bool,
    shallow: std::cmp::Reverse<usize>,
    path: std::cmp::Reverse<String>,
}

/// Whether a path lies in a folder that tools make, or is a file that systems leave behind: not worth a word.
pub(super) fn is_stray(path: &str) -> bool {
    path.split('/').any(|part| STRAY.contains(&part) || part.starts_with("._") || part == ".DS_Store")
}

/// Whether a path is hidden, or lies in a hidden folder: the name begins with a dot.
pub(super) fn is_hidden(path: &str) -> bool {
    path.split('/').any(|part| part.starts_with('.') && part != "." && part != "..")
}

/// The exercise whose file this may be, and whether the name is exactly right.
fn exercise_of(path: &str) -> Option<(&'static Exercise, bool)> {
    let name = path.rsplit('/').next().unwrap_or(path);
    if let Some(exercise) = name.strip_suffix(".rs").and_then(course::find) {
        return Some((exercise, true));
    }
    let lower = name.to_lowercase();
    let stem = COPIES.as_ref()?.captures(&lower)?;
    course::find(&stem[1]).map(|exercise| (exercise, false))
}

/// Whether a path has the name of an exercise's file, or nearly.
pub(super) fn is_of_an_exercise(path: &str) -> bool {
    exercise_of(path).is_some()
}

/// The best file for each exercise, and what there is to say of the others.
pub(super) fn choose<Place>(found: Vec<Found<Place>>) -> (BTreeMap<&'static str, Found<Place>>, Vec<Notice>) {
    let mut fitting: BTreeMap<&'static str, Vec<(Fit, Found<Place>)>> = BTreeMap::new();
    let mut others = Vec::new();
    for file in found {
        match exercise_of(&file.path) {
            Some((exercise, exact)) => {
                let fit = fit(exercise, exact, &file);
                fitting.entry(exercise.name).or_default().push((fit, file));
            }
            None => others.push(file.path),
        }
    }
    let mut notices = Vec::new();
    let mut chosen = BTreeMap::new();
    for (name, mut files) in fitting {
        files.sort_by(|(a, _), (b, _)| b.cmp(a));
        let mut files = files.into_iter().map(|(_, file)| file);
        if let Some(best) = files.next() {
            let passed_over: Vec<String> = files.map(|file| file.path).collect();
            if !passed_over.is_empty() {
                let text =
                    format!("For {name}, {} was judged, not {}.", quoted(&best.path), listed(&passed_over));
                notices.push(Notice { audience: Audience::Student, text });
            }
            chosen.insert(name, best);
        }
    }
    if !others.is_empty() {
        others.sort();
        let text = format!("Only the exercises' files are judged; ignored: {}.", listed(&others));
        notices.push(Notice { audience: Audience::Student, text });
    }
    (chosen, notices)
}

fn fit<Place>(exercise: &Exercise, exact: bool, file: &Found<Place>) -> Fit {
    let mut folders: Vec<&str> = file.path.split('/').collect();
    folders.pop();
    Fit {
        exact,
        attempt: file.attempt.clone(),
        in_its_folder: folders.last() == Some(&exercise.concept.name()),
        shallow: std::cmp::Reverse(folders.len()),
        path: std::cmp::Reverse(file.path.clone()),
    }
}

/// Some names in one phrase.
pub(super) fn listed(names: &[String]) -> String {
    let shown: Vec<String> = names.iter().take(LISTED).map(|name| quoted(name)).collect();
    match names.len().saturating_sub(LISTED) {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}

/// A name that may hold anything, on one line and not too long.
pub(super) fn quoted(name: &str) -> String {
    const LONGEST: usize = 80;
    let plain: String =
        name.chars().take(LONGEST).map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    if name.chars().count() > LONGEST { format!("{plain}…") } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(paths: &[&str]) -> Vec<Found<usize>> {
        let file =
            |(place, path): (usize, &&str)| Found { path: (*path).to_owned(), attempt: String::new(), place };
        paths.iter().enumerate().map(file).collect()
    }

    #[test]
    fn the_exact_name_in_its_folder_is_the_best() {
        let paths = [
            "old/lambert.rs",
            "x/lighting/lambert.rs",
            "lambert (1).rs",
            "src/main.rs",
            "Phong.rs",
            "LAMBERT.RS",
        ];
        let (chosen, notices) = choose(found(&paths));
        assert_eq!(chosen["lambert"].path, "x/lighting/lambert.rs");
        assert_eq!(chosen.len(), 1);
        let words: Vec<&str> = notices.iter().map(|notice| notice.text.as_str()).collect();
        assert!(words[0].contains("x/lighting/lambert.rs was judged, not old/lambert.rs"), "{words:?}");
        assert_eq!(words[1], "Only the exercises' files are judged; ignored: Phong.rs, src/main.rs.");
    }

    #[test]
    fn a_renamed_copy_counts_where_nothing_better_is() {
        for path in ["lambert (1).rs", "lambert-2.rs", "Lambert.rs", "lambert - Copy.rs", "lambert_(3).rs"] {
            let (chosen, _) = choose(found(&[path]));
            assert_eq!(chosen.get("lambert").map(|file| file.path.as_str()), Some(path));
        }
        assert!(choose(found(&["lambert.rs.txt", "my_lambert.rs", "lambert"])).0.is_empty());
    }

    #[test]
    fn ten_thousand_names_are_not_listed() {
        let paths: Vec<String> = (0..10_000).map(|n| format!("{n:05}.txt")).collect();
        let paths: Vec<&str> = paths.iter().map(String::as_str).collect();
        let (_, notices) = choose(found(&paths));
        assert!(notices[0].text.ends_with("00007.txt and 9992 more."), "{}", notices[0].text);
    }

    #[test]
    fn what_systems_leave_behind_is_not_worth_a_word() {
        for path in ["__MACOSX/._lambert.rs", "a/target/debug/lambert.rs", ".DS_Store", "a/.git/config"] {
            assert!(is_stray(path), "{path}");
        }
        for path in ["targets/lambert.rs", ".work/lambert.rs", "../lambert.rs", "./lambert.rs"] {
            assert!(!is_stray(path), "{path}");
        }
        assert!(is_hidden(".work/lambert.rs") && is_hidden("a/.lambert.rs"));
        assert!(!is_hidden("../lambert.rs") && !is_hidden("./a/b.rs"));
    }
}
