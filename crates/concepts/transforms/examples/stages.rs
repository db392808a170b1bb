//! One point at every stage of the pipeline, with the matrices that carry it there (L5).

use glam::{Vec3, vec3};
use transforms::{Camera, Pipeline, ViewVolume};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let camera = Camera::look_at(vec3(3.0, 2.0, 5.0), vec3(0.5, 0.0, -1.0), Vec3::Y)?;
    let volume = ViewVolume::from_fov_y(0.7, 4.0 / 3.0, -1.0, -20.0)?;
    let pipeline = Pipeline::new(camera, volume, 640, 480)?;

    for factor in pipeline.factors() {
        println!("{}: {}", factor.symbol, factor.meaning);
        for row in 0..4 {
            let [x, y, z, w] = factor.matrix.row(row).to_array();
            println!("    {x:9.4} {y:9.4} {z:9.4} {w:9.4}");
        }
    }

    let traced = pipeline.trace(vec3(1.0, 0.5, 0.25));
    println!("world     {}", traced.world);
    println!("camera    {}", traced.camera);
    println!("clip      {}   (w is z in camera space: negative, since the point is visible)", traced.clip);
    if let (Some(canonical), Some(screen)) = (traced.canonical, traced.screen) {
        println!("canonical {canonical}");
        println!("screen    {screen}");
    }
    Ok(())
}
