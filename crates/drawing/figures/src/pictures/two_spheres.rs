//! What happens to two spheres without depth? The one drawn last wins. (L15)

use scene::Renderer;

use super::studio::{built_in, painted_over, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::Values;

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L15", "L16"],
    name: "two-spheres",
    title: Text { en: "Two spheres with and without depth", nl: "Twee bollen met en zonder diepte" },
    caption: Text {
        en: "Two spheres of one size. Without depth (left) the farther one, which looks smaller, is drawn last and covers the nearer one. With a z-buffer (right) the order does not matter.",
        nl: "Twee bollen van gelijke grootte. Zonder diepte (links) wordt de verste, die kleiner lijkt, als laatste getekend en bedekt hij de dichtstbijzijnde. Met een z-buffer (rechts) maakt de volgorde niet uit.",
    },
    parameters: &[],
    size: (400, 300),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let loaded = built_in("two-spheres")?;
    let order: Vec<usize> = (0..loaded.scene.objects.len()).collect();
    let without = painted_over(&loaded, &order, values.size())?;
    let with = shot(&loaded, &settings(&loaded, Renderer::ZBuffer, values.size()))?;
    Ok(vec![
        Drawing::picture(
            "without-depth",
            Text {
                en: "The small sphere, which is farther away, covers part of the large one.",
                nl: "De kleine bol, die verder weg is, bedekt een deel van de grote.",
            },
            without,
        ),
        Drawing::picture(
            "with-depth",
            Text {
                en: "The large sphere, which is nearer, covers part of the small one.",
                nl: "De grote bol, die dichterbij is, bedekt een deel van de kleine.",
            },
            with,
        ),
    ])
}
