//! Cramer's rule: each unknown is a quotient of two determinants (L51).

use glam::Mat3;
use raytrace::triangle::{Solution, System, cramer};
use sheet::Words;

use super::{Step, determinant, equations, expanded, short};

/// det A, then for each unknown the determinant with the right-hand side in its column.
pub(super) fn tell(system: &System, steps: &mut Vec<Step>) -> Option<Solution> {
    let Mat3 { x_axis: p, y_axis: q, z_axis: d } = system.matrix;
    let (r, solution) = (system.rhs, cramer(system));
    steps.push(determinant(system));
    let Solution { beta, gamma, t } = solution?;
    let determinant = system.matrix.determinant();
    let replaced = [
        ("β", "1", Mat3::from_cols(r, q, d), beta),
        ("γ", "2", Mat3::from_cols(p, r, d), gamma),
        ("t", "3", Mat3::from_cols(p, q, r), t),
    ];
    for (column, (name, number, matrix, value)) in replaced.into_iter().enumerate() {
        let words = Words::new(
            format!(
                "For {name}: the right-hand side in column {number}, and the quotient of the determinants."
            ),
            format!("Voor {name}: het rechterlid in kolom {number}, en het quotiënt van de determinanten."),
        );
        let mut lines = expanded(&format!("det A_{number}"), &matrix);
        lines.push(
            format!(
                "{name} = det A_{number} / det A = {} / {} = {}",
                short(matrix.determinant()),
                super::factor(determinant),
                short(value)
            )
            .into(),
        );
        let marked = [(0, column), (1, column), (2, column)];
        steps.push(Step::new(words).lines(lines).showing(equations(&matrix, None, &marked)));
    }
    solution
}
