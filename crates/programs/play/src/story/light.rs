//! Which light reaches what the ray hit, and what colour comes of it (L56, L57)?

use canvas::Rgb;
use lighting::Light;
use raytrace::color::shows_light;
use raytrace::shadow::{light_share, shadow_ray};
use raytrace::{Hit, Interpolation, Optics, Ray, Search, nearest, ray_color};
use serde_json::{Value as Json, json};
use sheet::Words;

use super::json::{number, vector, words};
use super::rays::{Cast, is_mesh};
use super::subject::{Subject, Weighted, name_of_light};
use super::terms::Lit;

/// The light on what the ray hit.
pub(super) struct OnHit {
    /// What the ray sees, linear.
    pub(super) color: Rgb,
    /// What of each light arrives.
    pub(super) shares: Vec<Rgb>,
    pub(super) shadows: Vec<Shadow>,
    points: Vec<Weighted>,
}

/// A ray towards a light.
pub(super) struct Shadow {
    pub(super) light: Words,
    pub(super) ray: Ray,
    /// How far the light is; infinite for one without a place.
    pub(super) distance: f32,
    pub(super) met: Option<Hit>,
    pub(super) share: Rgb,
}

/// Asks for the light on what the ray hit.
pub(super) fn on_hit(subject: &Subject, cast: &Cast) -> OnHit {
    let (world, ray, (t0, t1)) = (&subject.world, &cast.ray, cast.interval);
    let color = ray_color(world, ray, t0, t1, &subject.rays());
    let mut all =
        OnHit { color, shares: vec![Rgb::ONE; world.lights.len()], shadows: Vec::new(), points: Vec::new() };
    let Some(hit) = &cast.hit else { return all };
    all.points = world.lighting_points(ray, hit);
    for (k, light) in world.lights.iter().enumerate() {
        if !subject.settings.shadows || is_behind(light, &all.points) {
            continue;
        }
        let Some(arriving) = light.illumination(hit.point) else { continue };
        let share = light_share(world, ray, hit, &arriving, Search::Hierarchy);
        let shadow = shadow_ray(world, ray, hit, &arriving);
        let met = nearest(world, &shadow, 0.0, arriving.distance);
        all.shares[k] = share;
        let light = name_of_light(k, light);
        all.shadows.push(Shadow { light, ray: shadow, distance: arriving.distance, met, share });
    }
    all
}

/// Whether a light stands behind the surface wherever the lighting model is evaluated: then no ray is sent.
fn is_behind(light: &Light, points: &[Weighted]) -> bool {
    let faces = |(at, _): &Weighted| {
        light.illumination(at.p_world).is_some_and(|light| lighting::lambert(at.n, light.to_light) > 0.0)
    };
    !points.iter().any(faces)
}

impl OnHit {
    /// The terms of the colour, with what mirrors and glass add; nothing for the background.
    pub(super) fn shading(&self, subject: &Subject, cast: &Cast) -> Json {
        let Some(hit) = &cast.hit else { return Json::Null };
        let world = &subject.world;
        let surface = world.surface(hit);
        let side = if hit.is_front(&cast.ray) { 1.0 } else { -1.0 };
        let n = side * world.shading_normal(hit);
        let to_eye = (cast.ray.origin - hit.point).normalize_or(n);
        let lit = Lit {
            place: lighting::SurfacePoint { p_world: hit.point, n, to_eye },
            mode: mode(subject, hit),
            points: &self.points,
            material: &surface.material,
            lights: if shows_light(world, &cast.ray, hit) { &world.lights } else { &[] },
            highlight: world.highlight,
            shares: &self.shares,
        };
        let (mut told, local) = lit.told();
        if let Some(term) = beyond(surface.optics, self.color - local) {
            if let Some(terms) = told["terms"].as_array_mut() {
                terms.push(term);
            }
            told["sum"] = vector(self.color);
        }
        told
    }

    /// The shadow rays as the page shows them.
    pub(super) fn told(&self, subject: &Subject) -> Json {
        self.shadows.iter().map(|shadow| shadow.told(subject)).collect()
    }
}

fn mode(subject: &Subject, hit: &Hit) -> Words {
    if !is_mesh(subject, hit) {
        return Words::new(
            "An exact ball: its own normal, at the point itself, whatever the shading.",
            "Een exacte bol: zijn eigen normaal, in het punt zelf, welke shading ook.",
        );
    }
    match subject.world.interpolation {
        Interpolation::Flat => Words::new(
            "Flat shading: the triangle's centroid and its own normal; the shadow is that of the point itself.",
            "Flat shading: het zwaartepunt van de driehoek en zijn eigen normaal; de schaduw is die van het punt zelf.",
        ),
        Interpolation::Gouraud => Words::new(
            "Gouraud shading: colours at the three corners, interpolated; the shadow is that of the point itself.",
            "Gouraud shading: kleuren in de drie hoekpunten, geïnterpoleerd; de schaduw is die van het punt zelf.",
        ),
        Interpolation::Phong => Words::new(
            "Phong shading: the normal is interpolated and brought back to unit length.",
            "Phong shading: de normaal is geïnterpoleerd en weer op lengte 1 gebracht.",
        ),
    }
}

/// What the rays add that a mirror or glass gives rise to.
fn beyond(optics: Optics, value: Rgb) -> Option<Json> {
    let (name, formula) = match optics {
        Optics::Opaque => return None,
        Optics::Mirror { .. } => (
            Words::new("mirror: what the reflected ray sees", "spiegel: wat de teruggekaatste straal ziet"),
            "k_m raycolor(p + t·r)",
        ),
        Optics::Glass { .. } => (
            Words::new(
                "glass: what the reflected and the refracted ray see",
                "glas: wat de teruggekaatste en de gebroken straal zien",
            ),
            "R raycolor(p + t·r) + (1 − R) k_t raycolor(p + t·d′)",
        ),
        Optics::Dissolved { .. } => (
            Words::new("half transparent: what lies behind", "halfdoorzichtig: wat erachter ligt"),
            "(1 − α) (raycolor(p + t·d) − local)",
        ),
    };
    let numbers = Words::new("raycolor minus the local light", "raycolor min het lokale licht");
    Some(
        json!({ "name": words(&name), "formula": formula, "numbers": words(&numbers), "value": vector(value) }),
    )
}

impl Shadow {
    /// Whether all of the light arrives.
    pub(super) fn is_lit(&self) -> bool {
        self.share == Rgb::ONE
    }

    fn told(&self, subject: &Subject) -> Json {
        json!({
            "light": words(&self.light),
            "origin": vector(self.ray.origin),
            "direction": vector(self.ray.direction),
            "distance": number(self.distance),
            "met": words(&self.met_what(subject)),
            "at": self.met.as_ref().map(|met| vector(met.point)),
            "share": vector(self.share),
            "lit": self.is_lit(),
        })
    }

    fn met_what(&self, subject: &Subject) -> Words {
        let Some(met) = &self.met else {
            return Words::new("nothing: lit", "niets: verlicht");
        };
        let name = if is_mesh(subject, met) {
            subject.names.triangle(met.object, met.triangle)
        } else {
            subject.names.object(met.object)
        };
        let (t, share) = (sheet::text::decimal(met.t, 3), super::json::triple(self.share));
        if self.share == Rgb::ZERO {
            Words::new(
                format!("{} at distance {t}: in shadow", name.en),
                format!("{} op afstand {t}: in de schaduw", name.nl),
            )
        } else {
            Words::new(
                format!("{} at distance {t}, clear: {share} of the light gets through", name.en),
                format!("{} op afstand {t}, doorzichtig: {share} van het licht komt erdoor", name.nl),
            )
        }
    }
}
