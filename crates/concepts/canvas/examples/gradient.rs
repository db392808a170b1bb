//! Two ramps from black to white: equal steps of light above, equal steps of the encoded value below.
//!
//! `cargo run -p canvas --example gradient -- gradient.png`
//!
//! The lower ramp looks even. The upper one is the physically even one, and looks too bright: half the light of white,
//! at the middle mark, is step 188 of 255.

use std::error::Error;
use std::path::PathBuf;

use canvas::{Format, Image, Rgb, codec, srgb};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 241;
/// Columns of one step of the ramps.
const STEP: u32 = 40;

fn main() -> Result<(), Box<dyn Error>> {
    let path: PathBuf = std::env::args_os().nth(1).ok_or("usage: gradient PICTURE.png|.16.png|.exr")?.into();
    let picture = Image::from_fn(WIDTH, HEIGHT, color);
    std::fs::write(&path, codec::encode(&picture, Format::from_path(&path)?)?)?;
    Ok(())
}

/// The colour of pixel (i, j), j upwards: each ramp smooth in its outer half, in steps in its inner half.
fn color(i: u32, j: u32) -> Rgb {
    let middle = HEIGHT / 2;
    if j == middle || (i == WIDTH / 2 && j.abs_diff(middle) < 20) {
        return Rgb::new(0.8, 0.1, 0.0);
    }
    let smooth = i as f32 / (WIDTH - 1) as f32;
    let stepped = (i / STEP) as f32 / (WIDTH / STEP - 1) as f32;
    let along = if j.abs_diff(middle) > HEIGHT / 4 { smooth } else { stepped };
    Rgb::splat(if j > middle { along } else { srgb::decode(along) })
}
