//! In which order does the painter draw a scene, and what does each polygon cover again (L13, L14)?

use canvas::{Image, Rgb};
use scene::Settings;
use shading::{Facet, MOST_COMPARISONS, Surface, World};
use sheet::Words;
use transforms::Pipeline;
use zbuffer::painter::{Piece, Plan, Side, for_each_fragment, plan_within};
use zbuffer::{ScreenTriangle, project, rasterize_rows};

use super::{Drawing, Step, Told};
use crate::api::drawings::png;
use crate::story::names::Names;
use crate::{Look, Refusal, Stage};

/// As wide as a step's picture is at most.
const WIDTH: u32 = 480;

/// So many steps show single polygons; with more of them, a step shows several.
const MOST_STEPS: usize = 40;

/// So many triangles are taken at most.
const MOST_TRIANGLES: usize = 200_000;

/// The triangles that reach the screen, in drawing order, with the object and triangle that each comes from.
struct OnScreen {
    triangles: Vec<ScreenTriangle>,
    names: Vec<(usize, usize)>,
}

/// The picture after each polygon, or after each group of them.
pub(super) fn told(stage: &Stage, look: &Look) -> Result<Told, Refusal> {
    let width = look.width.min(WIDTH);
    let height = (look.height * width).div_ceil(look.width.max(1)).max(1);
    let small = Look { width, height, ..look.clone() };
    let settings = small.settings(scene::Renderer::Painter)?;
    let prepared = stage.prepared(&small)?;
    if prepared.triangle_count() > MOST_TRIANGLES {
        return Err(Refusal::new(
            format!(
                "more than {MOST_TRIANGLES} triangles are too many to take step by step: choose a lower level"
            ),
            format!(
                "meer dan {MOST_TRIANGLES} driehoeken zijn te veel om stap voor stap te doen: kies een lager niveau"
            ),
        ));
    }
    let pipeline = prepared.pipeline(width, height)?;
    let names = Names::of(&*stage.scene(&small)?);
    prepared.in_world(&settings, |world| painted(world, &pipeline, &settings, &names))
}

fn painted(world: &World, pipeline: &Pipeline, settings: &Settings, names: &Names) -> Result<Told, Refusal> {
    let on_screen = OnScreen::of(world, pipeline);
    let plan = plan_within(&on_screen.triangles, MOST_COMPARISONS).ok_or_else(|| {
        Refusal::new(
            "the polygons are too entangled to find an order in a few seconds",
            "de polygonen zijn te verstrengeld om in een paar seconden een volgorde te vinden",
        )
    })?;
    let mut canvas = Canvas {
        image: Image::new(pipeline.width(), pipeline.height(), world.background),
        is_painted: vec![false; (pipeline.width() * pipeline.height()) as usize],
    };
    let mut steps = vec![canvas.step(beginning(&plan, &on_screen), cycles(&plan, &on_screen, names))?];
    // Pieces none of whose pixels are on the screen are no steps.
    let pieces: Vec<&Piece> = plan.pieces.iter().collect();
    let drawn = pieces.len().max(1);
    let in_a_group = if drawn <= MOST_STEPS { 1 } else { drawn.div_ceil(MOST_STEPS) };
    for (k, group) in pieces.chunks(in_a_group).enumerate() {
        let mut work = (0, 0);
        for piece in group {
            let (object, triangle) = on_screen.names[piece.triangle];
            let lighting = world.lighting(pipeline);
            let facet = Facet::new(&world.objects[object], triangle, lighting.eye);
            let surface = Surface::new(settings.shading, facet, lighting);
            let (pixels, again) = canvas.paint(piece, &on_screen.triangles, &surface);
            work = (work.0 + pixels, work.1 + again);
        }
        let first = k * in_a_group + 1;
        let words = group_words(group, (first, drawn), work, &on_screen, names);
        steps.push(canvas.step(words, Vec::new())?);
    }
    let title = Words::new(
        "The painter's algorithm, from back to front",
        "Painter's algorithm, van achter naar voor",
    );
    Ok(Told { title, steps })
}

impl OnScreen {
    fn of(world: &World, pipeline: &Pipeline) -> Self {
        let (width, height) = (pipeline.width(), pipeline.height());
        let (clip_from_world, eye) = (pipeline.clip_from_world(), pipeline.camera().eye());
        let mut all = Self { triangles: Vec::new(), names: Vec::new() };
        for (index, object) in world.objects.iter().enumerate() {
            for k in 0..object.mesh.len() {
                let corners = Facet::new(object, k, eye).corners;
                for triangle in project(&clip_from_world, width, height, &corners).triangles() {
                    let mut is_seen = false;
                    rasterize_rows(&triangle, width, 0..height, |_| is_seen = true);
                    if is_seen {
                        all.triangles.push(triangle);
                        all.names.push((index, k));
                    }
                }
            }
        }
        all
    }

    fn name(&self, k: usize, names: &Names) -> Words {
        let (object, triangle) = self.names[k];
        names.triangle(object, triangle)
    }
}

/// What has been painted.
struct Canvas {
    image: Image,
    is_painted: Vec<bool>,
}

impl Canvas {
    /// Paints one piece; says how many pixels it has, and how many of them were painted before.
    fn paint(&mut self, piece: &Piece, triangles: &[ScreenTriangle], surface: &Surface) -> (usize, usize) {
        let (width, height) = (self.image.width(), self.image.height());
        let alone = Plan { pieces: vec![piece.clone()], cycles: Vec::new(), splits: 0 };
        let (mut pixels, mut again) = (0, 0);
        for_each_fragment(&alone, triangles, width, height, |_, fragment| {
            let color: Rgb = surface.color(fragment.weights);
            self.image.set(fragment.i, fragment.j, color);
            let painted = &mut self.is_painted[(fragment.j * width + fragment.i) as usize];
            pixels += 1;
            again += usize::from(std::mem::replace(painted, true));
        });
        (pixels, again)
    }

    /// The picture as it stands.
    fn step(&self, words: Words, lines: Vec<Words>) -> Result<Step, Refusal> {
        Ok(Step::new(words).lines(lines).showing(Drawing::Picture(png(&self.image)?)))
    }
}

fn beginning(plan: &Plan, on_screen: &OnScreen) -> Words {
    let (triangles, pieces) = (on_screen.triangles.len(), plan.pieces.len());
    if plan.cycles.is_empty() {
        return Words::new(
            format!(
                "The background. {triangles} triangles have pixels on the screen; there is an order from back to front."
            ),
            format!(
                "De achtergrond. {triangles} driehoeken hebben pixels op het scherm; er is een volgorde van achter naar voor."
            ),
        );
    }
    let (cycles, splits) = (plan.cycles.len(), plan.splits);
    Words::new(
        format!(
            "The background. Of {triangles} triangles some hide each other in turn (cycles: {cycles}): no order is right. {splits} cuts make {pieces} pieces of them, which have one."
        ),
        format!(
            "De achtergrond. Van {triangles} driehoeken verbergen sommige elkaar over en weer (cycli: {cycles}): geen volgorde is juist. {splits} sneden maken er {pieces} stukken van, die er wel een hebben."
        ),
    )
}

/// Who is in the way of an order.
fn cycles(plan: &Plan, on_screen: &OnScreen, names: &Names) -> Vec<Words> {
    const MOST: usize = 6;
    let told = plan.cycles.iter().take(MOST).map(|cycle| {
        let members: Vec<Words> =
            cycle.polygons.iter().take(MOST).map(|k| on_screen.name(*k, names)).collect();
        let (en, nl): (Vec<_>, Vec<_>) = members.into_iter().map(|words| (words.en, words.nl)).unzip();
        if cycle.is_piercing() {
            Words::new(
                format!("These pass through each other: {}.", en.join("; ")),
                format!("Deze gaan door elkaar heen: {}.", nl.join("; ")),
            )
        } else {
            Words::new(
                format!("A cycle, each partly behind the next: {}.", en.join("; ")),
                format!("Een cyclus, elk gedeeltelijk achter de volgende: {}.", nl.join("; ")),
            )
        }
    });
    told.collect()
}

fn group_words(
    group: &[&Piece],
    (first, all): (usize, usize),
    (pixels, again): (usize, usize),
    on_screen: &OnScreen,
    names: &Names,
) -> Words {
    let covered = Words::new(
        format!("{pixels} pixels painted, {again} of them over what was there."),
        format!("{pixels} pixels geschilderd, waarvan {again} over wat er al stond."),
    );
    let what = match group {
        [piece] => one(piece, on_screen, names),
        _ => several(group, on_screen, names),
    };
    let last = first + group.len() - 1;
    let numbers = if first == last { format!("{first}") } else { format!("{first}–{last}") };
    Words::new(
        format!("{numbers} of {all}: {}. {}", what.en, covered.en),
        format!("{numbers} van {all}: {}. {}", what.nl, covered.nl),
    )
}

/// One piece: a triangle, or a part that a cut left.
fn one(piece: &Piece, on_screen: &OnScreen, names: &Names) -> Words {
    let name = on_screen.name(piece.triangle, names);
    let cuts = piece.cuts().iter().map(|cut| {
        let by = on_screen.name(cut.by, names);
        match cut.side {
            Side::Nearer => Words::new(
                format!(", the part before the plane of {}", by.en),
                format!(", het deel vóór het vlak van {}", by.nl),
            ),
            Side::Farther => Words::new(
                format!(", the part behind the plane of {}", by.en),
                format!(", het deel achter het vlak van {}", by.nl),
            ),
        }
    });
    cuts.fold(name, |all, cut| Words::new(all.en + &cut.en, all.nl + &cut.nl))
}

/// Several pieces: how many of each object.
fn several(group: &[&Piece], on_screen: &OnScreen, names: &Names) -> Words {
    let mut objects: Vec<(usize, usize)> = Vec::new();
    for piece in group {
        let (object, _) = on_screen.names[piece.triangle];
        match objects.iter_mut().find(|(known, _)| *known == object) {
            Some((_, count)) => *count += 1,
            None => objects.push((object, 1)),
        }
    }
    let told = objects.into_iter().map(|(object, count)| {
        let name = names.object(object);
        (format!("{count} of {}", name.en), format!("{count} van {}", name.nl))
    });
    let (en, nl): (Vec<_>, Vec<_>) = told.unzip();
    Words::new(format!("triangles: {}", en.join(", ")), format!("driehoeken: {}", nl.join(", ")))
}
