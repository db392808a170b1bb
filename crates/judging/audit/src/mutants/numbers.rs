//! Constants: 0 for 1, one more, one less, twice, half.

use syn::{ExprLit, Lit};

use super::finder::Finder;

const KIND: &str = "another constant";

/// Below this a number is a tolerance: one more or less is the same as 1 in its place.
const TOLERANCE: f64 = 0.01;

pub(super) fn literal(finder: &mut Finder<'_>, literal: &ExprLit) {
    match &literal.lit {
        Lit::Float(number) => {
            let Ok(x) = number.base10_parse::<f64>() else { return };
            for other in others(x) {
                finder.change(KIND, literal, format!("{other:?}{}", number.suffix()));
            }
        }
        Lit::Int(number) => {
            let Ok(n) = number.base10_parse::<i64>() else { return };
            for other in [0, 1, n - 1, n + 1, 2 * n] {
                if other >= 0 {
                    finder.change(KIND, literal, format!("{other}{}", number.suffix()));
                }
            }
        }
        Lit::Bool(truth) => finder.change(KIND, literal, (!truth.value).to_string()),
        _ => {}
    }
}

/// What might stand in a number's place.
fn others(x: f64) -> Vec<f64> {
    if x == 0.0 {
        vec![1.0, -1.0]
    } else if x < TOLERANCE {
        vec![0.0, 1.0, 2.0 * x, 0.5 * x]
    } else {
        vec![0.0, 1.0, x - 1.0, x + 1.0, 2.0 * x, 0.5 * x]
    }
}
