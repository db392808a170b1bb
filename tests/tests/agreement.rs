//! Do rasterizer and ray tracer draw the same picture? (L21)
//!
//! They share the vocabulary, the conventions and the lighting equation, but nothing that decides what a pixel shows. So
//! for random scenes the same triangle must win in every pixel, and the colours must agree, but for pixels where the
//! rasterizer's snapping to 1/256 pixel can decide: those whose centre lies within [`SNAP`] of an edge, or where two
//! surfaces pass through each other, so that their depths differ by less than what [`SNAP`] makes of their slopes.
//! How many those are is counted and bounded too.

use std::cell::RefCell;
use std::sync::Arc;

use canvas::{Rgb, row_from_j, srgb};
use geometry::{Mesh, Triangle};
use glam::{DMat4, DVec2, DVec3, Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use proptest::prelude::*;
use shading::{Shading, Visibility};
use testkit::{Law, Outcome, ensure, strategy};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::DepthFormat;

/// How far, in pixels, a projected vertex can be from where it belongs: half a step of 1/256 in x and in y, and as much
/// again for the rounding of both renderers' 32-bit coordinates. That rounding is about 100 · 60 · 2⁻²⁴ pixels here (60
/// pixels, coordinates 100 times the smallest depth): less than the snapping.
const SNAP: f64 = 2.0 * std::f64::consts::SQRT_2 / 512.0;

/// A scene in terms that both renderers understand.
#[derive(Clone, Debug)]
struct Stage {
    meshes: Vec<(Mesh, Mat4, Material)>,
    lights: Vec<Light>,
    pipeline: Pipeline,
}

const BACKGROUND: Rgb = Rgb::new(0.1, 0.2, 0.4);

impl Stage {
    fn rasterized(&self, shading: Shading, visibility: Visibility) -> shading::Frame {
        let objects: Vec<shading::Object> = self
            .meshes
            .iter()
            .map(|(mesh, world_from_object, material)| shading::Object {
                mesh,
                world_from_object: *world_from_object,
                materials: std::slice::from_ref(material),
            })
            .collect();
        let world = shading::World {
            objects: &objects,
            lights: &self.lights,
            background: BACKGROUND,
            highlight: Highlight::Blinn,
        };
        shading::render(&world, &self.pipeline, shading, visibility)
    }

    fn traceable(&self, interpolation: raytrace::Interpolation) -> raytrace::World {
        let objects = self.meshes.iter().map(|(mesh, world_from_object, material)| {
            let shape = raytrace::Shape::Mesh(Arc::new(raytrace::TracedMesh::new(mesh.clone())));
            raytrace::Object::new(shape, *world_from_object, vec![raytrace::Surface::opaque(*material)])
                .expect("an invertible transform")
        });
        let mut world = raytrace::World::new(objects.collect(), self.lights.clone());
        world.background = BACKGROUND;
        world.interpolation = interpolation;
        world
    }

    fn triangle(&self, (object, triangle): (usize, usize)) -> Triangle {
        let (mesh, world_from_object, _) = &self.meshes[object];
        let [a, b, c] = mesh.triangle(triangle).corners().map(|p| world_from_object.transform_point3(p));
        Triangle { a, b, c }
    }

    fn triangles(&self) -> impl Iterator<Item = (usize, usize)> {
        self.meshes
            .iter()
            .enumerate()
            .flat_map(|(object, (mesh, ..))| (0..mesh.len()).map(move |k| (object, k)))
    }
}

/// The edges of everything on the screen, those included where near and far plane cut.
fn edges(stage: &Stage) -> Vec<(DVec2, DVec2)> {
    let (width, height) = (stage.pipeline.width(), stage.pipeline.height());
    let clip_from_world = stage.pipeline.clip_from_world();
    let polygons = stage
        .triangles()
        .map(|name| zbuffer::project(&clip_from_world, width, height, &stage.triangle(name)));
    polygons
        .flat_map(|polygon| {
            let points: Vec<DVec2> =
                polygon.vertices().iter().map(|v| v.position.truncate().as_dvec2()).collect();
            let next = |k: usize| points[(k + 1) % points.len()];
            points.iter().enumerate().map(|(k, p)| (*p, next(k))).collect::<Vec<_>>()
        })
        .collect()
}

fn distance_to_edge(p: DVec2, (a, b): (DVec2, DVec2)) -> f64 {
    let along = b - a;
    let share = if along == DVec2::ZERO {
        0.0
    } else {
        ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0)
    };
    p.distance(a + share * along)
}

/// The length of the part of the edge that is on the screen.
fn length_on_screen(stage: &Stage, (a, b): (DVec2, DVec2)) -> f64 {
    let along = b - a;
    let size = DVec2::new(stage.pipeline.width().into(), stage.pipeline.height().into());
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        // The screen is [−½, n − ½] on both axes.
        let (low, high) = (-0.5 - a[axis], size[axis] - 0.5 - a[axis]);
        if along[axis] == 0.0 {
            if low > 0.0 || high < 0.0 {
                return 0.0;
            }
        } else {
            let (s, t) = (low / along[axis], high / along[axis]);
            enter = enter.max(s.min(t));
            leave = leave.min(s.max(t));
        }
    }
    along.length() * (leave - enter).max(0.0)
}

/// Canonical z of a triangle's plane at a point of the screen, in 64 bits; `None` if the plane is seen edge-on.
fn depth_at(stage: &Stage, name: (usize, usize), p: DVec2) -> Option<f64> {
    let triangle = stage.triangle(name).corners().map(|corner| corner.as_dvec3());
    let [a, b, c] =
        triangle.map(|corner| stage.pipeline.camera_from_world().as_dmat4().transform_point3(corner));
    let n = (b - a).cross(c - a);
    let (volume, size) = (stage.pipeline.volume(), (stage.pipeline.width(), stage.pipeline.height()));
    let share = |x: f64, pixels: u32| (x + 0.5) / f64::from(pixels);
    let direction = DVec3::new(
        f64::from(volume.left) + share(p.x, size.0) * f64::from(volume.right - volume.left),
        f64::from(volume.bottom) + share(p.y, size.1) * f64::from(volume.top - volume.bottom),
        f64::from(volume.near),
    );
    let t = n.dot(a) / n.dot(direction);
    let clip: DMat4 = stage.pipeline.canonical_from_camera().as_dmat4();
    t.is_finite().then(|| clip.project_point3(t * direction).z)
}

/// Whether snapping may decide which of two surfaces is nearer at `p`: an affine function through three vertices that each
/// move by at most `SNAP` changes inside the triangle by at most its slope times `SNAP`.
fn depths_are_close(stage: &Stage, one: (usize, usize), other: (usize, usize), p: DVec2) -> bool {
    let depth_and_slope = |name| {
        let here = depth_at(stage, name, p)?;
        let right = depth_at(stage, name, p + DVec2::X)? - here;
        let up = depth_at(stage, name, p + DVec2::Y)? - here;
        Some((here, DVec2::new(right, up).length()))
    };
    let (Some((z1, slope1)), Some((z2, slope2))) = (depth_and_slope(one), depth_and_slope(other)) else {
        return true;
    };
    // Depths are rounded to 32 bits a few times on the way, by camera coordinates 100 times the smallest depth.
    let rounding = 64.0 * f64::from(f32::EPSILON);
    (z1 - z2).abs() <= (slope1 + slope2) * SNAP + rounding
}

/// How many pixels were compared and how many were left to snapping, over all scenes of a law.
#[derive(Default)]
struct Tally {
    pixels: usize,
    different: usize,
    /// The area within `SNAP` of an edge: 2 · SNAP · length, a pixel having area 1.
    edge_area: f64,
    /// Pixels with one winner whose colours differ by more than 1/255.
    colors_left_to_snapping: usize,
}

/// Pixel by pixel: the same (object, triangle) or a reason.
fn compare_winners(
    stage: &Stage,
    ours: impl Fn(usize) -> Option<(usize, usize)>,
    theirs: impl Fn(usize) -> Option<(usize, usize)>,
    tally: &mut Tally,
) -> Outcome {
    let edges = edges(stage);
    let (width, height) = (stage.pipeline.width(), stage.pipeline.height());
    tally.pixels += width as usize * height as usize;
    tally.edge_area += edges.iter().map(|edge| 2.0 * SNAP * length_on_screen(stage, *edge)).sum::<f64>();
    for j in 0..height {
        for i in 0..width {
            let index = row_from_j(j, height) as usize * width as usize + i as usize;
            let (one, other) = (ours(index), theirs(index));
            if one == other {
                continue;
            }
            tally.different += 1;
            let p = DVec2::new(i.into(), j.into());
            let near_an_edge = edges.iter().any(|edge| distance_to_edge(p, *edge) <= SNAP);
            let undecided = matches!((one, other), (Some(a), Some(b)) if depths_are_close(stage, a, b, p));
            ensure(near_an_edge || undecided, || format!("pixel ({i}, {j}): {one:?} against {other:?}"))?;
        }
    }
    Ok(())
}

/// The colours, as a file shows them: sRGB-encoded, 0 to 1.
fn encoded(color: Rgb) -> Vec3 {
    Vec3::from(color.to_array().map(srgb::encode))
}

/// Pixel by pixel, where the same triangle won: colours within 1/255, or a reason.
///
/// The reason can only be snapping: the rasterizer's colour belongs to a point of the triangle that is seen at most `SNAP`
/// from the pixel's centre. Where a surface is seen at a grazing angle its colour may change by more than 1/255 on that way,
/// so the colour must then lie between those that rays `SNAP` to all sides bring back.
fn compare_colors(
    stage: &Stage,
    frame: &shading::Frame,
    world: &raytrace::World,
    hits: &[Option<raytrace::Hit>],
    tally: &mut Tally,
) -> Outcome {
    let settings = raytrace::Settings { shadows: false, ..raytrace::Settings::default() };
    let traced = raytrace::render(world, &stage.pipeline, &settings, &|_| ());
    let (width, height) = (stage.pipeline.width(), stage.pipeline.height());
    for j in 0..height {
        for i in 0..width {
            let index = row_from_j(j, height) as usize * width as usize + i as usize;
            let winner = hits[index].map(|hit| (hit.object, hit.triangle));
            let (ours, theirs) = (encoded(frame.image.get(i, j)), encoded(traced.get(i, j)));
            let apart = (ours - theirs).abs().max_element();
            if apart <= 1.0 / 255.0 || frame.visible[index].map(|v| (v.object, v.triangle)) != winner {
                continue;
            }
            tally.colors_left_to_snapping += 1;
            let around = colors_around(stage, world, (i, j), winner);
            let (low, high) = around.fold((theirs, theirs), |(low, high), c| (low.min(c), high.max(c)));
            let within = ours.cmpge(low - 1.0 / 255.0).all() && ours.cmple(high + 1.0 / 255.0).all();
            ensure(within, || format!("pixel ({i}, {j}): {ours} against {theirs}, sRGB"))?;
        }
    }
    Ok(())
}

/// What rays `SNAP` beside a pixel's centre bring back, to all eight sides, where they meet the same triangle.
fn colors_around<'a>(
    stage: &'a Stage,
    world: &'a raytrace::World,
    (i, j): (u32, u32),
    winner: Option<(usize, usize)>,
) -> impl Iterator<Item = Vec3> + 'a {
    let settings = raytrace::Settings { shadows: false, ..raytrace::Settings::default() };
    let (t0, t1) = raytrace::visible_interval(&stage.pipeline.volume());
    (0..9).filter(|k| *k != 4).filter_map(move |k| {
        let aside = |step: i32| (f64::from(step - 1) * SNAP) as f32;
        let ray = raytrace::viewing_ray(&stage.pipeline, i as f32 + aside(k % 3), j as f32 + aside(k / 3));
        let hit = raytrace::nearest(world, &ray, t0, t1)?;
        let same = Some((hit.object, hit.triangle)) == winner;
        same.then(|| encoded(raytrace::ray_color(world, &ray, t0, t1, &settings)))
    })
}

const MODES: [(Shading, raytrace::Interpolation); 3] = [
    (Shading::Flat, raytrace::Interpolation::Flat),
    (Shading::Gouraud, raytrace::Interpolation::Gouraud),
    (Shading::Phong, raytrace::Interpolation::Phong),
];

fn camera_and_volume() -> impl Strategy<Value = Pipeline> {
    let eye = (strategy::unit_vector(), 4.0_f32..9.0).prop_map(|(direction, distance)| distance * direction);
    (eye, strategy::point(1.0), 0.4_f32..1.2, 24_u32..60, 24_u32..60, strategy::unit_vector())
        .prop_filter("up along the gaze", |(eye, target, .., up)| {
            (*target - *eye).normalize().cross(*up).length() > 0.2
        })
        .prop_map(|(eye, target, fov_y, width, height, up)| {
            let camera = Camera::look_at(eye, target, up).expect("checked");
            let aspect = width as f32 / height as f32;
            let volume = ViewVolume::from_fov_y(fov_y, aspect, -0.5, -30.0).expect("a valid volume");
            Pipeline::new(camera, volume, width, height).expect("a valid pipeline")
        })
}

fn lights() -> impl Strategy<Value = Vec<Light>> {
    (strategy::unit_vector(), strategy::point(8.0)).prop_map(|(to_light, position)| {
        vec![
            Light::Ambient { color: Rgb::new(0.10, 0.12, 0.15) },
            Light::Directional { to_light, color: Rgb::new(0.7, 0.6, 0.5) },
            Light::Point { position, color: Rgb::new(0.3, 0.4, 0.5) },
        ]
    })
}

fn material() -> impl Strategy<Value = Material> {
    ((0.1_f32..0.9, 0.1_f32..0.9, 0.1_f32..0.9), 1.0_f32..20.0).prop_map(|(diffuse, exponent)| Material {
        diffuse: Rgb::from(diffuse),
        specular: Rgb::splat(0.3),
        exponent,
    })
}

/// Loose triangles that hide and pierce each other; some reach behind the eye.
fn triangle_soup() -> impl Strategy<Value = Stage> {
    let triangles = proptest::collection::vec((strategy::triangle(3.0), material()), 1..14);
    let behind = strategy::triangle(12.0);
    (triangles, behind, material(), camera_and_volume(), lights()).prop_map(
        |(mut triangles, large, material, pipeline, lights)| {
            triangles.push((large, material));
            let meshes = triangles.into_iter().map(|(t, material)| {
                let mesh = Mesh::new(t.corners().to_vec(), vec![[0, 1, 2]]).expect("a mesh");
                (mesh, Mat4::IDENTITY, material)
            });
            Stage { meshes: meshes.collect(), lights, pipeline }
        },
    )
}

/// Curved shapes with shared edges and smooth normals, bent by any affine map, mirrored ones too.
fn curved_shapes() -> impl Strategy<Value = Stage> {
    let shape = (0_u32..4, strategy::affine(1.5), any::<bool>(), material()).prop_map(
        |(kind, m, mirrored, material)| {
            let mesh = match kind {
                0 => geometry::shapes::icosphere(2),
                1 => geometry::shapes::torus(1.0, 0.4, 2),
                2 => geometry::shapes::cuboid(vec3(1.0, 1.5, 0.7), 1),
                _ => geometry::shapes::disc(1.2, 2),
            };
            let flip = if mirrored { Mat4::from_scale(vec3(-1.0, 1.0, 1.0)) } else { Mat4::IDENTITY };
            (mesh.expect("a shape"), m * flip, material)
        },
    );
    (proptest::collection::vec(shape, 1..4), camera_and_volume(), lights())
        .prop_map(|(meshes, pipeline, lights)| Stage { meshes, lights, pipeline })
}

fn agreement(sentence: &str, cases: u32, stages: impl Strategy<Value = Stage>) {
    let tally = RefCell::new(Tally::default());
    let law = Law::new(sentence).cases(cases).demand("much is seen", 0.5).demand("one hides another", 0.3);
    law.holds_for(stages, |stage, seen| {
        let z_buffered = stage.rasterized(Shading::Phong, Visibility::ZBuffer(DepthFormat::F32));
        let painted = stage.rasterized(Shading::Phong, Visibility::Painter);
        let world = stage.traceable(raytrace::Interpolation::Phong);
        let hits = raytrace::visible(&world, &stage.pipeline);

        let drawn = z_buffered.shaded.iter().filter(|n| **n > 0).count();
        seen.class("much is seen", 5 * drawn > hits.len());
        seen.class("one hides another", painted.shaded.iter().any(|n| *n > 1));

        let by_z = |k: usize| z_buffered.visible[k].map(|v| (v.object, v.triangle));
        let by_order = |k: usize| painted.visible[k].map(|v| (v.object, v.triangle));
        let by_ray = |k: usize| hits[k].map(|hit| (hit.object, hit.triangle));
        compare_winners(&stage, by_z, by_ray, &mut tally.borrow_mut())?;
        compare_winners(&stage, by_order, by_ray, &mut tally.borrow_mut())?;

        for (shading, interpolation) in MODES {
            let frame = stage.rasterized(shading, Visibility::ZBuffer(DepthFormat::F32));
            let world = stage.traceable(interpolation);
            compare_colors(&stage, &frame, &world, &hits, &mut tally.borrow_mut())?;
        }
        Ok(())
    });
    let Tally { pixels, different, edge_area, colors_left_to_snapping } = tally.into_inner();
    println!(
        "{sentence}: of {pixels} pixels {different} winners and {colors_left_to_snapping} colours left to snapping"
    );
    assert!(
        (different as f64) <= edge_area,
        "{different} of {pixels} winners differ, more than the {edge_area:.0} expected within reach of snapping"
    );
    // A pixel's colour must change by 1/255 over 1/181 pixel: by 0.7 a pixel, which only silhouettes and gleams do.
    assert!(
        1000 * colors_left_to_snapping <= pixels,
        "{colors_left_to_snapping} colours of {pixels} pixels differ by more than 1/255"
    );
}

#[test]
fn loose_triangles_win_the_same_pixels_in_every_renderer() {
    agreement("all renderers see the same triangle, loose ones", 96, triangle_soup());
}

#[test]
fn curved_shapes_win_the_same_pixels_in_every_renderer() {
    agreement("all renderers see the same triangle, curved shapes", 64, curved_shapes());
}

#[test]
fn a_renderer_with_another_light_is_noticed() {
    let camera = Camera::look_at(vec3(0.5, 1.0, 5.0), Vec3::ZERO, Vec3::Y).expect("a camera");
    let volume = ViewVolume::from_fov_y(0.8, 1.0, -0.5, -30.0).expect("a volume");
    let sphere = geometry::shapes::icosphere(2).expect("a sphere");
    let stage = |red: f32| Stage {
        meshes: vec![(sphere.clone(), Mat4::IDENTITY, Material::default())],
        lights: vec![Light::Directional { to_light: vec3(0.0, 0.6, 0.8), color: Rgb::new(red, 0.5, 0.5) }],
        pipeline: Pipeline::new(camera, volume, 48, 48).expect("a pipeline"),
    };
    let world = stage(0.5).traceable(raytrace::Interpolation::Phong);
    let hits = raytrace::visible(&world, &stage(0.5).pipeline);
    let outcome = |red: f32| {
        let frame = stage(red).rasterized(Shading::Phong, Visibility::ZBuffer(DepthFormat::F32));
        compare_colors(&stage(0.5), &frame, &world, &hits, &mut Tally::default())
    };
    assert!(outcome(0.5).is_ok());
    assert!(outcome(0.52).is_err());
}

#[test]
fn a_renderer_that_is_half_a_pixel_off_is_noticed() {
    // The comparison must be able to fail: a camera moved by half a pixel's width gives other winners, away from edges.
    let look = |eye: Vec3| Camera::look_at(eye, vec3(eye.x, 0.0, 0.0), Vec3::Y).expect("a camera");
    let volume = ViewVolume::from_fov_y(0.8, 1.0, -0.5, -30.0).expect("a volume");
    let sphere = geometry::shapes::icosphere(2).expect("a sphere");
    let stage = |shift: f32| Stage {
        meshes: vec![(sphere.clone(), Mat4::IDENTITY, Material::default())],
        lights: Vec::new(),
        pipeline: Pipeline::new(look(vec3(shift, 0.0, 5.0)), volume, 48, 48).expect("a pipeline"),
    };
    // The window at distance 4 (the sphere's front) is 2 · 4 · tan 0.4 high, over 48 pixels.
    let half_a_pixel = 4.0 * 0.4_f32.tan() / 48.0;
    let frame = stage(0.0).rasterized(Shading::Phong, Visibility::ZBuffer(DepthFormat::F32));
    let hits = raytrace::visible(
        &stage(half_a_pixel).traceable(raytrace::Interpolation::Phong),
        &stage(half_a_pixel).pipeline,
    );
    let outcome = compare_winners(
        &stage(0.0),
        |k| frame.visible[k].map(|v| (v.object, v.triangle)),
        |k| hits[k].map(|hit| (hit.object, hit.triangle)),
        &mut Tally::default(),
    );
    assert!(outcome.is_err());
}
