//! Choices and steps: a condition negated or never true, branches exchanged, a step left out.

use syn::{BinOp, Expr, ExprIf, Stmt};

use super::finder::Finder;

pub(super) fn branches(finder: &mut Finder<'_>, chosen: &ExprIf) {
    if matches!(*chosen.cond, Expr::Let(_)) {
        return;
    }
    match &chosen.else_branch {
        Some((_, otherwise)) if matches!(**otherwise, Expr::Block(_)) => {
            finder.exchange("branches exchanged", &chosen.then_branch, &**otherwise);
        }
        _ => condition(finder, &chosen.cond),
    }
    finder.change("never so", &*chosen.cond, "false");
    if chosen.else_branch.is_some() {
        finder.change("always so", &*chosen.cond, "true");
    }
}

pub(super) fn condition(finder: &mut Finder<'_>, condition: &Expr) {
    let text = finder.text_of(condition);
    finder.change("condition negated", condition, format!("!({text})"));
}

/// A step that changes something, left out.
pub(super) fn statement(finder: &mut Finder<'_>, statement: &Stmt) {
    let Stmt::Expr(step, Some(_)) = statement else { return };
    let changes_something = match step {
        Expr::Assign(_) | Expr::MethodCall(_) | Expr::Call(_) | Expr::Continue(_) | Expr::Break(_) => true,
        Expr::Binary(binary) => matches!(
            binary.op,
            BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_)
        ),
        _ => false,
    };
    if changes_something {
        finder.change("step dropped", statement, "");
    }
}
