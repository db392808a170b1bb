//! The inverse: cofactors over the determinant, times the right-hand side (L51).

use glam::Mat3;
use raytrace::triangle::{Solution, System, inverse};
use sheet::Words;

use super::{Step, determinant, equations, factor, short};

/// The determinant, the matrix of cofactors turned over, the inverse, and its product with the right-hand side.
pub(super) fn tell(system: &System, steps: &mut Vec<Step>) -> Option<Solution> {
    steps.push(determinant(system));
    let solution = inverse(system)?;
    steps.push(cofactors(&system.matrix));

    let inverted = system.matrix.inverse();
    let determinant = system.matrix.determinant();
    let words = Words::new(
        format!("Turned over, rows for columns, and divided by det A = {}: the inverse.", short(determinant)),
        format!(
            "Gespiegeld, rijen voor kolommen, en gedeeld door det A = {}: de inverse.",
            short(determinant)
        ),
    );
    steps.push(Step::new(words).showing(equations(&inverted, None, &[])));

    let unknowns = [("β", solution.beta), ("γ", solution.gamma), ("t", solution.t)];
    for (row, (name, value)) in unknowns.into_iter().enumerate() {
        let products: Vec<String> = inverted
            .row(row)
            .to_array()
            .iter()
            .zip(system.rhs.to_array())
            .map(|(a, b)| format!("{}·{}", factor(*a), factor(b)))
            .collect();
        let words = Words::new(
            format!("{name}: row {} of the inverse times the right-hand side.", row + 1),
            format!("{name}: rij {} van de inverse maal het rechterlid.", row + 1),
        );
        let line = format!("{name} = {} = {}", products.join(" + "), short(value));
        let marked = [(row, 0), (row, 1), (row, 2), (0, 3), (1, 3), (2, 3)];
        steps.push(Step::new(words).lines(vec![line.into()]).showing(equations(
            &inverted,
            Some(system.rhs),
            &marked,
        )));
    }
    Some(solution)
}

/// The cofactors: each row is the cross product of the two other rows.
fn cofactors(m: &Mat3) -> Step {
    let [first, second, third] = [0, 1, 2].map(|k| m.row(k));
    let rows = [second.cross(third), third.cross(first), first.cross(second)];
    let matrix = Mat3::from_cols(rows[0], rows[1], rows[2]).transpose();
    const SIGNS: [[&str; 3]; 3] = [["", "−", ""], ["−", "", "−"], ["", "−", ""]];
    let mut lines = Vec::new();
    for (row, values) in rows.iter().enumerate() {
        for (column, value) in values.to_array().into_iter().enumerate() {
            lines.push(Words::from(format!(
                "C_{}{} = {}{} = {}",
                row + 1,
                column + 1,
                SIGNS[row][column],
                minor(m, row, column),
                short(value)
            )));
        }
    }
    let words = Words::new(
        "The cofactors: for each number the 2×2 determinant that is left without its row and column, with signs + − + in turn.",
        "De cofactoren: voor elk getal de 2×2-determinant die overblijft zonder zijn rij en kolom, met afwisselend + − +.",
    );
    Step::new(words).lines(lines).showing(equations(&matrix, None, &[]))
}

/// What is left without a row and a column, written out.
fn minor(m: &Mat3, row: usize, column: usize) -> String {
    let others = |k: usize| match k {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    };
    let ([r, s], [c, d]) = (others(row), others(column));
    let at = |row: usize, column: usize| factor(m.row(row)[column]);
    format!("({}·{} − {}·{})", at(r, c), at(s, d), at(r, d), at(s, c))
}
