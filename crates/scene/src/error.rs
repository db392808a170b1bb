//! What is wrong with a scene file, where, and what would be right?

/// A fault of a scene, OBJ or MTL file, said so that it can be mended.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {problem}\n  {remedy}", place(file, *.line, *.column))]
pub struct SceneError {
    /// The file as the user named it, or the name of a built-in scene.
    pub file: String,
    /// The line, counted from 1; `None` where the whole file is meant.
    pub line: Option<usize>,
    /// The column in characters, counted from 1; `None` where the whole line is meant.
    pub column: Option<usize>,
    /// What is wrong, with the value that was found.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

fn place(file: &str, line: Option<usize>, column: Option<usize>) -> String {
    let number = |n: Option<usize>| n.map(|n| format!(":{n}")).unwrap_or_default();
    format!("{file}{}{}", number(line), number(column))
}
