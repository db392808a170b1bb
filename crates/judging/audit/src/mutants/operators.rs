//! Operators, signs and borders: `+` for `-`, `<` for `<=`, a minus too many.

use syn::{BinOp, Expr, ExprBinary, ExprRange, ExprUnary, RangeLimits, UnOp};

use super::finder::Finder;

const OPERATOR: &str = "another operator";
const BORDER: &str = "border moved";
const COMPARISON: &str = "another comparison";
const OPERAND: &str = "operand dropped";

pub(super) fn binary(finder: &mut Finder<'_>, binary: &ExprBinary) {
    let others: &[(&'static str, &str)] = match binary.op {
        BinOp::Add(_) => &[(OPERATOR, "-"), (OPERATOR, "*")],
        BinOp::Sub(_) => &[(OPERATOR, "+")],
        BinOp::Mul(_) => &[(OPERATOR, "/"), (OPERATOR, "+")],
        BinOp::Div(_) => &[(OPERATOR, "*")],
        BinOp::Rem(_) => &[(OPERATOR, "/"), (OPERATOR, "*")],
        BinOp::AddAssign(_) => &[(OPERATOR, "-="), (OPERATOR, "=")],
        BinOp::SubAssign(_) => &[(OPERATOR, "+="), (OPERATOR, "=")],
        BinOp::MulAssign(_) => &[(OPERATOR, "/="), (OPERATOR, "=")],
        BinOp::DivAssign(_) => &[(OPERATOR, "*="), (OPERATOR, "=")],
        BinOp::And(_) => &[(OPERATOR, "||")],
        BinOp::Or(_) => &[(OPERATOR, "&&")],
        BinOp::Lt(_) => &[(BORDER, "<="), (COMPARISON, ">"), (COMPARISON, ">=")],
        BinOp::Le(_) => &[(BORDER, "<"), (COMPARISON, ">="), (COMPARISON, ">")],
        BinOp::Gt(_) => &[(BORDER, ">="), (COMPARISON, "<"), (COMPARISON, "<=")],
        BinOp::Ge(_) => &[(BORDER, ">"), (COMPARISON, "<="), (COMPARISON, "<")],
        BinOp::Eq(_) => &[(COMPARISON, "!="), (COMPARISON, "<="), (COMPARISON, ">=")],
        BinOp::Ne(_) => &[(COMPARISON, "=="), (COMPARISON, "<"), (COMPARISON, ">")],
        _ => &[],
    };
    for (kind, other) in others {
        finder.change(kind, &binary.op, *other);
    }
    if keeps_type(&binary.op) {
        for operand in [&binary.left, &binary.right] {
            let text = finder.text_of(&**operand);
            finder.change(OPERAND, binary, text);
        }
    }
    if matches!(binary.op, BinOp::Sub(_) | BinOp::Div(_)) {
        finder.exchange("operands exchanged", &*binary.left, &*binary.right);
    }
}

/// Whether an operand can stand for the whole.
fn keeps_type(operator: &BinOp) -> bool {
    use BinOp::{Add, And, Div, Mul, Or, Rem, Sub};
    matches!(operator, Add(_) | Sub(_) | Mul(_) | Div(_) | Rem(_) | And(_) | Or(_))
}

pub(super) fn unary(finder: &mut Finder<'_>, unary: &ExprUnary) {
    let inside = finder.text_of(&*unary.expr);
    match unary.op {
        UnOp::Neg(_) => finder.change("sign dropped", unary, inside),
        UnOp::Not(_) => finder.change("negation dropped", unary, inside),
        _ => {}
    }
}

/// A minus before something that has none.
pub(super) fn sign(finder: &mut Finder<'_>, expr: &Expr) {
    let one_word = matches!(
        expr,
        Expr::Path(_)
            | Expr::Field(_)
            | Expr::MethodCall(_)
            | Expr::Call(_)
            | Expr::Index(_)
            | Expr::Paren(_)
            | Expr::Lit(_)
    );
    let text = finder.text_of(expr);
    if one_word && text.parse() != Ok(0.0) {
        finder.change("sign added", expr, format!("-{text}"));
    }
}

pub(super) fn range(finder: &mut Finder<'_>, range: &ExprRange) {
    let (Some(start), Some(end)) = (&range.start, &range.end) else { return };
    let limits = match range.limits {
        RangeLimits::HalfOpen(_) => "..=",
        RangeLimits::Closed(_) => "..",
    };
    finder.change(BORDER, &range.limits, limits);
    let (first, last) = (finder.text_of(&**start), finder.text_of(&**end));
    finder.change(BORDER, &**start, format!("({first} + 1)"));
    finder.change(BORDER, &**end, format!("({last} - 1)"));
}
