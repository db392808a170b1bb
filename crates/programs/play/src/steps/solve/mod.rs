//! How is the 3×3 system of a ray and a triangle solved by hand (L50, L51)?
//!
//! Each step is a few lines of arithmetic with its numbers. What is shown is computed by `raytrace::triangle`, whose
//! solution the last step has.

mod cramer;
mod elimination;
mod inverse;

use geometry::{Ray, Triangle};
use glam::{Mat3, Vec3};
use raytrace::nearest;
use raytrace::triangle::{Solution, System, system};
use serde::Deserialize;
use sheet::Words;
use sheet::text::decimal;

use super::{Drawing, Equations, Step, Told};
use crate::story::subject::Subject;
use crate::{Look, Refusal, Stage};

/// By which of the slide's three ways (L51).
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum How {
    /// Quotients of determinants.
    Cramer,
    /// A⁻¹·b.
    Inverse,
    /// Gaussian elimination with the largest pivot, and back-substitution.
    Elimination,
}

/// A system, and where it comes from.
struct Problem {
    system: System,
    words: Words,
    /// Between which t a hit counts.
    interval: (f32, f32),
}

/// The steps for the worked example, or for the triangle that a pixel shows.
pub(super) fn told(
    stage: &Stage,
    how: How,
    look: Option<&Look>,
    pixel: Option<(u32, u32)>,
) -> Result<Told, Refusal> {
    let problem = match look {
        None => worked_example(),
        Some(look) => seen(stage, look, pixel.unwrap_or((look.width / 2, look.height / 2)))?,
    };
    let system = &problem.system;
    let mut steps = vec![beginning(&problem)];
    let (title, solution) = match how {
        How::Cramer => (Words::new("Cramer's rule", "Regel van Cramer"), cramer::tell(system, &mut steps)),
        How::Inverse => (Words::new("The inverse", "De inverse"), inverse::tell(system, &mut steps)),
        How::Elimination => {
            (Words::new("Gaussian elimination", "Gauss-eliminatie"), elimination::tell(system, &mut steps))
        }
    };
    steps.push(solution.map_or_else(parallel, |solution| end(&problem, solution)));
    Ok(Told { title, steps })
}

/// The ray and the triangle of exercise 4.2 (L54).
fn worked_example() -> Problem {
    Problem {
        system: system(&Ray::new(Vec3::ONE, Vec3::NEG_ONE), &Triangle::new(Vec3::X, Vec3::Y, Vec3::Z)),
        words: Words::new(
            "The worked example: e = (1, 1, 1), d = (−1, −1, −1), a = (1, 0, 0), b = (0, 1, 0), c = (0, 0, 1).",
            "Het voorbeeld: e = (1, 1, 1), d = (−1, −1, −1), a = (1, 0, 0), b = (0, 1, 0), c = (0, 0, 1).",
        ),
        interval: (0.0, f32::INFINITY),
    }
}

/// The triangle that the ray through a pixel meets first.
fn seen(stage: &Stage, look: &Look, pixel: (u32, u32)) -> Result<Problem, Refusal> {
    let subject = Subject::new(stage, look, pixel)?;
    let (ray, (t0, t1)) = (subject.ray(), subject.interval());
    let hit = nearest(&subject.world, &ray, t0, t1).ok_or_else(|| {
        Refusal::new(
            "the pixel shows the background: there is no triangle",
            "de pixel toont de achtergrond: er is geen driehoek",
        )
    })?;
    let [a, b, c] = subject.world.objects()[hit.object].corners(hit.triangle).ok_or_else(|| {
        Refusal::new(
            "the pixel shows an exact ball: it has a quadratic equation and no triangle",
            "de pixel toont een exacte bol: die heeft een kwadratische vergelijking en geen driehoek",
        )
    })?;
    let name = subject.names.triangle(hit.object, hit.triangle);
    let (i, j) = pixel;
    Ok(Problem {
        system: system(&ray, &Triangle::new(a, b, c)),
        words: Words::new(
            format!("Pixel ({i}, {j}) shows {}; its viewing ray and this triangle.", name.en),
            format!("Pixel ({i}, {j}) toont {}; zijn kijkstraal en deze driehoek.", name.nl),
        ),
        interval: (t0, t1),
    })
}

fn beginning(problem: &Problem) -> Step {
    let matrix = &problem.system.matrix;
    let unknowns = Words::new(
        "e + t·d = a + β(b − a) + γ(c − a), unknowns on the left: the columns are a − b, a − c and d, at the right stands a − e.",
        "e + t·d = a + β(b − a) + γ(c − a), onbekenden links: de kolommen zijn a − b, a − c en d, rechts staat a − e.",
    );
    let equations = equations(matrix, Some(problem.system.rhs), &[]);
    Step::new(problem.words.clone()).lines(vec![unknowns]).showing(equations)
}

fn parallel() -> Step {
    Step::new(Words::new(
        "The determinant is 0, to within rounding: the ray is parallel to the plane, there is no solution.",
        "De determinant is 0, op afronding na: de straal is evenwijdig aan het vlak, er is geen oplossing.",
    ))
}

/// The solution, and whether it is a hit (L49, L53).
fn end(problem: &Problem, Solution { beta, gamma, t }: Solution) -> Step {
    let alpha = Solution { beta, gamma, t }.weights().alpha;
    let (t0, t1) = problem.interval;
    let tests = [
        (format!("β = {} ≥ 0", short(beta)), beta >= 0.0),
        (format!("γ = {} ≥ 0", short(gamma)), gamma >= 0.0),
        (format!("β + γ = {} ≤ 1", short(beta + gamma)), beta + gamma <= 1.0),
        (format!("{} ≤ t = {} ≤ {}", short(t0), short(t), short(t1)), t0 <= t && t <= t1),
    ];
    let is_hit = tests.iter().all(|(_, holds)| *holds);
    let mut lines = vec![Words::from(format!(
        "β = {}, γ = {}, t = {}; α = 1 − β − γ = {}",
        short(beta),
        short(gamma),
        short(t),
        short(alpha)
    ))];
    lines.extend(tests.into_iter().map(|(test, holds)| {
        Words::new(
            format!("{test}: {}", if holds { "yes" } else { "no" }),
            format!("{test}: {}", if holds { "ja" } else { "nee" }),
        )
    }));
    let words = if is_hit {
        Words::new("The ray hits the triangle.", "De straal raakt de driehoek.")
    } else {
        Words::new("The ray misses the triangle.", "De straal mist de driehoek.")
    };
    let mut step = Step::new(words).lines(lines);
    step.solution = Some([beta, gamma, t]);
    step
}

/// The matrix with its right-hand side; `marked`: what the step is about.
fn equations(matrix: &Mat3, rhs: Option<Vec3>, marked: &[(usize, usize)]) -> Drawing {
    Drawing::Equations(Equations {
        matrix: [0, 1, 2].map(|row| matrix.row(row).to_array()),
        rhs: rhs.map(|rhs| rhs.to_array()),
        marked: marked.to_vec(),
    })
}

/// A number in few digits: `2`, `−0.3333`, `1.2e−6`.
fn short(x: f32) -> String {
    if !x.is_finite() {
        return if x > 0.0 { "∞".to_owned() } else { "−∞".to_owned() };
    }
    if x != 0.0 && x.abs() < 1e-3 {
        return format!("{x:.2e}").replace('-', "−");
    }
    let text = decimal(x, 4);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The same between brackets if it is negative, to stand after an operator.
fn factor(x: f32) -> String {
    let text = short(x);
    if text.starts_with('−') { format!("({text})") } else { text }
}

/// The 2×2 determinants that the first row's numbers are multiplied with, signs included.
fn cofactors_of_first_row(m: &Mat3) -> [f32; 3] {
    // The columns' cross products hold them: det = x·(y × z), by components.
    let rows = [m.row(0), m.row(1), m.row(2)];
    rows[1].cross(rows[2]).to_array()
}

/// Whether there is one solution at all: det A, with which two of the three ways begin.
fn determinant(system: &System) -> Step {
    let words = Words::new(
        "The determinant of the matrix, along its first row.",
        "De determinant van de matrix, langs de eerste rij.",
    );
    let row = [(0, 0), (0, 1), (0, 2)];
    Step::new(words).lines(expanded("det A", &system.matrix)).showing(equations(&system.matrix, None, &row))
}

/// The determinant, expanded along its first row.
fn expanded(name: &str, m: &Mat3) -> Vec<Words> {
    let ([a, b, c], [p, q, r]) = (m.row(0).to_array(), cofactors_of_first_row(m));
    let ([d, e, f], [g, h, k]) = (m.row(1).to_array(), m.row(2).to_array());
    let product = |x: f32, y: f32| format!("{}·{}", factor(x), factor(y));
    let minor = |(x, y): (f32, f32), (z, w): (f32, f32)| format!("({} − {})", product(x, y), product(z, w));
    vec![
        format!(
            "{name} = {}·{} − {}·{} + {}·{}",
            factor(a),
            minor((e, k), (f, h)),
            factor(b),
            minor((d, k), (f, g)),
            factor(c),
            minor((d, h), (e, g))
        )
        .into(),
        format!("= {} + {} + {} = {}", product(a, p), product(b, q), product(c, r), short(m.determinant()))
            .into(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn a_determinant_is_expanded_with_its_own_numbers() {
        // Rows (1, 4, 2), (2, −1, 0), (0, 3, 1): 1·(−1·1 − 0·3) − 4·(2·1 − 0·0) + 2·(2·3 − (−1)·0) = −1 − 8 + 12.
        let m = Mat3::from_cols(vec3(1.0, 2.0, 0.0), vec3(4.0, -1.0, 3.0), vec3(2.0, 0.0, 1.0));
        let lines = expanded("det A", &m);
        assert_eq!(lines[0].en, "det A = 1·((−1)·1 − 0·3) − 4·(2·1 − 0·0) + 2·(2·3 − (−1)·0)");
        assert_eq!(lines[1].en, "= 1·(−1) + 4·(−2) + 2·6 = 3");
    }

    #[test]
    fn numbers_are_short_and_have_a_true_minus() {
        assert_eq!(
            [2.0, -1.0 / 3.0, -0.0, 1.25e-6, 1e5].map(short),
            ["2", "−0.3333", "0", "1.25e−6", "100000"]
        );
        assert_eq!(factor(-2.5), "(−2.5)");
    }
}
