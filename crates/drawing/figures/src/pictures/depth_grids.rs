//! What is in the depth buffer after each polygon? (L17)

use canvas::{Image, Rgb};
use glam::{Vec2, vec2};
use sheet::{Ink, Letters, Sheet, Side};
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, draw::draw as draw_triangle};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::on_screen;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L17", "L16", "E18"],
    name: "depth-grids",
    title: Text { en: "The z-buffer step by step", nl: "Het z-buffer-algoritme stap voor stap" },
    caption: Text {
        en: "The depth buffer after clearing and after each of three polygons; larger is nearer, 0 is the farthest. A polygon is drawn only where it is nearer than what is stored. (The slide's first grid lost a row.)",
        nl: "De z-buffer na het wissen en na elk van drie polygonen; groter is dichterbij, 0 is het verst. Een polygoon wordt alleen getekend waar hij dichterbij is dan wat is opgeslagen. (Het eerste raster van de slide mist een rij.)",
    },
    parameters: &[
        Parameter::number("first", DEPTH_OF_FIRST, 10.0, 1.0, 20.0),
        Parameter::number("second", DEPTH_OF_SECOND, 5.0, 1.0, 20.0),
        Parameter::number("third", DEPTH_OF_THIRD, 15.0, 1.0, 20.0),
    ],
    size: (640, 480),
    draw,
    handles: without_handles,
};

const DEPTH_OF_FIRST: Text = Text { en: "z of the first polygon", nl: "z van de eerste polygoon" };
const DEPTH_OF_SECOND: Text = Text { en: "z of the second polygon", nl: "z van de tweede polygoon" };
const DEPTH_OF_THIRD: Text = Text { en: "z of the third polygon", nl: "z van de derde polygoon" };

/// The slide's grid: columns and rows.
pub const GRID: (u32, u32) = (WIDTH, HEIGHT);
const WIDTH: u32 = 6;
const HEIGHT: u32 = 5;

fn draw(values: &Values) -> Drawn {
    let [first, second, third] = ["first", "second", "third"].map(|name| values.number(name));
    let polygons = polygons_of_the_grids([first, second, third]);
    let mut image = Image::new(WIDTH, HEIGHT, Rgb::ZERO);
    let mut depth = DepthBuffer::new(WIDTH, HEIGHT, DepthFormat::F32);
    let mut grids = vec![grid(&depth)];
    for (k, polygon) in polygons.iter().enumerate() {
        let color = Rgb::splat((k + 1) as f32);
        for triangle in polygon {
            draw_triangle(triangle, |_| color, &mut image, &mut depth);
        }
        grids.push(grid(&depth));
    }
    let inks = |z: f32| match z {
        _ if z == third => Ink::A,
        _ if z == first => Ink::B,
        _ if z == second => Ink::C,
        _ => Ink::Faint,
    };
    let covered = grids[3].iter().filter(|z| **z == third).count();
    let alt = Words::new(
        format!(
            "Four grids of 6 by 5 depths: all 0; then {first} at the lower left; then {second} around it; then {third} in a triangle over {covered} cells."
        ),
        format!(
            "Vier rasters van 6 bij 5 dieptes: alles 0; dan {first} linksonder; dan {second} eromheen; dan {third} in een driehoek over {covered} cellen."
        ),
    );
    let mut sheet = Sheet::new(Vec2::ZERO, vec2(29.0, 7.2), 1160.0);
    for (k, grid) in grids.iter().enumerate() {
        draw_grid(&mut sheet, grid, k, inks);
    }
    Ok(vec![Drawing::only(alt, |alt| sheet.svg(alt))])
}

/// The stored depths, rows from the top down, 0 where nothing was drawn.
fn grid(depth: &DepthBuffer) -> Vec<f32> {
    let rows = (0..HEIGHT).rev();
    rows.flat_map(|j| (0..WIDTH).map(move |i| (i, j))).map(|(i, j)| depth.get(i, j).unwrap_or(0.0)).collect()
}

fn draw_grid(sheet: &mut Sheet, grid: &[f32], k: usize, ink: impl Fn(f32) -> Ink) {
    let corner = vec2(0.7 + 7.1 * k as f32, 0.6);
    sheet.label(corner + vec2(3.0, 5.25), Side::Above, (k + 1).to_string(), Letters::Plain, Ink::Main);
    for (cell, z) in grid.iter().enumerate() {
        let (i, row) = (cell as u32 % WIDTH, cell as u32 / WIDTH);
        let at = corner + vec2(i as f32, (HEIGHT - 1 - row) as f32);
        let square = [at, at + Vec2::X, at + Vec2::ONE, at + Vec2::Y];
        if *z != 0.0 {
            sheet.wash(&square, ink(*z));
        }
        sheet.polygon(&square, Ink::Faint.pen().fine());
        let letters = if *z == 0.0 { Ink::Main } else { ink(*z) };
        sheet.label_sized(at + Vec2::splat(0.5), Side::Middle, z.to_string(), Letters::Plain, letters, 17.0);
    }
}

/// The slide's three polygons at these depths, in drawing order, each as triangles with corners in pixels, y upwards (L17): two
/// rectangles from the lower left corner and a triangle that leaves the screen.
#[must_use]
pub fn polygons_of_the_grids([first, second, third]: [f32; 3]) -> [Vec<ScreenTriangle>; 3] {
    [
        rectangle(first, vec2(3.5, 2.5)),
        rectangle(second, vec2(5.5, 4.5)),
        vec![triangle(third, [vec2(2.5, 5.0), vec2(-0.25, -0.5), vec2(8.0, -0.5)])],
    ]
}

/// A triangle of one depth.
fn triangle(z: f32, corners: [Vec2; 3]) -> ScreenTriangle {
    on_screen::triangle(corners.map(|corner| corner.extend(z).to_array()))
}

/// The rectangle from the screen's lower left corner to `end`, as two triangles.
fn rectangle(z: f32, end: Vec2) -> Vec<ScreenTriangle> {
    let start = Vec2::splat(-0.5);
    let corners = [start, vec2(end.x, start.y), end, vec2(start.x, end.y)];
    vec![triangle(z, [corners[0], corners[1], corners[2]]), triangle(z, [corners[0], corners[2], corners[3]])]
}
