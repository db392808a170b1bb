//! The fast version finds what the slide's loop finds: the same triangle and the same depth in every pixel, bit for bit.

use geometry::Mesh;
use glam::{Mat4, Vec3, vec3};
use proptest::prelude::*;
use testkit::{Law, ensure};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::fast::{Band, Faces, MeshInstance, NONE, Projected};
use zbuffer::{DepthBuffer, DepthFormat, project, rasterize};

/// Triangle and depth of a pixel.
type Seen = Option<(u32, f32)>;

/// Screens of no round size: rows that fill no band, columns that fill no block.
fn pipeline((width, height): (u32, u32)) -> Pipeline {
    let camera = Camera::look_at(vec3(0.3, 0.2, 3.0), vec3(0.1, 0.0, -1.0), Vec3::Y).unwrap();
    let volume = ViewVolume { left: -1.0, right: 1.1, bottom: -0.9, top: 1.0, near: -1.0, far: -9.0 };
    Pipeline::new(camera, volume, width, height).unwrap()
}

/// Triangles all over the place, several of them through one corner or twice the same, some beyond the near plane and some
/// beside the screen.
fn soup() -> impl Strategy<Value = (Vec<Vec3>, Vec<[u32; 3]>)> + Clone {
    let coordinate = || prop_oneof![3 => -2.0_f32..2.0, 1 => -12.0_f32..12.0, 1 => Just(0.5)];
    let depth = prop_oneof![4 => -5.0_f32..1.5, 1 => -14.0_f32..6.0];
    let positions = prop::collection::vec((coordinate(), coordinate(), depth), 3..40);
    let small = prop::collection::vec(
        (-2.0_f32..2.0, -2.0_f32..2.0, -4.0_f32..1.0, prop::array::uniform6(-0.1_f32..0.1)),
        0..40,
    );
    let triangles = prop::collection::vec(prop::array::uniform3(0_u32..1000), 1..40);
    (positions, small, triangles).prop_map(|(positions, small, triangles)| {
        let mut positions: Vec<Vec3> = positions.into_iter().map(|(x, y, z)| vec3(x, y, z)).collect();
        let count = positions.len() as u32;
        let mut triangles: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(|k| k % count)).collect();
        for (x, y, z, [a, b, c, d, e, f]) in small {
            let (p, first) = (vec3(x, y, z), positions.len() as u32);
            positions.extend([p, p + vec3(a, b, c), p + vec3(d, e, f)]);
            triangles.push([first, first + 1, first + 2]);
        }
        (positions, triangles)
    })
}

/// The slide's loop over all triangles of two copies of the mesh.
fn slide(mesh: &Mesh, maps: &[Mat4], faces: Faces, pipeline: &Pipeline) -> Vec<Seen> {
    let (width, height) = (pipeline.width(), pipeline.height());
    let mut depth = DepthBuffer::new(width, height, DepthFormat::F32);
    let mut seen = vec![None; (width * height) as usize];
    let mut number = 0;
    for map in maps {
        for k in 0..mesh.len() {
            let corners = mesh.triangle(k).corners().map(|p| map.transform_point3(p));
            let world = geometry::Triangle::new(corners[0], corners[1], corners[2]);
            for part in project(&pipeline.clip_from_world(), width, height, &world).triangles() {
                let is_front = (part.doubled_area() > 0) != (map.determinant() < 0.0);
                if faces == Faces::Front && !is_front {
                    continue;
                }
                rasterize(&part, width, height, |f| {
                    if depth.test_and_set(f.i, f.j, f.z) {
                        seen[((height - 1 - f.j) * width + f.i) as usize] = Some((number, f.z as f32));
                    }
                });
            }
            number += 1;
        }
    }
    seen
}

fn fast(mesh: &Mesh, maps: &[Mat4], faces: Faces, pipeline: &Pipeline) -> Vec<Seen> {
    let parts: Vec<MeshInstance> =
        maps.iter().map(|map| MeshInstance { mesh, world_from_object: *map }).collect();
    let mut projected = Projected::default();
    projected.project(&parts, pipeline, faces);
    let mut band = Band::default();
    let mut seen = Vec::new();
    for b in 0..projected.bands() {
        band.draw(b, &projected, &parts);
        for row in band.rows() {
            seen.extend(band.row(row).map(|(number, z)| (number != NONE).then_some((number, z))));
        }
    }
    seen
}

#[test]
fn every_pixel_shows_the_triangle_and_the_depth_of_the_slides_loop() {
    let shift = (-0.5_f32..0.5, -0.5_f32..0.5, prop_oneof![Just(1.0_f32), Just(-1.0)]);
    let map = shift.prop_map(|(x, y, side)| {
        Mat4::from_translation(vec3(x, y, 0.1)) * Mat4::from_scale(vec3(side, 1.0, 1.2))
    });
    let size =
        prop_oneof![Just((37_u32, 29_u32)), Just((130, 50)), Just((5, 3)), Just((1, 1)), Just((64, 16))];
    Law::new("bit for bit, the fast z-buffer sees what the slide's loop sees")
        .cases(1500)
        .demand("something is seen", 0.9)
        .demand("several triangles are seen", 0.5)
        .demand("fronts only", 0.3)
        .demand("two triangles equally near", 0.05)
        .holds_for(
            (soup(), map, size, any::<bool>()),
            |((positions, triangles), map, size, fronts), seen| {
                let Ok(mesh) = Mesh::new(positions, triangles) else { return Ok(()) };
                let faces = if fronts { Faces::Front } else { Faces::Both };
                // The first copy again at the end: all its depths are tied.
                let maps = [Mat4::IDENTITY, map, Mat4::IDENTITY];
                let pipeline = pipeline(size);
                let (ours, theirs) =
                    (fast(&mesh, &maps, faces, &pipeline), slide(&mesh, &maps, faces, &pipeline));
                let numbers: std::collections::BTreeSet<_> =
                    theirs.iter().flatten().map(|(number, _)| *number).collect();
                seen.class("something is seen", !numbers.is_empty());
                seen.class("several triangles are seen", numbers.len() > 3);
                seen.class("fronts only", fronts);
                seen.class("two triangles equally near", numbers.iter().any(|n| (*n as usize) < mesh.len()));
                let first = ours.iter().zip(&theirs).position(|(ours, theirs)| ours != theirs);
                ensure(first.is_none(), || {
                    let pixel = first.unwrap_or_default();
                    format!("pixel {pixel} of {size:?}: {:?}, not {:?}", ours[pixel], theirs[pixel])
                })
            },
        );
}
