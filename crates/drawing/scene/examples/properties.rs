//! What the pixels of the teapot know: colour, depth, normals, barycentric coordinates and overdraw, side by side:
//! `cargo run --release -p scene --example properties -- properties.png [zbuffer | painter | raytrace]`

use std::error::Error;

use canvas::{Format, Rgb, codec, side_by_side};
use scene::{Named, Renderer, Settings, Shading, Show, builtin, prepare, render};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().unwrap_or_else(|| "properties.png".to_owned());
    let renderer: Renderer = arguments.next().unwrap_or_else(|| "zbuffer".to_owned()).parse()?;
    let loaded = builtin::all()[0].load()?;
    let prepared = prepare(&loaded)?;
    let mut pictures = Vec::new();
    for shading in [Shading::Flat, Shading::Phong] {
        for (_, show) in Show::ALL {
            let settings =
                Settings { renderer, shading, show: *show, size: (320, 240), ..loaded.scene.settings };
            pictures.push(render(&prepared, &settings, &|_| ())?.image);
        }
    }
    let strip = side_by_side(&pictures.iter().collect::<Vec<_>>(), 4, Rgb::ONE);
    std::fs::write(path, codec::encode(&strip, Format::Png8)?)?;
    Ok(())
}
