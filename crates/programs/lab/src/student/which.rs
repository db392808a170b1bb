//! Which exercise is meant by a name, a file or a concept?

use std::path::{Path, PathBuf};

use course::{Concept, Exercise};

use super::workbench::Workbench;
use crate::failure::Failure;

/// An exercise and the file to judge it by.
#[derive(Clone, Debug)]
pub(crate) struct Meant {
    /// The exercise.
    pub(crate) exercise: &'static Exercise,
    /// Its file: the student's own, or one from elsewhere that was named.
    pub(crate) file: PathBuf,
}

/// What the words on the command line mean, in the order of the exercises, each once.
///
/// # Errors
/// [`Failure`] for a word that means nothing, with the nearest that does.
pub(crate) fn meant(bench: &Workbench, words: &[String]) -> Result<Vec<Meant>, Failure> {
    let mut chosen: Vec<(usize, PathBuf)> = Vec::new();
    let exercises = course::all();
    for word in words {
        for (at, file) in of_word(bench, exercises, word, Prefer::Concept)? {
            if chosen.iter().all(|other| *other != (at, file.clone())) {
                chosen.push((at, file));
            }
        }
    }
    chosen.sort_by_key(|(at, _)| *at);
    Ok(chosen.into_iter().map(|(at, file)| Meant { exercise: &exercises[at], file }).collect())
}

/// All exercises, each with the student's own file.
pub(crate) fn all(bench: &Workbench) -> Vec<Meant> {
    course::all().iter().map(|exercise| Meant { file: bench.file(exercise), exercise }).collect()
}

/// The one exercise of this name; concepts and files from elsewhere are not meant here.
///
/// # Errors
/// [`Failure`] if there is none, with the nearest that there is.
pub(crate) fn one(bench: &Workbench, word: &str) -> Result<&'static Exercise, Failure> {
    let exercises = course::all();
    let places = of_word(bench, exercises, word, Prefer::Exercise)?;
    match places.as_slice() {
        [(at, _)] => Ok(&exercises[*at]),
        _ => Err(Failure::new(
            format!("{word} is a concept with {} exercises", places.len()),
            "give the name of one exercise; `cargo lab` lists them",
        )),
    }
}

/// What a word means that names both, as `zbuffer` does.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Prefer {
    Concept,
    Exercise,
}

fn of_word(
    bench: &Workbench,
    exercises: &[Exercise],
    word: &str,
    prefer: Prefer,
) -> Result<Vec<(usize, PathBuf)>, Failure> {
    let of_concept = || {
        let of_concept = exercises.iter().enumerate().filter(|(_, exercise)| exercise.concept.name() == word);
        of_concept.map(|(at, exercise)| (at, bench.file(exercise))).collect::<Vec<_>>()
    };
    let of_name = || {
        let is_meant =
            |exercise: &Exercise| exercise.name == word || exercise.path().trim_end_matches(".rs") == word;
        let at = exercises.iter().position(is_meant);
        at.map(|at| (at, bench.file(&exercises[at]))).into_iter().collect()
    };
    let (first, second) = match prefer {
        Prefer::Concept => (of_concept(), of_name()),
        Prefer::Exercise => (of_name(), of_concept()),
    };
    for found in [first, second] {
        if !found.is_empty() {
            return Ok(found);
        }
    }
    let path = Path::new(word);
    // `exercises/zbuffer/`, as a shell completes it.
    let folder = path.file_name().and_then(|name| name.to_str()).filter(|_| path.is_dir());
    if let Some(folder) = folder.filter(|folder| Concept::ALL.iter().any(|concept| concept.name() == *folder))
    {
        return of_word(bench, exercises, folder, Prefer::Concept);
    }
    if word.ends_with(".rs") || path.components().count() > 1 {
        return of_path(bench, exercises, path).map(|found| vec![found]);
    }
    Err(unknown(word))
}

/// A file is an exercise's by its name; it may lie anywhere.
fn of_path(bench: &Workbench, exercises: &[Exercise], path: &Path) -> Result<(usize, PathBuf), Failure> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let Some(at) = exercises.iter().position(|exercise| exercise.name == stem) else {
        return Err(Failure::new(
            format!("{} is not called like an exercise", path.display()),
            format!("give the file the name of its exercise: {}", nearest(&stem)),
        ));
    };
    // `transforms/lambert.rs` may also be meant from the folder of exercises.
    let in_exercises = bench.exercises.join(path);
    let in_root = bench.root.join(path);
    let candidates = [path.to_owned(), in_root, in_exercises];
    let found = candidates.into_iter().find(|candidate| candidate.symlink_metadata().is_ok());
    // A bare name means the student's own file, wherever one stands.
    let alone = path.components().count() == 1;
    let file = found.unwrap_or_else(|| if alone { bench.file(&exercises[at]) } else { path.to_owned() });
    Ok((at, std::path::absolute(&file).unwrap_or(file)))
}

fn unknown(word: &str) -> Failure {
    Failure::new(
        format!("there is no exercise or concept called `{word}`"),
        format!("did you mean {}? `cargo lab` lists all of them", nearest(word)),
    )
}

/// The name that is nearest to what was typed.
fn nearest(word: &str) -> String {
    let names = course::all().iter().map(|exercise| exercise.name);
    let names: Vec<&str> = names.chain(Concept::ALL.map(Concept::name)).collect();
    let word = word.to_lowercase().replace(['-', ' '], "_");
    // What was typed may be the beginning or a part of the name; letters in another order cost as much as one that is wrong.
    let likeness = |name: &str| {
        let part = if !word.is_empty() && name.contains(&word) { 0.5 } else { 0.0 };
        part + strsim::jaro_winkler(name, &word)
    };
    let best = names.into_iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    best.unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_finds_the_name() {
        for typo in
            ["rotate-about-point", "rotate_abuot_point", "rotate", "Rotate_About_Point", "rotat_about_piont"]
        {
            assert_eq!(nearest(typo), "rotate_about_point", "{typo}");
        }
        assert_eq!(nearest("zbufer"), "zbuffer");
        assert_eq!(nearest("transform"), "transforms");
    }
}
