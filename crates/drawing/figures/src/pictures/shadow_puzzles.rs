//! How do shadows tell where things are? (L45)

use scene::{Loaded, Renderer, Settings};

use super::studio::{Fault, built_in, from_text, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::Values;

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L45", "L44"],
    name: "shadow-puzzles",
    title: Text { en: "Shadows tell where things are", nl: "Schaduwen vertellen waar dingen zijn" },
    caption: Text {
        en: "Three puzzles, each with and without shadows. Two bins that look alike: one floats. Stones that lie on ice so clear that it cannot be seen: their shadows lie on the lake's bed, so they seem to hover. Posts under a sun directly overhead: their shadows hide beneath them, and they stand nowhere; only the ring shows that the sun shines.",
        nl: "Drie puzzels, elk met en zonder schaduwen. Twee bakken die op elkaar lijken: één zweeft. Stenen op ijs zo helder dat het niet te zien is: hun schaduwen vallen op de bodem van het meer, dus lijken ze te zweven. Palen onder een zon recht boven: hun schaduwen vallen onder henzelf, en ze staan nergens; alleen de ring verraadt dat de zon schijnt.",
    },
    parameters: &[],
    size: (360, 270),
    draw,
    handles: without_handles,
};

struct Puzzle {
    name: &'static str,
    load: fn() -> Result<Loaded, Fault>,
    with: Text,
    without: Text,
}

const PUZZLES: [Puzzle; 3] = [
    Puzzle {
        name: "bin",
        load: || built_in("floating-bin"),
        with: Text {
            en: "Two bins: the left one stands on its shadow, that of the right one lies far behind and below it.",
            nl: "Twee bakken: de linker staat op zijn schaduw, die van de rechter ligt ver achter en onder hem.",
        },
        without: Text {
            en: "Two bins that look just alike.",
            nl: "Twee bakken die er precies hetzelfde uitzien.",
        },
    },
    Puzzle {
        name: "ice",
        load: || from_text(ICE),
        with: Text {
            en: "Stones with shadows that lie apart from them: they seem to hover.",
            nl: "Stenen met schaduwen die van hen af liggen: ze lijken te zweven.",
        },
        without: Text {
            en: "The same stones seem to lie on the ground.",
            nl: "Dezelfde stenen lijken op de grond te liggen.",
        },
    },
    Puzzle {
        name: "noon",
        load: || from_text(NOON),
        with: Text {
            en: "Posts and a ring under the sun: the posts have no shadow beside them, the ring has one straight beneath it.",
            nl: "Palen en een ring onder de zon: de palen hebben geen schaduw naast zich, de ring heeft er een recht onder zich.",
        },
        without: Text {
            en: "The same without shadows: the posts look as before, the ring might be anywhere.",
            nl: "Hetzelfde zonder schaduwen: de palen zien er net zo uit, de ring kan overal zijn.",
        },
    },
];

fn draw(values: &Values) -> Drawn {
    let mut drawings = Vec::new();
    for puzzle in &PUZZLES {
        let loaded = (puzzle.load)()?;
        for (shadows, word, alt) in [(true, "with", puzzle.with), (false, "without", puzzle.without)] {
            let settings = Settings { shadows, ..settings(&loaded, Renderer::Raytrace, values.size()) };
            let name = format!("{}-{word}-shadow", puzzle.name);
            drawings.push(Drawing::picture(name, Words::from(alt), shot(&loaded, &settings)?));
        }
    }
    Ok(drawings)
}

/// The ice itself is left out: it is too clear to be seen, which is the puzzle.
const ICE: &str = r#"
background = [0.70, 0.80, 0.88]
[camera]
eye = [0, 4.2, 9]
target = [0, 0.1, -0.6]
fov = 34
[[light]]
kind = "ambient"
color = [0.28, 0.30, 0.34]
[[light]]
kind = "directional"
to-light = [0.55, 1, 0.35]
color = [0.70, 0.66, 0.58]
[material.bed]
diffuse = [0.42, 0.52, 0.50]
specular = 0
[material.stone]
diffuse = [0.36, 0.33, 0.31]
specular = 0.1
exponent = 12
[[object]]
material = "bed"
polygons = [[[-60, -1.1, 9], [60, -1.1, 9], [60, -1.1, -80], [-60, -1.1, -80]]]
[[object]]
shape = "sphere"
level = 4
material = "stone"
transforms = [{ scale = [0.62, 0.3, 0.5] }]
instances = [
    [{ translate = [-1.6, 0.3, 0.6] }],
    [{ scale = 0.7 }, { rotate = 50, axis = [0, 1, 0] }, { translate = [0.5, 0.21, 1.7] }],
    [{ scale = 1.3 }, { rotate = -30, axis = [0, 1, 0] }, { translate = [1.5, 0.39, -1.6] }],
    [{ scale = 0.5 }, { translate = [-0.4, 0.15, -0.9] }],
]
"#;

const NOON: &str = r#"
background = [0.45, 0.66, 0.90]
[camera]
eye = [0.8, 2.6, 9]
target = [0, 0.9, 0]
fov = 34
[[light]]
kind = "ambient"
color = [0.30, 0.31, 0.33]
[[light]]
kind = "directional"
to-light = [0, 1, 0]
color = [0.66, 0.64, 0.60]
[material.ground]
diffuse = [0.62, 0.58, 0.48]
specular = 0
[material.post]
diffuse = [0.80, 0.30, 0.14]
specular = 0
[[object]]
material = "ground"
polygons = [[[-60, 0, 9], [60, 0, 9], [60, 0, -80], [-60, 0, -80]]]
[[object]]
shape = "box"
size = [0.22, 1.8, 0.22]
material = "post"
transforms = [{ translate = [0, 0.9, 0] }]
instances = [
    [{ translate = [-2.2, 0, 0.4] }],
    [{ translate = [-0.9, 0, 1.5] }],
    [{ translate = [0.6, 0, -1.2] }],
    [{ translate = [2.1, 0, 0.2] }],
]
[[object]]
shape = "torus"
major = 0.5
minor = 0.1
level = 4
material = "post"
transforms = [{ translate = [1.2, 1.1, 1.4] }]
"#;
