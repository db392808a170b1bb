//! Where in an exercise's file does a line stand that was cut out of it?

use course::Exercise;

/// The line in the exercise's file, from 1, of a line in a student's file that was made of its slide's solution.
///
/// The functions are the same there but for the first one's name; each begins in the first column.
pub(crate) fn in_the_course(exercise: &Exercise, submission: &str, line: usize) -> Option<usize> {
    let lines: Vec<&str> = submission.lines().take(line).collect();
    let begin = lines.iter().rposition(|line| name(line).is_some())?;
    let name_there = match name(lines[begin])? {
        given if given == exercise.name => exercise.reference.name,
        helper => helper,
    };
    let there =
        exercise.source.lines().position(|line| line.starts_with("fn ") && name(line) == Some(name_there))?;
    Some(there + (line - begin))
}

/// The name of the function that begins in a line.
fn name(line: &str) -> Option<&str> {
    let line = line.strip_prefix("pub ").unwrap_or(line);
    line.strip_prefix("fn ")?.split('(').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_a_submission_is_found_in_the_exercises_file() {
        let exercise = course::find("lambert").expect("the exercise");
        let submission = exercise.submission(&exercise.reference).expect("its text");
        let line = submission
            .lines()
            .position(|line| line.contains(".max(0.0)") && !line.starts_with("//"))
            .expect("a body");
        let there = in_the_course(exercise, &submission, line + 1).expect("a place");
        assert_eq!(exercise.source.lines().nth(there - 1), submission.lines().nth(line));
    }
}
