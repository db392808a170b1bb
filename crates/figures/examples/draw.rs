//! Draws figures into a folder, without a page: `cargo run -p figures --example draw -- L54 E4`.

use std::error::Error;
use std::fs;
use std::path::Path;

use canvas::{Format, codec};
use figures::{Content, Values};

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let folder = Path::new("target/figures");
    fs::create_dir_all(folder)?;
    for asked in std::env::args().skip(1) {
        for figure in figures::find(&asked) {
            for drawing in (figure.draw)(&Values::of(figure))? {
                let path = folder.join(drawing.file_name(&figure.stem()));
                match &drawing.content {
                    Content::Picture(image) => fs::write(&path, codec::encode(image, Format::Png8)?)?,
                    Content::Diagram(svg) => fs::write(&path, svg)?,
                }
                println!("{}: {}", path.display(), drawing.alt.en);
            }
        }
    }
    Ok(())
}
