//! What did the viewing ray meet, when every triangle was asked in turn (L43, L53)?

mod entry;

use std::cmp::Ordering;

use geometry::{Ray, Triangle};
use raytrace::triangle::{Exit, Solution, cramer, raytri_or_exit, system};
use raytrace::{Hit, HitRecord, Shape, all_met, nearest};
use serde_json::{Value as Json, json};
use sheet::Words;
use sheet::text::decimal;

use super::json::{count, number, vector, words};
use super::subject::Subject;
use entry::{Entry, outside};

/// So many entries are shown at most.
const MOST_SHOWN: usize = 60;

/// A triangle is near if the ray crosses its plane so little outside that no barycentric coordinate misses by more.
const NEAR: f32 = 0.5;

/// What the loop over all triangles did with the viewing ray.
pub(super) struct Cast {
    pub(super) ray: Ray,
    pub(super) interval: (f32, f32),
    /// What the pixel shows; nothing for the background.
    pub(super) hit: Option<Hit>,
    /// Everything on the ray's line.
    pub(super) met: Vec<HitRecord>,
    entries: Vec<Entry>,
    left_out: usize,
    triangles: usize,
    balls: usize,
    exits: [usize; 4],
}

/// The slide's loop with the viewing ray of the pixel.
pub(super) fn cast(subject: &Subject) -> Cast {
    let (ray, (t0, t1), world) = (subject.ray(), subject.interval(), &subject.world);
    let met = all_met(world, &ray);
    let mut cast = Cast {
        ray,
        interval: (t0, t1),
        hit: nearest(world, &ray, t0, t1),
        met: met.clone(),
        entries: Vec::new(),
        left_out: 0,
        triangles: 0,
        balls: 0,
        exits: [0; 4],
    };
    // Both lists are in the order of the loop.
    let mut met = met.into_iter().peekable();
    for (k, object) in world.objects().iter().enumerate() {
        if let Shape::Mesh(traced) = object.shape() {
            for triangle in 0..traced.mesh().len() {
                let is_this = |met: &HitRecord| (met.object as usize, met.triangle as usize) == (k, triangle);
                let hit = met.next_if(is_this);
                let Some([a, b, c]) = object.corners(triangle) else { continue };
                cast.ask((k, triangle), &Triangle::new(a, b, c), hit);
            }
        } else {
            cast.balls += 1;
            while let Some(crossing) = met.next_if(|met| met.object as usize == k) {
                cast.cross(crossing);
            }
        }
    }
    cast.leave_out();
    cast
}

impl Cast {
    /// One triangle, by the slide's test and by the watertight one.
    fn ask(&mut self, (object, k): (usize, usize), triangle: &Triangle, hit: Option<HitRecord>) {
        self.triangles += 1;
        let (t0, t1) = self.interval;
        let exit = raytri_or_exit(&self.ray, triangle, t0, t1).err();
        if let Some(exit) = exit {
            self.exits[exit as usize] += 1;
        }
        let solution = match (hit, exit) {
            (Some(met), _) => Some(Solution { beta: met.weights.beta, gamma: met.weights.gamma, t: met.t }),
            (None, Some(Exit::Parallel | Exit::T)) => None,
            (None, _) => cramer(&system(&self.ray, triangle)).filter(|solution| outside(solution) <= NEAR),
        };
        if let Some(solution) = solution {
            self.enter((object, Some(k)), solution, exit, hit.is_some());
        }
    }

    /// One crossing of an exact ball.
    fn cross(&mut self, met: HitRecord) {
        let solution = Solution { beta: 0.0, gamma: 0.0, t: met.t };
        self.enter((met.object as usize, None), solution, None, true);
    }

    fn enter(
        &mut self,
        (object, triangle): (usize, Option<usize>),
        solution: Solution,
        exit: Option<Exit>,
        is_hit: bool,
    ) {
        let (t0, t1) = self.interval;
        let before = self.entries.iter().rev().find(|entry| entry.nearer).map(|entry| entry.solution.t);
        let t = solution.t;
        let nearer = is_hit && t0 < t && t < t1 && before.is_none_or(|before| t < before);
        let order = self.triangles + self.balls;
        self.entries.push(Entry { order, object, triangle, solution, exit, is_hit, nearer, before });
    }

    /// Keeps the hits and the nearest of the misses.
    fn leave_out(&mut self) {
        let mut by_distance: Vec<usize> = (0..self.entries.len()).collect();
        let distance = |entry: &Entry| if entry.is_hit { -1.0 } else { outside(&entry.solution) };
        by_distance.sort_by(|a, b| {
            distance(&self.entries[*a]).partial_cmp(&distance(&self.entries[*b])).unwrap_or(Ordering::Equal)
        });
        let mut stays = vec![false; self.entries.len()];
        by_distance.iter().take(MOST_SHOWN).for_each(|k| stays[*k] = true);
        self.left_out = self.entries.len().saturating_sub(MOST_SHOWN);
        let mut stays = stays.into_iter();
        self.entries.retain(|_| stays.next().unwrap_or(true));
    }

    /// How the loop went, as the page shows it.
    pub(super) fn told(&self, subject: &Subject) -> Vec<(&'static str, Json)> {
        let (t0, t1) = self.interval;
        let tests: Vec<Json> = self.entries.iter().map(|entry| entry.told(subject, self.interval)).collect();
        vec![
            ("summary", words(&self.summary(subject))),
            ("ray", json!({ "origin": vector(self.ray.origin), "direction": vector(self.ray.direction) })),
            ("interval", json!([number(t0), number(t1)])),
            ("counts", Json::Array(self.counts())),
            ("tests", Json::Array(tests)),
            ("system", self.hit.as_ref().map_or(Json::Null, |hit| self.system(subject, hit))),
            ("visible", self.hit.as_ref().map_or(Json::Null, |hit| self.visible(subject, hit))),
        ]
    }

    fn visible(&self, subject: &Subject, hit: &Hit) -> Json {
        let mesh = is_mesh(subject, hit);
        json!({
            "object": hit.object,
            "triangle": mesh.then_some(hit.triangle),
            "t": number(hit.t),
            "point": vector(hit.point),
        })
    }

    fn summary(&self, subject: &Subject) -> Words {
        let Some(hit) = &self.hit else {
            return Words::new(
                "The ray meets nothing between the near and the far plane: background.",
                "De straal treft niets tussen het near- en het far-vlak: achtergrond.",
            );
        };
        let t = decimal(hit.t, 4);
        if is_mesh(subject, hit) {
            let name = subject.names.triangle(hit.object, hit.triangle);
            return Words::new(
                format!("Of {} triangles the nearest hit is {}, at t = {t}.", self.triangles, name.en),
                format!(
                    "Van {} driehoeken is het dichtstbijzijnde snijpunt op {}, bij t = {t}.",
                    self.triangles, name.nl
                ),
            );
        }
        let name = subject.names.object(hit.object);
        Words::new(
            format!(
                "The nearest hit is on {}, at t = {t}: an exact ball, no triangles; t solves a quadratic equation.",
                name.en
            ),
            format!(
                "Het dichtstbijzijnde snijpunt ligt op {}, bij t = {t}: een exacte bol, geen driehoeken; t lost een kwadratische vergelijking op.",
                name.nl
            ),
        )
    }

    fn counts(&self) -> Vec<Json> {
        let hits = self.entries.iter().filter(|entry| entry.is_hit).count();
        let exit = |exit: Exit| self.exits[exit as usize];
        [
            (Words::new("triangles asked", "driehoeken gevraagd"), self.triangles),
            (Words::new("exact balls asked", "exacte bollen gevraagd"), self.balls),
            (
                Words::new("exit: parallel to the plane", "uitgang: evenwijdig aan het vlak"),
                exit(Exit::Parallel),
            ),
            (Words::new("exit: t outside [t₀, t₁]", "uitgang: t buiten [t₀, t₁]"), exit(Exit::T)),
            (Words::new("exit: γ outside [0, 1]", "uitgang: γ buiten [0, 1]"), exit(Exit::Gamma)),
            (Words::new("exit: β outside [0, 1 − γ]", "uitgang: β buiten [0, 1 − γ]"), exit(Exit::Beta)),
            (
                Words::new(
                    "points where the line meets a surface",
                    "punten waar de lijn een oppervlak treft",
                ),
                hits,
            ),
            (Words::new("near misses not listed", "bijna-treffers niet vermeld"), self.left_out),
        ]
        .map(|(what, n)| count(&what, n))
        .to_vec()
    }

    /// The 3×3 system of the visible triangle in world space, its solution, and the inside tests (L50, L49).
    fn system(&self, subject: &Subject, hit: &Hit) -> Json {
        let Some([a, b, c]) = subject.world.objects()[hit.object].corners(hit.triangle) else {
            return Json::Null;
        };
        let system = system(&self.ray, &Triangle::new(a, b, c));
        let Some(Solution { beta, gamma, t }) = cramer(&system) else { return Json::Null };
        let (t0, t1) = self.interval;
        let test = |test: String, holds: bool| json!({ "test": test, "holds": holds });
        let n = |x: f32| decimal(x, 4);
        let matrix = [0, 1, 2].map(|row| vector(system.matrix.row(row)));
        json!({
            "corners": [vector(a), vector(b), vector(c)],
            "matrix": matrix,
            "rhs": vector(system.rhs),
            "beta": number(beta),
            "gamma": number(gamma),
            "t": number(t),
            "inside": [
                test(format!("β = {} > 0", n(beta)), beta > 0.0),
                test(format!("γ = {} > 0", n(gamma)), gamma > 0.0),
                test(format!("β + γ = {} < 1", n(beta + gamma)), beta + gamma < 1.0),
                test(format!("t = {} ∈ [{}, {}]", n(t), n(t0), n(t1)), t0 <= t && t <= t1),
            ],
        })
    }
}

/// Whether a hit is on a triangle.
pub(super) fn is_mesh(subject: &Subject, hit: &Hit) -> bool {
    matches!(subject.world.objects()[hit.object].shape(), Shape::Mesh(_))
}
