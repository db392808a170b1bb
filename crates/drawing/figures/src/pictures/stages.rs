//! Where is a mesh, and one point of it, at each stage of the pipeline? (L5)

use canvas::{Image, Rgb};
use geometry::{Mesh, shapes};
use glam::{Mat4, Quat, Vec3, vec2, vec3};
use lighting::{Highlight, Light, Material};
use shading::{CREASE_ANGLE, Object, Shading, Visibility, World, render, with_vertex_normals};
use sheet::{Ink, Letters, Sheet, Side};
use transforms::{Camera, Pipeline, ViewVolume};

use super::studio::Fault;
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, in_picture, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L5", "L1", "L2", "L3", "L4", "E1"],
    name: "stages",
    title: Text { en: "The graphics pipeline", nl: "Grafische pijplijn" },
    caption: Text {
        en: "A teapot, its viewing volume and one point of it (red), seen from aside in each space. P bends the pyramid into a box, which makes what is near larger; then the box becomes the cube and the cube the screen (its depth is stretched here). The table follows the point: screen = V·S·C·P·R·T.",
        nl: "Een theepot, zijn viewing volume en één punt ervan (rood), van opzij gezien in elke ruimte. P buigt de piramide tot een doos, waardoor wat dichtbij is groter wordt; daarna wordt de doos de kubus en de kubus het scherm (de diepte is hier uitgerekt). De tabel volgt het punt: scherm = V·S·C·P·R·T.",
    },
    parameters: &[
        Parameter::number("x", Text { en: "x of the point", nl: "x van het punt" }, 2.9, -3.5, 3.5),
        Parameter::number("y", Text { en: "y of the point", nl: "y van het punt" }, 2.35, 0.0, 3.2),
        Parameter::number("z", Text { en: "z of the point", nl: "z van het punt" }, 0.0, -2.0, 2.0),
        Parameter::number(
            "near",
            Text { en: "distance of the near plane", nl: "afstand van het near-vlak" },
            4.5,
            1.0,
            5.0,
        ),
    ],
    size: (360, 300),
    draw,
    handles,
};

/// The screen of the figure: few pixels, so that its numbers stay small.
const SCREEN: (u32, u32) = (16, 12);
const FAR: f32 = 13.0;

/// A space with the map into it.
struct Stage {
    name: &'static str,
    title: Text,
    from_world: Mat4,
}

fn draw(values: &Values) -> Drawn {
    let (pipeline, point) = (pipeline(values.number("near"))?, point(values));
    let stages = stages(&pipeline);
    let mut drawings = Vec::new();
    for stage in &stages {
        let image = picture(stage, &pipeline, point, values.size())?;
        let at = match stage.name {
            // The drawing stretches the depth; the words do not.
            "5-screen" => pipeline.screen_from_world().project_point3(point),
            _ => stage.from_world.project_point3(point),
        };
        let alt = Words::new(
            format!("{}: the teapot in its viewing volume; the point is at {}.", stage.title.en, triple(at)),
            format!(
                "{}: de theepot in zijn viewing volume; het punt ligt op {}.",
                stage.title.nl,
                triple(at)
            ),
        );
        drawings.push(Drawing::picture(stage.name, alt, image));
    }
    drawings.push(table(&pipeline, point));
    with_handles(drawings, handles(values))
}

fn point(values: &Values) -> Vec3 {
    ["x", "y", "z"].map(|axis| values.number(axis)).into()
}

/// The camera whose pipeline the figure follows.
fn pipeline(near: f32) -> Result<Pipeline, Fault> {
    let camera = Camera::look_at(vec3(3.0, 4.4, 6.8), vec3(0.2, 1.5, 0.0), Vec3::Y)?;
    let volume = ViewVolume::from_fov_y(0.62, 4.0 / 3.0, -near, -FAR)?;
    Ok(Pipeline::new(camera, volume, SCREEN.0, SCREEN.1)?)
}

/// The point in each picture, by turns along x and y and along z and y, since a picture has two directions. The near plane
/// where it has a place of its own; later spaces put it where they put every near plane.
fn handles(values: &Values) -> Handled {
    let (pipeline, point) = (pipeline(values.number("near"))?, point(values));
    let (width, height) = values.size();
    let mut lists = Vec::new();
    for (k, stage) in stages(&pipeline).iter().enumerate() {
        let photograph = Observer::of(stage, &pipeline).photograph(values.size())?;
        let place = |p: Vec3| {
            in_picture(&photograph, stage.from_world.project_point3(p)).ok_or("behind the observer")
        };
        let (name, moves): (_, &[&str]) = if k % 2 == 0 {
            (Text { en: "the point, along x and y", nl: "het punt, langs x en y" }, &["x", "y"])
        } else {
            (Text { en: "the point, along z and y", nl: "het punt, langs z en y" }, &["z", "y"])
        };
        let mut list = Handles::none(vec2(width as f32, height as f32)).and(name, moves, place(point)?);
        if k < 2 {
            let [first, .., third] = [0, 1, 2].map(|corner| corners(&pipeline)[corner]);
            let near = Text { en: "the near plane", nl: "het near-vlak" };
            list = list.and(near, &["near"], place(0.5 * (first + third))?);
        }
        lists.push(list);
    }
    Ok(lists)
}

/// Whoever looks at a stage: the middle of the viewing volume there, and how far it reaches.
struct Observer {
    corners: [Vec3; 8],
    middle: Vec3,
    radius: f32,
}

impl Observer {
    fn of(stage: &Stage, pipeline: &Pipeline) -> Self {
        let corners = corners(pipeline).map(|p| stage.from_world.project_point3(p));
        let middle = corners.iter().sum::<Vec3>() / 8.0;
        let radius = corners.iter().map(|p| p.distance(middle)).fold(0.0, f32::max);
        Self { corners, middle, radius }
    }

    /// A look from aside and above, from where each space looks alike.
    fn photograph(&self, (width, height): (u32, u32)) -> Result<Pipeline, Fault> {
        const FOV: f32 = 0.45;
        let Self { middle, radius, .. } = *self;
        let aspect = width as f32 / height as f32;
        let fov_y = 2.0 * ((0.5 * FOV).tan() / aspect.min(1.0)).atan();
        let distance = radius / (0.5 * FOV).sin();
        let eye = middle + distance * vec3(1.0, 0.5, 0.75).normalize();
        let (near, far) = (-(distance - 1.1 * radius), -(distance + 1.1 * radius));
        let volume = ViewVolume::from_fov_y(fov_y, aspect, near, far)?;
        Ok(Pipeline::new(Camera::look_at(eye, middle, Vec3::Y)?, volume, width, height)?)
    }
}

fn stages(pipeline: &Pipeline) -> [Stage; 5] {
    let [t, r, p, ..] = pipeline.factors().map(|factor| factor.matrix);
    let stage = |name, en, nl, from_world| Stage { name, title: Text { en, nl }, from_world };
    let clip = pipeline.clip_from_world();
    // Only for the eye: a screen is 16 units wide and its depth 2.
    let stretched = Mat4::from_scale(vec3(1.0, 1.0, 5.0)) * pipeline.screen_from_world();
    [
        stage("1-world", "World", "Wereld", Mat4::IDENTITY),
        stage("2-camera", "Camera", "Camera", r * t),
        stage("3-perspective", "After P", "Na P", p * r * t),
        stage("4-canonical", "Canonical cube", "Canonieke kubus", clip),
        stage("5-screen", "Screen", "Scherm", stretched),
    ]
}

/// The eight corners of the viewing volume, world space; near first.
fn corners(pipeline: &Pipeline) -> [Vec3; 8] {
    let ViewVolume { left, right, bottom, top, near, far } = pipeline.volume();
    let world_from_camera = pipeline.camera().world_from_camera();
    let sides = [(left, bottom), (right, bottom), (right, top), (left, top)];
    std::array::from_fn(|k| {
        let (x, y) = sides[k % 4];
        let depth = if k < 4 { near } else { far };
        world_from_camera.transform_point3(depth / near * vec3(x, y, near))
    })
}

fn picture(stage: &Stage, pipeline: &Pipeline, point: Vec3, size: (u32, u32)) -> Result<Image, Fault> {
    let map = |p: &Vec3| stage.from_world.project_point3(*p);
    let pot = shapes::teapot(3)?.without_normals();
    let moved = pot.positions().iter().map(map).collect();
    let pot = with_vertex_normals(pot.with_positions(moved)?, CREASE_ANGLE);
    let observer = Observer::of(stage, pipeline);
    let Observer { corners, radius, .. } = observer;
    let (bar, ball) = (shapes::cuboid(Vec3::ONE, 0)?, shapes::icosphere(3)?);
    let clay = [Material { diffuse: vec3(0.62, 0.42, 0.22), specular: Rgb::splat(0.2), exponent: 30.0 }];
    let (line, red) = ([Material::matt(vec3(0.05, 0.15, 0.5))], [Material::matt(vec3(0.9, 0.05, 0.03))]);
    let mut objects = vec![
        Object { mesh: &pot, world_from_object: Mat4::IDENTITY, materials: &clay },
        object(
            &ball,
            Mat4::from_scale_rotation_translation(Vec3::splat(0.045 * radius), Quat::IDENTITY, map(&point)),
            &red,
        ),
    ];
    for [a, b] in edges() {
        objects.push(object(&bar, along(corners[a], corners[b], 0.012 * radius), &line));
    }
    developed(&objects, &observer, size)
}

fn object<'a>(mesh: &'a Mesh, world_from_object: Mat4, materials: &'a [Material]) -> Object<'a> {
    Object { mesh, world_from_object, materials }
}

/// The twelve edges of a box whose corners are numbered as by [`corners`].
fn edges() -> impl Iterator<Item = [usize; 2]> {
    (0..4).flat_map(|k| [[k, (k + 1) % 4], [4 + k, 4 + (k + 1) % 4], [k, 4 + k]])
}

/// What makes a unit cube a bar from `a` to `b`.
fn along(a: Vec3, b: Vec3, thickness: f32) -> Mat4 {
    let turn = Quat::from_rotation_arc(Vec3::Z, (b - a).normalize_or(Vec3::Z));
    let size = vec3(thickness, thickness, a.distance(b) + thickness);
    Mat4::from_scale_rotation_translation(size, turn, 0.5 * (a + b))
}

/// What the observer sees.
fn developed(objects: &[Object], observer: &Observer, (width, height): (u32, u32)) -> Result<Image, Fault> {
    /// Samples along each side of a pixel.
    const FINER: u32 = 2;
    let lights = [
        Light::Ambient { color: Rgb::splat(0.35) },
        Light::Directional { to_light: vec3(0.9, 1.0, 0.3).normalize(), color: Rgb::splat(0.6) },
    ];
    let world = World { objects, lights: &lights, background: Rgb::splat(0.85), highlight: Highlight::Blinn };
    let pipeline = observer.photograph((FINER * width, FINER * height))?;
    Ok(render(&world, &pipeline, Shading::Phong, Visibility::default()).image.box_downsampled(FINER))
}

/// The point at each stage, a line each.
fn table(pipeline: &Pipeline, point: Vec3) -> Drawing {
    let traced = pipeline.trace(point);
    let nowhere = || "—".to_owned();
    let lines = [
        (Text { en: "world", nl: "wereld" }, "", triple(traced.world)),
        (Text { en: "camera", nl: "camera" }, "R·T", triple(traced.camera)),
        (
            Text { en: "clip", nl: "clip" },
            "S·C·P",
            format!(
                "({:.3}, {:.3}, {:.3}, {:.3})",
                traced.clip.x, traced.clip.y, traced.clip.z, traced.clip.w
            ),
        ),
        (Text { en: "canonical", nl: "canoniek" }, "/ w", traced.canonical.map_or_else(nowhere, triple)),
        (Text { en: "screen", nl: "scherm" }, "V", traced.screen.map_or_else(nowhere, triple)),
    ];
    let alt = Words::new(
        lines.iter().map(|(name, _, at)| format!("{} {at}", name.en)).collect::<Vec<_>>().join("; "),
        lines.iter().map(|(name, _, at)| format!("{} {at}", name.nl)).collect::<Vec<_>>().join("; "),
    );
    let mut sheet = Sheet::new(vec2(0.0, 0.0), vec2(500.0, 230.0), 500.0);
    for (k, (name, factors, at)) in lines.into_iter().enumerate() {
        let y = 200.0 - 42.0 * k as f32;
        sheet.label(vec2(4.0, y), Side::Right, name, Letters::Plain, Ink::Main);
        sheet.label(vec2(108.0, y), Side::Right, factors, Letters::Scalar, Ink::B);
        sheet.label(vec2(170.0, y), Side::Right, at, Letters::Plain, Ink::A);
        sheet.line(vec2(12.0, y - 21.0), vec2(488.0, y - 21.0), Ink::Faint.pen().fine());
    }
    Drawing::diagram("6-table", alt.clone(), sheet.svg(&alt))
}

fn triple(p: Vec3) -> String {
    format!("({:.3}, {:.3}, {:.3})", p.x, p.y, p.z)
}
