//! A small world for the pictures of claims: three balls on a chequered floor.

use canvas::{Image, Rgb};
use geometry::{Ray, Sphere, Triangle};
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material, lambert};
use raytrace::{Object, Settings, Shape, Surface, World, local_color, ray_color};
use transforms::{Pipeline, viewport};
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, ScreenVertex, draw, project};

use crate::sample::pipeline;
use crate::transform_errors::slide_is_inside;
use crate::window_errors::slide_window_from_pixel;
use crate::{pair, text};
use figures::{Drawing, Drawn};

/// Width and height of the pictures.
pub(super) const SIZE: (u32, u32) = (320, 240);

pub(super) const SKY: Rgb = Rgb::new(0.45, 0.6, 0.8);

const TO_SUN: Vec3 = Vec3::new(0.36, 0.8, 0.48);

const BALLS: [(Vec3, f32, Rgb); 3] = [
    (Vec3::new(-1.3, 0.7, 0.3), 0.7, Rgb::new(0.75, 0.1, 0.06)),
    (Vec3::new(0.3, 1.0, -1.0), 1.0, Rgb::new(0.85, 0.6, 0.08)),
    (Vec3::new(1.4, 0.5, 0.7), 0.5, Rgb::new(0.08, 0.25, 0.7)),
];

fn view() -> Pipeline {
    pipeline((vec3(0.0, 2.2, 6.0), vec3(0.0, 0.7, 0.0)), 0.7, (-1.0, -40.0), SIZE)
}

/// E2: cut by the books' test taken literally, and by ours.
pub(super) fn clipping_pair() -> Drawn {
    let pipeline = view();
    let clip_from_world = pipeline.clip_from_world();
    let coloured = triangles();
    let slide = coloured
        .iter()
        .filter_map(|(triangle, color)| Some((slide_project(&pipeline, triangle)?, *color)))
        .collect();
    let right = coloured.iter().flat_map(|(triangle, color)| {
        project(&clip_from_world, SIZE.0, SIZE.1, triangle).triangles().map(|part| (part, *color))
    });
    let alt_slide = text(
        "An empty sky: balls and floor are cut away.",
        "Een lege lucht: ballen en vloer zijn weggeknipt.",
    );
    let alt_right = text(
        "A red, a yellow and a blue ball on a chequered floor.",
        "Een rode, een gele en een blauwe bal op een geblokte vloer.",
    );
    pair(
        Drawing::picture("slide", alt_slide, drawn(slide)),
        Drawing::picture("right", alt_right, drawn(right.collect())),
    )
}

/// Keeps the triangle if all its corners pass −w ≤ x, y, z ≤ w, then divides by w.
fn slide_project(pipeline: &Pipeline, triangle: &Triangle) -> Option<ScreenTriangle> {
    let clip = triangle.corners().map(|p| pipeline.clip_from_world() * p.extend(1.0));
    let weights = [geometry::Barycentric::A, geometry::Barycentric::B, geometry::Barycentric::C];
    let vertex = |k: usize| {
        let w = clip[k].w;
        let position = pipeline.screen_from_canonical().transform_point3(clip[k].truncate() / w);
        ScreenVertex { position: position.as_dvec3(), inv_w: w.recip(), weights: weights[k] }
    };
    clip.iter()
        .all(|corner| slide_is_inside(*corner))
        .then(|| ScreenTriangle { vertices: [0, 1, 2].map(vertex) })
}

fn drawn(polygons: Vec<(ScreenTriangle, Rgb)>) -> Image {
    let mut image = Image::new(SIZE.0, SIZE.1, SKY);
    let mut depth = DepthBuffer::new(SIZE.0, SIZE.1, DepthFormat::F32);
    draw::z_buffer(SKY, &polygons, &mut image, &mut depth);
    image
}

/// The floor's squares and the balls' triangles, each in one colour by Lambert's law.
fn triangles() -> Vec<(Triangle, Rgb)> {
    let mut all = Vec::new();
    for (x, z) in (-6..6).flat_map(|x| (-12..4).map(move |z| (x, z))) {
        let corner = |dx: i16, dz: i16| vec3(f32::from(x + dx), 0.0, f32::from(z + dz));
        let grey = if (x + z) % 2 == 0 { 0.5 } else { 0.15 };
        let color = Rgb::splat(grey);
        all.push((Triangle::new(corner(0, 0), corner(0, 1), corner(1, 1)), color));
        all.push((Triangle::new(corner(0, 0), corner(1, 1), corner(1, 0)), color));
    }
    let sphere = geometry::shapes::icosphere(3).expect("a sphere");
    for (center, radius, color) in BALLS {
        for k in 0..sphere.len() {
            let [a, b, c] = sphere.triangle(k).corners().map(|p| center + radius * p);
            let triangle = Triangle::new(a, b, c);
            let n = triangle.normal().unwrap_or(Vec3::Y);
            all.push((triangle, color * (0.2 + lambert(n, TO_SUN))));
        }
    }
    all
}

/// The balls alone, and a floor, for rays.
pub(super) fn world() -> World {
    let opaque =
        |color: Rgb| Surface::opaque(Material { specular: Rgb::splat(0.4), ..Material::new(color, 60.0) });
    let object = |shape: Shape, color: Rgb| {
        Object::new(shape, Mat4::IDENTITY, vec![opaque(color)]).expect("an object")
    };
    let mut objects: Vec<Object> =
        BALLS.map(|(center, radius, color)| object(Shape::Sphere(Sphere::new(center, radius)), color)).into();
    objects.push(object(Shape::Plane(geometry::Plane::new(Vec3::ZERO, Vec3::Y)), Rgb::splat(0.3)));
    let lights = vec![
        Light::Ambient { color: Rgb::splat(0.2) },
        Light::Directional { to_light: TO_SUN, color: Rgb::ONE },
    ];
    let mut world = World::new(objects, lights);
    world.background = SKY;
    world
}

/// E14: rays through the window that the printed factors give, and through the right one.
pub(super) fn window_pair() -> Drawn {
    let (pipeline, world) = (view(), world());
    let (volume, basis) = (pipeline.volume(), pipeline.camera().basis());
    let traced = |window_from_pixel: glam::Mat3| {
        Image::from_fn(SIZE.0, SIZE.1, |i, j| {
            let s = window_from_pixel * vec3(i as f32, j as f32, 1.0);
            let to_s = s.x * basis.u + s.y * basis.v + volume.near * basis.w;
            let ray = Ray::new(pipeline.camera().eye(), to_s);
            ray_color(&world, &ray, 1.0, volume.far / volume.near, &Settings::default())
        })
    };
    let alt_slide = text(
        "The scene has slid into the lower left corner: only the upper right quarter of it is seen, at the same scale.",
        "Het tafereel is naar linksonder geschoven: alleen het kwart rechtsboven is te zien, op dezelfde schaal.",
    );
    let alt_right = text("Three balls in the middle of the picture.", "Drie ballen midden in beeld.");
    pair(
        Drawing::picture("slide", alt_slide, traced(slide_window_from_pixel(&volume, SIZE.0, SIZE.1))),
        Drawing::picture("right", alt_right, traced(viewport::window_from_pixel(&volume, SIZE.0, SIZE.1))),
    )
}

/// The loop of the basic algorithm (L55): a ray a pixel.
pub(super) fn slide_loop(world: &World, pipeline: &Pipeline) -> Image {
    let (t0, t1) = raytrace::visible_interval(&pipeline.volume());
    Image::from_fn(pipeline.width(), pipeline.height(), |i, j| {
        let ray = raytrace::viewing_ray(pipeline, i as f32, j as f32);
        local_color(world, &ray, t0, t1)
    })
}
