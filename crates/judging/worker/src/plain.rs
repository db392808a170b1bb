//! Which types can travel?

use glam::{Mat3, Mat4, Vec2, Vec3, Vec4};

use crate::value::Value;

/// A type that can be taken apart into a [`Value`] and put together again.
pub trait Plain: Sized {
    /// The value of it.
    fn into_value(self) -> Value;

    /// From a value; `None` if the value is of another type.
    fn from_value(value: Value) -> Option<Self>;

    /// The value of a list.
    fn list_into_value(list: Vec<Self>) -> Value {
        Value::List(list.into_iter().map(Self::into_value).collect())
    }

    /// A list from its value.
    fn list_from_value(value: Value) -> Option<Vec<Self>> {
        let Value::List(values) = value else { return None };
        values.into_iter().map(Self::from_value).collect()
    }
}

/// The two about lists once more, for a type that lists are made of: what is written out in its own implementation is compiled with this
/// library, what comes from the trait's with each student's file.
macro_rules! lists {
    () => {
        fn list_into_value(list: Vec<Self>) -> $crate::Value {
            $crate::Value::List(list.into_iter().map(<Self as $crate::Plain>::into_value).collect())
        }

        fn list_from_value(value: $crate::Value) -> Option<Vec<Self>> {
            let $crate::Value::List(values) = value else { return None };
            values.into_iter().map(<Self as $crate::Plain>::from_value).collect()
        }
    };
}

pub(crate) use lists;

impl Plain for Value {
    fn into_value(self) -> Value {
        self
    }

    fn from_value(value: Value) -> Option<Self> {
        Some(value)
    }
}

impl Plain for () {
    fn into_value(self) -> Value {
        Value::Nothing
    }

    fn from_value(value: Value) -> Option<Self> {
        matches!(value, Value::Nothing).then_some(())
    }
}

impl Plain for bool {
    fn into_value(self) -> Value {
        Value::Truth(self)
    }

    fn from_value(value: Value) -> Option<Self> {
        if let Value::Truth(truth) = value { Some(truth) } else { None }
    }
}

impl Plain for f32 {
    fn into_value(self) -> Value {
        Value::Number(self)
    }

    fn from_value(value: Value) -> Option<Self> {
        if let Value::Number(number) = value { Some(number) } else { None }
    }

    lists!();
}

macro_rules! whole {
    ($($whole:ty),*) => { $(
        impl Plain for $whole {
            fn into_value(self) -> Value {
                // Counts of this size do not occur; whoever makes one gets the nearest that can travel.
                Value::Whole(i64::try_from(self).unwrap_or(i64::MAX))
            }

            fn from_value(value: Value) -> Option<Self> {
                if let Value::Whole(whole) = value { whole.try_into().ok() } else { None }
            }

            lists!();
        }
    )* };
}

whole!(u8, u32, i32, usize, i64);

macro_rules! vectors {
    ($($type:ty),*) => { $(
        impl Plain for $type {
            fn into_value(self) -> Value {
                Value::Vector(self.to_array().to_vec())
            }

            fn from_value(value: Value) -> Option<Self> {
                let Value::Vector(numbers) = value else { return None };
                Some(Self::from_array(numbers.try_into().ok()?))
            }

            lists!();
        }
    )* };
}

vectors!(Vec2, Vec3, Vec4);

macro_rules! matrices {
    ($($type:ty),*) => { $(
        impl Plain for $type {
            fn into_value(self) -> Value {
                Value::Matrix(self.to_cols_array().to_vec())
            }

            fn from_value(value: Value) -> Option<Self> {
                let Value::Matrix(columns) = value else { return None };
                Some(Self::from_cols_array(&columns.try_into().ok()?))
            }
        }
    )* };
}

matrices!(Mat3, Mat4);

impl<T: Plain> Plain for Option<T> {
    fn into_value(self) -> Value {
        self.map_or(Value::Nothing, T::into_value)
    }

    fn from_value(value: Value) -> Option<Self> {
        if value == Value::Nothing { Some(None) } else { T::from_value(value).map(Some) }
    }
}

impl<T: Plain> Plain for Vec<T> {
    fn into_value(self) -> Value {
        T::list_into_value(self)
    }

    fn from_value(value: Value) -> Option<Self> {
        T::list_from_value(value)
    }
}

impl<T: Plain, const N: usize> Plain for [T; N] {
    fn into_value(self) -> Value {
        Value::List(self.into_iter().map(T::into_value).collect())
    }

    fn from_value(value: Value) -> Option<Self> {
        Vec::from_value(value)?.try_into().ok()
    }
}

macro_rules! tuple {
    ($($name:ident),*) => {
        impl<$($name: Plain),*> Plain for ($($name,)*) {
            fn into_value(self) -> Value {
                #[expect(non_snake_case, reason = "a type's letter names its value here")]
                let ($($name,)*) = self;
                Value::List(vec![$($name.into_value()),*])
            }

            fn from_value(value: Value) -> Option<Self> {
                let Value::List(values) = value else { return None };
                let mut values = values.into_iter();
                let tuple = ($($name::from_value(values.next()?)?,)*);
                values.next().is_none().then_some(tuple)
            }
        }
    };
}

tuple!(A, B);
tuple!(A, B, C);
tuple!(A, B, C, D);
