//! What can be typed after the commands that draw?

use std::path::PathBuf;

use clap::builder::{NonEmptyStringValueParser, PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand};
use scene::limits::{GREATEST_DEPTH, GREATEST_SAMPLES, GREATEST_SIDE};
use scene::{Named, Renderer, Shading, Show, parse_name};

const RENDER_EXAMPLES: &str = "\
Examples:
  The teapot by all three renderers side by side, in teapot.png:
    cargo lab render
  One renderer, smooth edges, a file of your choice:
    cargo lab render glass-and-mirror --renderer raytrace --samples 3 -o glass.png
  A mesh from elsewhere; camera and light are chosen to fit it:
    cargo lab render spot.obj --shading flat --size 800x600
  What the depth buffer holds:
    cargo lab render two-spheres --renderer zbuffer --show depth
  By the loops of the slides instead of the fast ones; the times say what that costs:
    cargo lab render two-spheres --size 320x240 --slide
  A scene of your own:
    cargo lab scenes teapot > mine.toml
    cargo lab render mine.toml";

const FIGURES_EXAMPLES: &str = "\
Examples:
  All figures and claims on one page, figures/index.html:
    cargo lab figures
  The figures of one item, with another exponent:
    cargo lab figures L31 --set p=64
  For a wall: larger pictures in a folder of your choice:
    cargo lab figures --size 1280x960 --out wall";

const CLAIMS_EXAMPLES: &str = "\
Examples:
  All claims, a line each:
    cargo lab claims
  Some of them, with the evidence:
    cargo lab claims E3 L26
  For machines:
    cargo lab claims --json

Exit code: 0 all verdicts came out as recorded, 1 one did not, 2 error.";

const COMPARE_EXAMPLES: &str = "\
Examples:
  Is it the same picture?
    cargo lab compare before.png after.png
  Allow each channel to be one step of an 8-bit file off:
    cargo lab compare before.png after.png --tolerance 1/255
  Show where they differ: both pictures and a heat map, black where they agree:
    cargo lab compare before.png after.png -o difference.png

Exit code: 0 the same, 1 different, 2 error.";

const SCENES_EXAMPLES: &str = "\
Examples:
  All built-in scenes, a line each:
    cargo lab scenes
  Start a scene of your own from one of them:
    cargo lab scenes cornell-box > mine.toml
    cargo lab render mine.toml";

/// The commands that draw.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Draw a scene or a mesh and write the picture to a file
    #[command(after_help = RENDER_EXAMPLES, args_override_self = true)]
    Render(RenderArgs),
    /// Say whether two pictures are the same, and where they differ
    #[command(after_help = COMPARE_EXAMPLES)]
    Compare(CompareArgs),
    /// Draw the lecture's figures into a folder, with a page that shows them
    #[command(after_help = FIGURES_EXAMPLES)]
    Figures(FiguresArgs),
    /// Put the lecture's claims on trial
    #[command(after_help = CLAIMS_EXAMPLES)]
    Claims(ClaimsArgs),
    /// List the built-in scenes, or print one as a scene file
    #[command(after_help = SCENES_EXAMPLES)]
    Scenes(ScenesArgs),
}

/// `cargo lab render`. What is not given here comes from the scene.
#[derive(Args, Debug)]
pub(crate) struct RenderArgs {
    /// A scene file (.toml), a mesh (.obj) or the name of a built-in scene [default: the teapot]
    #[arg(value_name = "SCENE")]
    pub(crate) scene: Option<PathBuf>,

    /// The picture file: .png (8 bits a channel), .16.png (16 bits) or .exr (OpenEXR, all the light). An existing file is
    /// replaced, but not a read-only one; a symbolic link is followed [default: the scene's name with .png, in the current
    /// folder]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Draw with this renderer only [default: all three, side by side: painter, zbuffer, raytrace from left to right]
    #[arg(long, value_name = "NAME", value_parser = named::<Renderer>())]
    pub(crate) renderer: Option<Renderer>,

    /// Where the lighting is computed: once a triangle, at its corners, or in every pixel
    #[arg(long, value_name = "NAME", value_parser = named::<Shading>())]
    pub(crate) shading: Option<Shading>,

    /// Width and height of each renderer's picture, in pixels: 640x480, say; each at most 16384, and all pictures together
    /// at most 67 million pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size)]
    pub(crate) size: Option<(u32, u32)>,

    /// What to show of the visible surface
    #[arg(long, value_name = "WHAT", value_parser = named::<Show>())]
    pub(crate) show: Option<Show>,

    /// Average N × N samples in each pixel, for smooth edges; 1 to 16
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1, GREATEST_SAMPLES))]
    pub(crate) samples: Option<u32>,

    /// Use N threads [default: one for each processor]. The picture does not depend on it
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1, MOST_THREADS))]
    pub(crate) threads: Option<u32>,

    /// Draw by the loops of the slides, as they stand there, instead of the fast ones: the same picture but for rounding, and how much
    /// slower it comes. Every ray then asks every triangle: choose a small --size
    #[arg(long)]
    pub(crate) slide: bool,

    /// Let no object cast a shadow (only the ray tracer draws shadows)
    #[arg(long)]
    pub(crate) no_shadows: bool,

    /// Follow light through at most N mirrors or glass surfaces (only the ray tracer does); 0: through none; at most 64
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(0, GREATEST_DEPTH))]
    pub(crate) max_depth: Option<u32>,
}

/// `cargo lab compare`.
#[derive(Args, Debug)]
pub(crate) struct CompareArgs {
    /// One picture, PNG or OpenEXR
    #[arg(value_name = "A")]
    pub(crate) a: PathBuf,

    /// The other picture, of the same size
    #[arg(value_name = "B")]
    pub(crate) b: PathBuf,

    /// Also write a picture: A, B and a heat map of their difference, from left to right
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// The greatest difference of a channel that still counts as the same: 0 to 1, where 1 is from black to white and
    /// 1/255 is one step of an 8-bit file. OpenEXR is compared as a screen would show it: sRGB, clamped to 0 … 1
    #[arg(long, value_name = "T", default_value = "0", allow_negative_numbers = true, value_parser = tolerance)]
    pub(crate) tolerance: f32,
}

/// `cargo lab figures`.
#[derive(Args, Debug)]
pub(crate) struct FiguresArgs {
    /// Numbers or names of figures: L31, E4, exponent-strip [default: all of them, and the claims]
    #[arg(value_name = "FIGURE")]
    pub(crate) figures: Vec<String>,

    /// The folder for the pictures and their page, index.html. It is made if it is not there; what was drawn into it before
    /// and has not changed stays
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub(crate) out: PathBuf,

    /// Width and height of each picture, in pixels: 640x480, say [default: each figure's own]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size)]
    pub(crate) size: Option<(u32, u32)>,

    /// Give a parameter another value, in each chosen figure that has it; once for each parameter. The page shows the names
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    pub(crate) set: Vec<(String, f32)>,
}

/// `cargo lab claims`.
#[derive(Args, Debug)]
pub(crate) struct ClaimsArgs {
    /// Numbers or names of claims: E3, L26 [default: all of them]
    #[arg(value_name = "CLAIM")]
    pub(crate) claims: Vec<String>,

    /// Print JSON instead of a table
    #[arg(long)]
    pub(crate) json: bool,
}

/// `cargo lab scenes`.
#[derive(Args, Debug)]
pub(crate) struct ScenesArgs {
    /// Print this scene as a scene file
    #[arg(value_name = "NAME", value_parser = PossibleValuesParser::new(scene::builtin::all().iter().map(|scene| scene.name)))]
    pub(crate) name: Option<String>,
}

/// More threads than any computer this runs on has processors; the system refuses numbers far above.
const MOST_THREADS: u32 = 1024;

/// Choices by the names that scene files use as well.
fn named<T: Named + Send + Sync>() -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(T::ALL.iter().map(|(name, _)| *name)).try_map(|name| parse_name(&name))
}

/// A whole number from `least` to `greatest`.
fn whole(least: u32, greatest: u32) -> impl TypedValueParser<Value = u32> {
    NonEmptyStringValueParser::new().try_map(move |text| {
        let number = text.parse().ok().filter(|number| (least..=greatest).contains(number));
        number.ok_or_else(|| format!("expected a whole number from {least} to {greatest}"))
    })
}

/// `640x480` is (640, 480).
fn size(text: &str) -> Result<(u32, u32), String> {
    let expected = || "expected WIDTHxHEIGHT in pixels, such as 640x480".to_owned();
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(expected)?;
    let whole = |digits: &str| {
        let decimal = !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
        // A number of more digits than fit is too large, whatever it is.
        decimal.then(|| digits.parse().unwrap_or(u32::MAX))
    };
    let size = (whole(width).ok_or_else(expected)?, whole(height).ok_or_else(expected)?);
    if size.0 == 0 || size.1 == 0 {
        return Err("width and height must be at least 1 pixel".to_owned());
    }
    if size.0.max(size.1) > GREATEST_SIDE {
        return Err(format!("width and height must be at most {GREATEST_SIDE} pixels"));
    }
    Ok(size)
}

/// `p=64` is ("p", 64).
fn setting(text: &str) -> Result<(String, f32), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE, such as p=64")?;
    let value = value.trim().parse::<f32>().ok().filter(|value| value.is_finite());
    match value {
        Some(value) if !name.trim().is_empty() => Ok((name.trim().to_owned(), value)),
        _ => Err("expected NAME=VALUE with a number, such as p=64".to_owned()),
    }
}

/// A number or a fraction, `0.004` or `1/255`, from 0 to 1.
fn tolerance(text: &str) -> Result<f32, String> {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    let value = above.trim().parse::<f32>().and_then(|above| Ok(above / below.trim().parse::<f32>()?));
    value
        .ok()
        .filter(|value| (0.0..=1.0).contains(value))
        .ok_or_else(|| "expected a number from 0 to 1, such as 0.02 or 1/255".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_two_whole_numbers() {
        assert_eq!(size("640x480"), Ok((640, 480)));
        assert_eq!(size("7×3"), Ok((7, 3)));
        for wrong in [
            "",
            "12",
            "x",
            "axb",
            "640x",
            "x480",
            "-1x5",
            "+1x5",
            "1.5x2",
            "1x2x3",
            "0x7",
            "7x0",
            "1 x 2",
            "1000000x1000000",
            "99999999999x1",
            "1x16385",
            "٣x٣",
        ] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_setting_is_a_name_and_a_number() {
        assert_eq!(setting("p=64"), Ok(("p".to_owned(), 64.0)));
        for wrong in ["", "p", "p=", "=3", "p=x", "p=NaN", "p=inf", "p=1,5"] {
            assert!(setting(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_tolerance_is_a_number_or_a_fraction() {
        assert_eq!(tolerance("0.25"), Ok(0.25));
        assert_eq!(tolerance("3/255"), Ok(3.0 / 255.0));
        for wrong in ["", "x", "-0.1", "1.1", "NaN", "inf", "1/0", "0/0", "1/", "/2", "1/2/3", "7/3"] {
            assert!(tolerance(wrong).is_err(), "{wrong}");
        }
    }
}
