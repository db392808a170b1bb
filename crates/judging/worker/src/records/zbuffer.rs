//! Of what is left of polygons on the screen, and of what hides what.

use vocabulary::{Buffers, Fragment, Occlusion, Pixel};

use super::record;
use crate::value::Record;
use crate::{Plain, Value};

record!(Pixel { i, j });
record!(Fragment { i, j, z, colour });
record!(Occlusion { behind, in_front });

impl Plain for Buffers {
    fn into_value(self) -> Value {
        Value::Record(Record {
            name: "Buffers".into(),
            fields: vec![("rgb".into(), self.rgb.into_value()), ("z".into(), self.z.into_value())],
        })
    }

    fn from_value(value: Value) -> Option<Self> {
        let Value::Record(Record { name, fields }) = value else { return None };
        let [(_, rgb), (_, z)] = <[_; 2]>::try_from(fields).ok()?;
        let read = Self { rgb: Plain::from_value(rgb)?, z: Plain::from_value(z)? };
        (name == "Buffers").then_some(read)
    }
}
