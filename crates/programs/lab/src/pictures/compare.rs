//! `cargo lab compare`: do two pictures show the same?

use std::fs::File;
use std::io::Read;
use std::panic;
use std::path::Path;

use canvas::codec::{self, Decoded};
use canvas::{Difference, Image, difference, side_by_side};

use super::args::CompareArgs;
use super::output::Target;
use super::render::{GAP, GAP_COLOR};
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::{say, warn};

/// Added to a tolerance: decoding a step of a file and encoding it again costs a few roundings of 6e-8, so that one step of
/// an 8-bit file may look like 1/255 and a little. Far less than a step of a 16-bit file, 1.5e-5.
const ROUNDING: f32 = 1e-6;

/// The longest file that is read, in bytes: the most pixels in the widest kind, RGBA in `f32`, and as much again.
const MOST_BYTES: u64 = codec::MOST_PIXELS * 16 * 2;

/// Says whether and how much two pictures differ, and draws it if asked.
///
/// # Errors
/// [`Failure`] if a picture cannot be read, or the output not be written.
pub(crate) fn run(asked: &CompareArgs) -> Result<Outcome, Failure> {
    let target = asked.output.as_deref().map(Target::check).transpose()?;
    for picture in [&asked.a, &asked.b] {
        if target.as_ref().is_some_and(|target| target.replaces(picture)) {
            return Err(Failure::new(
                format!("{} would be replaced by the output", picture.display()),
                "choose another name with -o",
            ));
        }
    }
    let (a, b) = (read(&asked.a)?, read(&asked.b)?);

    // With no tolerance any difference counts, be it a rounding.
    let threshold = if asked.tolerance > 0.0 { asked.tolerance + ROUNDING } else { 0.0 };
    let found = match difference(&a.image, &b.image, threshold) {
        Ok(found) => found,
        Err(mismatch) => {
            say(&mismatch.to_string())?;
            if let Some(target) = target {
                warn(&format!("{} was not written", target.named().display()));
            }
            return Ok(Outcome::Differs);
        }
    };
    say(&report(asked, &a.image, &found))?;
    if let Some(word) = alpha_word(&a, &b) {
        say(&word)?;
    }
    if let Some(target) = target {
        target.write(&side_by_side(&[&a.image, &b.image, &found.heat_map()], GAP, GAP_COLOR))?;
        say(&format!("wrote {}: A, B and their difference", target.named().display()))?;
    }
    Ok(if found.over_threshold == 0 { Outcome::Done } else { Outcome::Differs })
}

fn read(path: &Path) -> Result<Decoded, Failure> {
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MOST_BYTES).read_to_end(&mut bytes))
        .map_err(|error| Failure::io("read", path, &error, "give the path of a PNG or OpenEXR file"))?;
    // A library that panics on a damaged file is caught where it is called; its message would only confuse.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let image = codec::decode_with_alpha(&bytes);
    panic::set_hook(hook);
    image.map_err(|error| Failure::unreadable(path, &error))
}

/// What is to be said where the pictures differ in their opacity, which is not compared.
fn alpha_word(a: &Decoded, b: &Decoded) -> Option<String> {
    let pixels = a.image.pixels().len();
    let opacity = |of: &Decoded, k: usize| of.alpha.as_ref().map_or(1.0, |alpha| alpha[k]);
    let differ = (0..pixels).filter(|k| opacity(a, *k) != opacity(b, *k)).count();
    (differ > 0).then(|| {
        format!("alpha differs in {differ} of {pixels} pixels; colors were compared with black behind them")
    })
}

/// What was found, in one line or two.
fn report(asked: &CompareArgs, image: &Image, found: &Difference) -> String {
    let (a, b) = (asked.a.display(), asked.b.display());
    let pixels = image.pixels().len();
    let Some((i, j)) = found.greatest_at else {
        return format!("same: none of {pixels} pixels differs between {a} and {b}");
    };
    let verdict = match found.over_threshold {
        0 => format!("same: none of {pixels} pixels differs by more than {}", asked.tolerance),
        count => format!(
            "different: {count} of {pixels} pixels ({:.2} %) differ by more than {}",
            100.0 * count as f64 / pixels as f64,
            asked.tolerance
        ),
    };
    let nan = match found.not_a_number {
        0 => String::new(),
        count => format!("; {count} of {pixels} pixels are NaN, which is within no tolerance"),
    };
    format!(
        "{verdict}, between {a} and {b}{nan}\n\
         greatest difference {:.6} ({:.1} steps of 255) at pixel ({i}, {j}), counted from the lower left; mean {:.6}",
        found.greatest,
        found.greatest * 255.0,
        found.mean
    )
}
