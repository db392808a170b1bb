//! What holds for every scene.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use glam::{Vec3, vec3};
use lighting::{Highlight, Light, Material, Rgb};
use proptest::collection::{btree_map, vec};
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;
use raytrace::{Optics, Surface};
use scene::{
    DepthFormat, Lens, Loaded, Named, Object, RenderError, Renderer, Scene, Settings, Shading, Shape, Show,
    Transform, View, prepare, render,
};
use testkit::{Law, ensure};
use transforms::{Camera, ViewVolume};

#[test]
fn what_was_written_reads_back_as_the_same_scene() {
    Law::new("parsing what was written gives the same scene")
        .demand("window", 0.2)
        .demand("field of view", 0.2)
        .demand("copies", 0.2)
        .demand("glass", 0.1)
        .demand("mirror", 0.1)
        .demand("polygons", 0.1)
        .demand("a name that needs quotes", 0.1)
        .holds_for(scene(), |scene, seen| {
            let optics = |wanted: fn(&Optics) -> bool| scene.materials.values().any(|s| wanted(&s.optics));
            seen.class("window", matches!(scene.camera.lens, Lens::Window(_)));
            seen.class("field of view", matches!(scene.camera.lens, Lens::FieldOfView { .. }));
            seen.class("copies", scene.objects.iter().any(|object| object.instances.len() > 1));
            seen.class("glass", optics(|o| matches!(o, Optics::Glass { .. })));
            seen.class("mirror", optics(|o| matches!(o, Optics::Mirror { .. })));
            seen.class("half transparent", optics(|o| matches!(o, Optics::Dissolved { .. })));
            seen.class("polygons", scene.objects.iter().any(|o| matches!(o.shape, Shape::Polygons { .. })));
            seen.class(
                "a name that needs quotes",
                scene.materials.keys().any(|name| name.contains(['"', '\\', '\n'])),
            );

            let text = scene.to_toml();
            let again = Scene::from_toml(&text, "again.toml");
            ensure(again.as_ref() == Ok(&scene), || format!("{text}\nreads back as {again:#?}"))
        });
}

#[test]
fn every_renderer_draws_every_scene_without_a_nan() {
    let law = Law::new("a scene that can be read can be drawn, or an error says why not").cases(64);
    law.demand("something is seen", 0.2).demand("drawn", 0.6).holds_for(
        (scene(), select(Renderer::ALL), select(Show::ALL)),
        |(mut scene, (_, renderer), (_, show)), seen| {
            scene.objects.retain(|object| !matches!(object.shape, Shape::Obj { .. }));
            let settings = Settings { renderer, show, size: (16, 12), samples: 1, ..scene.settings };
            let loaded =
                Loaded::from_scene(&scene, "".as_ref()).map_err(|e| TestCaseError::fail(e.to_string()))?;
            let rendered = prepare(&loaded).and_then(|prepared| render(&prepared, &settings, &|_| ()));
            seen.class("drawn", rendered.is_ok());
            let rendered = match rendered {
                Ok(rendered) => rendered,
                Err(error) => return ensure(is_legitimate(&error), || format!("{error:?}")),
            };
            let first = rendered.image.pixels()[0];
            seen.class("something is seen", rendered.image.pixels().iter().any(|pixel| *pixel != first));
            ensure(rendered.image.pixels().iter().all(|pixel| !pixel.is_nan()), || {
                "a pixel is NaN".to_owned()
            })
        },
    );
}

/// Sizes and transforms multiply: what each may be alone can be too large or too flat together, which only shows when
/// they are applied. Nothing else that could be read may be refused afterwards.
fn is_legitimate(error: &RenderError) -> bool {
    matches!(error, RenderError::FarAway { .. } | RenderError::Object(_) | RenderError::Mesh(_))
}

fn scene() -> impl Strategy<Value = Scene> {
    let materials = btree_map(name(), surface(), 0..4);
    materials.prop_flat_map(|materials| {
        let names: Vec<String> = materials.keys().cloned().collect();
        let parts = (view(), color(0.0..=3.0), vec(light(), 0..4), vec(object(names), 0..4), settings());
        parts.prop_map(move |(camera, background, lights, objects, settings)| Scene {
            camera,
            background,
            lights,
            materials: materials.clone(),
            objects,
            settings,
        })
    })
}

/// Plain names, names with spaces, and names full of what TOML has to escape.
fn name() -> impl Strategy<Value = String> {
    prop_oneof!["[a-z]{1,6}", "[ -~]{0,8}", "[\"\\\\\n\t\u{7f}é]{1,4}"]
}

/// Round numbers, odd ones and ones near the ends of what is allowed.
fn length() -> impl Strategy<Value = f32> {
    prop_oneof![4 => 0.1_f32..4.0, 1 => 1e-9_f32..1e-6, 1 => 1e6_f32..1e8, 1 => Just(1.0)]
}

fn point() -> impl Strategy<Value = Vec3> {
    let coordinate =
        || prop_oneof![6 => -5.0_f32..5.0, 1 => -1e8_f32..1e8, 1 => Just(0.0), 1 => -1e-8_f32..1e-8];
    (coordinate(), coordinate(), coordinate()).prop_map(Vec3::from)
}

fn direction() -> impl Strategy<Value = Vec3> {
    (testkit::strategy::unit_vector(), 0.01_f32..100.0).prop_map(|(unit, length)| length * unit)
}

fn color(range: RangeInclusive<f32>) -> impl Strategy<Value = Rgb> {
    (range.clone(), range.clone(), range).prop_map(Rgb::from)
}

fn view() -> impl Strategy<Value = View> {
    let plane = || option::of(0.01_f32..2.0);
    let fov = (1.0_f32..170.0, plane(), option::of(2.0_f32..50.0)).prop_map(|(degrees, near, far)| {
        Lens::FieldOfView { degrees, near: near.map(|n| -n), far: far.map(|f| -f - 1.0) }
    });
    let lens = prop_oneof![fov, testkit::strategy::view_volume().prop_map(Lens::Window)];
    let near_the_origin = || testkit::strategy::point(8.0);
    (near_the_origin(), near_the_origin(), direction(), lens)
        .prop_map(|(eye, target, up, lens)| View { eye, target, up, lens })
        .prop_filter("no camera", |view| {
            let volume = match view.lens {
                Lens::Window(volume) => volume.validate(),
                Lens::FieldOfView { degrees, .. } => {
                    ViewVolume::from_fov_y(degrees.to_radians(), 1.0, -1.0, -2.0).map(|_| ())
                }
            };
            volume.is_ok() && Camera::look_at(view.eye, view.target, view.up).is_ok()
        })
}

fn light() -> impl Strategy<Value = Light> {
    prop_oneof![
        color(0.0..=2.0).prop_map(|color| Light::Ambient { color }),
        (direction(), color(0.0..=2.0)).prop_map(|(to_light, color)| Light::Directional { to_light, color }),
        (point(), color(0.0..=2.0)).prop_map(|(position, color)| Light::Point { position, color }),
    ]
}

fn surface() -> impl Strategy<Value = Surface> {
    let share = || color(0.0..=1.0);
    let optics = prop_oneof![
        Just(Optics::Opaque),
        share().prop_map(|reflectance| Optics::Mirror { reflectance }),
        (1.0_f32..3.0, share())
            .prop_map(|(refractive_index, transmittance)| Optics::Glass { refractive_index, transmittance }),
        (0.0_f32..=1.0).prop_map(|opacity| Optics::Dissolved { opacity }),
    ];
    let exponent = prop_oneof![0.0_f32..300.0, 1e3_f32..=4096.0, Just(0.0)];
    (share(), share(), exponent, optics).prop_map(|(diffuse, specular, exponent, optics)| Surface {
        material: Material { diffuse, specular, exponent },
        optics,
    })
}

fn object(names: Vec<String>) -> impl Strategy<Value = Object> {
    let material = if names.is_empty() { Just(None).boxed() } else { option::of(select(names)).boxed() };
    let copies = prop_oneof![Just(Vec::new()), vec(vec(transform(), 0..3), 1..4)];
    (shape(), material, vec(transform(), 0..4), copies, 0.0_f32..=180.0).prop_map(
        |(shape, material, transforms, instances, crease_degrees)| Object {
            shape,
            material,
            transforms,
            instances,
            crease_degrees,
        },
    )
}

fn shape() -> impl Strategy<Value = Shape> {
    let level = || 0_u32..=3;
    let polygon = vec(point(), 3..6);
    prop_oneof![
        (length(), level()).prop_map(|(radius, level)| Shape::Sphere { radius, level }),
        (length(), level()).prop_map(|(radius, level)| Shape::UvSphere { radius, level }),
        (length(), level()).prop_map(|(radius, level)| Shape::Icosphere { radius, level }),
        (length(), level()).prop_map(|(radius, level)| Shape::Disc { radius, level }),
        (length(), length(), length(), level())
            .prop_map(|(x, y, z, level)| Shape::Cuboid { size: vec3(x, y, z), level }),
        (length(), 0.1_f32..0.9, level())
            .prop_map(|(major, share, level)| Shape::Torus { major, minor: share * major, level })
            .prop_filter("too thin", |shape| !matches!(shape, Shape::Torus { minor, .. } if *minor < 1e-9)),
        (0_u32..=1).prop_map(|level| Shape::Teapot { level }),
        vec(polygon, 1..4).prop_map(|polygons| Shape::Polygons { polygons }),
        ("[a-zé \"]{1,5}", any::<bool>()).prop_map(|(stem, fit)| Shape::Obj { path: stem + ".obj", fit }),
    ]
}

fn transform() -> impl Strategy<Value = Transform> {
    let factor = || prop_oneof![0.2_f32..3.0, -3.0_f32..-0.2];
    prop_oneof![
        point().prop_map(Transform::Translate),
        (factor(), factor(), factor()).prop_map(|factors| Transform::Scale(Vec3::from(factors))),
        (-400.0_f32..400.0, direction()).prop_map(|(degrees, axis)| Transform::Rotate { degrees, axis }),
    ]
}

fn settings() -> impl Strategy<Value = Settings> {
    fn any_of<T: Named + std::fmt::Debug>() -> impl Strategy<Value = T> {
        select(T::ALL).prop_map(|(_, choice)| choice)
    }
    let names = (
        any_of::<Renderer>(),
        any_of::<Shading>(),
        any_of::<Show>(),
        any_of::<Highlight>(),
        any_of::<DepthFormat>(),
    );
    let numbers = ((1_u32..5000, 1_u32..5000), 1_u32..=16, any::<bool>(), 0_u32..=64);
    (names, numbers).prop_map(
        |((renderer, shading, show, highlight, depth_bits), (size, samples, shadows, max_depth))| Settings {
            renderer,
            shading,
            size,
            show,
            samples,
            shadows,
            max_depth,
            highlight,
            depth_bits,
        },
    )
}

/// The empty scene is the smallest; it has no materials, and so on.
#[test]
fn the_empty_scene_is_drawn_in_its_background_colour() {
    let scene = Scene {
        camera: View {
            eye: vec3(1.0, 2.0, 8.0),
            target: Vec3::ZERO,
            up: Vec3::Y,
            lens: Lens::FieldOfView { degrees: 40.0, near: None, far: None },
        },
        background: vec3(0.25, 0.5, 0.75),
        lights: Vec::new(),
        materials: BTreeMap::new(),
        objects: Vec::new(),
        settings: Settings { size: (5, 3), ..Settings::default() },
    };
    let prepared = prepare(&Loaded::from_scene(&scene, "".as_ref()).unwrap()).unwrap();
    for (name, renderer) in Renderer::ALL {
        let image =
            render(&prepared, &Settings { renderer: *renderer, ..scene.settings }, &|_| ()).unwrap().image;
        assert!(image.pixels().iter().all(|pixel| *pixel == scene.background), "{name}");
    }
}
