//! Where do rays go wrong if the slides are followed to the letter? (E11, E12)

use canvas::{Image, Rgb};
use geometry::{Ray, Sphere, Triangle};
use glam::{Mat4, Vec3, vec3};
use lighting::{Illumination, Light, lambert};
use raytrace::shadow::is_lit;
use raytrace::triangle::raytri;
use raytrace::{Object, Shape, Surface, World, any_hit, nearest, viewing_ray};
use transforms::Pipeline;
use zbuffer::project;

use crate::sample::{Sequence, pipeline, trials};
use crate::stage::SIZE;
use crate::{Claim, Examination, Trial, Verdict, judge, pair, text, versions};
use figures::{Drawing, Drawn};

/// The listing, word by word: comparisons that reject, and no test for a parallel ray.
#[expect(clippy::manual_range_contains, reason = "as on the slide; a range would reject NaN")]
pub(super) fn slide_raytri(ray: &Ray, triangle: &Triangle, t0: f32, t1: f32) -> bool {
    let (to_b, to_c, d) = (triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    let to_e = triangle.a - ray.origin;
    let determinant = to_b.dot(to_c.cross(d));
    let t = to_b.dot(to_c.cross(to_e)) / determinant;
    if t < t0 || t > t1 {
        return false;
    }
    let gamma = to_b.dot(to_e.cross(d)) / determinant;
    if gamma < 0.0 || gamma > 1.0 {
        return false;
    }
    let beta = to_e.dot(to_c.cross(d)) / determinant;
    if beta < 0.0 || beta > 1.0 - gamma {
        return false;
    }
    true
}

const NOT_PARALLEL: &str = "the ray is not parallel to the triangle";

/// A triangle in the plane z = 0, and a ray through it or along that plane.
pub(super) fn flat_triangle() -> Triangle {
    Triangle::new(vec3(0.0, 0.0, 0.0), vec3(4.0, 0.0, 0.0), vec3(0.0, 8.0, 0.0))
}

pub(super) static PARALLEL: Claim = Claim {
    number: "E11",
    name: "parallel-ray",
    quote: "bereken t als (t < t0 of t > t1) return false … return true",
    translation: "compute t; if (t < t0 or t > t1) return false … return true",
    truth: text(
        "For a ray in the triangle's plane t, γ and β are 0/0: not a number, which no comparison rejects, so the listing says hit. A test for parallel rays belongs first.",
        "Voor een straal in het vlak van de driehoek zijn t, γ en β 0/0: geen getal, en geen vergelijking wijst dat af, dus de listing zegt raak. Een test op evenwijdige stralen hoort ervoor.",
    ),
    expected: Verdict::HoldsIf(NOT_PARALLEL),
    code: &["raytrace::triangle::raytri"],
    examine: || {
        let triangle = flat_triangle();
        let trials = trials(200, 121, |random| {
            let level = random.below(4) == 0;
            let mut ray = Ray::new(random.point(9.0), random.direction());
            if level {
                (ray.origin.z, ray.direction.z) = (0.0, 0.0);
            }
            let (slide, right) =
                (slide_raytri(&ray, &triangle, 0.0, 99.0), raytri(&ray, &triangle, 0.0, 99.0));
            Trial::under(
                !level,
                slide == right.is_some(),
                format!("the slide says {slide} of a ray in the plane"),
            )
        });
        // Beside the triangle, and away from it.
        let ray = Ray::new(vec3(-3.0, -2.0, 0.0), vec3(-1.0, 0.0, 0.0));
        let parallel = crate::sample::trials(100, 126, |random| {
            let ray = Ray::new(random.point(9.0).with_z(0.0), random.direction().with_z(0.0));
            Trial::new(raytri(&ray, &triangle, 0.0, 99.0).is_none(), "a parallel ray hits")
        });
        judge("the listing says whether the ray hits", Some(NOT_PARALLEL), &trials)
            .with_right("our raytri finds no hit for a ray in the plane", &parallel)
            .compared(
                "a ray in the triangle's plane that starts beside it and leads away",
                format!("{}", slide_raytri(&ray, &triangle, 0.0, 99.0)),
                format!("{:?}", raytri(&ray, &triangle, 0.0, 99.0)),
            )
    },
    pictures: None,
    versions: Some(versions::parallel),
};

/// A triangle across the z axis.
pub(super) fn across(z: f32) -> Triangle {
    Triangle::new(vec3(-9.0, -9.0, z), vec3(9.0, -9.0, z), vec3(0.0, 9.0, z))
}

pub(super) static RETURNS_NO_T: Claim = Claim {
    number: "E11",
    name: "returns-no-t",
    quote: "boolean raytri(ray r, vector a, vector b, vector c, t0, t1)",
    translation: "boolean raytri(ray r, vector a, vector b, vector c, t0, t1)",
    truth: text(
        "A boolean does not say which of two hits is nearer, nor where in the triangle it is: t, β and γ must be returned.",
        "Een boolean zegt niet welke van twee treffers dichterbij is, noch waar in de driehoek: t, β en γ moeten terug.",
    ),
    expected: Verdict::Refuted,
    code: &["raytrace::triangle::raytri"],
    examine: || {
        let ray = Ray::new(Vec3::ZERO, vec3(0.0, 0.0, -2.0));
        let trials = trials(50, 122, |random| {
            let (near, far) = (across(-random.between(1.0, 5.0)), across(-random.between(5.1, 9.0)));
            let answers = [near, far].map(|triangle| slide_raytri(&ray, &triangle, 0.0, 99.0));
            Trial::new(answers[0] != answers[1], format!("both answers are {}", answers[0]))
        });
        let two = [across(-6.0), across(-10.0)];
        let slide = two.map(|triangle| slide_raytri(&ray, &triangle, 0.0, 99.0));
        let right = two.map(|triangle| raytri(&ray, &triangle, 0.0, 99.0).map(|hit| hit.t));
        judge("the answer tells the nearer of two triangles", None, &trials).compared(
            "two triangles, one behind the other",
            format!("{slide:?}"),
            format!("t = {right:?}"),
        )
    },
    pictures: None,
    versions: Some(versions::returns_no_t),
};

fn ball() -> World {
    let ball = Shape::Sphere(Sphere::new(vec3(0.3, 0.1, 0.0), 1.0));
    let object = Object::new(ball, Mat4::IDENTITY, vec![Surface::default()]).expect("a ball");
    World::new(vec![object], Vec::new())
}

fn sun(to_light: Vec3) -> Illumination {
    Illumination { to_light, distance: f32::INFINITY, color: Rgb::ONE }
}

/// p + t·l with t in [0, ∞], from the very point that was hit.
fn slide_is_lit(world: &World, p: Vec3, to_light: Vec3) -> bool {
    !any_hit(world, &Ray::new(p, to_light), 0.0, f32::INFINITY)
}

pub(super) static SHADOW_FROM_ZERO: Claim = Claim {
    number: "E12",
    name: "shadow-ray-from-zero",
    quote: "schaduwstraal p + tl snijdt geen object, dan p niet in schaduw",
    translation: "shadow ray p + tl meets no object, then p is not in shadow",
    truth: text(
        "The point is rounded and lies a little inside or outside its own surface: from t = 0 every other shadow ray meets it. The ray must start off the surface, by as much as rounding can have moved the point.",
        "Het punt is afgerond en ligt net binnen of buiten het eigen oppervlak: vanaf t = 0 raakt om en om een schaduwstraal dat zelf. De straal moet naast het oppervlak beginnen, zo ver als afronding het punt kan hebben verplaatst.",
    ),
    expected: Verdict::Refuted,
    code: &["raytrace::shadow::is_lit", "raytrace::Hit"],
    examine: || {
        let (world, mut lost, mut ours_lost) = (ball(), 0, 0);
        let trials = trials(1000, 123, |random| {
            let eye = 4.0 * random.direction();
            let ray = Ray::through(eye, vec3(0.3, 0.1, 0.0) + 0.5 * random.point(1.0));
            let Some(hit) = nearest(&world, &ray, 0.0, f32::INFINITY) else {
                return Trial::new(true, "beside");
            };
            let to_light = (hit.normal + 0.5 * random.direction()).normalize();
            let slide = slide_is_lit(&world, hit.point, to_light);
            lost += usize::from(!slide);
            ours_lost += usize::from(!is_lit(&world, &ray, &hit, &sun(to_light)));
            Trial::new(slide, format!("a lit point at {} is called dark", hit.point))
        });
        let offset = [Trial::new(ours_lost == 0, format!("{ours_lost} points lost"))];
        judge("a point of a ball that faces the light is lit", None, &trials)
            .with_right("with an offset all 1000 points are lit", &offset)
            .compared(
                "1000 points of a lone ball that face the light",
                format!("{lost} in shadow"),
                format!("{ours_lost} in shadow, with an offset"),
            )
    },
    pictures: Some(acne_pair),
    versions: None,
};

fn acne_pair() -> Drawn {
    let alt_slide = text(
        "A ball peppered with black dots where it should be lit.",
        "Een bal vol zwarte stippen waar hij verlicht zou moeten zijn.",
    );
    let alt_right = text("The same ball, smooth.", "Dezelfde bal, glad.");
    let slide = lit_ball(|world, _, hit, to_light| slide_is_lit(world, hit.point, to_light));
    let right = lit_ball(|world, ray, hit, to_light| is_lit(world, ray, hit, &sun(to_light)));
    pair(Drawing::picture("slide", alt_slide, slide), Drawing::picture("right", alt_right, right))
}

fn lit_ball(is_lit: impl Fn(&World, &Ray, &raytrace::Hit, Vec3) -> bool) -> Image {
    let (world, to_light) = (ball(), vec3(0.36, 0.48, 0.8));
    let pipeline = pipeline((vec3(0.3, 0.1, 4.0), vec3(0.3, 0.1, 0.0)), 0.6, (-1.0, -9.0), SIZE);
    Image::from_fn(SIZE.0, SIZE.1, |i, j| {
        let ray = viewing_ray(&pipeline, i as f32, j as f32);
        let Some(hit) = nearest(&world, &ray, 1.0, 9.0) else { return Rgb::new(0.4, 0.5, 0.6) };
        let diffuse = if is_lit(&world, &ray, &hit, to_light) { lambert(hit.normal, to_light) } else { 0.0 };
        Rgb::new(0.85, 0.55, 0.2) * (0.12 + diffuse)
    })
}

const NOTHING_BEHIND: &str = "nothing lies behind the lamp";

pub(super) static BEYOND_THE_LAMP: Claim = Claim {
    number: "E12",
    name: "shadow-from-beyond-the-lamp",
    quote: "Licht uit richting l (op oneindig), werp schaduwstraal p + tl van p naar lichtbron",
    translation: "light from direction l (at infinity); cast shadow ray p + tl from p to the light source",
    truth: text(
        "With t up to ∞ a wall behind a lamp shades what stands before it. The ray to a point light ends at its t.",
        "Met t tot ∞ geeft een muur achter een lamp schaduw ervóór. De straal naar een puntlicht eindigt bij de t daarvan.",
    ),
    expected: Verdict::HoldsIf(NOTHING_BEHIND),
    code: &["lighting::Light::illumination", "raytrace::shadow::is_lit"],
    examine: || {
        let mut results = Vec::new();
        let trials = trials(100, 124, |random| {
            let (lamp_z, wall_z) = (random.between(1.0, 3.0), random.between(4.0, 5.0));
            let behind = random.below(2) == 0;
            let (slide, right) = lamp_and_wall(random, lamp_z, behind.then_some(wall_z));
            if behind {
                results.push((slide, right));
            }
            Trial::under(
                !behind,
                slide == right,
                format!("lamp at {lamp_z:.2}, wall at {wall_z:.2}: lit {slide}, in truth {right}"),
            )
        });
        let lit = |pick: fn(&(bool, bool)) -> bool| results.iter().filter(|r| pick(r)).count();
        let ends: Vec<Trial> =
            results.iter().map(|(_, right)| Trial::new(*right, "a lit point is dark")).collect();
        judge("t in [0, ∞] finds what shades a point from a lamp", Some(NOTHING_BEHIND), &trials)
            .with_right("a ray that ends at the lamp finds the point lit", &ends)
            .compared(
                format!("{} points under a lamp that hangs before a wall", results.len()),
                format!("{} lit", lit(|r| r.0)),
                format!("{} lit", lit(|r| r.1)),
            )
    },
    pictures: None,
    versions: Some(versions::beyond_the_lamp),
};

/// Whether a point of the floor z = 0 is lit by a lamp above it: with t up to ∞, and with t up to the lamp.
pub(super) fn lamp_and_wall(random: &mut Sequence, lamp_z: f32, wall_z: Option<f32>) -> (bool, bool) {
    let object = |z: f32, n: Vec3| {
        let plane = geometry::Plane::new(vec3(0.0, 0.0, z), n);
        Object::new(Shape::Plane(plane), Mat4::IDENTITY, vec![Surface::default()]).expect("a plane")
    };
    let mut objects = vec![object(0.0, Vec3::Z)];
    objects.extend(wall_z.map(|z| object(z, Vec3::NEG_Z)));
    let world = World::new(objects, Vec::new());
    let q = random.point(2.0).with_z(0.0);
    let lamp = Light::Point { position: vec3(0.2, 0.1, lamp_z), color: Rgb::ONE };
    let ray = Ray::through(vec3(0.5, 0.2, 0.9), q);
    match (nearest(&world, &ray, 0.0, f32::INFINITY), lamp.illumination(q)) {
        (Some(hit), Some(light)) => {
            (is_lit(&world, &ray, &hit, &sun(light.to_light)), is_lit(&world, &ray, &hit, &light))
        }
        _ => (false, false),
    }
}

const IN_THE_VOLUME: &str = "the object lies between near and far plane";

pub(super) static VIEWING_INTERVAL: Claim = Claim {
    number: "E12",
    name: "viewing-rays-from-zero",
    quote: "if (ray hits an object with t in [0, ∞])",
    translation: "if (ray hits an object with t in [0, ∞])",
    truth: text(
        "Rays with t from 0 also see what lies before the near plane or beyond the far one. To match the z-buffer they run from t = 1 to t = f/n.",
        "Stralen met t vanaf 0 zien ook wat vóór het near-vlak of voorbij het far-vlak ligt. Om bij de z-buffer te passen lopen ze van t = 1 tot t = f/n.",
    ),
    expected: Verdict::HoldsIf(IN_THE_VOLUME),
    code: &["raytrace::visible_interval", "zbuffer::project"],
    examine: viewing_interval,
    pictures: None,
    versions: Some(versions::viewing_interval),
};

fn viewing_interval() -> Examination {
    let pipeline = pipeline((Vec3::ZERO, Vec3::NEG_Z), 0.9, (-1.0, -10.0), (32, 32));
    let trials = trials(100, 125, |random| {
        let distance = random.between(0.2, 15.0);
        let (by_slide, by_us, by_buffer) = who_sees(&pipeline, distance);
        let inside = (1.0..10.0).contains(&distance);
        let numbers =
            format!("{distance:.2} away: seen by rays from 0 {by_slide}, by the z-buffer {by_buffer}");
        Trial::under(inside, by_slide == by_buffer && by_us == by_buffer, numbers)
    });
    let seen = |seen: bool| if seen { "seen" } else { "not seen" };
    let (slide, right, _) = who_sees(&pipeline, 0.5);
    let limited = crate::sample::trials(100, 125, |random| {
        let (_, by_us, by_buffer) = who_sees(&pipeline, random.between(0.2, 15.0));
        Trial::new(by_us == by_buffer, "seen by one only")
    });
    judge("rays with t in [0, ∞] see what the z-buffer sees", Some(IN_THE_VOLUME), &trials)
        .with_right("rays with t from 1 to f/n see what the z-buffer sees", &limited)
        .compared(
            "a wall half way to the near plane",
            seen(slide),
            format!("{} with t from 1 to f/n, as by the z-buffer", seen(right)),
        )
}

/// Whether a wall across the gaze is seen by rays with t in [0, ∞], by rays with t in (1, f/n), and by the z-buffer.
pub(super) fn who_sees(pipeline: &Pipeline, distance: f32) -> (bool, bool, bool) {
    let size = 3.0 * distance;
    let corner = |x: f32, y: f32| vec3(x * size, y * size, -distance);
    let wall = Triangle::new(corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 1.0));
    let ray = viewing_ray(pipeline, 15.0, 15.0);
    let (t0, t1) = raytrace::visible_interval(&pipeline.volume());
    let hit = |t0, t1| raytri(&ray, &wall, t0, t1).is_some();
    let drawn = project(&pipeline.clip_from_world(), 32, 32, &wall).triangles().count() > 0;
    (hit(0.0, f32::INFINITY), hit(t0, t1), drawn)
}
