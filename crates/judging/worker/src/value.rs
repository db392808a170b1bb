//! What travels between the one who asks and the one who answers?

use std::borrow::Cow;
use std::cell::Cell;
use std::fmt;

use serde::{Deserialize, Deserializer, Serialize};

/// Lists within lists, at most: an answer that is nested deeper was not made by an honest worker, and reading it would take
/// a stack without end.
const DEEPEST: u32 = 12;

/// A value of an exercise: an argument, or what a function returned.
///
/// `Display` writes it as a person would, `(1, 2, 3)` for a vector; floating-point numbers with as many digits as it takes to
/// read them back exactly, but for those near zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Value {
    /// Nothing there: `None`, or `()`.
    Nothing,
    /// True or false.
    Truth(bool),
    /// A count, an index, a pixel's coordinate.
    Whole(i64),
    /// A number; NaN and infinities too.
    Number(f32),
    /// A vector of two, three or four numbers.
    Vector(Vec<f32>),
    /// A square matrix, column after column.
    Matrix(Vec<f32>),
    /// Several values in order: a slice, a vector of values, a tuple, an array.
    #[serde(deserialize_with = "nested")]
    List(Vec<Value>),
    /// A struct or a variant of an enum: its name, its fields' names and values.
    #[serde(deserialize_with = "nested")]
    Record(Record),
}

/// The name of a struct, a variant or a field: usually a word of the program itself, so that taking a struct apart copies no text.
pub(crate) type Name = Cow<'static, str>;

/// A struct or a variant of an enum, taken apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its name, `Ray`, say.
    pub name: Name,
    /// Its fields in order of declaration.
    pub fields: Vec<(Name, Value)>,
}

thread_local! {
    static DEPTH: Cell<u32> = const { Cell::new(0) };
}

/// Whether two lists of arguments are the same to the bit: −0 is not 0 here, since a function may tell them apart.
pub fn identical(a: &[Value], b: &[Value]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.identical(b))
}

/// Reads what stands inside another value, unless it stands too deep.
fn nested<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<T, D::Error> {
    let depth = DEPTH.get();
    if depth == DEEPEST {
        return Err(serde::de::Error::custom("values are nested too deeply"));
    }
    DEPTH.set(depth + 1);
    let inner = T::deserialize(deserializer);
    DEPTH.set(depth);
    inner
}

impl Value {
    /// The same to the bit, where every NaN is the same as every other: NaN given and NaN wanted agree.
    pub fn same(&self, other: &Self) -> bool {
        self.distance(other) == Some(0.0)
    }

    /// How far two values are apart: the greatest distance of two numbers in the same place, relative to their size where that is
    /// above 1; 0 for two NaN, infinity for a NaN beside a number.
    ///
    /// `None` if they are of different shape, or differ in what is counted, named or true.
    pub fn distance(&self, other: &Self) -> Option<f32> {
        match (self, other) {
            (Self::Nothing, Self::Nothing) => Some(0.0),
            (Self::Truth(a), Self::Truth(b)) => (a == b).then_some(0.0),
            (Self::Whole(a), Self::Whole(b)) => (a == b).then_some(0.0),
            (Self::Number(a), Self::Number(b)) => Some(apart(*a, *b)),
            (Self::Vector(a), Self::Vector(b)) | (Self::Matrix(a), Self::Matrix(b)) => {
                greatest(a.len() == b.len(), a.iter().zip(b).map(|(a, b)| Some(apart(*a, *b))))
            }
            (Self::List(a), Self::List(b)) => {
                greatest(a.len() == b.len(), a.iter().zip(b).map(|(a, b)| a.distance(b)))
            }
            (Self::Record(a), Self::Record(b)) => greatest(
                a.name == b.name && a.fields.len() == b.fields.len(),
                a.fields.iter().zip(&b.fields).map(|((_, a), (_, b))| a.distance(b)),
            ),
            _ => None,
        }
    }

    fn identical(&self, other: &Self) -> bool {
        let bits = |a: &[f32], b: &[f32]| a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()));
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => a.to_bits() == b.to_bits(),
            (Self::Vector(a), Self::Vector(b)) | (Self::Matrix(a), Self::Matrix(b)) => bits(a, b),
            (Self::List(a), Self::List(b)) => identical(a, b),
            (Self::Record(a), Self::Record(b)) => {
                a.name == b.name
                    && a.fields.len() == b.fields.len()
                    && a.fields.iter().zip(&b.fields).all(|((_, a), (_, b))| a.identical(b))
            }
            // What is left holds no numbers of floating point.
            _ => self == other,
        }
    }

    /// The memory that it takes, in bytes: far more than the bytes that travel, for lists of small values.
    pub fn memory(&self) -> usize {
        let inside = match self {
            Self::Nothing | Self::Truth(_) | Self::Whole(_) | Self::Number(_) => 0,
            Self::Vector(numbers) | Self::Matrix(numbers) => size_of_val(numbers.as_slice()),
            Self::List(values) => values.iter().map(Self::memory).sum(),
            Self::Record(record) => {
                let field = |(name, value): &(Name, Self)| size_of::<Name>() + name.len() + value.memory();
                record.name.len() + record.fields.iter().map(field).sum::<usize>()
            }
        };
        size_of::<Self>() + inside
    }

    /// Whether a number in it is NaN or infinite.
    pub fn has_strange_numbers(&self) -> bool {
        match self {
            Self::Nothing | Self::Truth(_) | Self::Whole(_) => false,
            Self::Number(x) => !x.is_finite(),
            Self::Vector(xs) | Self::Matrix(xs) => xs.iter().any(|x| !x.is_finite()),
            Self::List(values) => values.iter().any(Self::has_strange_numbers),
            Self::Record(record) => record.fields.iter().any(|(_, value)| value.has_strange_numbers()),
        }
    }
}

fn apart(a: f32, b: f32) -> f32 {
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    let distance = (a - b).abs() / a.abs().max(b.abs()).max(1.0);
    if distance.is_nan() { f32::INFINITY } else { distance }
}

fn greatest(alike: bool, mut distances: impl Iterator<Item = Option<f32>>) -> Option<f32> {
    if !alike {
        return None;
    }
    distances.try_fold(0.0_f32, |most, distance| distance.map(|d| most.max(d)))
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => f.write_str("None"),
            Self::Truth(b) => write!(f, "{b}"),
            Self::Whole(n) => write!(f, "{n}"),
            Self::Number(x) => number(f, *x),
            Self::Vector(xs) => between(f, ["(", ", ", ")"], xs, |f, x| number(f, *x)),
            Self::Matrix(columns) => matrix(f, columns),
            Self::List(values) => between(f, ["[", ", ", "]"], values, |f, value| write!(f, "{value}")),
            Self::Record(Record { name, fields }) if fields.is_empty() => f.write_str(name),
            Self::Record(Record { name, fields }) => {
                write!(f, "{name} ")?;
                between(f, ["{ ", ", ", " }"], fields, |f, (name, value)| write!(f, "{name}: {value}"))
            }
        }
    }
}

/// Below this a number is written with two digits and its power of ten…
const TINY: f32 = 1e-5;

/// …and from here on with all digits and its power of ten.
const HUGE: f32 = 1e9;

/// Shortest digits that read back as the same number; without "-0", which nobody asked for.
fn number(f: &mut fmt::Formatter<'_>, x: f32) -> fmt::Result {
    if x == 0.0 {
        f.write_str("0")
    } else if x.abs() < TINY {
        // What rounding leaves of a zero: its digits mean nothing.
        write!(f, "{x:.1e}")
    } else if x.is_finite() && x.abs() >= HUGE {
        write!(f, "{x:e}")
    } else {
        write!(f, "{x}")
    }
}

/// Row by row, though the numbers are stored by columns.
fn matrix(f: &mut fmt::Formatter<'_>, columns: &[f32]) -> fmt::Result {
    let side = columns.len().isqrt();
    let rows: Vec<Vec<f32>> = (0..side).map(|i| (0..side).map(|j| columns[j * side + i]).collect()).collect();
    // As in a mathematics program: [1, 2; 3, 4].
    between(f, ["[", "; ", "]"], &rows, |f, row| between(f, ["", ", ", ""], row, |f, x| number(f, *x)))
}

fn between<T>(
    f: &mut fmt::Formatter<'_>,
    [open, separator, close]: [&str; 3],
    items: &[T],
    one: impl Fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    f.write_str(open)?;
    for (at, item) in items.iter().enumerate() {
        if at > 0 {
            f.write_str(separator)?;
        }
        one(f, item)?;
    }
    f.write_str(close)
}
