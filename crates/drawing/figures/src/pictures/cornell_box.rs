//! How does the Cornell box look under the lecture's lighting? (L23)

use scene::{Renderer, Settings, builtin, prepare, render};

use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::Values;

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L23"],
    name: "cornell-box",
    title: Text { en: "The Cornell box", nl: "De Cornell box" },
    caption: Text {
        en: "The room as it was measured, ray traced with local lighting and shadows. No light goes from wall to wall: the fronts of the boxes show ambient light alone, and the boxes take no colour from the red and the green wall.",
        nl: "De kamer zoals die is opgemeten, geraytraced met lokale belichting en schaduwen. Geen licht gaat van muur naar muur: de voorkanten van de blokken tonen alleen omgevingslicht, en de blokken nemen geen kleur aan van de rode en de groene muur.",
    },
    parameters: &[],
    size: (480, 480),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let loaded = builtin::find("cornell-box").ok_or("no built-in Cornell box")?.load()?;
    let settings =
        Settings { renderer: Renderer::Raytrace, size: values.size(), samples: 2, ..loaded.scene.settings };
    let image = render(&prepare(&loaded)?, &settings, &|_| ())?.image;
    let alt = Text {
        en: "A room with a red wall at the left, a green one at the right, and two white boxes that cast shadows on the floor.",
        nl: "Een kamer met links een rode en rechts een groene muur, en twee witte blokken die schaduwen op de vloer werpen.",
    };
    Ok(vec![Drawing::picture("", alt, image)])
}
