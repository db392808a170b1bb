//! Does drawing from back to front work, and does the z-buffer? (L13–L17)

use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, painter};

use crate::flat::{
    SIDE, cycle, different, fragments, nearest, painted, piercing, random_triangles, z_buffered,
};
use crate::sample::{permutations, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, text};

pub(super) static PAINTER: Claim = Claim {
    number: "L13",
    name: "back-to-front",
    quote: "Painter's algorithm: van back-to-front",
    translation: "painter's algorithm: from back to front",
    truth: text(
        "Drawn so that each polygon comes after all that it hides, every pixel shows the nearest. Such an order exists unless polygons hide each other in a cycle or pass through each other.",
        "Getekend zo dat elk polygoon na alles komt wat het bedekt, toont elke pixel het dichtstbijzijnde. Die volgorde bestaat, tenzij polygonen elkaar in een kring bedekken of doorsnijden.",
    ),
    expected: Verdict::HoldsIf(NO_CYCLE),
    code: &["zbuffer::painter::order", "zbuffer::draw::z_buffer"],
    examine: || {
        let mut trials = trials(60, 21, |random| {
            // Neighbours in the list share half their range of depths.
            let triangles =
                random_triangles(random, 4, |_, k| (-0.9 + 0.3 * k as f32, -0.3 + 0.3 * k as f32));
            painter_trial(&triangles, SIDE)
        });
        trials.push(painter_trial(&cycle(), 64));
        judge("drawing from back to front shows the nearest polygon in every pixel", Some(NO_CYCLE), &trials)
    },
    pictures: None,
    versions: None,
};

const NO_CYCLE: &str = "no polygons hide each other in a cycle or pass through each other";

fn painter_trial(triangles: &[ScreenTriangle], side: u32) -> Trial {
    let order = painter::order(triangles);
    let exists = order.is_ok();
    let order = order.unwrap_or_else(|_| painter::order_by_depth(triangles));
    let wrong = different(&painted(triangles, &order, side), &nearest(triangles, side));
    Trial::under(
        exists,
        wrong == 0,
        format!("{} polygons, drawn as {order:?}: {wrong} wrong pixels", triangles.len()),
    )
}

pub(super) static SORTED_BY_DEPTH: Claim = Claim {
    number: "L13",
    name: "sorted-by-depth",
    quote: "van back-to-front",
    translation: "from back to front, by one depth a polygon",
    truth: text(
        "Sorting by the farthest vertex is right where no two polygons share a range of depths. A long polygon begins far away and can still lie over others.",
        "Sorteren op het verste hoekpunt klopt als geen twee polygonen een dieptebereik delen. Een lang polygoon begint ver weg en kan toch over andere liggen.",
    ),
    expected: Verdict::HoldsIf(APART_IN_DEPTH),
    code: &["zbuffer::painter::order_by_depth"],
    examine: || {
        let trials = trials(80, 22, |random| {
            let apart = random.below(2) == 0;
            let slot = |k: usize| -0.9 + 0.35 * k as f32;
            let triangles = random_triangles(random, 5, |_, k| {
                if apart { (slot((2 * k) % 5), slot((2 * k) % 5) + 0.3) } else { (-0.9, 0.9) }
            });
            let order = painter::order_by_depth(&triangles);
            let wrong = different(&painted(&triangles, &order, SIDE), &nearest(&triangles, SIDE));
            Trial::under(
                apart,
                wrong == 0,
                format!("drawn as {order:?}: {wrong} of {} pixels wrong", SIDE * SIDE),
            )
        });
        judge("sorted by farthest vertex, every pixel shows the nearest", Some(APART_IN_DEPTH), &trials)
    },
    pictures: None,
    versions: None,
};

const APART_IN_DEPTH: &str = "no two polygons share a range of depths";

pub(super) static CYCLES: Claim = Claim {
    number: "L14",
    name: "occlusion-cycles",
    quote: "Two occlusion cycles, which cannot be drawn in back-to-front order.",
    translation: "two occlusion cycles, which cannot be drawn in back-to-front order",
    truth: text(
        "All orders were tried: each leaves wrong pixels. Only cutting a polygon helps.",
        "Alle volgordes zijn geprobeerd: elke laat foute pixels over. Alleen een polygoon doorsnijden helpt.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::painter::order", "zbuffer::painter::plan"],
    examine: || {
        let (mut trials, mut wrong_pixels) = (Vec::new(), Vec::new());
        let figures: [Vec<ScreenTriangle>; 2] = [cycle().into(), piercing().into()];
        for triangles in &figures {
            let right = nearest(triangles, 64);
            for order in permutations(triangles.len()) {
                let wrong = different(&painted(triangles, &order, 64), &right);
                wrong_pixels.push(format!("{wrong}"));
                trials.push(Trial::new(wrong > 0, format!("order {order:?} draws every pixel right")));
            }
        }
        let found = figures.each_ref().map(|triangles| {
            painter::order(triangles).map_or_else(|cycle| cycle.to_string(), |order| format!("{order:?}"))
        });
        judge("every order leaves wrong pixels", None, &trials)
            .noted(format!("wrong pixels, order by order: {}", wrong_pixels.join(", ")))
            .noted(found.join("; "))
    },
    pictures: None,
    versions: None,
};

pub(super) static DRAWN_LAST: Claim = Claim {
    number: "L15",
    name: "drawn-last-overwrites",
    quote: "is farther away but is drawn last, so it incorrectly overwrites the nearer one.",
    translation: "the farther sphere is drawn last, so it incorrectly overwrites the nearer one",
    truth: text(
        "Without depth the order of drawing decides: what is drawn last is seen, near or far.",
        "Zonder diepte beslist de tekenvolgorde: wat het laatst getekend is, is te zien, dichtbij of ver.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::rasterize"],
    examine: || {
        let mut overwritten = 0;
        let trials = trials(60, 23, |random| {
            let triangles = random_triangles(random, 2, |_, k| if k == 0 { (0.2, 0.9) } else { (-0.9, 0.1) });
            let last = painted(&triangles, &[0, 1], SIDE);
            let by_pixel = fragments(&triangles, SIDE);
            let both = by_pixel.iter().filter(|(_, list)| list.len() == 2);
            let lost = both.clone().filter(|((j, i), _)| last[(j * SIDE + i) as usize] == Some(1)).count();
            overwritten += lost;
            Trial::new(lost == both.count(), format!("{lost} pixels of the nearer one overwritten"))
        });
        let examination =
            judge("of two polygons the one drawn last is seen wherever both are", None, &trials);
        examination.noted(format!("{overwritten} pixels show the farther one, all of them wrongly"))
    },
    pictures: None,
    versions: None,
};

pub(super) static ORDER_OF_DRAWING: Claim = Claim {
    number: "L16",
    name: "any-order",
    quote: "als z-waarde dichterbij camera is dan opgeslagen z-waarde: zet nieuwe kleur en nieuwe z-waarde",
    translation: "if z is nearer to the camera than the stored z: set the new colour and the new z",
    truth: text(
        "The picture does not depend on the order of drawing where no two z in a pixel are equal; of equal ones the first drawn stays.",
        "Het beeld hangt niet van de tekenvolgorde af waar geen twee z-waarden in een pixel gelijk zijn; van gelijke blijft de eerst getekende.",
    ),
    expected: Verdict::HoldsIf(NO_EQUAL_DEPTHS),
    code: &["zbuffer::DepthBuffer::test_and_set"],
    examine: || {
        let trials = trials(60, 24, |random| {
            // Every other scene has flat triangles on two depths only.
            let level = random.below(2) == 0;
            let triangles = random_triangles(random, 5, |random, _| {
                let z = 0.25 * random.below(2) as f32;
                if level { (z, z) } else { (-0.9, 0.9) }
            });
            let order = random.order(5);
            let other = z_buffered(&triangles, &order, SIDE, DepthFormat::F32);
            let changed = different(&nearest(&triangles, SIDE), &other);
            let numbers = format!("drawn as {order:?} instead of [0, 1, 2, 3, 4]: {changed} pixels change");
            Trial::under(!has_equal_depths(&triangles), changed == 0, numbers)
        });
        judge("the picture is the same in another order", Some(NO_EQUAL_DEPTHS), &trials)
    },
    pictures: None,
    versions: None,
};

const NO_EQUAL_DEPTHS: &str = "no two z in a pixel are equal";

fn has_equal_depths(triangles: &[ScreenTriangle]) -> bool {
    fragments(triangles, SIDE).values().any(|list| {
        // As the buffer stores them.
        let mut depths: Vec<f32> = list.iter().map(|(_, fragment)| fragment.z as f32).collect();
        depths.sort_by(f32::total_cmp);
        depths.windows(2).any(|two| two[0] == two[1])
    })
}

/// The slide's grids after the first, second and third polygon; 0 is nothing.
const GRIDS: [[[u8; 6]; 5]; 3] = [
    [[0; 6], [0; 6], [10, 10, 10, 10, 0, 0], [10, 10, 10, 10, 0, 0], [10, 10, 10, 10, 0, 0]],
    [[5; 6], [5; 6], [10, 10, 10, 10, 5, 5], [10, 10, 10, 10, 5, 5], [10, 10, 10, 10, 5, 5]],
    [
        [5, 5, 15, 15, 5, 5],
        [5, 5, 15, 15, 15, 5],
        [10, 15, 15, 15, 15, 15],
        [10, 15, 15, 15, 15, 15],
        [15; 6],
    ],
];

/// The pixels of the three polygons, as (row from the top, column), and their depths.
fn polygons() -> [(u8, Vec<(usize, usize)>); 3] {
    let covered = |covers: &dyn Fn(usize, usize) -> bool| {
        (0..5)
            .flat_map(|row| (0..6).map(move |column| (row, column)))
            .filter(|(r, c)| covers(*r, *c))
            .collect()
    };
    let slanted = [2..4, 2..5, 1..6, 1..6, 0..6];
    [
        (10, covered(&|row, column| 2 <= row && column < 4)),
        (5, covered(&|_, _| true)),
        (15, covered(&|row, column| slanted[row].contains(&column))),
    ]
}

pub(super) static FOUR_GRIDS: Claim = Claim {
    number: "L17",
    name: "four-grids",
    quote: "0 0 0 0 0 0 → 10 10 10 10 0 0 → 10 10 10 10 5 5 → 10 15 15 15 15 15",
    translation: "the middle row of the four depth grids",
    truth: text(
        "The algorithm gives the slide's grids: 5 does not overwrite 10, and 15 overwrites both. Larger is nearer.",
        "Het algoritme geeft de roosters van de dia: 5 overschrijft 10 niet, 15 overschrijft beide. Groter is dichterbij.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::DepthBuffer"],
    examine: four_grids,
    pictures: None,
    versions: None,
};

fn four_grids() -> Examination {
    let mut depth = DepthBuffer::new(6, 5, DepthFormat::F32);
    let mut trials = Vec::new();
    for (step, (z, pixels)) in polygons().into_iter().enumerate() {
        for (row, column) in pixels {
            depth.test_and_set(column as u32, 4 - row as u32, f32::from(z));
        }
        for (row, columns) in GRIDS[step].iter().enumerate() {
            let stored = [0, 1, 2, 3, 4, 5].map(|column| depth.get(column, 4 - row as u32).unwrap_or(0.0));
            let holds = stored == columns.map(f32::from);
            trials.push(Trial::new(
                holds,
                format!("grid {}, row {row}: {stored:?}, on the slide {columns:?}", step + 2),
            ));
        }
    }
    judge("each row of each grid is the slide's", None, &trials)
}
