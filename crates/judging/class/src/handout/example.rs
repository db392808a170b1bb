//! How does a worked example become a test? Its values are written as Rust, by the types of the exercise's signature.

use std::fmt::Write;

use course::{Example, Exercise, Value};

/// The test program: a module an exercise, and what compares answers.
pub(super) fn main(exercises: &[Exercise]) -> String {
    let mut main = include_str!("fixed/examples.rs").to_owned();
    for exercise in exercises {
        let _ = writeln!(main, "mod {};", exercise.name);
    }
    main
}

/// The tests of one exercise. Those with several right answers stand in its task.
pub(super) fn tests(exercise: &Exercise) -> String {
    let (parameters, answer) = types(exercise.signature.text);
    let mut tests = format!(
        "//! {}: the worked examples of `{}`.\n\n#![allow(unused_imports, clippy::excessive_precision, clippy::approx_constant)]\n\n\
         use glam::*;\nuse vocabulary::*;\n\nuse crate::close;\n",
        exercise.title.english, exercise.name
    );
    for (at, example) in exercise.examples.iter().enumerate() {
        let Some(tolerance) = example.tolerance else { continue };
        let arguments = parameters.iter().zip(&example.arguments);
        let arguments: Vec<String> = arguments.map(|(of, value)| written(of, value)).collect();
        let _ = write!(
            tests,
            "\n/// {}\n#[test]\nfn example_{}() {{\n    let answer = exercises::{}::{}::{}({});\n    let wanted: {answer} = {};\n    \
             close(&answer, &wanted, {tolerance:?});\n}}\n",
            capital(example),
            at + 1,
            exercise.concept.name(),
            exercise.name,
            exercise.name,
            arguments.join(", "),
            written(&answer, &example.answer),
        );
    }
    tests
}

fn capital(example: &Example) -> String {
    let mut letters = example.caption.chars();
    letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).chain(['.']).collect()
}

/// The types of the parameters and of the answer, from "(theta: f32, p: Vec2, ) -> Mat3".
fn types(signature: &str) -> (Vec<String>, String) {
    let (parameters, answer) = signature.rsplit_once("->").unwrap_or((signature, ""));
    let inside = parameters.trim().trim_start_matches('(').trim_end_matches(')');
    let of = |parameter: &str| parameter.split_once(':').map(|(_, of)| of.trim().to_owned());
    (separate(inside).into_iter().filter_map(of).collect(), answer.trim().to_owned())
}

/// The parts between commas, but for commas within brackets.
fn separate(list: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut begin) = (Vec::new(), 0, 0);
    for (at, letter) in list.char_indices() {
        match letter {
            '(' | '[' | '<' => depth += 1,
            ')' | ']' | '>' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&list[begin..at]);
                begin = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&list[begin..]);
    parts
}

/// A value of this type, as it is written in Rust.
fn written(of: &str, value: &Value) -> String {
    if let Some(inner) = within(of, "Option<", ">") {
        return if *value == Value::Nothing {
            "None".to_owned()
        } else {
            format!("Some({})", written(inner, value))
        };
    }
    match value {
        Value::Nothing => "()".to_owned(),
        Value::Truth(truth) => truth.to_string(),
        Value::Whole(whole) => whole.to_string(),
        Value::Number(x) => number(*x),
        Value::Vector(xs) => format!("Vec{}::new({})", xs.len(), numbers(xs)),
        Value::Matrix(xs) => format!("Mat{}::from_cols_array(&[{}])", xs.len().isqrt(), numbers(xs)),
        Value::List(values) => list(of, values),
        Value::Record(record) => {
            // A variant of an enum stands behind the enum's name.
            let name =
                if of == "Light" { format!("Light::{}", record.name) } else { record.name.to_string() };
            let field = |(field, value): &(_, Value)| format!("{field}: {}", written("", value));
            let fields: Vec<String> =
                record.fields.iter().map(|(name, value)| field(&(name, value.clone()))).collect();
            format!("{name} {{ {} }}", fields.join(", "))
        }
    }
}

/// What stands between the beginning and the end of a type's name.
fn within<'t>(of: &'t str, begin: &str, end: &str) -> Option<&'t str> {
    of.strip_prefix(begin)?.strip_suffix(end)
}

fn list(of: &str, values: &[Value]) -> String {
    let all = |inner: &str| values.iter().map(|value| written(inner, value)).collect::<Vec<_>>().join(", ");
    if let Some(inner) = within(of, "&[", "]") {
        return format!("&[{}]", all(inner));
    }
    if let Some((inner, _)) = within(of, "[", "]").and_then(|inside| inside.rsplit_once(';')) {
        return format!("[{}]", all(inner));
    }
    if let Some(inner) = within(of, "(", ")") {
        let parts: Vec<String> =
            separate(inner).into_iter().zip(values).map(|(of, value)| written(of.trim(), value)).collect();
        return format!("({})", parts.join(", "));
    }
    // Within a struct no type is known: lists are vectors there.
    format!("vec![{}]", all(within(of, "Vec<", ">").unwrap_or("")))
}

fn numbers(xs: &[f32]) -> String {
    xs.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ")
}

/// With as many digits as it takes to read it back exactly.
fn number(x: f32) -> String {
    if x.is_nan() {
        "f32::NAN".to_owned()
    } else if x.is_infinite() {
        if x > 0.0 { "f32::INFINITY".to_owned() } else { "f32::NEG_INFINITY".to_owned() }
    } else {
        format!("{x:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use course::Plain;

    #[test]
    fn types_are_told_apart_at_the_outer_commas() {
        let (parameters, answer) = types("(ts: &[[usize; 3]], hit: Option<(usize, f32)>, ) -> (Mat3, Vec3)");
        assert_eq!(parameters, ["&[[usize; 3]]", "Option<(usize, f32)>"]);
        assert_eq!(answer, "(Mat3, Vec3)");
    }

    #[test]
    fn values_are_written_as_rust() {
        let triangles = vec![[0_usize, 1, 2], [2, 1, 3]].into_value();
        assert_eq!(written("&[[usize; 3]]", &triangles), "&[[0, 1, 2], [2, 1, 3]]");
        assert_eq!(written("Option<(usize, f32)>", &Some((1_usize, 0.5_f32)).into_value()), "Some((1, 0.5))");
        assert_eq!(written("Option<f32>", &Value::Nothing), "None");
        assert_eq!(written("f32", &f32::INFINITY.into_value()), "f32::INFINITY");
    }
}
