//! Whole pictures: nothing lost, the same for any number of threads, the right side up.

use std::sync::{Arc, Mutex};

use canvas::{Image, Rgb};
use geometry::{Mesh, Plane, Sphere, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material};
use raytrace::{
    Interpolation, Object, Optics, Search, Settings, Shape, Surface, TracedMesh, World, pick, render, visible,
};
use transforms::{Camera, Pipeline, ViewVolume};

/// The Cornell box as it was measured, in millimetres, closed by a sixth wall: each quadrilateral by its corners.
const CORNELL_BOX: [[[f32; 3]; 4]; 14] = [
    // Floor, ceiling, back wall, right wall, left wall, and the front.
    [[552.8, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 559.2], [549.6, 0.0, 559.2]],
    [[556.0, 548.8, 0.0], [556.0, 548.8, 559.2], [0.0, 548.8, 559.2], [0.0, 548.8, 0.0]],
    [[549.6, 0.0, 559.2], [0.0, 0.0, 559.2], [0.0, 548.8, 559.2], [556.0, 548.8, 559.2]],
    [[0.0, 0.0, 559.2], [0.0, 0.0, 0.0], [0.0, 548.8, 0.0], [0.0, 548.8, 559.2]],
    [[552.8, 0.0, 0.0], [549.6, 0.0, 559.2], [556.0, 548.8, 559.2], [556.0, 548.8, 0.0]],
    [[552.8, 0.0, 0.0], [556.0, 548.8, 0.0], [0.0, 548.8, 0.0], [0.0, 0.0, 0.0]],
    // The two blocks: tops, then some of their sides.
    [[130.0, 165.0, 65.0], [82.0, 165.0, 225.0], [240.0, 165.0, 272.0], [290.0, 165.0, 114.0]],
    [[290.0, 0.0, 114.0], [290.0, 165.0, 114.0], [240.0, 165.0, 272.0], [240.0, 0.0, 272.0]],
    [[130.0, 0.0, 65.0], [130.0, 165.0, 65.0], [290.0, 165.0, 114.0], [290.0, 0.0, 114.0]],
    [[82.0, 0.0, 225.0], [82.0, 165.0, 225.0], [130.0, 165.0, 65.0], [130.0, 0.0, 65.0]],
    [[423.0, 330.0, 247.0], [265.0, 330.0, 296.0], [314.0, 330.0, 456.0], [472.0, 330.0, 406.0]],
    [[423.0, 0.0, 247.0], [423.0, 330.0, 247.0], [472.0, 330.0, 406.0], [472.0, 0.0, 406.0]],
    [[314.0, 0.0, 456.0], [314.0, 330.0, 456.0], [265.0, 330.0, 296.0], [265.0, 0.0, 296.0]],
    [[265.0, 0.0, 296.0], [265.0, 330.0, 296.0], [423.0, 330.0, 247.0], [423.0, 0.0, 247.0]],
];

/// The box, either as one mesh or with each wall an object of its own.
fn cornell_box(one_mesh: bool, walls: usize) -> World {
    let corners = CORNELL_BOX[..walls].as_flattened().iter().map(|p| Vec3::from(*p)).collect::<Vec<_>>();
    let triangles =
        |quad: u32| [[4 * quad, 4 * quad + 1, 4 * quad + 2], [4 * quad, 4 * quad + 2, 4 * quad + 3]];
    let object = |triangles: Vec<[u32; 3]>| {
        let mesh = Mesh::new(corners.clone(), triangles).unwrap();
        Object::new(Shape::Mesh(Arc::new(TracedMesh::new(mesh))), Mat4::IDENTITY, vec![Surface::default()])
            .unwrap()
    };
    let quads = 0..walls as u32;
    let objects = if one_mesh {
        vec![object(quads.flat_map(triangles).collect())]
    } else {
        quads.map(|quad| object(triangles(quad).to_vec())).collect()
    };
    World::new(objects, Vec::new())
}

fn looking(eye: Vec3, target: Vec3, size: u32) -> Pipeline {
    let camera = Camera::look_at(eye, target, Vec3::Y).unwrap();
    let volume = ViewVolume::from_fov_y(1.9, 1.0, -0.5, -5000.0).unwrap();
    Pipeline::new(camera, volume, size, size).unwrap()
}

#[test]
fn a_closed_box_seen_from_inside_loses_none_of_a_million_rays() {
    let eye = vec3(278.0, 273.0, 40.0);
    // Into an edge, into a corner, and straight along an axis.
    let (edge, corner, wall) = (vec3(0.0, 273.0, 559.2), vec3(0.0, 548.8, 559.2), vec3(278.0, 273.0, 559.2));
    for (target, one_mesh) in [(edge, true), (corner, false), (wall, true)] {
        let hits = visible(&cornell_box(one_mesh, 14), &looking(eye, target, 1024));
        assert_eq!(hits.len(), 1024 * 1024);
        assert_eq!(hits.iter().filter(|hit| hit.is_none()).count(), 0);
    }
}

#[test]
fn an_open_box_loses_the_rays_that_leave_through_its_front() {
    // So that the test above would notice.
    let hits =
        visible(&cornell_box(true, 5), &looking(vec3(278.0, 273.0, 300.0), vec3(278.0, 273.0, 0.0), 64));
    assert!(hits.iter().any(Option::is_none) && hits.iter().any(Option::is_some));
}

/// A bit of everything: instances of a mesh, mirror, glass, a plane, lights of each kind.
fn medley() -> World {
    let torus = Arc::new(TracedMesh::new(shapes::torus(1.0, 0.4, 1).unwrap()));
    let plain = Surface::opaque(Material::new(Rgb::new(0.8, 0.3, 0.1), 40.0));
    let mirror = Surface {
        material: Material { diffuse: Rgb::ZERO, ..Material::default() },
        optics: Optics::Mirror { reflectance: Rgb::new(0.9, 0.8, 0.7) },
    };
    let glass = Surface {
        material: Material { diffuse: Rgb::ZERO, ..Material::default() },
        optics: Optics::Glass { refractive_index: 1.5, transmittance: Rgb::new(0.9, 1.0, 0.9) },
    };
    let object = |shape: Shape, at: Vec3, surface| {
        Object::new(shape, Mat4::from_translation(at) * Mat4::from_rotation_x(0.7), vec![surface]).unwrap()
    };
    let ball = Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));
    let mut world = World::new(
        vec![
            object(Shape::Mesh(torus.clone()), vec3(-1.5, 0.0, 0.0), plain),
            object(Shape::Mesh(torus), vec3(1.5, 0.5, -2.0), mirror),
            object(ball.clone(), vec3(0.5, 0.0, 1.5), glass),
            object(ball, vec3(0.0, 1.0, -4.0), mirror),
            Object::new(Shape::Plane(Plane::new(vec3(0.0, -1.2, 0.0), Vec3::Y)), Mat4::IDENTITY, vec![plain])
                .unwrap(),
        ],
        vec![
            Light::Ambient { color: Rgb::splat(0.2) },
            Light::Directional { to_light: vec3(0.48, 0.64, 0.6), color: Rgb::new(0.7, 0.7, 0.6) },
            Light::Point { position: vec3(-3.0, 5.0, 4.0), color: Rgb::splat(0.4) },
        ],
    );
    world.background = Rgb::new(0.2, 0.3, 0.5);
    world
}

fn bits(image: &Image) -> Vec<[u32; 3]> {
    image.pixels().iter().map(|c| c.to_array().map(f32::to_bits)).collect()
}

#[test]
fn the_number_of_threads_changes_no_bit_and_neither_does_building_again() {
    let pipeline = looking(vec3(0.3, 0.5, 5.0), vec3(0.0, 0.0, -1.0), 97);
    let settings = Settings { samples: 2, ..Settings::default() };
    let with_threads = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| bits(&render(&medley(), &pipeline, &settings, &|_| ())))
    };
    let one = with_threads(1);
    assert!(one == with_threads(2) && one == with_threads(5));
}

#[test]
fn the_slow_search_draws_the_same_picture() {
    let pipeline = looking(vec3(0.3, 0.5, 5.0), vec3(0.0, 0.0, -1.0), 64);
    for interpolation in [Interpolation::Flat, Interpolation::Gouraud, Interpolation::Phong] {
        let mut world = medley();
        world.interpolation = interpolation;
        let picture =
            |search| bits(&render(&world, &pipeline, &Settings { search, ..Settings::default() }, &|_| ()));
        assert!(picture(Search::Hierarchy) == picture(Search::BruteForce));
    }
}

#[test]
fn progress_counts_every_row() {
    let rows = Mutex::new(Vec::new());
    let pipeline = looking(vec3(0.3, 0.5, 5.0), Vec3::ZERO, 24);
    let _ = render(&medley(), &pipeline, &Settings::default(), &|done| rows.lock().unwrap().push(done));
    let mut rows = rows.into_inner().unwrap();
    rows.sort_unstable();
    assert_eq!(rows, (1..=24).collect::<Vec<_>>());
}

#[test]
fn up_is_up_right_is_right_and_the_mouse_finds_what_is_there() {
    let ball = |at: Vec3, color: Rgb| {
        let surface = Surface::opaque(Material::matt(color));
        Object::new(Shape::Sphere(Sphere::new(at, 0.5)), Mat4::IDENTITY, vec![surface]).unwrap()
    };
    let above = ball(vec3(0.0, 3.0, 0.0), Rgb::X);
    let to_the_right = ball(vec3(3.0, 0.0, 0.0), Rgb::Y);
    let world = World::new(vec![above, to_the_right], vec![Light::Ambient { color: Rgb::ONE }]);
    let pipeline = looking(vec3(0.0, 0.0, 5.0), Vec3::ZERO, 101);
    let image = render(&world, &pipeline, &Settings::default(), &|_| ());
    let pixel_of = |p: Vec3| pipeline.trace(p).screen.unwrap();
    let (up, right) = (pixel_of(vec3(0.0, 3.0, 0.0)), pixel_of(vec3(3.0, 0.0, 0.0)));
    assert!(up.y > 50.0 && right.x > 50.0);
    assert_eq!(image.get(50, up.y as u32), Rgb::X);
    assert_eq!(image.get(right.x as u32, 50), Rgb::Y);
    assert_eq!(pick(&world, &pipeline, up.x, up.y).unwrap().object, 0);
    assert_eq!(pick(&world, &pipeline, right.x, right.y).unwrap().object, 1);
    assert_eq!(pick(&world, &pipeline, 50.0, 50.0), None);
    // Rows run down while j runs up (E18).
    let first_row_with_red = image.pixels().iter().position(|c| *c == Rgb::X).unwrap() / 101;
    assert!(first_row_with_red < 50);
    assert_eq!(visible(&world, &pipeline)[(100 - up.y as usize) * 101 + 50].unwrap().object, 0);
}

#[test]
fn only_what_lies_between_near_and_far_plane_is_seen() {
    let wall = |z: f32| Shape::Plane(Plane::new(vec3(0.0, 0.0, z), Vec3::Z));
    let object = |z| Object::new(wall(z), Mat4::IDENTITY, vec![Surface::default()]).unwrap();
    let camera = Camera::look_at(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y).unwrap();
    let volume = ViewVolume { left: -3.0, right: 1.0, bottom: -1.0, top: 2.0, near: -2.0, far: -10.0 };
    let pipeline = Pipeline::new(camera, volume, 8, 6).unwrap();
    for (z, seen) in [(-1.99, false), (-2.01, true), (-9.99, true), (-10.01, false)] {
        let hits = visible(&World::new(vec![object(z)], Vec::new()), &pipeline);
        assert!(hits.iter().all(|hit| hit.is_some() == seen), "{z}");
    }
}

#[test]
fn a_pixel_is_the_mean_of_the_centres_of_its_parts() {
    let (world, pipeline) = (medley(), looking(vec3(0.5, 2.0, 6.0), vec3(0.1, 0.4, 0.0), 12));
    let (t0, t1) = raytrace::visible_interval(&pipeline.volume());
    // The centres of n parts of the interval from −½ to ½.
    for centres in [&[0.0_f32][..], &[-0.25, 0.25], &[-0.375, -0.125, 0.125, 0.375]] {
        let n = centres.len() as u32;
        let settings = Settings { samples: n, ..Settings::default() };
        let image = render(&world, &pipeline, &settings, &|_| ());
        for (i, j) in [(2, 3), (7, 5), (10, 1)] {
            let places = centres.iter().flat_map(|dj| centres.iter().map(move |di| (*di, *dj)));
            let ray = |(di, dj)| raytrace::viewing_ray(&pipeline, i as f32 + di, j as f32 + dj);
            let sum: Rgb = places.map(|at| raytrace::ray_color(&world, &ray(at), t0, t1, &settings)).sum();
            assert_eq!(image.get(i, j), sum / (n * n) as f32, "{n} × {n} samples");
        }
    }
}

#[test]
fn more_samples_soften_an_edge() {
    let ball = Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));
    let surface = Surface::opaque(Material::matt(Rgb::ONE));
    let world = World::new(
        vec![Object::new(ball, Mat4::IDENTITY, vec![surface]).unwrap()],
        vec![Light::Ambient { color: Rgb::ONE }],
    );
    let pipeline = looking(vec3(0.1, 0.2, 3.0), Vec3::ZERO, 31);
    let picture = |samples| render(&world, &pipeline, &Settings { samples, ..Settings::default() }, &|_| ());
    let between = |image: &Image| image.pixels().iter().filter(|c| 0.0 < c.x && c.x < 1.0).count();
    assert_eq!(between(&picture(1)), 0);
    let soft = picture(4);
    assert!(between(&soft) > 20);
    // Sixteenths: the mean of a 4 × 4 grid, and the same as a picture four times as large, averaged.
    assert!(soft.pixels().iter().all(|c| (c.x * 16.0).fract() == 0.0));
    let large = render(&world, &looking(vec3(0.1, 0.2, 3.0), Vec3::ZERO, 124), &Settings::default(), &|_| ());
    let differing =
        large.box_downsampled(4).pixels().iter().zip(soft.pixels()).filter(|(a, b)| a != b).count();
    // The two positions of a sample differ by rounding: only a sample on the very outline may differ.
    assert!(differing <= 2, "{differing}");
}
