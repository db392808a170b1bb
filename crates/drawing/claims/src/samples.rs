//! Which depth has a pixel, and whose pixel is it? What is sampled between vertices and on edges. (E9, E10, L49)

use canvas::{Image, Rgb};
use geometry::{Barycentric, Ray, Triangle};
use glam::{Vec2, Vec3, vec2, vec3};
use raytrace::triangle::{cramer, system, watertight};
use transforms::Pipeline;
use zbuffer::{Fragment, ScreenTriangle, project, rasterize};

use crate::flat::triangle;
use crate::ray_errors::slide_raytri;
use crate::sample::{pipeline, trials};
use crate::stage::{SIZE, SKY};
use crate::{Claim, Trial, Verdict, judge, pair, text, versions};
use figures::{Drawing, Drawn};

pub(super) static INSIDE: Claim = Claim {
    number: "L49",
    name: "inside-test",
    quote: "Snijpunt in driehoek ⇔ β > 0, γ > 0 en β + γ < 1",
    translation: "the intersection lies in the triangle ⇔ β > 0, γ > 0 and β + γ < 1",
    truth: text(
        "Right inside and outside; what the border belongs to is another matter (E10).",
        "Klopt binnen en buiten; waar de rand bij hoort is een andere kwestie (E10).",
    ),
    expected: Verdict::Holds,
    code: &["geometry::Barycentric::is_inside", "geometry::Triangle::barycentric"],
    examine: || {
        let trials = trials(300, 51, |random| {
            let triangle = random.triangle(3.0);
            let (beta, gamma) = (random.between(-1.0, 2.0), random.between(-1.0, 2.0));
            let p = triangle.point(Barycentric::from_beta_gamma(beta, gamma));
            // The same by edges: p lies on the inner side of all three.
            let n = triangle.cross();
            let [a, b, c] = triangle.corners();
            let inner = |from: Vec3, to: Vec3| (to - from).cross(p - from).dot(n) > 0.0;
            let by_edges = inner(a, b) && inner(b, c) && inner(c, a);
            let by_weights = triangle.barycentric(p).is_some_and(|weights| weights.is_inside());
            Trial::new(by_edges == by_weights, format!("β = {beta:.3}, γ = {gamma:.3}"))
        });
        judge("the test agrees with the sides of the three edges", None, &trials)
    },
    pictures: None,
    versions: None,
};

/// The unit square cut along its diagonal, at z = 0.
fn square() -> [Triangle; 2] {
    let corner = |x: f32, y: f32| vec3(x, y, 0.0);
    [
        Triangle::new(corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0)),
        Triangle::new(corner(0.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)),
    ]
}

const OFF_THE_EDGE: &str = "the point lies on no edge";

/// How many of the square's triangles have the point, by this test.
fn owners(test: impl Fn(&Ray, &Triangle) -> bool, p: Vec2) -> usize {
    let ray = Ray::new(p.extend(2.0), Vec3::NEG_Z);
    square().iter().filter(|triangle| test(&ray, triangle)).count()
}

fn slide_strict(ray: &Ray, triangle: &Triangle) -> bool {
    cramer(&system(ray, triangle)).is_some_and(|x| x.beta > 0.0 && x.gamma > 0.0 && x.beta + x.gamma < 1.0)
}

pub(super) fn slide_inclusive(ray: &Ray, triangle: &Triangle) -> bool {
    slide_raytri(ray, triangle, 0.0, f32::INFINITY)
}

/// How many points of the common edge there are, and how many triangles have one of them, by this test.
pub(super) fn edge_owners(test: impl Fn(&Ray, &Triangle) -> bool) -> (usize, usize) {
    let on_the_edge: Vec<Vec2> = points().into_iter().filter(|p| p.x == p.y).collect();
    (on_the_edge.len(), on_the_edge.iter().map(|p| owners(&test, *p)).sum())
}

/// Points of the square on a grid of eighths, which are exact: each seventh of them on the diagonal.
fn points() -> Vec<Vec2> {
    (1..8).flat_map(|i| (1..8).map(move |j| vec2(i as f32 / 8.0, j as f32 / 8.0))).collect()
}

fn ownership(test: fn(&Ray, &Triangle) -> bool) -> crate::Examination {
    let trials: Vec<Trial> = points()
        .into_iter()
        .map(|p| {
            let count = owners(test, p);
            Trial::under(p.x != p.y, count == 1, format!("{p} lies in {count} of the two triangles"))
        })
        .collect();
    let right = |ray: &Ray, triangle: &Triangle| watertight(ray, triangle, 0.0, f32::INFINITY).is_some();
    let mut ours: Vec<Trial> = points()
        .into_iter()
        .map(|p| Trial::new(owners(right, p) == 1, format!("{p} lies in {} triangles", owners(right, p))))
        .collect();
    let mut pixels = Vec::new();
    for triangle in &square_at(5.0) {
        rasterize(triangle, 32, 24, |f| pixels.push((f.i, f.j)));
    }
    let drawn = pixels.len();
    pixels.sort_unstable();
    pixels.dedup();
    ours.push(Trial::new(
        drawn == 64 && pixels.len() == 64,
        format!("{drawn} fragments, {} pixels", pixels.len()),
    ));
    judge("a point of the square lies in exactly one of its two triangles", Some(OFF_THE_EDGE), &trials)
        .with_right("by the watertight test and by the top-left rule it does, on the edge too", &ours)
        .compared(
            format!("{} rays at the common edge of two triangles", edge_owners(test).0),
            format!("{} hits", edge_owners(test).1),
            format!("{} hits, one each", edge_owners(right).1),
        )
}

pub(super) static STRICT: Claim = Claim {
    number: "E10",
    name: "strict-inside-test",
    quote: "β > 0, γ > 0, β + γ < 1",
    translation: "β > 0, γ > 0, β + γ < 1",
    truth: text(
        "The strict test gives an edge that two triangles share to neither: a hole. Rasterizer: the top-left rule. Rays: a watertight test.",
        "De strikte test geeft een gedeelde rand aan geen van beide driehoeken: een gat. Rasteriseren: de top-left-regel. Stralen: een waterdichte test.",
    ),
    expected: Verdict::HoldsIf(OFF_THE_EDGE),
    code: &["zbuffer::rasterize", "raytrace::triangle::watertight"],
    examine: || ownership(slide_strict),
    pictures: Some(edge_pair),
    versions: None,
};

pub(super) static INCLUSIVE: Claim = Claim {
    number: "E10",
    name: "inclusive-inside-test",
    quote: "als (gamma < 0 of gamma > 1) return false … als (beta < 0 of beta > 1 - gamma) return false",
    translation: "if (γ < 0 or γ > 1) return false … if (β < 0 or β > 1 − γ) return false",
    truth: text(
        "raytri includes the border, unlike the slide before it: a shared edge is hit twice, and blended twice.",
        "raytri rekent de rand mee, anders dan de dia ervoor: een gedeelde rand wordt twee keer geraakt, en twee keer gemengd.",
    ),
    expected: Verdict::HoldsIf(OFF_THE_EDGE),
    code: &["raytrace::triangle::raytri", "raytrace::triangle::watertight"],
    examine: || ownership(slide_inclusive),
    // The pair of the strict test shows this one too.
    pictures: None,
    versions: Some(versions::inclusive),
};

/// Screen pixels of the enlarged picture of an edge.
const PIXEL: u32 = 10;

/// A half transparent square, twice: by the strict test at the left and by the inclusive one at the right; then by ours.
fn edge_pair() -> Drawn {
    let squares = [square_at(5.0), square_at(19.0)];
    let (width, height) = (SIZE.0 / PIXEL, SIZE.1 / PIXEL);
    let tests = [slide_strict as fn(&Ray, &Triangle) -> bool, slide_inclusive];
    let slide = enlarged(|i, j| {
        let ray = Ray::new(vec3(i as f32, j as f32, 2.0), Vec3::NEG_Z);
        let hits = squares.iter().zip(tests).flat_map(|(square, test)| square.iter().map(move |t| (t, test)));
        hits.filter(|(on_screen, test)| {
            let [a, b, c] = on_screen.vertices.map(|v| v.position.as_vec3());
            test(&ray, &Triangle::new(a, b, c))
        })
        .count() as i32
    });
    let mut owned = vec![0; (width * height) as usize];
    for triangle in squares.iter().flatten() {
        rasterize(triangle, width, height, |f| owned[(f.j * width + f.i) as usize] += 1);
    }
    let right = enlarged(|i, j| owned[(j * width + i) as usize]);
    let alt_slide = text(
        "Two half transparent squares of large pixels. Along the diagonal of the left one there is a row of holes and its border is missing; along the diagonal of the right one the pixels are darker, blended twice.",
        "Twee halfdoorzichtige vierkanten van grote pixels. Langs de diagonaal van het linker zit een rij gaten en de rand ontbreekt; langs die van het rechter zijn de pixels donkerder, dubbel gemengd.",
    );
    let alt_right = text(
        "Two half transparent squares of even colour: each pixel drawn once.",
        "Twee halfdoorzichtige vierkanten van egale kleur: elke pixel één keer getekend.",
    );
    pair(Drawing::picture("slide", alt_slide, slide), Drawing::picture("right", alt_right, right))
}

/// Two triangles whose edges run through the centres of pixels. Eight wide: then weights are exact, and only the rule counts.
fn square_at(x: f32) -> [ScreenTriangle; 2] {
    let (right, low, high) = (x + 8.0, 8.0, 16.0);
    [
        triangle([[x, low, 0.0], [right, low, 0.0], [right, high, 0.0]]),
        triangle([[x, low, 0.0], [right, high, 0.0], [x, high, 0.0]]),
    ]
}

/// A picture of large pixels: so many layers of half transparent blue over white.
fn enlarged(mut layers: impl FnMut(u32, u32) -> i32) -> Image {
    let paint = Rgb::new(0.05, 0.15, 0.7);
    Image::from_fn(SIZE.0, SIZE.1, |x, y| {
        let (i, j) = (x / PIXEL, y / PIXEL);
        let is_border = x % PIXEL == 0 || y % PIXEL == 0;
        let rest = 0.4_f32.powi(layers(i, j));
        let color = Rgb::ONE * rest + paint * (1.0 - rest);
        if is_border { color * 0.85 } else { color }
    })
}

/// E9: a chequered floor from z = −2 to z = −50 before the camera, its depth interpolated on the screen both ways.
pub(super) fn floor_pair() -> Drawn {
    let pipeline = pipeline((vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, -1.0)), 0.9, (-1.0, -100.0), SIZE);
    let alt_slide = text(
        "The squares are equally high from front to back, far too small near the eye, and the columns bend.",
        "De vakken zijn van voor naar achter even hoog, dichtbij veel te klein, en de kolommen buigen.",
    );
    let alt_right = text(
        "A chequered floor whose squares become smaller with distance; the columns are straight.",
        "Een geblokte vloer waarvan de vakken met de afstand kleiner worden; de kolommen zijn recht.",
    );
    pair(
        Drawing::picture("slide", alt_slide, floor(&pipeline, slide_camera_z)),
        Drawing::picture("right", alt_right, floor(&pipeline, camera_z)),
    )
}

type CameraZ = fn(&Pipeline, &ScreenTriangle, &Fragment) -> f32;

/// Interpolates camera z over the pixels, like everything else.
fn slide_camera_z(_: &Pipeline, on_screen: &ScreenTriangle, fragment: &Fragment) -> f32 {
    let [a, b, c] = on_screen.vertices.map(|v| v.position.as_vec3().with_z(0.0));
    let pixel = vec3(fragment.i as f32, fragment.j as f32, 0.0);
    let [z_a, z_b, z_c] = on_screen.vertices.map(|v| v.inv_w.recip());
    Triangle::new(a, b, c).barycentric(pixel).map_or(z_a, |weights| weights.interpolate(z_a, z_b, z_c))
}

/// Interpolates z after the projection, and goes back to the camera.
fn camera_z(pipeline: &Pipeline, _: &ScreenTriangle, fragment: &Fragment) -> f32 {
    pipeline.canonical_from_camera().inverse().project_point3(vec3(0.0, 0.0, fragment.z as f32)).z
}

fn floor(pipeline: &Pipeline, camera_z: CameraZ) -> Image {
    let mut image = Image::new(SIZE.0, SIZE.1, SKY);
    let corner = |x: f32, z: f32| vec3(x, 0.0, z);
    let [a, b, c, d] = [corner(-12.0, -2.0), corner(12.0, -2.0), corner(12.0, -50.0), corner(-12.0, -50.0)];
    for triangle in [Triangle::new(a, b, c), Triangle::new(a, c, d)] {
        for part in project(&pipeline.clip_from_world(), SIZE.0, SIZE.1, &triangle).triangles() {
            rasterize(&part, SIZE.0, SIZE.1, |f| {
                let z = camera_z(pipeline, &part, &f);
                // The point at that depth on the pixel's ray, which runs from the eye to the window at z = −1.
                let to_window = raytrace::viewing_ray(pipeline, f.i as f32, f.j as f32).direction;
                let p = to_window * -z;
                let is_dark = ((p.x / 2.0).floor() + (p.z / 2.0).floor()) as i64 % 2 == 0;
                image.set(f.i, f.j, if is_dark { Rgb::splat(0.08) } else { Rgb::splat(0.7) });
            });
        }
    }
    image
}
