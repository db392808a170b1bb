//! What is said of an exercise beside its task? By which laws it is judged and what they are worth, and examples with several right answers.

use std::fmt::Write;

use course::{Exercise, trial};

/// A page about one exercise.
pub(super) fn page(exercise: &Exercise, hints: bool) -> String {
    let mut page = format!("# {}\n\n", exercise.title.english);
    let _ = writeln!(
        page,
        "{} ({}). The task stands in `exercises/{}`.",
        exercise.title.dutch,
        exercise.items,
        exercise.path()
    );
    if !exercise.prerequisites.is_empty() {
        let _ = writeln!(page, "\nBest done after {}.", exercise.prerequisites.join(", "));
    }
    laws(&mut page, exercise);
    several_answers(&mut page, exercise);
    if hints {
        page.push_str("\n## Hints\n\nEach says more than the one before.\n\n");
        for (at, hint) in exercise.hints.iter().enumerate() {
            let _ = writeln!(page, "{}. {hint}", at + 1);
        }
    }
    page
}

fn laws(page: &mut String, exercise: &Exercise) {
    let _ = writeln!(
        page,
        "\n## Laws\n\n{} points in all.\n\n| points | law | says |\n|---|---|---|",
        exercise.points()
    );
    let _ = writeln!(
        page,
        "| {} | {} | The worked examples come out as they should. |",
        Exercise::EXAMPLE_POINTS,
        trial::EXAMPLES
    );
    for law in &exercise.laws {
        // A bar would end the cell.
        let _ =
            writeln!(page, "| {} | {} | {} |", law.points(), law.name(), law.statement().replace('|', "\\|"));
    }
}

/// Examples that no test can decide by comparing.
fn several_answers(page: &mut String, exercise: &Exercise) {
    let several: Vec<_> = exercise.examples.iter().filter(|example| example.tolerance.is_none()).collect();
    if several.is_empty() {
        return;
    }
    page.push_str("\n## Examples with several right answers\n\n");
    for example in several {
        let arguments = exercise.signature.parameters.iter().zip(&example.arguments);
        let arguments: Vec<String> = arguments.map(|(name, value)| format!("{name} = {value}")).collect();
        let _ = writeln!(
            page,
            "- {}: `{}({})`. A right answer is `{}`.",
            example.caption,
            exercise.name,
            arguments.join(", "),
            example.answer
        );
    }
}
