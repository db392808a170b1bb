//! Which exercises draw a figure, and how? One table.

use course::Exercise;
use figures::Figure;

use super::knobs::Knobs;
use super::panel::Panel;
use super::{light, rays, screen, smooth};

/// The figures by name, and the exercises whose functions draw them.
const TABLE: &[(&str, &[&str])] = &[
    ("viewing-volume", &["perspective", "canonical_from_camera"]),
    ("camera-frame", &["camera_frame", "camera_from_world", "change_of_basis", "change_of_basis_inverse"]),
    (
        "stages",
        &[
            "camera_from_world",
            "canonical_from_camera",
            "perspective",
            "screen_from_canonical",
            "change_of_basis",
            "rotate_about_point",
        ],
    ),
    ("pixel-grid", &["window_from_pixel", "screen_from_canonical"]),
    ("rotation-about-a-point", &["rotate_about_point"]),
    ("cycle", &["painters_order"]),
    ("two-spheres", &["painters_order", "zbuffer"]),
    ("depth-grids", &["zbuffer", "rasterize"]),
    ("z-fighting", &["depth_at"]),
    ("depth-on-screen", &["depth_at", "perspective"]),
    ("depth-step", &["perspective"]),
    ("barycentric-plane", &["barycentric", "covers"]),
    ("two-loops", &["rasterize", "nearest_hit", "ray_color"]),
    ("lambert", &["lambert"]),
    ("facing-away", &["lambert", "ambient_and_diffuse"]),
    ("apple", &["phong_highlight"]),
    ("first-attempt", &["reflection", "phong_highlight"]),
    ("exponent-strip", &["phong_highlight"]),
    ("phong-geometry", &["reflection", "phong_highlight"]),
    ("halfway-vector", &["halfway", "blinn_phong"]),
    ("highlight-width", &["blinn_phong", "phong_highlight"]),
    ("components", &["ambient_and_diffuse", "light_all"]),
    ("flat-and-gouraud", &["face_normal", "gouraud"]),
    ("octagon", &["vertex_normals"]),
    ("normal-error", &["vertex_normals"]),
    ("coarse-spheres", &["phong_shading", "gouraud"]),
    ("cornell-box", &["nearest_hit", "ray_sphere"]),
    ("shadow-puzzles", &["in_shadow"]),
    ("viewing-ray", &["viewing_ray", "ray_sphere"]),
    ("worked-example", &["ray_triangle", "ray_triangle_system"]),
    ("shadow-rays", &["in_shadow"]),
    ("shadows", &["in_shadow", "ray_color"]),
    ("mirrors-and-glass", &["ray_color_recursive", "refract"]),
];

/// The exercises that draw a figure, in the order of the course.
pub(super) fn exercises_of(figure: &Figure) -> Vec<&'static Exercise> {
    let names = TABLE.iter().find(|(name, _)| *name == figure.name).map_or(&[][..], |(_, names)| names);
    names.iter().filter_map(|name| course::find(name)).collect()
}

/// The pictures that an exercise's function makes pixel by pixel; none where a drawing of lines says more.
pub(super) fn panels(exercise: &Exercise, knobs: &Knobs<'_>) -> Vec<Panel> {
    let panels: fn(&Knobs<'_>) -> Vec<Panel> = match exercise.name {
        "lambert" => light::lambert,
        "ambient_and_diffuse" => light::ambient_and_diffuse,
        "reflection" => light::reflection,
        "phong_highlight" => light::phong_highlight,
        "halfway" => light::halfway,
        "blinn_phong" => light::blinn_phong,
        "light_all" => light::light_all,
        "gouraud" => smooth::gouraud,
        "phong_shading" => smooth::phong_shading,
        "face_normal" => smooth::face_normal,
        "vertex_normals" => smooth::vertex_normals,
        "covers" => screen::covers,
        "rasterize" => screen::rasterize,
        "barycentric" => screen::barycentric,
        "depth_at" => screen::depth_at,
        "zbuffer" => screen::zbuffer,
        "painters_order" => screen::painters_order,
        "ray_sphere" => rays::ray_sphere,
        "ray_triangle" => rays::ray_triangle,
        "ray_triangle_system" => rays::ray_triangle_system,
        "nearest_hit" => rays::nearest_hit,
        "in_shadow" => rays::in_shadow,
        "ray_color" => rays::ray_color,
        "ray_color_recursive" => rays::ray_color_recursive,
        "viewing_ray" => rays::viewing_ray,
        _ => return Vec::new(),
    };
    panels(knobs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_exercise_draws_a_figure() {
        let missing: Vec<&str> = course::all()
            .iter()
            .filter(|exercise| !TABLE.iter().any(|(_, names)| names.contains(&exercise.name)))
            .map(|exercise| exercise.name)
            .collect();
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn every_name_of_the_table_means_something() {
        for (figure, names) in TABLE {
            assert!(figures::all().iter().any(|known| known.name == *figure), "{figure}");
            for name in *names {
                assert!(course::find(name).is_some(), "{figure}: {name}");
            }
        }
    }
}
