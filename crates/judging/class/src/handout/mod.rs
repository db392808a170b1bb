//! What are students given? A small workspace of its own: tasks, stubs, worked examples as tests; no solutions, and nothing of what judges.
//!
//! [`files`] gives its text; `task` is what is said of an exercise, `example` how a worked example becomes a test.

mod example;
mod task;

use course::Exercise;

/// A file: its path within the handout, with `/`, and its text.
pub type File = (String, String);

/// What does not depend on the exercises.
const FIXED: [(&str, &str); 13] = [
    ("Cargo.toml", include_str!("fixed/workspace.toml")),
    ("README.md", include_str!("fixed/README.md")),
    (".gitignore", "/target\n"),
    ("exercises/Cargo.toml", include_str!("fixed/exercises.toml")),
    ("exercises/lib.rs", include_str!("../../../../../exercises/lib.rs")),
    ("vocabulary/Cargo.toml", include_str!("fixed/vocabulary.toml")),
    ("vocabulary/README.md", include_str!("../../../vocabulary/README.md")),
    ("vocabulary/src/lib.rs", include_str!("../../../vocabulary/src/lib.rs")),
    ("vocabulary/src/geometry.rs", include_str!("../../../vocabulary/src/geometry.rs")),
    ("vocabulary/src/lighting.rs", include_str!("../../../vocabulary/src/lighting.rs")),
    ("vocabulary/src/raytrace.rs", include_str!("../../../vocabulary/src/raytrace.rs")),
    ("vocabulary/src/transforms.rs", include_str!("../../../vocabulary/src/transforms.rs")),
    ("vocabulary/src/zbuffer.rs", include_str!("../../../vocabulary/src/zbuffer.rs")),
];

/// The students' edition, all files of it, with or without the three hints of each exercise. `exercises` are all of the course: the library
/// names every one.
pub fn files(exercises: &[Exercise], hints: bool) -> Vec<File> {
    let mut files: Vec<File> =
        FIXED.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect();
    for exercise in exercises {
        files.push((format!("exercises/{}", exercise.path()), exercise.stub.to_owned()));
        files.push((format!("tasks/{}", exercise.path().replace(".rs", ".md")), task::page(exercise, hints)));
        files.push((format!("exercises/tests/examples/{}.rs", exercise.name), example::tests(exercise)));
    }
    files.push(("exercises/tests/examples/main.rs".to_owned(), example::main(exercises)));
    files
}

#[cfg(test)]
mod tests;
