//! The z-buffer algorithm (L16), with the lecture's four grids (L17).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::colour;
use vocabulary::{Buffers, Fragment};

use super::drawing;
use crate::exercise::{arguments, signature};
use crate::law::{Broken, Stop};
use crate::{Concept, Example, Exercise, Law, Misconception, Plain, Title, close, that};

const STUB: &str = r#"//! The z-buffer algorithm (L16).
//!
//! 1. Set every pixel of the rgb-buffer to the background colour and every pixel of the z-buffer to the farthest z.
//! 2. For every polygon, for each of its pixels: if its z is nearer than the stored z, store the new colour and the new z.
//!
//! The polygons are rasterized already: `fragments` holds what each leaves in each of its pixels, those of the first polygon
//! first, then those of the second, and so on. Give both buffers after the last one.
//!
//! - Larger z is nearer, and 0 is the farthest, as in the slide's grids (L17). No z is negative.
//! - A fragment with the same z as the stored one is not nearer: it changes nothing.
//! - Buffers are lists of rows: pixel (i, j) is `rgb[j][i]` and `z[j][i]`, j = 0 … height − 1, i = 0 … width − 1. Row 0 is
//!   the lowest of the picture.
//! - Every fragment lies on the screen.
//!
//! std: `vec![vec![0.0; width as usize]; height as usize]`; an index is a usize: `fragment.i as usize`.

use glam::Vec3;
use vocabulary::{Buffers, Fragment};

pub fn zbuffer(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    todo!()
}
"#;

signature!((fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers);

/// Colours and depths are copied, never computed.
const EXACT: f32 = 0.0;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "zbuffer",
        concept: Concept::Zbuffer,
        items: "L16, L17, E16",
        title: Title { english: "The z-buffer algorithm", dutch: "Het z-bufferalgoritme" },
        prerequisites: &["depth_at", "rasterize"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Two buffers of the same size: one says what is seen in a pixel, the other how near that is. What must stand in \
                them before the first polygon?",
            "One loop over the fragments. The stored z of the fragment's pixel decides; if the fragment wins, both buffers \
                change.",
            "for f in fragments { let (i, j) = (f.i as usize, f.j as usize); if f.z > z[j][i] { z[j][i] = f.z; rgb[j][i] = \
                f.colour; } }",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(pixel_by_pixel), program!(sorted_first)],
        misconceptions: misconceptions(),
        explanation: "Nothing was sorted: the nearest of any number of polygons is found with one comparison a fragment, \
            and where no two depths are equal the order of the polygons does not matter. Where two are equal it does, and \
            with few bits many become equal: z-fighting. What lies behind is forgotten, so something transparent cannot be \
            mixed in later (L19).",
        draw: drawing::grids,
        source: include_str!("zbuffer.rs"),
    }
}

const BACKGROUND: Vec3 = vec3(1.0, 1.0, 1.0);
const RED: Vec3 = vec3(1.0, 0.0, 0.0);
const GREEN: Vec3 = vec3(0.0, 1.0, 0.0);
const BLUE: Vec3 = vec3(0.0, 0.0, 1.0);

/// Pixels in a row of the slide's grids.
const WIDTH: u32 = 6;

/// The slide's grids have five rows; its first grid lost one (E18).
const HEIGHT: u32 = 5;

/// The slide's polygons: for each row from the top, the columns that it has.
const AT_10: [(u32, u32); 5] = [(0, 0), (0, 0), (0, 4), (0, 4), (0, 4)];
const AT_5: [(u32, u32); 5] = [(0, 6); 5];
const AT_15: [(u32, u32); 5] = [(2, 4), (2, 5), (1, 6), (1, 6), (0, 6)];

fn examples() -> Vec<Example> {
    let ten = polygon(AT_10, 10.0, RED);
    let five = polygon(AT_5, 5.0, GREEN);
    let fifteen = polygon(AT_15, 15.0, BLUE);
    let (first, second) = ([0.0, 10.0], [5.0, 10.0]);
    // From the top row down, as the slide prints them.
    let after_ten = [[0.0; 6], [0.0; 6], picked(first, 4), picked(first, 4), picked(first, 4)];
    let after_five = [[5.0; 6], [5.0; 6], picked(second, 4), picked(second, 4), picked(second, 4)];
    let after_fifteen = [
        [5.0, 5.0, 15.0, 15.0, 5.0, 5.0],
        [5.0, 5.0, 15.0, 15.0, 15.0, 5.0],
        [10.0, 15.0, 15.0, 15.0, 15.0, 15.0],
        [10.0, 15.0, 15.0, 15.0, 15.0, 15.0],
        [15.0; 6],
    ];
    let example = |caption, fragments: Vec<Fragment>, grid| {
        Example::new(caption, arguments![fragments, BACKGROUND, WIDTH, HEIGHT], buffers(grid), EXACT)
    };
    vec![
        example("the slide's first grid: cleared", Vec::new(), [[0.0; 6]; 5]),
        example("the slide's second grid: a polygon at 10", ten.clone(), after_ten),
        example(
            "the slide's third grid: 5 does not overwrite 10",
            [ten.clone(), five.clone()].concat(),
            after_five,
        ),
        example("the slide's fourth grid: 15 overwrites both", [ten, five, fifteen].concat(), after_fifteen),
    ]
}

/// A row of six: `near` in the first `count` pixels, `far` in the others.
fn picked([far, near]: [f32; 2], count: usize) -> [f32; 6] {
    std::array::from_fn(|i| if i < count { near } else { far })
}

/// The fragments of a polygon, row after row from the top.
fn polygon(rows: [(u32, u32); 5], z: f32, colour: Vec3) -> Vec<Fragment> {
    let row = |(j, (from, to)): (u32, (u32, u32))| (from..to).map(move |i| Fragment { i, j, z, colour });
    (0..HEIGHT).rev().zip(rows).flat_map(row).collect()
}

/// Both buffers from the slide's grid, whose rows run from the top down.
fn buffers(grid: [[f32; 6]; 5]) -> Buffers {
    let z: Vec<Vec<f32>> = grid.iter().rev().map(|row| row.to_vec()).collect();
    let colour = |z: &f32| match *z {
        5.0 => GREEN,
        10.0 => RED,
        15.0 => BLUE,
        _ => BACKGROUND,
    };
    Buffers { rgb: z.iter().map(|row| row.iter().map(colour).collect()).collect(), z }
}

/// What the algorithm gets: fragments, the background, the size of the screen.
#[derive(Clone, Debug)]
struct Scene {
    fragments: Vec<Fragment>,
    background: Vec3,
    width: u32,
    height: u32,
}

impl Scene {
    fn arguments(&self) -> Vec<crate::Value> {
        arguments![self.fragments.clone(), self.background, self.width, self.height]
    }

    fn of_pixel(&self, i: u32, j: u32) -> impl Iterator<Item = &Fragment> {
        self.fragments.iter().filter(move |fragment| fragment.i == i && fragment.j == j)
    }

    fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let Self { width, height, .. } = *self;
        (0..height).flat_map(move |j| (0..width).map(move |i| (i, j)))
    }
}

/// Up to eight fragments on a screen of at most 3 × 3 pixels, so that they meet. Their depths are `depths` in any order.
fn scene(depths: Vec<f32>) -> impl Strategy<Value = Scene> + Clone {
    let fragments = prop::collection::vec((0..3_u32, 0..3_u32, colour()), 2..=8);
    let depths = Just(depths).prop_shuffle();
    (fragments, depths, colour(), 1..=3_u32, 1..=3_u32).prop_map(
        |(places, depths, background, width, height)| {
            let fragments = places
                .into_iter()
                .zip(depths)
                // All on the screen, however small it is.
                .map(|((i, j, colour), z)| Fragment { i: i % width, j: j % height, z, colour })
                .collect();
            Scene { fragments, background, width, height }
        },
    )
}

/// No two depths are equal.
fn scene_of_different_depths() -> impl Strategy<Value = Scene> + Clone {
    scene((1..=8).map(|z| z as f32).collect())
}

/// Some depths are equal, and some are the farthest.
fn scene_of_few_depths() -> impl Strategy<Value = Scene> + Clone {
    scene([0, 1, 1, 1, 2, 2, 3, 3].map(|z| z as f32).to_vec())
}

/// Pixel (i, j) of a buffer.
fn pixel<T: Copy>(buffer: &[Vec<T>], i: u32, j: u32) -> Result<T, Stop> {
    let found = buffer.get(j as usize).and_then(|row| row.get(i as usize));
    found.copied().ok_or_else(|| {
        Stop::Broken(Broken {
            what: format!("pixel ({i}, {j}) is not there: rows are asked first"),
            values: None,
        })
    })
}

fn laws() -> Vec<Law> {
    vec![
        size_of_the_screen(),
        cleared(),
        nearest_depth(),
        colour_of_the_depth(),
        any_order(),
        first_of_equals(),
    ]
}

fn size_of_the_screen() -> Law {
    Law::of(
        "buffers_are_as_large_as_the_screen",
        1,
        "Both buffers have `height` rows of `width` pixels.",
        "A buffer has another size than the screen: which of the two indices is the row?",
    )
    .over(scene_of_different_depths(), |scene, program| {
        let Buffers { rgb, z } = program.ask(scene.arguments())?;
        let (rows, columns) = (scene.height as usize, scene.width as usize);
        that(rgb.len() == rows && z.len() == rows, || {
            format!("there are {} and {} rows, not {rows}", rgb.len(), z.len())
        })?;
        let whole = rgb.iter().all(|row| row.len() == columns) && z.iter().all(|row| row.len() == columns);
        that(whole, || format!("not every row has {columns} pixels"))
    })
}

fn cleared() -> Law {
    Law::of(
        "without_fragments_background",
        1,
        "A pixel without fragments has the background's colour and the farthest depth, 0.",
        "Nothing was drawn in this pixel. What stands in the buffers before the first polygon?",
    )
    .over(scene_of_different_depths(), |scene, program| {
        let Buffers { rgb, z } = program.ask(scene.arguments())?;
        for (i, j) in scene.pixels().filter(|(i, j)| scene.of_pixel(*i, *j).next().is_none()) {
            close(&format!("the colour of pixel ({i}, {j})"), pixel(&rgb, i, j)?, scene.background, EXACT)?;
            close(&format!("the depth of pixel ({i}, {j})"), pixel(&z, i, j)?, 0.0, EXACT)?;
        }
        Ok(())
    })
}

fn nearest_depth() -> Law {
    Law::of(
        "the_nearest_depth_is_kept",
        3,
        "The depth of a pixel is the largest z of its fragments, or 0 if it has none.",
        "The stored depth is not the nearest one: with what is a fragment compared, when is it stored, and which pixel is \
            (i, j)?",
    )
    .over(scene_of_few_depths(), |scene, program| {
        let Buffers { z, .. } = program.ask(scene.arguments())?;
        for (i, j) in scene.pixels() {
            let nearest = scene.of_pixel(i, j).map(|fragment| fragment.z).fold(0.0, f32::max);
            close(&format!("the depth of pixel ({i}, {j})"), pixel(&z, i, j)?, nearest, EXACT)?;
        }
        Ok(())
    })
}

fn colour_of_the_depth() -> Law {
    Law::of(
        "colour_and_depth_belong_together",
        2,
        "The colour of a pixel is that of a fragment with the stored depth, or the background's if nothing was nearer than 0.",
        "Colour and depth of a pixel come from different fragments: whoever wins must be stored in both buffers, whoever \
            loses in none.",
    )
    .over(scene_of_few_depths(), |scene, program| {
        let Buffers { rgb, z } = program.ask(scene.arguments())?;
        for (i, j) in scene.pixels() {
            let (seen, depth) = (pixel(&rgb, i, j)?, pixel(&z, i, j)?);
            let wanted = |fragment: &Fragment| fragment.z == depth && fragment.colour == seen;
            let background = depth == 0.0 && seen == scene.background;
            that(background || scene.of_pixel(i, j).any(wanted), || {
                let colour = seen.into_value();
                format!("pixel ({i}, {j}) shows {colour} at depth {depth}, which no fragment is")
            })?;
        }
        Ok(())
    })
}

fn any_order() -> Law {
    Law::of(
        "the_order_of_drawing_does_not_matter",
        2,
        "Where no two depths are equal, polygons may be drawn in any order.",
        "Drawn the other way round it looks different, though all depths differ: who wins must depend on the depth alone.",
    )
    .over(scene_of_different_depths(), |scene, program| {
        let first: Buffers = program.ask(scene.arguments())?;
        let mut turned = scene.clone();
        turned.fragments.reverse();
        let second: Buffers = program.ask(turned.arguments())?;
        close("what is drawn in reverse order", second, first, EXACT)
    })
}

fn first_of_equals() -> Law {
    Law::of(
        "of_equal_depths_the_first_stays",
        1,
        "A fragment with the stored depth changes nothing: of several equally near ones the first is seen.",
        "Two fragments are equally near. Does the later one win, and is that what \"nearer\" says?",
    )
    .over(scene_of_few_depths(), |scene, program| {
        let Buffers { rgb, .. } = program.ask(scene.arguments())?;
        for (i, j) in scene.pixels() {
            let nearest = scene.of_pixel(i, j).map(|fragment| fragment.z).fold(0.0, f32::max);
            let first = scene.of_pixel(i, j).find(|fragment| fragment.z == nearest && nearest > 0.0);
            let wanted = first.map_or(scene.background, |fragment| fragment.colour);
            close(&format!("the colour of pixel ({i}, {j})"), pixel(&rgb, i, j)?, wanted, EXACT)?;
        }
        Ok(())
    })
}

fn slide(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        if fragment.z > z[j][i] {
            rgb[j][i] = fragment.colour;
            z[j][i] = fragment.z;
        }
    }
    Buffers { rgb, z }
}

fn pixel_by_pixel(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    // The other loop outside, as a ray tracer has it.
    let nearest = |i: u32, j: u32| {
        let empty = Fragment { i, j, z: 0.0, colour: background };
        let here = fragments.iter().filter(|fragment| fragment.i == i && fragment.j == j);
        here.fold(empty, |nearest, fragment| if nearest.z < fragment.z { *fragment } else { nearest })
    };
    let rows = || (0..height).map(|j| (0..width).map(move |i| nearest(i, j)));
    Buffers {
        rgb: rows().map(|row| row.map(|fragment| fragment.colour).collect()).collect(),
        z: rows().map(|row| row.map(|fragment| fragment.z).collect()).collect(),
    }
}

fn sorted_first(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    // From back to front, and of equals the first one last, so that it stays.
    let mut order: Vec<&Fragment> = fragments.iter().rev().filter(|fragment| fragment.z > 0.0).collect();
    order.sort_by(|a, b| a.z.total_cmp(&b.z));
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in order {
        rgb[fragment.j as usize][fragment.i as usize] = fragment.colour;
        z[fragment.j as usize][fragment.i as usize] = fragment.z;
    }
    Buffers { rgb, z }
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(last_one_wins),
            looks_like: "every fragment is stored, near or not: the one drawn last wins",
            help: "That draws the far sphere over the near one. Compare with the stored z first.",
        },
        Misconception {
            program: program!(smaller_is_nearer),
            looks_like: "smaller z is taken to be nearer",
            help: "Many books count depth away from the eye. Here larger is nearer, and the farthest is 0.",
        },
        Misconception {
            program: program!(depth_not_stored),
            looks_like: "the winner's colour is stored, but not its depth",
            help: "The next fragment is then compared with the cleared depth and wins too: store both.",
        },
        Misconception {
            program: program!(colour_always_stored),
            looks_like: "the depth is compared, but the colour is stored in any case",
            help: "A fragment that is not nearer must change neither buffer.",
        },
        Misconception {
            program: program!(later_of_equals_wins),
            looks_like: "of equally near fragments the later one wins",
            help: "Nearer means strictly nearer: > and not ≥.",
        },
        Misconception {
            program: program!(rows_from_the_top),
            looks_like: "row 0 is taken to be the top of the picture",
            help: "Pixel (i, j) is `rgb[j][i]`, as it is: j runs upwards, and so do the rows of both buffers.",
        },
        Misconception {
            program: program!(columns_first),
            looks_like: "the column is asked first, then the row",
            help: "Buffers are lists of rows: `rgb[j][i]`. The first index says which row.",
        },
        Misconception {
            program: program!(background_is_black),
            looks_like: "the rgb-buffer is cleared to black",
            help: "Step 1 clears the rgb-buffer to the background colour.",
        },
    ]
}

fn last_one_wins(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        rgb[j][i] = fragment.colour;
        z[j][i] = fragment.z;
    }
    Buffers { rgb, z }
}

fn smaller_is_nearer(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![f32::INFINITY; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        if fragment.z < z[j][i] {
            rgb[j][i] = fragment.colour;
            z[j][i] = fragment.z;
        }
    }
    Buffers { rgb, z }
}

fn depth_not_stored(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        if fragment.z > z[j][i] {
            rgb[j][i] = fragment.colour;
        }
    }
    Buffers { rgb, z }
}

fn colour_always_stored(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![0.0_f32; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        z[j][i] = z[j][i].max(fragment.z);
        rgb[j][i] = fragment.colour;
    }
    Buffers { rgb, z }
}

fn later_of_equals_wins(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        if fragment.z >= z[j][i] {
            rgb[j][i] = fragment.colour;
            z[j][i] = fragment.z;
        }
    }
    Buffers { rgb, z }
}

fn rows_from_the_top(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; width as usize]; height as usize];
    let mut z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, (height - 1 - fragment.j) as usize);
        if fragment.z > z[j][i] {
            rgb[j][i] = fragment.colour;
            z[j][i] = fragment.z;
        }
    }
    Buffers { rgb, z }
}

fn columns_first(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![background; height as usize]; width as usize];
    let mut z = vec![vec![0.0; height as usize]; width as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        if fragment.z > z[i][j] {
            rgb[i][j] = fragment.colour;
            z[i][j] = fragment.z;
        }
    }
    Buffers { rgb, z }
}

fn background_is_black(fragments: &[Fragment], _background: Vec3, width: u32, height: u32) -> Buffers {
    let mut rgb = vec![vec![Vec3::ZERO; width as usize]; height as usize];
    let mut z = vec![vec![0.0; width as usize]; height as usize];
    for fragment in fragments {
        let (i, j) = (fragment.i as usize, fragment.j as usize);
        if fragment.z > z[j][i] {
            rgb[j][i] = fragment.colour;
            z[j][i] = fragment.z;
        }
    }
    Buffers { rgb, z }
}
