//! What stands at this place of the file? Values of a TOML text that know where they are and can say what is wrong.

use std::ops::{Range, RangeInclusive};

use glam::Vec3;
use lighting::Rgb;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::limits::GREATEST_COORDINATE;
use crate::nearest::nearest;
use crate::{Named, SceneError, parse_name};

/// The text of a scene file and its name in messages.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) file: &'a str,
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// The error at a place of the text.
    pub(crate) fn fault(
        &self,
        span: &Range<usize>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> SceneError {
        // An end of the parser's span may lie inside a character or behind the text when the text is cut off.
        let mut start = span.start.min(self.text.len());
        while !self.text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &self.text[..start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        SceneError {
            file: self.file.to_owned(),
            line: Some(before.matches('\n').count() + 1),
            column: Some(before[line_start..].chars().count() + 1),
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }
}

/// A value and its place.
#[derive(Clone)]
pub(crate) struct Value<'a> {
    source: Source<'a>,
    /// How a message calls it: `camera.eye`, say.
    path: String,
    value: &'a DeValue<'a>,
    span: Range<usize>,
}

/// A table and its place; its keys are known ones.
#[derive(Clone)]
pub(crate) struct Table<'a> {
    source: Source<'a>,
    path: String,
    entries: &'a DeTable<'a>,
    span: Range<usize>,
}

impl<'a> Table<'a> {
    /// The table at the root of a file.
    pub(crate) fn root(
        source: Source<'a>,
        root: &'a Spanned<DeTable<'a>>,
        known: &[&str],
    ) -> Result<Self, SceneError> {
        // The span of the root is the whole text; what is missing in it is missing at its start.
        let table = Self {
            source,
            path: String::new(),
            entries: root.get_ref(),
            span: 0..0,
        };
        table.check_keys(known)?;
        Ok(table)
    }

    /// The value of `key`, if it is there.
    pub(crate) fn get(&self, key: &str) -> Option<Value<'a>> {
        let value = self.entries.get(key)?;
        Some(Value {
            source: self.source,
            path: self.path_of(key),
            value: value.get_ref(),
            span: value.span(),
        })
    }

    /// The value of `key`, which must be there; `remedy` says what to write.
    pub(crate) fn need(&self, key: &str, remedy: &str) -> Result<Value<'a>, SceneError> {
        self.get(key)
            .ok_or_else(|| self.fault(format!("`{}` is missing", self.path_of(key)), remedy))
    }

    /// All keys and values, in the alphabetical order of the keys.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (String, Value<'a>)> + '_ {
        let keys = self.entries.iter().map(|(key, _)| key.get_ref().to_string());
        keys.filter_map(|key| self.get(&key).map(|value| (key, value)))
    }

    /// The error about the table as a whole.
    pub(crate) fn fault(&self, problem: impl Into<String>, remedy: impl Into<String>) -> SceneError {
        self.source.fault(&self.span, problem, remedy)
    }

    /// Refuses keys other than the `known` ones.
    pub(crate) fn check_keys(&self, known: &[&str]) -> Result<(), SceneError> {
        for (key, _) in self.entries.iter() {
            let name: &str = key.get_ref();
            if !known.contains(&name) {
                let problem = format!("unknown key `{}`", self.path_of(name));
                let remedy = nearest(name, known).map_or_else(
                    || format!("the keys here are {}", known.join(", ")),
                    |near| format!("did you mean `{near}`?"),
                );
                return Err(self.source.fault(&key.span(), problem, remedy));
            }
        }
        Ok(())
    }

    fn path_of(&self, key: &str) -> String {
        let key = plain(key);
        if self.path.is_empty() {
            key
        } else {
            format!("{}.{key}", self.path)
        }
    }
}

impl<'a> Value<'a> {
    /// Where it stands.
    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The error about this value.
    pub(crate) fn fault(&self, problem: impl Into<String>, remedy: impl Into<String>) -> SceneError {
        self.source.fault(&self.span, problem, remedy)
    }

    /// The error that this value is out of range or otherwise not what it must be.
    pub(crate) fn must_be(&self, what: impl std::fmt::Display) -> SceneError {
        self.fault(
            format!("`{}` is {}", self.path, self.shown()),
            format!("it must be {what}"),
        )
    }

    /// A number, finite and no greater than a scene can hold.
    pub(crate) fn number(&self) -> Result<f32, SceneError> {
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
    pub(crate) fn number_where(
        &self,
        must_be: &str,
        allowed: impl Fn(f32) -> bool,
    ) -> Result<f32, SceneError> {
        let number = self.number()?;
        if allowed(number) {
            Ok(number)
        } else {
            Err(self.must_be(must_be))
        }
    }

    /// A whole number of a range.
    pub(crate) fn whole(&self, range: RangeInclusive<u32>) -> Result<u32, SceneError> {
        let must_be = || {
            self.must_be(format!(
                "a whole number from {} to {}",
                range.start(),
                range.end()
            ))
        };
        let DeValue::Integer(digits) = self.value else {
            return Err(must_be());
        };
        let number = u32::from_str_radix(digits.as_str(), digits.radix()).map_err(|_| must_be())?;
        if range.contains(&number) {
            Ok(number)
        } else {
            Err(must_be())
        }
    }

    /// `true` or `false`.
    pub(crate) fn truth(&self) -> Result<bool, SceneError> {
        self.value.as_bool().ok_or_else(|| self.must_be("true or false"))
    }

    /// A string.
    pub(crate) fn text(&self) -> Result<&'a str, SceneError> {
        self.value
            .as_str()
            .ok_or_else(|| self.must_be("a text in quotes"))
    }

    /// A choice by its name.
    pub(crate) fn choice<T: Named>(&self) -> Result<T, SceneError> {
        let name = self.text()?;
        parse_name(name).map_err(|unknown| {
            let names: Vec<&str> = T::ALL.iter().map(|(name, _)| *name).collect();
            let remedy = nearest(name, &names).map_or_else(
                || format!("choose {}", unknown.known),
                |near| format!("did you mean \"{near}\"?"),
            );
            self.fault(
                format!("`{}`: \"{}\" is no {}", self.path, plain(name), unknown.what),
                remedy,
            )
        })
    }

    /// A point or a direction, `[x, y, z]`.
    pub(crate) fn vector(&self) -> Result<Vec3, SceneError> {
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
    pub(crate) fn direction(&self) -> Result<Vec3, SceneError> {
        let v = self.vector()?;
        if v.normalize_or_zero() == Vec3::ZERO {
            return Err(self.must_be("a direction: its length must not be 0"));
        }
        Ok(v)
    }

    /// A colour: `[red, green, blue]` or one number for a grey; each at least 0 and at most `greatest`.
    pub(crate) fn color(&self, greatest: f32) -> Result<Rgb, SceneError> {
        let color = if self.is_list() {
            self.vector()?
        } else {
            Rgb::splat(self.number()?)
        };
        if color.min_element() < 0.0 {
            return Err(self.must_be("a colour: light cannot be negative"));
        }
        if color.max_element() > greatest {
            return Err(self.must_be(format!(
                "at most {greatest}: no surface gives back more than it gets"
            )));
        }
        Ok(color)
    }

    /// Whether it is an array.
    pub(crate) fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// The elements of an array.
    pub(crate) fn items(&self) -> Result<Vec<Value<'a>>, SceneError> {
        let array = self
            .value
            .as_array()
            .ok_or_else(|| self.must_be("a list, [ … ]"))?;
        let element = |(k, value): (usize, &'a Spanned<DeValue<'a>>)| Value {
            source: self.source,
            path: format!("{}[{k}]", self.path),
            value: value.get_ref(),
            span: value.span(),
        };
        Ok(array.iter().enumerate().map(element).collect())
    }

    /// A table with no keys but the `known` ones.
    pub(crate) fn table(&self, known: &[&str]) -> Result<Table<'a>, SceneError> {
        let table = self.any_table()?;
        table.check_keys(known)?;
        Ok(table)
    }

    /// A table, whatever its keys.
    pub(crate) fn any_table(&self) -> Result<Table<'a>, SceneError> {
        let DeValue::Table(entries) = self.value else {
            return Err(self.must_be("a table of keys and values"));
        };
        Ok(Table {
            source: self.source,
            path: self.path.clone(),
            entries,
            span: self.span(),
        })
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
pub(crate) fn plain(text: &str) -> String {
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
