//! Calls and what they are given: arguments exchanged, a call left out, another one in its place.

use syn::{Expr, ExprCall, ExprMethodCall, ExprStruct, FieldValue};

use super::finder::Finder;
use super::{names, operators};

const ARGUMENTS: &str = "arguments exchanged";
const DROPPED: &str = "call dropped";

/// For these a·b is b·a: exchanged they are the same program.
const COMMUTATIVE: [&str; 3] = ["dot", "min", "max"];

/// These only lead from a list to its items; left out, either nothing changes or nothing compiles.
const PLUMBING: [&str; 6] = ["iter", "into_iter", "copied", "cloned", "clone", "enumerate"];

pub(super) fn call(finder: &mut Finder<'_>, call: &ExprCall) {
    let arguments: Vec<&Expr> = call.args.iter().collect();
    finder.exchange_each_two(ARGUMENTS, &arguments);
    for argument in &arguments {
        operators::sign(finder, argument);
    }
    if let [only] = arguments[..] {
        let text = finder.text_of(only);
        finder.change(DROPPED, call, text);
    }
    let (function, whole) = (finder.text_of(&*call.func), finder.text_of(call));
    if function.ends_with("from_cols") {
        finder.change("rows for columns", call, format!("{whole}.transpose()"));
    }
    if function == "Some" {
        finder.change("nothing returned", call, "None");
    }
}

pub(super) fn method(finder: &mut Finder<'_>, call: &ExprMethodCall) {
    let method = call.method.to_string();
    let receiver = finder.text_of(&*call.receiver);
    let arguments: Vec<&Expr> = call.args.iter().collect();
    if !PLUMBING.contains(&method.as_str()) {
        finder.change(DROPPED, call, receiver);
    }
    for other in names::mistaken_for(&names::METHODS, &method) {
        finder.change("another function", &call.method, other);
    }
    finder.exchange_each_two(ARGUMENTS, &arguments);
    for argument in &arguments {
        operators::sign(finder, argument);
    }
    if let [only] = arguments[..]
        && !COMMUTATIVE.contains(&method.as_str())
    {
        let argument = finder.text_of(only);
        finder.change(ARGUMENTS, call, format!("({argument}).{method}({receiver})"));
    }
}

/// The values of a struct's fields, each two exchanged.
pub(super) fn fields(finder: &mut Finder<'_>, made: &ExprStruct) {
    let fields: Vec<&FieldValue> = made.fields.iter().collect();
    for (at, first) in fields.iter().enumerate() {
        for second in &fields[at + 1..] {
            // Written out: the value in `Hit { t }` has the field's name.
            let with_value_of = |field: &FieldValue, other: &FieldValue| {
                format!("{}: {}", finder.text_of(&field.member), finder.text_of(&other.expr))
            };
            let (one, other) = (with_value_of(first, second), with_value_of(second, first));
            finder.change_two("fields exchanged", (*first, &one), (*second, &other));
        }
    }
}
