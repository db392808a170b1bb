//! Of what shines, and on what.

use vocabulary::{Light, Material, SurfacePoint};

use super::record;
use crate::value::Record;
use crate::{Parameter, Plain, Value};

record!(Material { diffuse, exponent });
record!(SurfacePoint { position, n, to_eye });

impl Plain for Light {
    fn into_value(self) -> Value {
        let (name, place, of, colour) = match self {
            Self::Point { position, colour } => ("Point", "position", position, colour),
            Self::Directional { to_light, colour } => ("Directional", "to_light", to_light, colour),
        };
        let fields = vec![(place.into(), of.into_value()), ("colour".into(), colour.into_value())];
        Value::Record(Record { name: name.into(), fields })
    }

    fn from_value(value: Value) -> Option<Self> {
        let Value::Record(Record { name, fields }) = value else { return None };
        let [place, colour] = <[_; 2]>::try_from(fields).ok()?;
        let (of, colour) = (Plain::from_value(place.1)?, Plain::from_value(colour.1)?);
        match &*name {
            "Point" => Some(Self::Point { position: of, colour }),
            "Directional" => Some(Self::Directional { to_light: of, colour }),
            _ => None,
        }
    }

    crate::plain::lists!();
}

impl<'a> Parameter<'a> for Light {
    type Kept = Self;

    fn lend(kept: &'a Self) -> Self {
        *kept
    }
}
