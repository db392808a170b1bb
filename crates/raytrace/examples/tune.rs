#[path = "../benches/scene/mod.rs"]
mod scene;
use canvas::Rgb;
use geometry::Ray;
use glam::{Mat4, Vec3A};
use lighting::{Light, Material};
use raytrace::*;
use std::sync::Arc;
use std::time::Instant;

fn best(n: usize, mut f: impl FnMut()) -> f64 {
    (0..n)
        .map(|_| {
            let s = Instant::now();
            f();
            s.elapsed().as_secs_f64()
        })
        .fold(f64::MAX, f64::min)
}

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let with_obvhs = args.iter().any(|a| a == "obvhs");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let two = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    pool.install(|| {
    for (name, n) in [("69k", 76), ("1M", 289)] {
        if args.iter().any(|a| a == "69k") && name == "1M" { continue; }
        if args.iter().any(|a| a == "1M") && name == "69k" { continue; }
        let mesh = scene::bumpy(n);
        let m2 = mesh.clone();
        let s = Instant::now();
        let traced = two.install(|| TracedMesh::new(m2));
        let build = s.elapsed().as_secs_f64();
        let mut world = World::new(vec![Object::new(Shape::Mesh(Arc::new(traced)), Mat4::IDENTITY, vec![Surface::opaque(Material { diffuse: Rgb::new(0.6,0.25,0.1), specular: Rgb::splat(0.3), exponent: 50.0 })]).unwrap()],
            vec![Light::Ambient { color: Rgb::splat(0.1) }, Light::Point { position: scene::LIGHT, color: Rgb::ONE }]);
        world.highlight = lighting::Highlight::Blinn;
        let primary = scene::primary(1024);
        let random = scene::random(1024*256);
        let mut met = vec![None; primary.len()];
        fast::nearest_each(&world, &primary, 0.0, f32::MAX, &mut met);
        let shadow: Vec<Ray> = primary.iter().zip(&met).filter_map(|(r, m)| m.map(|m| Ray::through(r.at(m.t * (1.0 - 1e-3)), scene::LIGHT))).collect();
        let ends = vec![1.0; shadow.len()];
        let mut hit = vec![false; shadow.len()];
        let rounds = 3;
        let p = best(rounds, || fast::nearest_each(&world, &primary, 0.0, f32::MAX, &mut met));
        let p1 = best(rounds, || primary.iter().zip(&mut met).for_each(|(r, m)| *m = fast::nearest(&world, r, 0.0, f32::MAX)));
        let p2 = best(rounds, || primary.iter().zip(&mut met).for_each(|(r, m)| *m = nearest(&world, r, 0.0, f32::MAX).map(|h| Met {t: h.t, object: 0, triangle: 0, weights: h.weights})));
        let mut rmet = vec![None; random.len()];
        let r = best(rounds, || fast::nearest_each(&world, &random, 0.0, f32::MAX, &mut rmet));
        let sh = best(rounds, || fast::any_hit_each(&world, &shadow, 0.0, &ends, &mut hit));
        let sh1 = best(rounds, || shadow.iter().zip(&mut hit).for_each(|(r, h)| *h = fast::any_hit(&world, r, 0.0, 1.0)));
        let rate = |n: usize, t: f64| n as f64 / t * 1e-6;
        println!("{name}: build {:.0} ms; primary {:.2} (single {:.2}, with Hit {:.2})  random {:.2}  shadow {:.2} (single {:.2}) hits {}", build * 1e3, rate(primary.len(), p), rate(primary.len(), p1), rate(primary.len(), p2), rate(random.len(), r), rate(shadow.len(), sh), rate(shadow.len(), sh1), hit.iter().filter(|h| **h).count());
        if name == "69k" || args.iter().any(|a| a == "picture") {
            let view = scene::view(1024, 768);
            let one = best(3, || drop(render(&world, &view, &Settings::default(), &|_| ())));
            let both = two.install(|| best(3, || drop(render(&world, &view, &Settings::default(), &|_| ()))));
            println!("  picture {:.0} ms, two {:.0} ms", one * 1e3, both * 1e3);
        }
        if with_obvhs {
            let tris: Vec<_> = (0..mesh.len()).map(|k| { let [v0, v1, v2] = mesh.triangle(k).corners().map(Vec3A::from); obvhs::triangle::Triangle { v0, v1, v2 } }).collect();
            let mut d = std::time::Duration::default();
            let bvh = obvhs::bvh2::builder::build_bvh2_from_tris(&tris, obvhs::BvhBuildParams::medium_build(), &mut d);
            let order: Vec<_> = bvh.primitive_indices.iter().map(|k| tris[*k as usize]).collect();
            let go = |rays: &[Ray]| best(rounds, || { let mut s = 0.0; for r in rays { let mut h = obvhs::ray::RayHit::none(); bvh.ray_traverse(obvhs::ray::Ray::new(r.origin.into(), r.direction.into(), 0.0, f32::MAX), &mut h, |ray, k| order[k].intersect(ray)); s += h.t; } std::hint::black_box(s); });
            let (p, r) = (go(&primary), go(&random));
            let s = best(rounds, || { let mut c = 0; for r in &shadow { c += usize::from(bvh.ray_traverse_miss(obvhs::ray::Ray::new(r.origin.into(), r.direction.into(), 0.0, 1.0), |ray, k| order[k].intersect(ray))); } std::hint::black_box(c); });
            println!("  obvhs build {:.0} ms; {:.2} {:.2} {:.2}", d.as_secs_f64() * 1e3, rate(primary.len(), p), rate(random.len(), r), rate(shadow.len(), s));
        }
    }
    });
}
