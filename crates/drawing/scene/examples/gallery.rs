//! Scenes by every renderer, side by side, as PNG files in a folder; without a list of files, every built-in scene:
//! `cargo run --release -p scene --example gallery -- FOLDER [SCENE.toml | MESH.obj]...`

use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

use canvas::{Format, Rgb, codec, side_by_side};
use scene::{Loaded, Named, Renderer, Settings, builtin, load, prepare, render};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).map(PathBuf::from);
    let folder = arguments.next().unwrap_or_default();
    let files: Vec<PathBuf> = arguments.collect();
    for file in &files {
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        draw(&name, &load(file)?, &folder)?;
    }
    for scene in builtin::all().iter().filter(|_| files.is_empty()) {
        draw(scene.name, &scene.load()?, &folder)?;
    }
    Ok(())
}

fn draw(name: &str, loaded: &Loaded, folder: &Path) -> Result<(), Box<dyn Error>> {
    let prepared = prepare(loaded)?;
    let mut pictures = Vec::new();
    for (renderer_name, renderer) in Renderer::ALL {
        let start = Instant::now();
        let settings = Settings { renderer: *renderer, ..loaded.scene.settings };
        let rendered = render(&prepared, &settings, &|_| ())?;
        let milliseconds = start.elapsed().as_millis();
        println!("{name:16} {renderer_name:9} {milliseconds:6} ms  {}", rendered.notes.join("; "));
        pictures.push(rendered.image);
    }
    let strip = side_by_side(&pictures.iter().collect::<Vec<_>>(), 8, Rgb::ONE);
    std::fs::write(folder.join(format!("{name}.png")), codec::encode(&strip, Format::Png8)?)?;
    Ok(())
}
