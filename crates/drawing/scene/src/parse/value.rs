//! What stands at this place of the file? Values of a TOML text that know what they must be and can say what is wrong.

use std::ops::{Range, RangeInclusive};

use glam::Vec3;
use lighting::Rgb;
use toml::Spanned;
use toml::de::DeValue;

use super::nearest::nearest;
use super::table::{Source, Table};
use crate::limits::GREATEST_COORDINATE;
use crate::{Named, SceneError, parse_name};

/// A value and its place.
#[derive(Clone)]
pub(super) struct Value<'a> {
    pub(super) source: Source<'a>,
    /// How a message calls it: `camera.eye`, say.
    pub(super) path: String,
    pub(super) value: &'a DeValue<'a>,
    pub(super) span: Range<usize>,
}

impl<'a> Value<'a> {
    /// Where it stands.
    pub(super) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The error about this value.
    pub(super) fn fault(&self, problem: impl Into<String>, remedy: impl Into<String>) -> SceneError {
        self.source.fault(&self.span, problem, remedy)
    }

    /// The sentence of a warning about this value, with its place.
    pub(super) fn said(&self, sentence: &str) -> String {
        let SceneError { file, line, .. } = self.fault("", "");
        format!("{file}:{}: {sentence}", line.unwrap_or(1))
    }

    /// The error that this value is out of range or otherwise not what it must be.
    pub(super) fn must_be(&self, what: impl std::fmt::Display) -> SceneError {
        self.fault(format!("`{}` is {}", self.path, self.shown()), format!("it must be {what}"))
    }

    /// A number, finite and no greater than a scene can hold.
    pub(super) fn number(&self) -> Result<f32, SceneError> {
        let number = self.any_number().ok_or_else(|| self.must_be("a number"))?;
        if !number.is_finite() {
            return Err(self.must_be("a finite number"));
        }
        if number.abs() > GREATEST_COORDINATE {
            return Err(self.must_be(format!("at most {GREATEST_COORDINATE:e}; choose larger units")));
        }
        Ok(number)
    }

    /// A number for which `allowed` holds; `must_be` says it in words.
    pub(super) fn number_where(
        &self,
        must_be: &str,
        allowed: impl Fn(f32) -> bool,
    ) -> Result<f32, SceneError> {
        let number = self.number()?;
        if allowed(number) { Ok(number) } else { Err(self.must_be(must_be)) }
    }

    /// A whole number of a range.
    pub(super) fn whole(&self, range: RangeInclusive<u32>) -> Result<u32, SceneError> {
        let must_be = || self.must_be(format!("a whole number from {} to {}", range.start(), range.end()));
        let DeValue::Integer(digits) = self.value else {
            return Err(must_be());
        };
        let number = u32::from_str_radix(digits.as_str(), digits.radix()).map_err(|_| must_be())?;
        if range.contains(&number) { Ok(number) } else { Err(must_be()) }
    }

    /// `true` or `false`.
    pub(super) fn truth(&self) -> Result<bool, SceneError> {
        self.value.as_bool().ok_or_else(|| self.must_be("true or false"))
    }

    /// A string.
    pub(super) fn text(&self) -> Result<&'a str, SceneError> {
        self.value.as_str().ok_or_else(|| self.must_be("a text in quotes"))
    }

    /// A choice by its name.
    pub(super) fn choice<T: Named>(&self) -> Result<T, SceneError> {
        let name = self.text()?;
        parse_name(name).map_err(|unknown| {
            let names: Vec<&str> = T::ALL.iter().map(|(name, _)| *name).collect();
            let remedy = nearest(name, &names).map_or_else(
                || format!("choose {}", unknown.known),
                |near| format!("did you mean \"{near}\"?"),
            );
            self.fault(format!("`{}`: \"{}\" is no {}", self.path, plain(name), unknown.what), remedy)
        })
    }

    /// A point or a direction, `[x, y, z]`.
    pub(super) fn vector(&self) -> Result<Vec3, SceneError> {
        let items = self.value.as_array().map_or(0, |array| array.len());
        if items != 3 {
            return Err(self.must_be("three numbers, [x, y, z]"));
        }
        let mut components = [0.0; 3];
        for (component, item) in components.iter_mut().zip(self.items()?) {
            *component = item.number()?;
        }
        Ok(Vec3::from(components))
    }

    /// A vector that is not zero.
    pub(super) fn direction(&self) -> Result<Vec3, SceneError> {
        let v = self.vector()?;
        if v.normalize_or_zero() == Vec3::ZERO {
            return Err(self.must_be("a direction: its length must not be 0"));
        }
        Ok(v)
    }

    /// A colour: `[red, green, blue]` or one number for a grey; each at least 0 and at most `greatest`.
    pub(super) fn color(&self, greatest: f32) -> Result<Rgb, SceneError> {
        let color = if self.is_list() { self.vector()? } else { Rgb::splat(self.number()?) };
        if color.min_element() < 0.0 {
            return Err(self.must_be("a colour: light cannot be negative"));
        }
        if color.max_element() > greatest {
            return Err(self.must_be(format!("at most {greatest}: no surface gives back more than it gets")));
        }
        Ok(color)
    }

    /// Whether it is an array.
    pub(super) fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// The elements of an array.
    pub(super) fn items(&self) -> Result<Vec<Value<'a>>, SceneError> {
        let array = self.value.as_array().ok_or_else(|| self.must_be("a list, [ … ]"))?;
        let element = |(k, value): (usize, &'a Spanned<DeValue<'a>>)| Value {
            source: self.source,
            path: format!("{}[{k}]", self.path),
            value: value.get_ref(),
            span: value.span(),
        };
        Ok(array.iter().enumerate().map(element).collect())
    }

    /// A table with no keys but the `known` ones.
    pub(super) fn table(&self, known: &[&str]) -> Result<Table<'a>, SceneError> {
        let table = self.any_table()?;
        table.check_keys(known)?;
        Ok(table)
    }

    /// A table, whatever its keys.
    pub(super) fn any_table(&self) -> Result<Table<'a>, SceneError> {
        let DeValue::Table(entries) = self.value else {
            return Err(self.must_be("a table of keys and values"));
        };
        Ok(Table { source: self.source, path: self.path.clone(), entries, span: self.span() })
    }

    /// Integer or float, as the nearest `f32`; too large a number becomes infinite.
    fn any_number(&self) -> Option<f32> {
        match self.value {
            // Read as f32 at once: a detour through f64 would round twice.
            DeValue::Float(digits) => digits.as_str().parse().ok(),
            DeValue::Integer(digits) if digits.radix() == 10 => digits.as_str().parse().ok(),
            DeValue::Integer(digits) => {
                let number = u64::from_str_radix(digits.as_str(), digits.radix()).ok();
                Some(number.map_or(f32::INFINITY, |n| n as f32))
            }
            _ => None,
        }
    }

    /// The value in a few characters, for messages.
    fn shown(&self) -> String {
        match self.value {
            DeValue::String(text) => format!("\"{}\"", plain(text)),
            DeValue::Integer(number) => number.to_string(),
            DeValue::Float(number) => number.to_string(),
            DeValue::Boolean(truth) => truth.to_string(),
            DeValue::Array(items) if items.len() <= 4 && items.iter().all(|i| is_number(i.get_ref())) => {
                let numbers: Vec<String> = items.iter().map(|item| number_text(item.get_ref())).collect();
                format!("[{}]", numbers.join(", "))
            }
            DeValue::Array(items) => format!("a list of {}", items.len()),
            other => format!("a {}", other.type_str()),
        }
    }
}

/// Text from a file, fit for a message: without control characters and not endless.
pub(super) fn plain(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    shown
}

fn is_number(value: &DeValue<'_>) -> bool {
    value.is_integer() || value.is_float()
}

fn number_text(value: &DeValue<'_>) -> String {
    match value {
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.to_string(),
        _ => String::new(),
    }
}
