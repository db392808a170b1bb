//! How does a typed function become one of values?

use glam::{Mat3, Mat4, Vec2, Vec3, Vec4};

use crate::plain::Plain;
use crate::value::Value;

/// A function of values; made by [`function!`](crate::function).
pub type Function = fn(Vec<Value>) -> Result<Value, Mismatch>;

/// The arguments are not those of the function: too few, too many, or of another type. The mistake of whoever asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The name of the first parameter without a fitting argument; empty if there were too many.
    pub parameter: &'static str,
}

/// A type that a function takes: an owned one as it is, a slice from a list that is kept for it.
pub trait Parameter<'a>: Sized {
    /// What is kept while the function runs.
    type Kept: Plain + 'a;

    /// The argument, from what is kept.
    fn lend(kept: &'a Self::Kept) -> Self;
}

impl<'a, T: Plain + 'a> Parameter<'a> for &'a [T] {
    type Kept = Vec<T>;

    fn lend(kept: &'a Vec<T>) -> Self {
        kept
    }
}

macro_rules! copied {
    ($($type:ty),*) => { $(
        impl<'a> Parameter<'a> for $type {
            type Kept = $type;

            fn lend(kept: &'a $type) -> Self {
                *kept
            }
        }
    )* };
}

copied!(bool, f32, u32, i32, usize, Vec2, Vec3, Vec4, Mat3, Mat4);

impl<'a, T: Plain + Copy + 'a, const N: usize> Parameter<'a> for [T; N] {
    type Kept = [T; N];

    fn lend(kept: &'a [T; N]) -> Self {
        *kept
    }
}

/// Makes a [`Function`] of values from a function and its signature.
///
/// ```
/// use glam::{Vec2, vec2};
/// use worker::{Function, Plain, Value};
///
/// fn stretched(factor: f32, points: &[Vec2]) -> Vec<Vec2> {
///     points.iter().map(|p| factor * *p).collect()
/// }
///
/// let function: Function = worker::function!(stretched, (factor: f32, points: &[Vec2]) -> Vec<Vec2>);
/// let arguments = vec![2.0.into_value(), vec![vec2(1.0, 2.0)].into_value()];
/// assert_eq!(function(arguments).unwrap().to_string(), "[(2, 4)]");
/// assert_eq!(function(vec![Value::Nothing]).unwrap_err().parameter, "factor");
/// ```
#[macro_export]
macro_rules! function {
    ($program:path, ($($parameter:ident: $type:ty),* $(,)?) -> $answer:ty) => {{
        fn adapted(arguments: ::std::vec::Vec<$crate::Value>) -> ::std::result::Result<$crate::Value, $crate::Mismatch> {
            let mut arguments = ::std::iter::IntoIterator::into_iter(arguments);
            $(
                let $parameter = ::std::iter::Iterator::next(&mut arguments)
                    .and_then(<<$type as $crate::Parameter>::Kept as $crate::Plain>::from_value)
                    .ok_or($crate::Mismatch { parameter: ::std::stringify!($parameter) })?;
            )*
            if ::std::iter::Iterator::next(&mut arguments).is_some() {
                return ::std::result::Result::Err($crate::Mismatch { parameter: "" });
            }
            let program: fn($($type),*) -> $answer = $program;
            let answer = program($(<$type as $crate::Parameter>::lend(&$parameter)),*);
            ::std::result::Result::Ok($crate::Plain::into_value(answer))
        }
        adapted as $crate::Function
    }};
}
