//! What is in this OBJ file? `cargo run --release -p geometry --example obj_stats -- MESH.obj`

use std::io::Write;
use std::path::Path;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: obj_stats MESH.obj")?;
    let folder = Path::new(&path).parent().unwrap_or(Path::new(""));
    let bytes = std::fs::read(&path)?;
    let start = Instant::now();
    let import = geometry::obj::parse(&bytes, &path, &mut |name| {
        std::fs::read(folder.join(name)).map_err(|reason| reason.to_string())
    })?;
    let milliseconds = start.elapsed().as_secs_f64() * 1e3;

    let mesh = &import.mesh;
    let size = mesh.aabb().size();
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "{} triangles over {} positions, {milliseconds:.1} ms",
        mesh.len(),
        mesh.positions().len()
    )?;
    writeln!(out, "size {} × {} × {}", size.x, size.y, size.z)?;
    writeln!(
        out,
        "normals: {}, texture: {}",
        mesh.normals().is_some(),
        mesh.texture_coordinates().is_some()
    )?;
    writeln!(out, "materials: {}", import.materials.len())?;
    for warning in &import.warnings {
        writeln!(out, "warning: {warning}")?;
    }
    Ok(())
}
