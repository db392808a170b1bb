//! Which triangles did the z-buffer's loop test at the pixel, and which of them stayed (L16)?

use canvas::Rgb;
use lighting::{Material, SurfacePoint};
use serde_json::{Value as Json, json};
use shading::{Facet, Shading, Surface};
use sheet::Words;
use sheet::text::decimal;
use zbuffer::sample::{Sample, sample};
use zbuffer::{DepthBuffer, DepthFormat, Fragment, project};

use super::json::{bytes, count, number, words};
use super::subject::{Subject, Weighted};
use super::terms::Lit;

/// What the loop did at the pixel.
pub(super) struct Loop {
    scene: usize,
    clipped: usize,
    beside: usize,
    pub(super) tests: Vec<Test>,
    /// What the pixel shows in the end; nothing for the background.
    pub(super) shown: Option<Shown>,
    /// Its colour, linear.
    pub(super) color: Rgb,
}

/// A triangle, or what clipping left of it, that was tested at the pixel.
pub(super) struct Test {
    /// Its place in drawing order, from 1.
    order: usize,
    pub(super) object: usize,
    pub(super) triangle: usize,
    pub(super) sample: Sample,
    /// What the buffer held before.
    before: Option<f32>,
    /// Whether it was drawn.
    nearer: bool,
}

/// The surface that the pixel shows.
pub(super) struct Shown {
    pub(super) object: usize,
    pub(super) triangle: usize,
    pub(super) fragment: Fragment,
    pub(super) place: SurfacePoint,
    points: Vec<Weighted>,
    material: Material,
}

/// The slide's loop, for one pixel.
pub(super) fn looped(subject: &Subject) -> Loop {
    subject.prepared.in_world(&subject.settings, |world| looped_over(subject, world))
}

fn looped_over(subject: &Subject, world: &shading::World) -> Loop {
    let Subject { pipeline, settings, i, j, .. } = subject;
    let (width, height) = (pipeline.width(), pipeline.height());
    let (clip_from_world, lighting) = (pipeline.clip_from_world(), world.lighting(pipeline));
    // The buffer of this pixel alone.
    let mut depth = DepthBuffer::new(1, 1, DepthFormat::F32);
    let mut all =
        Loop { scene: 0, clipped: 0, beside: 0, tests: Vec::new(), shown: None, color: world.background };
    for (index, object) in world.objects.iter().enumerate() {
        for triangle in 0..object.mesh.len() {
            all.scene += 1;
            let facet = Facet::new(object, triangle, lighting.eye);
            let left = project(&clip_from_world, width, height, &facet.corners);
            if left.vertices().is_empty() {
                all.clipped += 1;
                continue;
            }
            let mut is_beside = true;
            for sample in left.triangles().filter_map(|part| sample(&part, *i, *j)) {
                is_beside = false;
                let before = depth.get(0, 0);
                let drawn = sample.fragment.filter(|fragment| depth.test_and_set(0, 0, fragment.z));
                if let Some(fragment) = drawn {
                    let surface = Surface::new(settings.shading, facet, lighting);
                    all.color = surface.color(fragment.weights);
                    all.shown = Some(Shown::new(&surface, &facet, lighting, (index, triangle), fragment));
                }
                let (order, nearer) = (all.scene, drawn.is_some());
                all.tests.push(Test { order, object: index, triangle, sample, before, nearer });
            }
            all.beside += usize::from(is_beside);
        }
    }
    all
}

impl Shown {
    fn new(
        surface: &Surface,
        facet: &Facet,
        lighting: shading::Lighting,
        (object, triangle): (usize, usize),
        fragment: Fragment,
    ) -> Self {
        let weights = fragment.weights;
        let place = lighting.surface_point(facet.corners.point(weights), surface.normal(weights));
        let points = surface.lighting_points(weights);
        Self { object, triangle, fragment, place, points, material: facet.material }
    }
}

impl Loop {
    /// The loop as the page shows it.
    pub(super) fn told(&self, subject: &Subject) -> Json {
        json!({
            "color": bytes(self.color),
            "linear": super::json::vector(self.color),
            "summary": words(&self.summary(subject)),
            "counts": self.counts(),
            "tests": self.tests.iter().map(|test| test.told(subject)).collect::<Vec<_>>(),
            "visible": self.shown.as_ref().map(|shown| json!({
                "object": shown.object,
                "triangle": shown.triangle,
                "z": number(shown.fragment.z as f32),
            })),
            "shading": self.shown.as_ref().map(|shown| self.shading(subject, shown)),
        })
    }

    fn summary(&self, subject: &Subject) -> Words {
        let (tested, drawn) = (self.tests.len(), self.tests.iter().filter(|test| test.nearer).count());
        let Some(shown) = &self.shown else {
            return Words::new(
                format!(
                    "Of {} triangles {tested} were tested here and none covers the pixel: it shows the background.",
                    self.scene
                ),
                format!(
                    "Van {} driehoeken zijn er hier {tested} getest en geen bedekt de pixel: hij toont de achtergrond.",
                    self.scene
                ),
            );
        };
        let name = subject.names.triangle(shown.object, shown.triangle);
        let z = decimal(shown.fragment.z as f32, 5);
        Words::new(
            format!(
                "Of {} triangles {tested} were tested here and {drawn} drawn; the last of these stays: {}, z = {z}.",
                self.scene, name.en
            ),
            format!(
                "Van {} driehoeken zijn er hier {tested} getest en {drawn} getekend; de laatste daarvan blijft: {}, z = {z}.",
                self.scene, name.nl
            ),
        )
    }

    fn counts(&self) -> Vec<Json> {
        let inside = self.tests.iter().filter(|test| test.sample.fragment.is_some()).count();
        let drawn = self.tests.iter().filter(|test| test.nearer).count();
        [
            (Words::new("triangles in the scene", "driehoeken in de scène"), self.scene),
            (
                Words::new("clipped away: outside the viewing volume", "weggeknipt: buiten het zichtvolume"),
                self.clipped,
            ),
            (Words::new("their box does not hold the pixel", "hun kader bevat de pixel niet"), self.beside),
            (Words::new("tested at this pixel", "getest op deze pixel"), self.tests.len()),
            (Words::new("the pixel's centre is inside", "het midden van de pixel ligt erin"), inside),
            (
                Words::new(
                    "nearer than the stored depth: drawn",
                    "dichterbij dan de opgeslagen diepte: getekend",
                ),
                drawn,
            ),
        ]
        .map(|(what, n)| count(&what, n))
        .to_vec()
    }

    fn shading(&self, subject: &Subject, shown: &Shown) -> Json {
        let mode = match subject.settings.shading {
            Shading::Flat => Words::new(
                "Flat shading: one colour a triangle, at its centroid, with its own normal.",
                "Flat shading: één kleur per driehoek, in het zwaartepunt, met zijn eigen normaal.",
            ),
            Shading::Gouraud => Words::new(
                "Gouraud shading: colours at the three corners, interpolated.",
                "Gouraud shading: kleuren in de drie hoekpunten, geïnterpoleerd.",
            ),
            Shading::Phong => Words::new(
                "Phong shading: the normal is interpolated and brought back to unit length.",
                "Phong shading: de normaal is geïnterpoleerd en weer op lengte 1 gebracht.",
            ),
        };
        let lights = subject.prepared.lights();
        let lit = Lit {
            place: shown.place,
            mode,
            points: &shown.points,
            material: &shown.material,
            lights,
            highlight: subject.settings.highlight,
            // Nothing casts a shadow: the lighting is local (L35).
            shares: &vec![Rgb::ONE; lights.len()],
        };
        lit.told().0
    }
}

impl Test {
    fn told(&self, subject: &Subject) -> Json {
        let Sample { edges, owns, screen_weights, fragment } = self.sample;
        let weights = fragment.map(|fragment| super::json::vector(fragment.weights.to_vec3()));
        json!({
            "order": self.order,
            "object": self.object,
            "triangle": self.triangle,
            "name": words(&subject.names.triangle(self.object, self.triangle)),
            "edges": edges,
            "owns": owns,
            "inside": fragment.is_some(),
            "screen_weights": screen_weights,
            "weights": weights,
            "z": fragment.map(|fragment| number(fragment.z as f32)),
            "before": self.before.map(number),
            "nearer": fragment.map(|_| self.nearer),
            "words": words(&self.words()),
        })
    }

    /// Edges on which the pixel's centre lies exactly, as the tie rule sees them.
    fn rule(&self) -> Words {
        const EDGES: [&str; 3] = ["bc", "ca", "ab"];
        let on_edge = |k: &usize| self.sample.edges[*k] == 0;
        let rules = (0..3).filter(on_edge).map(|k| {
            let edge = EDGES[k];
            if self.sample.owns[k] {
                Words::new(
                    format!(" The centre lies exactly on {edge}, a left or top edge: it belongs to this triangle."),
                    format!(" Het midden ligt precies op {edge}, een linker- of bovenrand: het hoort bij deze driehoek."),
                )
            } else {
                Words::new(
                    format!(" The centre lies exactly on {edge}, neither a left nor a top edge: it belongs to the neighbour."),
                    format!(" Het midden ligt precies op {edge}, geen linker- of bovenrand: het hoort bij de buur."),
                )
            }
        });
        rules.fold(Words::new("", ""), |all, rule| Words::new(all.en + &rule.en, all.nl + &rule.nl))
    }

    fn words(&self) -> Words {
        let rule = self.rule();
        let z = |z: f64| decimal(z as f32, 5);
        let words = match (self.sample.fragment, self.before) {
            (None, _) => {
                const EDGES: [&str; 3] = ["bc", "ca", "ab"];
                let outside = (0..3).filter(|k| self.sample.edges[*k] < 0).map(|k| EDGES[k]);
                let outside: Vec<&str> = outside.collect();
                match outside.as_slice() {
                    [] => Words::new("Not inside.", "Niet erin."),
                    edges => Words::new(
                        format!("Outside: on the outer side of {}.", edges.join(", ")),
                        format!("Erbuiten: aan de buitenkant van {}.", edges.join(", ")),
                    ),
                }
            }
            (Some(f), None) => Words::new(
                format!("Inside; the first here, z = {}: drawn.", z(f.z)),
                format!("Erin; de eerste hier, z = {}: getekend.", z(f.z)),
            ),
            (Some(f), Some(before)) if self.nearer => Words::new(
                format!("Inside; z = {} > {}: nearer, drawn.", z(f.z), z(before.into())),
                format!("Erin; z = {} > {}: dichterbij, getekend.", z(f.z), z(before.into())),
            ),
            (Some(f), Some(before)) => Words::new(
                format!("Inside; z = {} ≤ {}: not nearer, not drawn.", z(f.z), z(before.into())),
                format!("Erin; z = {} ≤ {}: niet dichterbij, niet getekend.", z(f.z), z(before.into())),
            ),
        };
        Words::new(words.en + &rule.en, words.nl + &rule.nl)
    }
}
