//! What does the ray tracer show, in light, in shadow and in mirrors? (L55–L58)

use canvas::difference;
use geometry::{Plane, Ray, Sphere};
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material, Rgb};
use raytrace::optics::refracted;
use raytrace::shadow::is_lit;
use raytrace::surface::Optics;
use raytrace::{Object, Settings, Shape, Surface, World, local_color, nearest, ray_color};

use crate::sample::{pipeline, short, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, stage, text};

pub(super) static RENDER_LOOP: Claim = Claim {
    number: "L55",
    name: "render-loop",
    quote: "for each pixel do compute viewing ray, if (ray hits an object …) … set pixel to that color",
    translation: "for each pixel: compute the viewing ray; if it hits an object, set the pixel to that colour",
    truth: text(
        "The slide's loop, pixel by pixel, draws what the renderer draws on all threads.",
        "De lus van de dia, pixel voor pixel, tekent wat de renderer op alle threads tekent.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::render", "raytrace::local_color"],
    examine: || {
        let world = stage::world();
        let trials = trials(3, 111, |random| {
            let eye = vec3(random.between(-3.0, 3.0), 2.0, 6.0);
            let pipeline = pipeline((eye, vec3(0.0, 0.5, 0.0)), 0.8, (-1.0, -30.0), (48, 36));
            let (slow, fast) = (
                stage::slide_loop(&world, &pipeline),
                raytrace::render(&world, &pipeline, &Settings::default(), &|_| ()),
            );
            // One adds the lights up at once, the other light by light: the last bit may differ.
            let differ = difference(&slow, &fast, 1e-6).map_or(usize::MAX, |d| d.over_threshold);
            Trial::new(differ == 0, format!("{differ} pixels differ"))
        });
        judge("the slide's loop and the renderer give the same picture", None, &trials)
    },
    pictures: None,
    versions: None,
};

/// A ball over a floor.
fn ball_over_floor() -> World {
    let surface = || vec![Surface::opaque(Material::new(Rgb::new(0.7, 0.5, 0.3), 10.0))];
    let object = |shape| Object::new(shape, Mat4::IDENTITY, surface()).expect("an object");
    let ball = object(Shape::Sphere(Sphere::new(vec3(0.0, 2.0, 0.0), 1.0)));
    let floor = object(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y)));
    World::new(vec![ball, floor], vec![Light::Ambient { color: Rgb::splat(0.2) }])
}

pub(super) static SHADOW_RAYS: Claim = Claim {
    number: "L56",
    name: "shadow-rays",
    quote: "schaduwstraal q + tl snijdt object, dan q in schaduw",
    translation: "shadow ray q + tl meets an object, then q is in shadow",
    truth: text(
        "So it is: the ball's shadow lies where the line to the light passes its centre at less than the radius.",
        "Zo is het: de schaduw van de bal ligt waar de lijn naar het licht op minder dan de straal langs het middelpunt gaat.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::shadow::is_lit"],
    examine: || {
        let world = ball_over_floor();
        let trials = trials(400, 112, |random| {
            let q = vec3(random.between(-4.0, 4.0), 0.0, random.between(-4.0, 4.0));
            let to_light = (random.direction_around(Vec3::Y) + Vec3::Y).normalize();
            let ray = Ray::through(vec3(0.0, 0.4, 9.0), q);
            let Some(hit) = nearest(&world, &ray, 0.0, f32::INFINITY).filter(|hit| hit.object == 1) else {
                return Trial::new(true, "the ball hides q from the eye");
            };
            let to_center = vec3(0.0, 2.0, 0.0) - q;
            let aside = to_center.cross(to_light).length();
            let light = lighting::Illumination { to_light, distance: f32::INFINITY, color: Rgb::ONE };
            let lit = is_lit(&world, &ray, &hit, &light);
            // A ray that grazes the ball to within rounding may go either way.
            let holds = lit == (aside > 1.0) || (aside - 1.0).abs() < 1e-4;
            Trial::new(holds, format!("q = {}, {aside:.3} beside the centre: lit {lit}", short(q)))
        });
        judge("q is in shadow just where the ball is in the way", None, &trials)
    },
    pictures: None,
    versions: None,
};

/// The slide's raycolor in its own words, its (h·n)^p without maximum.
fn slide_raycolor(world: &World, ray: &Ray, t0: f32, t1: f32) -> Rgb {
    let Some(hit) = nearest(world, ray, t0, t1) else { return world.background };
    let material = world.surface(&hit).material;
    let (n, e) = (hit.normal_towards(ray), (ray.origin - hit.point).normalize());
    let mut c = material.diffuse * lighting::light::ambient(&world.lights);
    for light in world.lights.iter().filter_map(|light| light.illumination(hit.point)) {
        if is_lit(world, ray, &hit, &light) {
            let l = light.to_light;
            let h = (e + l) / (e + l).length();
            c += material.diffuse * light.color * n.dot(l).max(0.0)
                + light.color * h.dot(n).powf(material.exponent);
        }
    }
    c
}

pub(super) static RAYCOLOR: Claim = Claim {
    number: "L57",
    name: "raycolor",
    quote: "als (P's schaduwstraal geen object snijdt) dan … c = c + c_r c_l max(0, n·l) + c_l (h·n)^p",
    translation: "if P's shadow ray meets no object then … c = c + c_r c_l max(0, n·l) + c_l (h·n)^p",
    truth: text(
        "On closed bodies the shadow ray also hides the fault of (h·n)^p (E3): a point with n·l < 0 lies in its own body's shadow.",
        "Op gesloten lichamen verbergt de schaduwstraal ook de fout van (h·n)^p (E3): een punt met n·l < 0 ligt in de schaduw van zijn eigen lichaam.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::local_color"],
    examine: || {
        let trials = trials(300, 113, |random| {
            let mut world = ball_over_floor();
            let to_light = random.direction_around(Vec3::Y);
            world.lights.push(Light::Directional { to_light, color: random.color() });
            let target = vec3(random.between(-2.0, 2.0), random.between(0.0, 3.0), 0.0);
            let ray = Ray::through(vec3(0.0, 2.5, 8.0), target);
            let slide = slide_raycolor(&world, &ray, 0.0, f32::INFINITY);
            let ours = local_color(&world, &ray, 0.0, f32::INFINITY);
            // Sums of a few numbers below 2, and a power that multiplies roundings by 10.
            Trial::new(slide.abs_diff_eq(ours, 1e-4), format!("{} and {}", short(slide), short(ours)))
        });
        judge("the listing gives the colour of our local lighting on closed bodies", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static RECURSION_ENDS: Claim = Claim {
    number: "L58",
    name: "recursion-ends",
    quote: "Ray tracing en recursieve ray tracing",
    translation: "ray tracing and recursive ray tracing",
    truth: text(
        "With a greatest depth it ends even between two facing mirrors: each adds its own light, and the sum is that of a geometric series.",
        "Met een grootste diepte eindigt het ook tussen twee spiegels tegenover elkaar: elke voegt eigen licht toe, samen een meetkundige reeks.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::ray_color", "raytrace::Settings"],
    examine: || {
        let mirror = Surface {
            material: Material::matt(Rgb::splat(0.5)),
            optics: Optics::Mirror { reflectance: Rgb::splat(0.5) },
        };
        let wall = |z: f32| {
            let plane = Plane::new(vec3(0.0, 0.0, z), if z < 0.0 { Vec3::Z } else { Vec3::NEG_Z });
            Object::new(Shape::Plane(plane), Mat4::IDENTITY, vec![mirror]).expect("a mirror")
        };
        let world = World::new(vec![wall(-1.0), wall(1.0)], vec![Light::Ambient { color: Rgb::ONE }]);
        let ray = Ray::new(Vec3::ZERO, vec3(0.1, 0.2, -1.0));
        let trials: Vec<Trial> = (0..12)
            .map(|max_depth| {
                let settings = Settings { max_depth, ..Settings::default() };
                let c = ray_color(&world, &ray, 0.0, f32::INFINITY, &settings).x;
                // 0.5 of ambient light a mirror, each seen through half as much again: 1 − 0.5^(d+1).
                let series = 1.0 - 0.5_f32.powi(max_depth as i32 + 1);
                Trial::new((c - series).abs() < 1e-6, format!("depth {max_depth}: {c} instead of {series}"))
            })
            .collect();
        judge("between two mirrors the colour is 1 − ½^(d+1)", None, &trials)
    },
    pictures: None,
    versions: None,
};

const NO_TOTAL_REFLECTION: &str = "there is no total internal reflection";

pub(super) static SNELL: Claim = Claim {
    number: "L58",
    name: "snells-law",
    quote: "deels doorgelaten (transparant oppervlak)",
    translation: "in part transmitted (a transparent surface)",
    truth: text(
        "What passes is bent by n₁ sin θ₁ = n₂ sin θ₂; where that has no solution nothing passes at all.",
        "Wat doorgaat buigt volgens n₁ sin θ₁ = n₂ sin θ₂; waar dat geen oplossing heeft, gaat er niets door.",
    ),
    expected: Verdict::HoldsIf(NO_TOTAL_REFLECTION),
    code: &["raytrace::optics::refracted"],
    examine: snell,
    pictures: None,
    versions: None,
};

fn snell() -> Examination {
    let trials = trials(300, 114, |random| {
        let (d, n) = (-random.direction_around(Vec3::Z), Vec3::Z);
        let (n_1, n_2) = (random.between(1.0, 2.0), random.between(1.0, 2.0));
        let sine = d.cross(n).length();
        let passes = n_1 * sine < n_2;
        let numbers = format!("n₁ = {n_1:.2}, n₂ = {n_2:.2}, sin θ₁ = {sine:.3}");
        let Some(behind) = refracted(d, n, n_1 / n_2) else {
            return Trial::under(passes, false, format!("{numbers}: nothing passes"));
        };
        // A root of a difference from 1: near grazing it loses half the digits.
        let holds = (n_1 * sine - n_2 * behind.cross(n).length()).abs() < 1e-3 && behind.z < 0.0;
        Trial::under(passes, holds, numbers)
    });
    judge("light passes, bent by Snell's law", Some(NO_TOTAL_REFLECTION), &trials)
}
