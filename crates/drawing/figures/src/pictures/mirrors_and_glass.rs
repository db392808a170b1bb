//! What does each level of recursion add? (L58)

use scene::{Renderer, Settings};

use super::studio::{Fault, built_in, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L58"],
    name: "mirrors-and-glass",
    title: Text { en: "Recursive ray tracing", nl: "Recursieve ray tracing" },
    caption: Text {
        en: "Mirrors and glass send rays on. Where the depth is used up a ray brings back the background: with depth 0 mirrors and glass are flat blue with their own highlights; with depth 1 a mirror shows the room, but not what other mirrors show, and glass not what is behind it; then the pictures in pictures appear.",
        nl: "Spiegels en glas sturen stralen door. Waar de diepte op is brengt een straal de achtergrond terug: met diepte 0 zijn spiegels en glas egaal blauw met hun eigen glansplekken; met diepte 1 toont een spiegel de kamer, maar niet wat andere spiegels tonen, en glas niet wat erachter ligt; daarna verschijnen de beelden in beelden.",
    },
    parameters: &[Parameter::count(
        "depth",
        Text { en: "greatest depth of recursion", nl: "grootste diepte van de recursie" },
        10.0,
        2.0,
        64.0,
    )],
    size: (400, 300),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let loaded = built_in("glass-and-mirror")?;
    let drawing = |max_depth: u32| -> Result<Drawing, Fault> {
        let settings = Settings { max_depth, ..settings(&loaded, Renderer::Raytrace, values.size()) };
        let alt = Words::new(
            format!(
                "A ball of glass, one of silver, a matt one and a tall mirror; rays are followed through {max_depth} surfaces."
            ),
            format!(
                "Een glazen bol, een zilveren, een matte en een hoge spiegel; stralen worden door {max_depth} oppervlakken gevolgd."
            ),
        );
        Ok(Drawing::picture(format!("depth-{max_depth}"), alt, shot(&loaded, &settings)?))
    };
    [0, 1, values.count("depth")].into_iter().map(drawing).collect()
}
