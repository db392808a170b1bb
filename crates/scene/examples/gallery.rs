//! Every built-in scene by every renderer, side by side: `cargo run --release -p scene --example gallery -- FOLDER`.

use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;

use canvas::{Format, Rgb, codec, side_by_side};
use scene::{Named, Renderer, Settings, builtin, prepare, render};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| ".".to_owned()));
    for built_in in builtin::all() {
        let loaded = built_in.load()?;
        let prepared = prepare(&loaded)?;
        let mut pictures = Vec::new();
        for (name, renderer) in Renderer::ALL {
            let start = Instant::now();
            let rendered =
                render(&prepared, &Settings { renderer: *renderer, ..loaded.scene.settings }, &|_| ())?;
            println!(
                "{:16} {name:9} {:6.0} ms  {}",
                built_in.name,
                start.elapsed().as_secs_f64() * 1e3,
                rendered.notes.join("; ")
            );
            pictures.push(rendered.image);
        }
        let strip = side_by_side(&pictures.iter().collect::<Vec<_>>(), 8, Rgb::ONE);
        std::fs::write(folder.join(format!("{}.png", built_in.name)), codec::encode(&strip, Format::Png8)?)?;
    }
    Ok(())
}
