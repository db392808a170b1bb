//! Why do the two loops differ at a pixel? Each reason is looked for, and given with its numbers.

use canvas::Rgb;
use raytrace::{Optics, ray_color};
use scene::Named;
use shading::Shading;
use sheet::Words;
use sheet::text::{decimal, degrees};

use super::json::steps_of;
use super::light::OnHit;
use super::rays::{Cast, is_mesh};
use super::subject::Subject;
use super::zbuffer::{Loop, Shown, Test};

/// Two colours count as one if no channel is more than so many of the 256 steps apart: light that two programs add up in
/// different order can round to neighbouring steps.
const SAME_STEPS: u8 = 1;

/// Radians: normals less than a tenth of a degree apart are no reason.
const LEAST_ANGLE: f32 = 1.7e-3;

/// Whether both loops show one surface in one colour, and if not, why.
pub(super) fn compared(
    subject: &Subject,
    rasterized: &Loop,
    cast: &Cast,
    light: &OnHit,
) -> (bool, Vec<Words>) {
    let same_color = apart(rasterized.color, light.color) <= SAME_STEPS;
    let same_surface = match (&rasterized.shown, &cast.hit) {
        (None, None) => true,
        (Some(shown), Some(hit)) => {
            let triangles = is_mesh(subject, hit);
            shown.object == hit.object && (!triangles || shown.triangle == hit.triangle)
        }
        _ => false,
    };
    if same_surface && same_color {
        return (true, Vec::new());
    }
    let mut why = Vec::new();
    if !same_surface {
        why.extend(of_surfaces(subject, rasterized, cast));
    }
    if !same_color {
        why.extend(of_colors(subject, rasterized, cast, light));
    }
    if why.is_empty() {
        why.push(Words::new(
            "Rounding: the z-buffer moves corners to 1/256 pixel, the ray tracer does not.",
            "Afronding: de z-buffer verplaatst hoekpunten naar 1/256 pixel, de raytracer niet.",
        ));
    }
    (false, why)
}

/// How many 8-bit steps two colours are apart, at most.
fn apart(a: Rgb, b: Rgb) -> u8 {
    let (a, b) = (steps_of(a), steps_of(b));
    (0..3).map(|k| a[k].abs_diff(b[k])).max().unwrap_or(0)
}

/// Another surface, or a surface against the background.
fn of_surfaces(subject: &Subject, rasterized: &Loop, cast: &Cast) -> Vec<Words> {
    let objects =
        [rasterized.shown.as_ref().map(|shown| shown.object), cast.hit.as_ref().map(|hit| hit.object)];
    let ball = objects
        .into_iter()
        .flatten()
        .find(|object| !matches!(subject.world.objects()[*object].shape(), raytrace::Shape::Mesh(_)));
    let mut why = Vec::new();
    if let Some(ball) = ball {
        let name = subject.names.object(ball);
        why.push(Words::new(
            format!("The ray tracer has {} exactly; the z-buffer has triangles whose corners lie on it, so its outline is a little smaller.", name.en),
            format!("De raytracer heeft {} exact; de z-buffer heeft driehoeken met de hoekpunten erop, dus een iets kleinere omtrek.", name.nl),
        ));
    }
    why.extend(depth_tie(rasterized, cast));
    why.extend(edge(rasterized, cast));
    why.extend(planes(cast));
    why
}

/// The test of the triangle that the ray hit, at this pixel.
fn test_of_hit<'a>(rasterized: &'a Loop, cast: &Cast) -> Option<&'a Test> {
    let hit = cast.hit.as_ref()?;
    rasterized.tests.iter().find(|test| (test.object, test.triangle) == (hit.object, hit.triangle))
}

/// Both triangles cover the pixel, and are equally deep there.
fn depth_tie(rasterized: &Loop, cast: &Cast) -> Option<Words> {
    let (ours, theirs) =
        (rasterized.shown.as_ref()?.fragment.z, test_of_hit(rasterized, cast)?.sample.fragment?.z);
    // A few steps of the f32s that the buffer stores.
    let tie = (ours - theirs).abs() <= 16.0 * f64::from(f32::EPSILON);
    let difference = format!("{:.1e}", ours - theirs);
    tie.then(|| {
        Words::new(
            format!("Two surfaces are equally near, to within rounding (z differs by {difference}): the first drawn stays, and the ray tracer's rounding may choose the other."),
            format!("Twee oppervlakken zijn even dichtbij, op afronding na (z verschilt {difference}): wat het eerst getekend is blijft, en de afronding van de raytracer kan de andere kiezen."),
        )
    })
}

/// A sample on or beside an edge.
fn edge(rasterized: &Loop, cast: &Cast) -> Option<Words> {
    // One of the two triangles, seen by the other loop as a miss.
    let shown = rasterized.shown.as_ref();
    let ray_misses_shown = shown.is_some_and(|shown| {
        !cast
            .met
            .iter()
            .any(|met| (met.object as usize, met.triangle as usize) == (shown.object, shown.triangle))
    });
    let test = test_of_hit(rasterized, cast);
    let pixel_misses_hit = cast.hit.is_some() && test.is_none_or(|test| test.sample.fragment.is_none());
    if !ray_misses_shown && !pixel_misses_hit {
        return None;
    }
    let of_shown = shown.and_then(|shown| {
        rasterized.tests.iter().find(|test| (test.object, test.triangle) == (shown.object, shown.triangle))
    });
    let on_edge = [of_shown, test].into_iter().flatten().any(|test| test.sample.edges.contains(&0));
    Some(if on_edge {
        Words::new(
            "The pixel's centre lies exactly on an edge: the top-left rule gives it to one triangle, the ray tracer's watertight test to another.",
            "Het midden van de pixel ligt precies op een rand: de top-left-regel geeft hem aan de ene driehoek, de waterdichte test van de raytracer aan de andere.",
        )
    } else {
        Words::new(
            "The pixel's centre lies beside an edge: the z-buffer moves corners to 1/256 pixel, the ray tracer leaves them where they are.",
            "Het midden van de pixel ligt vlak bij een rand: de z-buffer verplaatst hoekpunten naar 1/256 pixel, de raytracer laat ze waar ze zijn.",
        )
    })
}

/// A surface that lies in the near or in the far plane, to within rounding.
fn planes(cast: &Cast) -> Option<Words> {
    let (t0, t1) = cast.interval;
    let at = |t: f32, plane: f32| (t - plane).abs() <= 16.0 * f32::EPSILON * plane;
    let met = cast.met.iter().find(|met| at(met.t, t0) || at(met.t, t1))?;
    let t = decimal(met.t, 6);
    Some(Words::new(
        format!(
            "A surface lies in the near or far plane (t = {t}): clipping and the test of t round differently."
        ),
        format!(
            "Een oppervlak ligt in het near- of far-vlak (t = {t}): clippen en de test van t ronden anders af."
        ),
    ))
}

/// One surface, two colours.
fn of_colors(subject: &Subject, rasterized: &Loop, cast: &Cast, light: &OnHit) -> Vec<Words> {
    let (Some(shown), Some(hit)) = (&rasterized.shown, &cast.hit) else { return Vec::new() };
    let mut why = Vec::new();
    let (t0, t1) = cast.interval;
    let unshadowed = raytrace::Settings { shadows: false, ..subject.rays() };
    let without_shadows = ray_color(&subject.world, &cast.ray, t0, t1, &unshadowed);
    if apart(without_shadows, light.color) > 0 {
        for shadow in light.shadows.iter().filter(|shadow| !shadow.is_lit()) {
            why.push(Words::new(
                format!("Shadow: {} does not reach the point; only the ray tracer asks.", shadow.light.en),
                format!(
                    "Schaduw: {} bereikt het punt niet; alleen de raytracer vraagt dat.",
                    shadow.light.nl
                ),
            ));
        }
    }
    match subject.world.surface(hit).optics {
        Optics::Opaque => {}
        Optics::Mirror { .. } => why.push(Words::new(
            "A mirror: only the ray tracer follows the reflected ray.",
            "Een spiegel: alleen de raytracer volgt de teruggekaatste straal.",
        )),
        Optics::Glass { .. } => why.push(Words::new(
            "Glass: only the ray tracer follows the reflected and the refracted ray.",
            "Glas: alleen de raytracer volgt de teruggekaatste en de gebroken straal.",
        )),
        Optics::Dissolved { .. } => why.push(Words::new(
            "Half transparent: only the ray tracer shows what lies behind.",
            "Halfdoorzichtig: alleen de raytracer toont wat erachter ligt.",
        )),
    }
    if !is_mesh(subject, hit) && shown.object == hit.object {
        why.extend(ball_normal(subject, shown, cast));
    }
    why
}

/// The exact ball's normal against that of its triangles.
fn ball_normal(subject: &Subject, shown: &Shown, cast: &Cast) -> Option<Words> {
    let hit = cast.hit.as_ref()?;
    let n = subject.world.shading_normal(hit);
    let angle = n.angle_between(shown.place.n);
    let turned = |light: &&lighting::Light| {
        let faces = |p, n| {
            let arriving = light.illumination(p);
            arriving.is_some_and(|light| lighting::lambert(n, light.to_light) > 0.0)
        };
        faces(hit.point, n) != faces(shown.place.p_world, shown.place.n)
    };
    let behind = subject.world.lights.iter().any(|light| turned(&light));
    let shading = subject.settings.shading;
    if shading == Shading::Phong && angle < LEAST_ANGLE && !behind {
        return None;
    }
    let (angle, name) = (degrees(angle), shading.name());
    let (mut en, mut nl) = (
        format!(
            "The ray tracer has the exact ball and lights each point with its own normal; the z-buffer's triangles have {name} shading, with a normal {angle} off here."
        ),
        format!(
            "De raytracer heeft de exacte bol en belicht elk punt met zijn eigen normaal; de driehoeken van de z-buffer hebben {name} shading, met een normaal die hier {angle} afwijkt."
        ),
    );
    if shading == Shading::Gouraud {
        en += " They interpolate the colours of their corners.";
        nl += " Die interpoleren de kleuren van hun hoekpunten.";
    }
    if behind {
        en += " One of the two normals turns away from a light that the other faces.";
        nl += " De ene normaal keert zich af van een lichtbron die de andere ziet.";
    }
    Some(Words::new(en, nl))
}
