//! How do the structs of the vocabulary travel? By name, field after field: one line a struct.

mod geometry;
mod lighting;
mod raytrace;
mod transforms;
mod zbuffer;

/// How a struct of the vocabulary, `Copy`, becomes a value and an argument.
macro_rules! record {
    ($name:ident { $($field:ident),* }) => {
        impl $crate::Plain for $name {
            fn into_value(self) -> $crate::Value {
                $crate::Value::Record($crate::value::Record {
                    name: stringify!($name).into(),
                    fields: vec![$((stringify!($field).into(), self.$field.into_value())),*],
                })
            }

            fn from_value(value: $crate::Value) -> Option<Self> {
                let $crate::Value::Record($crate::value::Record { name, fields }) = value else { return None };
                let mut fields = fields.into_iter().map(|(_, value)| value);
                let read = Self { $($field: $crate::Plain::from_value(fields.next()?)?),* };
                (name == stringify!($name) && fields.next().is_none()).then_some(read)
            }

            $crate::plain::lists!();
        }

        impl<'a> $crate::Parameter<'a> for $name {
            type Kept = $name;

            fn lend(kept: &'a $name) -> Self {
                *kept
            }
        }
    };
}

use record;
