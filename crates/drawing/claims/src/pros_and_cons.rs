//! Six pros and cons of the z-buffer, one by one. (L19)

use canvas::{Image, Rgb};
use zbuffer::{DepthBuffer, DepthFormat, Fragment, draw, rasterize, rasterize_rows};

use crate::flat::{SIDE, random_triangles, triangle};
use crate::sample::{Sequence, pipeline, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, measured, text};

pub(super) static MEMORY: Claim = Claim {
    number: "L19",
    name: "memory",
    quote: "Veel geheugen nodig om z-waarden te bewaren",
    translation: "much memory is needed to keep the z",
    truth: text(
        "Two to four bytes a pixel: about as much as the picture itself, 8.3 MB at 1920 × 1080 with 32 bits. Much in 1974; today it is not the problem.",
        "Twee tot vier bytes per pixel: ongeveer zoveel als het beeld zelf, 8,3 MB bij 1920 × 1080 met 32 bits. In 1974 veel; nu geen probleem.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::DepthFormat::bits"],
    examine: || {
        let pixels = 1920 * 1080;
        let picture = 3 * pixels;
        let bytes =
            [DepthFormat::Bits16, DepthFormat::Bits24, DepthFormat::F32].map(|f| f.bits() / 8 * pixels);
        let megabytes = bytes.map(|bytes| format!("{:.1}", f64::from(bytes) / 1e6));
        // Much: at least half of what the picture takes.
        let numbers = format!(
            "1920 × 1080: {} MB for depths of 16, 24 and 32 bits beside {:.1} MB of 8-bit colour",
            megabytes.join(", "),
            f64::from(picture) / 1e6,
        );
        measured(bytes.iter().all(|bytes| 2 * bytes >= picture), numbers)
    },
    pictures: None,
    versions: None,
};

pub(super) static HARDWARE: Claim = Claim {
    number: "L19",
    name: "fits-hardware",
    quote: "Kan in hardware geïmplementeerd worden",
    translation: "can be implemented in hardware",
    truth: text(
        "No pixel asks about another and no fragment about a later one: bands of the screen drawn apart give the same picture, bit for bit.",
        "Geen pixel vraagt naar een andere en geen fragment naar een later: apart getekende banden van het scherm geven hetzelfde beeld, bit voor bit.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::DepthBuffer::bands_mut", "zbuffer::rasterize_rows"],
    examine: || {
        let trials = trials(40, 31, |random| {
            let triangles = random_triangles(random, 8, |_, _| (-0.9, 0.9));
            let mut whole = DepthBuffer::new(SIDE, SIDE, DepthFormat::F32);
            for triangle in &triangles {
                rasterize(triangle, SIDE, SIDE, |f| _ = whole.test_and_set(f.i, f.j, f.z));
            }
            let height = 1 + random.below(9) as u32;
            let mut banded = DepthBuffer::new(SIDE, SIDE, DepthFormat::F32);
            // Each band for itself, and the last first.
            let mut bands: Vec<_> = banded.bands_mut(height).collect();
            for band in bands.iter_mut().rev() {
                for triangle in &triangles {
                    let rows = band.rows();
                    rasterize_rows(triangle, SIDE, rows, |f| _ = band.test_and_set(f.i, f.j, f.z));
                }
            }
            drop(bands);
            Trial::new(whole == banded, format!("bands of {height} rows give other depths"))
        });
        judge("bands drawn apart, in any order, give the same depths", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static ANY_NUMBER: Claim = Claim {
    number: "L19",
    name: "any-number-of-polygons",
    quote: "Geen limiet aan aantal polygonen",
    translation: "no limit to the number of polygons",
    truth: text(
        "A polygon is forgotten once it is drawn: the memory is that of the pixels, for ten polygons and for ten thousand.",
        "Een polygoon kan na het tekenen vergeten worden: het geheugen is dat van de pixels, bij tien polygonen en bij tienduizend.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::DepthBuffer", "zbuffer::rasterize"],
    examine: || {
        let mut random = Sequence::new(32);
        let trials: Vec<Trial> = [10, 100, 1000, 10_000]
            .into_iter()
            .map(|count| {
                let mut depth = DepthBuffer::new(SIDE, SIDE, DepthFormat::F32);
                let mut nearest = vec![f32::NEG_INFINITY; (SIDE * SIDE) as usize];
                for _ in 0..count {
                    // Made, drawn and dropped, one at a time.
                    let [polygon] = random_triangles(&mut random, 1, |_, _| (-0.9, 0.9))[..] else {
                        continue;
                    };
                    rasterize(&polygon, SIDE, SIDE, |f| {
                        let known = &mut nearest[(f.j * SIDE + f.i) as usize];
                        *known = known.max(f.z as f32);
                        depth.test_and_set(f.i, f.j, f.z);
                    });
                }
                let cells = depth.width() * depth.height();
                let right = (0..cells).all(|k| {
                    depth.get(k % SIDE, k / SIDE).unwrap_or(f32::NEG_INFINITY) == nearest[k as usize]
                });
                Trial::new(right && cells == SIDE * SIDE, format!("{count} polygons, {cells} depths kept"))
            })
            .collect();
        let kept: Vec<_> = trials.iter().map(|trial| trial.numbers.clone()).collect();
        judge("the nearest depth of all polygons is kept, in one number a pixel", None, &trials)
            .noted(kept.join("; "))
    },
    pictures: None,
    versions: None,
};

pub(super) static SIMPLE: Claim = Claim {
    number: "L19",
    name: "simple",
    quote: "Implementatie heel simpel",
    translation: "the implementation is very simple",
    truth: text(
        "A comparison and two assignments. The painter's algorithm that draws the same picture takes many times as many lines.",
        "Eén vergelijking en twee toekenningen. Het painter's algoritme dat hetzelfde beeld tekent kost vele malen zoveel regels.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::draw::z_buffer", "zbuffer::painter"],
    examine: || {
        let z_buffer = code_lines(include_str!("../../../concepts/zbuffer/src/draw.rs"))
            + code_lines(include_str!("../../../concepts/zbuffer/src/depth_buffer.rs"));
        let painter: usize = [
            include_str!("../../../concepts/zbuffer/src/painter/order.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/relation.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/cycle.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/facet.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/boxes.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/plan.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/graph.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/piece.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/outlined_piece.rs"),
            include_str!("../../../concepts/zbuffer/src/painter/clipping.rs"),
        ]
        .into_iter()
        .map(code_lines)
        .sum();
        let numbers =
            format!("{z_buffer} lines of code for drawing and depth buffer, {painter} for the painter");
        measured(3 * z_buffer < painter, numbers)
    },
    pictures: None,
    versions: None,
};

/// Lines that are neither empty nor remarks, up to the tests.
fn code_lines(source: &str) -> usize {
    let before_tests = source.split("#[cfg(test)]").next().unwrap_or(source);
    before_tests.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")).count()
}

pub(super) static TRANSPARENCY: Claim = Claim {
    number: "L19",
    name: "no-transparency",
    quote: "Kan geen transparante oppervlakken aan",
    translation: "cannot handle transparent surfaces",
    truth: text(
        "A blended colour depends on the order of drawing: if the nearer pane comes first, the farther one is thrown away behind it.",
        "Een gemengde kleur hangt af van de tekenvolgorde: komt de voorste ruit eerst, dan wordt de achterste weggegooid.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::draw::draw"],
    examine: || {
        let trials = trials(40, 33, |random| {
            let panes = [
                (0.3, random.color(), random.between(0.2, 0.8)),
                (-0.3, random.color(), random.between(0.2, 0.8)),
            ];
            let (right, wrong) = (blended([panes[1], panes[0]]), blended(panes));
            let numbers = format!("back first {right:.2}, front first {wrong:.2}");
            Trial::new(!right.abs_diff_eq(wrong, 1e-4), numbers)
        });
        let panes = [(0.3, Rgb::X, 0.5), (-0.3, Rgb::Y, 0.5)];
        judge("two panes drawn in the other order give another colour", None, &trials).noted(format!(
            "red before green on black, half transparent: {:.2} if green is drawn first, {:.2} if red is",
            blended([panes[1], panes[0]]),
            blended(panes),
        ))
    },
    pictures: None,
    versions: None,
};

/// The colour of a pixel after drawing two panes (z, colour, opacity) in this order.
fn blended(panes: [(f32, Rgb, f32); 2]) -> Rgb {
    let mut image = Image::new(4, 4, Rgb::ZERO);
    let mut depth = DepthBuffer::new(4, 4, DepthFormat::F32);
    for (z, color, opacity) in panes {
        let pane = triangle([[-9.0, -9.0, z], [20.0, -9.0, z], [-9.0, 20.0, z]]);
        let before = image.get(1, 2);
        let blend = |_: &Fragment| color * opacity + before * (1.0 - opacity);
        draw::draw(&pane, blend, &mut image, &mut depth);
    }
    image.get(1, 2)
}

pub(super) static FIGHTING: Claim = Claim {
    number: "L19",
    name: "limited-resolution",
    quote: "Beperkte resolutie van de z-buffer kan leiden tot “z-fighting”",
    translation: "limited resolution of the z-buffer can lead to z-fighting",
    truth: text(
        "A hundred units away, 16 bits mix two walls half a unit apart; 32 bits tell them apart in every pixel.",
        "Op honderd eenheden afstand haalt 16 bits twee muren op een halve eenheid door elkaar; 32 bits houdt ze in elke pixel uit elkaar.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::DepthFormat", "zbuffer::project"],
    examine: limited_resolution,
    pictures: None,
    versions: None,
};

fn limited_resolution() -> Examination {
    let wrong = |format| wrong_pixels(format, 0.5);
    let (coarse, fine) = (wrong(DepthFormat::Bits16), wrong(DepthFormat::F32));
    let numbers = format!(
        "near 0.1, far 1000, two slanting walls 100 units away, 0.5 apart: the farther one is seen in {coarse} of {} pixels with 16 bits, in {fine} with 32",
        64 * 64
    );
    measured(coarse > 0 && fine == 0, numbers)
}

/// Two slanting walls, the nearer drawn second: in how many pixels the farther one stays.
fn wrong_pixels(format: DepthFormat, gap: f32) -> usize {
    let pipeline = pipeline((glam::Vec3::ZERO, glam::Vec3::NEG_Z), 0.3, (-0.1, -1000.0), (64, 64));
    let mut depth = DepthBuffer::new(64, 64, format);
    let mut image = Image::new(64, 64, Rgb::ZERO);
    for (z, color) in [(-100.0 - gap, Rgb::X), (-100.0, Rgb::Y)] {
        // Covers the window from corner to corner, and slants by 20 units across it.
        let corner = |x: f32, y: f32| glam::vec3(x, y, z + 0.1 * x + 0.2 * y);
        let wall = geometry::Triangle::new(corner(-90.0, -60.0), corner(90.0, -60.0), corner(0.0, 90.0));
        for part in zbuffer::project(&pipeline.clip_from_world(), 64, 64, &wall).triangles() {
            draw::draw(&part, |_| color, &mut image, &mut depth);
        }
    }
    image.pixels().iter().filter(|pixel| **pixel == Rgb::X).count()
}
