//! Gaussian elimination: row operations until a triangle is left, then the unknowns from below (L51).

use raytrace::triangle::{RowOperation, Solution, System, elimination_watched};
use sheet::Words;

use super::{Step, factor, short};
use crate::steps::{Drawing, Equations};

/// The row operations one by one, then back-substitution.
pub(super) fn tell(system: &System, steps: &mut Vec<Step>) -> Option<Solution> {
    let mut last = [[0.0; 4]; 3];
    let solution = elimination_watched(system, |operation, rows| {
        steps.push(operated(operation, rows));
        last = *rows;
    })?;
    let Solution { beta, gamma, t } = solution;
    let [first, second, third] = last;
    let lines = [
        (2, "t", format!("t = {} / {} = {}", short(third[3]), factor(third[2]), short(t))),
        (
            1,
            "γ",
            format!(
                "γ = ({} − {}·{}) / {} = {}",
                short(second[3]),
                factor(second[2]),
                factor(t),
                factor(second[1]),
                short(gamma)
            ),
        ),
        (
            0,
            "β",
            format!(
                "β = ({} − {}·{} − {}·{}) / {} = {}",
                short(first[3]),
                factor(first[1]),
                factor(gamma),
                factor(first[2]),
                factor(t),
                factor(first[0]),
                short(beta)
            ),
        ),
    ];
    for (row, name, line) in lines {
        let words = Words::new(
            format!("Back-substitution: row {} gives {name}.", row + 1),
            format!("Terugsubstitutie: rij {} geeft {name}.", row + 1),
        );
        let marked = (row..4).map(|column| (row, column)).collect();
        steps.push(Step::new(words).lines(vec![line.into()]).showing(shown(&last, marked)));
    }
    Some(solution)
}

fn operated(operation: RowOperation, rows: &[[f32; 4]; 3]) -> Step {
    let whole = |row: usize| (0..4).map(move |column| (row, column));
    match operation {
        RowOperation::Exchange { column, with } if with == column => {
            let pivot = short(rows[column][column]);
            let words = Words::new(
                format!(
                    "Column {}: the number largest in absolute value from here down, {pivot}, stands in place: the pivot.",
                    column + 1
                ),
                format!(
                    "Kolom {}: het in absolute waarde grootste getal vanaf hier omlaag, {pivot}, staat op zijn plaats: de spil.",
                    column + 1
                ),
            );
            Step::new(words).showing(shown(rows, vec![(column, column)]))
        }
        RowOperation::Exchange { column, with } => {
            let (pivot, a, b) = (short(rows[column][column]), column + 1, with + 1);
            let words = Words::new(
                format!(
                    "Column {a}: rows {a} and {b} change places, so that {pivot}, no other being larger in absolute value, is the pivot."
                ),
                format!(
                    "Kolom {a}: rij {a} en {b} wisselen van plaats, zodat {pivot}, in absolute waarde door geen ander overtroffen, de spil is."
                ),
            );
            Step::new(words).showing(shown(rows, whole(column).chain(whole(with)).collect()))
        }
        RowOperation::Subtract { column, from, factor: times } => {
            let (pivot, row) = (column + 1, from + 1);
            let words = Words::new(
                format!("Row {row} minus {} times row {pivot}.", factor(times)),
                format!("Rij {row} min {} maal rij {pivot}.", factor(times)),
            );
            let line = format!("R_{row} ← R_{row} − {}·R_{pivot}", factor(times));
            Step::new(words).lines(vec![line.into()]).showing(shown(rows, whole(from).collect()))
        }
    }
}

fn shown(rows: &[[f32; 4]; 3], marked: Vec<(usize, usize)>) -> Drawing {
    Drawing::Equations(Equations {
        matrix: rows.map(|[a, b, c, _]| [a, b, c]),
        rhs: Some(rows.map(|row| row[3])),
        marked,
    })
}
