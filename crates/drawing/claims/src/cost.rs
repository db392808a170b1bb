//! Is h cheaper than r? (E5)

use std::cell::Cell;
use std::hint::black_box;
use std::time::Instant;

use glam::{Vec3, vec3};
use lighting::{halfway, reflect};

use crate::sample::Sequence;
use crate::{Claim, Examination, Verdict, measured, text, versions};

pub(super) static R_IS_EXPENSIVE: Claim = Claim {
    number: "E5",
    name: "r-is-expensive",
    quote: "Berekenen van r en e·r rekenintensief, vervangen door h·n",
    translation: "computing r and e·r is expensive; replaced by h·n",
    truth: text(
        "r = 2(n·l)n − l needs no square root, h = (e+l)/‖e+l‖ needs one: r is about as cheap, often cheaper. h pays off where eye and light are far away and h is constant.",
        "r = 2(n·l)n − l heeft geen wortel nodig, h = (e+l)/‖e+l‖ wel: r is ongeveer even goedkoop, vaak goedkoper. h loont als oog en licht ver weg zijn en h constant is.",
    ),
    expected: Verdict::Refuted,
    code: &["lighting::reflect", "lighting::halfway"],
    examine: r_is_expensive,
    pictures: None,
    versions: Some(versions::cost),
};

/// To the eye, to the light, and the normal: which they are does not change how much is computed.
pub(super) fn operands() -> [Vec3; 3] {
    [vec3(0.6, 0.0, 0.8), vec3(0.0, 0.6, 0.8), Vec3::Z]
}

fn r_is_expensive() -> Examination {
    let [e, l, n] = operands();
    let [r, h] = [slide_r, slide_h].map(|form| {
        let count = Count::default();
        form(&count, e, l, n);
        count
    });
    let costs = |count: &Count| format!("{} operations, {} of them roots", count.all(), count.roots());
    // Expensive: it costs at least half as much again as what replaces it. A root counts as one operation, though it takes
    // longer than a sum.
    let is_expensive = 2 * r.all() > 3 * h.all();
    measured(is_expensive, format!("r and e·r: {}; h and h·n: {}", costs(&r), costs(&h)))
        .compared(
            "the cost of r and e·r, where h and h·n have 1",
            "much more than 1 (“rekenintensief”)",
            format!("{:.2}, by operations", f64::from(r.all()) / f64::from(h.all())),
        )
        .noted(format!("{:.2} by time: medians of 61 rounds in turns, on this machine", ratio_of_times()))
}

/// Counts what is computed: sums, differences, products, quotients and roots.
#[derive(Default)]
pub(super) struct Count {
    all: Cell<u32>,
    roots: Cell<u32>,
}

impl Count {
    pub(super) fn all(&self) -> u32 {
        self.all.get()
    }

    pub(super) fn roots(&self) -> u32 {
        self.roots.get()
    }

    fn one(&self, x: f32) -> f32 {
        self.all.set(self.all.get() + 1);
        x
    }

    fn three(&self, v: Vec3) -> Vec3 {
        vec3(self.one(v.x), self.one(v.y), self.one(v.z))
    }

    fn root(&self, x: f32) -> f32 {
        self.roots.set(self.roots.get() + 1);
        self.one(x.sqrt())
    }

    fn dot(&self, a: Vec3, b: Vec3) -> f32 {
        let products = self.three(a * b);
        self.one(self.one(products.x + products.y) + products.z)
    }
}

/// e·r with r = 2(n·l)n − l.
pub(super) fn slide_r(count: &Count, e: Vec3, l: Vec3, n: Vec3) -> f32 {
    let twice = count.one(2.0 * count.dot(n, l));
    let r = count.three(count.three(twice * n) - l);
    count.dot(e, r)
}

/// h·n with h = (e + l)/‖e + l‖.
pub(super) fn slide_h(count: &Count, e: Vec3, l: Vec3, n: Vec3) -> f32 {
    let sum = count.three(e + l);
    let h = count.three(sum / count.root(count.dot(sum, sum)));
    count.dot(h, n)
}

/// How many times as long r and e·r take as h and h·n.
fn ratio_of_times() -> f64 {
    let mut random = Sequence::new(85);
    let pairs: Vec<(Vec3, Vec3)> =
        (0..2000).map(|_| (random.direction_around(Vec3::Z), random.direction_around(Vec3::Z))).collect();
    // Each result is used and nothing is known before, so that nothing is left out.
    let n = black_box(Vec3::Z);
    let by_r = || pairs.iter().map(|(e, l)| black_box(e).dot(reflect(n, *black_box(l)))).sum::<f32>();
    let h = |e: Vec3, l: Vec3| halfway(e, l).map_or(0.0, |h| h.dot(n));
    let by_h = || pairs.iter().map(|(e, l)| h(*black_box(e), *black_box(l))).sum::<f32>();
    // In turns, so that a busy machine slows both alike.
    let (r_times, h_times): (Vec<_>, Vec<_>) =
        (0..61).map(|_| (nanoseconds(by_r), nanoseconds(by_h))).unzip();
    median(r_times) / median(h_times)
}

fn nanoseconds(work: impl FnOnce() -> f32) -> f64 {
    let start = Instant::now();
    black_box(work());
    start.elapsed().as_nanos() as f64
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
