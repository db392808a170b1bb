//! A red floor five thousandths of a unit above a blue one, in 16, 24 and 32 bits of depth (L20).
//!
//! `cargo run --release -p zbuffer --example z_fighting -- FLOOR.png` draws the three side by side and prints the step of
//! each format at some distances. In 16 bits the blue floor breaks through where the step outgrows what lies between the two.

use canvas::{Format, Image, Rgb, codec};
use geometry::Triangle;
use glam::{Vec3, vec3};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::depth_format::step_at;
use zbuffer::draw::z_buffer;
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, project};

const SIDE: u32 = 320;
const FORMATS: [DepthFormat; 3] = [DepthFormat::Bits16, DepthFormat::Bits24, DepthFormat::F32];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let camera = Camera::look_at(vec3(0.0, 1.0, 0.0), vec3(0.3, 0.4, -2.0), Vec3::Y)?;
    let volume = ViewVolume::from_fov_y(0.8, 1.0, -0.1, -1000.0)?;
    let view = Pipeline::new(camera, volume, SIDE, SIDE)?;

    let mut pictures = Image::new(3 * SIDE, SIDE, Rgb::ZERO);
    for (format, k) in FORMATS.into_iter().zip(0..) {
        let picture = floors(&view, format);
        for j in 0..SIDE {
            for i in 0..SIDE {
                pictures.set(k * SIDE + i, j, picture.get(i, j));
            }
        }
    }
    let path = std::env::args().nth(1).unwrap_or_else(|| "z_fighting.png".to_owned());
    std::fs::write(&path, codec::encode(&pictures, Format::Png8)?)?;

    println!("distance   16 bits      24 bits      32 bits");
    for distance in [1.0, 3.0, 10.0, 30.0, 100.0, 300.0] {
        let [step16, step24, step32] = FORMATS.map(|format| step_at(format, &volume, distance));
        println!("{distance:8}   {step16:<10.2e}   {step24:<10.2e}   {step32:<10.2e}");
    }
    Ok(())
}

/// Both floors, the lower one drawn last.
fn floors(view: &Pipeline, format: DepthFormat) -> Image {
    let mut image = Image::new(SIDE, SIDE, Rgb::ZERO);
    let mut depth = DepthBuffer::new(SIDE, SIDE, format);
    let red = floor(view, 0.005).map(|triangle| (triangle, Rgb::new(0.7, 0.1, 0.05)));
    let blue = floor(view, 0.0).map(|triangle| (triangle, Rgb::new(0.05, 0.1, 0.6)));
    let polygons: Vec<_> = red.chain(blue).collect();
    z_buffer(Rgb::splat(0.6), &polygons, &mut image, &mut depth);
    image
}

/// A floor that reaches from behind the eye to 500 units before it.
fn floor(view: &Pipeline, height: f32) -> impl Iterator<Item = ScreenTriangle> {
    let [a, b] = [vec3(-400.0, height, 20.0), vec3(400.0, height, 20.0)];
    let [c, d] = [vec3(400.0, height, -500.0), vec3(-400.0, height, -500.0)];
    let clip_from_world = view.clip_from_world();
    [Triangle::new(a, b, c), Triangle::new(a, c, d)]
        .into_iter()
        .flat_map(move |triangle| project(&clip_from_world, SIDE, SIDE, &triangle).triangles())
}
