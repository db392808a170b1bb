//! What does a figure look like when the student's own function draws it?

/// Draws figures with the student's functions.
#[derive(Debug)]
pub struct Mine;
