//! `cargo lab render`: how does this scene look?

use std::ffi::OsString;
use std::fmt::{self, Write};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use canvas::{Image, Rgb, codec, side_by_side};
use scene::{Builtin, Loaded, Named, Prepared, RenderError, Rendered, Renderer, Settings, builtin};

use super::args::RenderArgs;
use super::output::Target;
use super::progress::Progress;
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::{say, warn};

/// The order from left to right, if nobody asks for one renderer: as the lecture introduces them.
const ALL_RENDERERS: [Renderer; 3] = [Renderer::Painter, Renderer::ZBuffer, Renderer::Raytrace];

/// Pixels between pictures that stand side by side.
pub(crate) const GAP: u32 = 8;

/// A grey that is neither black nor white on screen (sRGB 0.5).
pub(crate) const GAP_COLOR: Rgb = Rgb::splat(0.214);

/// Draws the scene and writes the picture.
///
/// # Errors
/// [`Failure`] if the scene, the flags or the output file are not in order.
pub(crate) fn run(asked: &RenderArgs) -> Result<Outcome, Failure> {
    let source = Source::named(asked.scene.as_deref())?;
    let target = Target::check(&asked.output.clone().unwrap_or_else(|| source.picture()))?;
    let loaded = source.load()?;
    for warning in &loaded.warnings {
        warn(warning);
    }

    let settings = settings(asked, loaded.scene.settings);
    let renderers = asked.renderer.map_or(ALL_RENDERERS.to_vec(), |one| vec![one]);
    check_row(settings.size, renderers.len())?;
    let mut said = Ok(());
    let drawn =
        with_threads(asked.threads, || draw_all(&loaded, &settings, &renderers, asked.slide, &mut said))?;
    let pictures = drawn.map_err(|error| failure(error, &source))?;

    let pictures: Vec<&Image> = pictures.iter().collect();
    let row = side_by_side(&pictures, GAP, GAP_COLOR);
    let bytes = target.write(&row)?;
    // The picture is what was asked for: that nobody could be told of it is a failure, but no reason to lose it.
    said.and(say(&report(&target, &row, bytes, &renderers)))?;
    Ok(Outcome::Done)
}

/// Why there is no picture, with the name of the scene where its content is to blame.
fn failure(error: RenderError, source: &Source) -> Failure {
    let is_of_scene = !matches!(
        error,
        RenderError::Scene(_) | RenderError::Setting { .. } | RenderError::TooManyPixels { .. }
    );
    let failure = Failure::from(error);
    let problem = if is_of_scene { format!("{source}: {}", failure.problem) } else { failure.problem };
    Failure { problem, ..failure }
}

/// Where the scene comes from.
enum Source {
    Builtin(&'static Builtin),
    File(PathBuf),
}

impl Source {
    /// A built-in scene by its name, or else a file; without a name the first built-in scene.
    fn named(name: Option<&Path>) -> Result<Self, Failure> {
        let Some(name) = name else {
            return Ok(Self::Builtin(&builtin::all()[0]));
        };
        if let Some(builtin) = name.to_str().and_then(builtin::find) {
            return Ok(Self::Builtin(builtin));
        }
        if name.is_dir() {
            return Err(Failure::new(
                format!("{} is a folder, not a scene", name.display()),
                "give a .toml or .obj file, or a name that `cargo lab scenes` lists",
            ));
        }
        // Something that looks like a file name, or is one, shall be read; the reader says what is wrong with it.
        let is_file = name.extension().is_some() || name.components().count() > 1 || name.exists();
        if is_file {
            return Ok(Self::File(name.to_owned()));
        }
        let known: Vec<&str> = builtin::all().iter().map(|scene| scene.name).collect();
        Err(Failure::new(
            format!("there is no built-in scene and no file called {}", name.display()),
            format!("give a .toml or .obj file, or one of {}", known.join(", ")),
        ))
    }

    fn load(&self) -> Result<Loaded, Failure> {
        let loaded = match self {
            Self::Builtin(builtin) => builtin.load(),
            Self::File(path) => {
                let there = fs::metadata(path);
                let remedy = "give a .toml or .obj file, or a name that `cargo lab scenes` lists";
                there.map_err(|error| Failure::io("read", path, &error, remedy))?;
                scene::load(path)
            }
        };
        Ok(loaded?)
    }

    /// The picture's file unless one is named: in the current folder, called as the scene.
    fn picture(&self) -> PathBuf {
        let mut name = match self {
            Self::Builtin(builtin) => OsString::from(builtin.name),
            Self::File(path) => path.file_stem().unwrap_or_default().to_owned(),
        };
        name.push(".png");
        name.into()
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Builtin(builtin) => f.write_str(builtin.name),
            Self::File(path) => path.display().fmt(f),
        }
    }
}

/// The scene's settings, except what was asked for.
fn settings(asked: &RenderArgs, scene: Settings) -> Settings {
    Settings {
        shading: asked.shading.unwrap_or(scene.shading),
        size: asked.size.unwrap_or(scene.size),
        show: asked.show.unwrap_or(scene.show),
        samples: asked.samples.unwrap_or(scene.samples),
        shadows: scene.shadows && !asked.no_shadows,
        max_depth: asked.max_depth.unwrap_or(scene.max_depth),
        ..scene
    }
}

/// Refuses pictures that side by side have more pixels than `cargo lab compare` reads back, before they take any memory.
fn check_row((width, height): (u32, u32), pictures: usize) -> Result<(), Failure> {
    let pixels = pictures as u64 * u64::from(width) * u64::from(height);
    if pixels <= codec::MOST_PIXELS {
        return Ok(());
    }
    let most = codec::MOST_PIXELS;
    Err(match pictures {
        1 => Failure::new(
            format!("{width} × {height} pixels are too many: a picture may have {most}"),
            "choose a smaller --size",
        ),
        _ => Failure::new(
            format!(
                "{pictures} pictures of {width} × {height} pixels are too large: side by side they may have {most} pixels"
            ),
            "choose a smaller --size, or one --renderer",
        ),
    })
}

/// Does the work with so many threads; without a number, with one for each processor.
fn with_threads<T: Send>(threads: Option<u32>, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    let mut pool = rayon::ThreadPoolBuilder::new();
    if let Some(threads) = threads {
        pool = pool.num_threads(threads as usize);
    }
    let pool = pool.build().map_err(|error| {
        Failure::new(format!("cannot start the threads: {error}"), "ask for fewer --threads")
    })?;
    Ok(pool.install(work))
}

/// One picture a renderer, each announced when it is there; `said` keeps the first failure to do so.
fn draw_all(
    loaded: &Loaded,
    settings: &Settings,
    renderers: &[Renderer],
    slide: bool,
    said: &mut Result<(), Failure>,
) -> Result<Vec<Image>, RenderError> {
    let mut tell = |text: &str| {
        if said.is_ok() {
            *said = say(text);
        }
    };
    let prepared = scene::prepare(loaded)?;
    for warning in prepared.warnings() {
        warn(warning);
    }
    let mut pictures = Vec::new();
    for &renderer in renderers {
        let (rendered, time) = draw(&prepared, &Settings { renderer, ..*settings }, slide)?;
        let (width, height) = settings.size;
        tell(&format!("{renderer:10}{width} × {height} pixels in {}", readable(time)));
        for note in &rendered.notes {
            // The line above says whose note it is.
            let note = note.strip_prefix(&format!("{renderer}: ")).unwrap_or(note);
            tell(&format!("{:10}{note}", ""));
        }
        pictures.push(rendered.image);
    }
    Ok(pictures)
}

fn draw(prepared: &Prepared, settings: &Settings, slide: bool) -> Result<(Rendered, Duration), RenderError> {
    let progress = Progress::start(settings.renderer.name());
    let render = if slide { scene::render_slide } else { scene::render };
    let rendered = render(prepared, settings, &|share| progress.reached(share));
    let time = progress.finish();
    Ok((rendered?, time))
}

/// What was written, in a line.
fn report(target: &Target, row: &Image, bytes: usize, renderers: &[Renderer]) -> String {
    let mut text = format!(
        "wrote {}: {} × {} pixels, {:.1} kB",
        target.named().display(),
        row.width(),
        row.height(),
        bytes as f64 / 1000.0
    );
    if renderers.len() > 1 {
        let names: Vec<&str> = renderers.iter().map(|renderer| renderer.name()).collect();
        // Writing to a string cannot fail.
        let _ = write!(text, "; from left to right {}", names.join(", "));
    }
    text
}

fn readable(time: Duration) -> String {
    match time.as_secs_f64() {
        seconds if seconds < 1.0 => format!("{:.0} ms", seconds * 1000.0),
        seconds => format!("{seconds:.1} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_is_refused_before_it_takes_memory() {
        assert!(check_row((8192, 8192), 1).is_ok());
        assert!(check_row((4096, 4096), 3).is_ok());
        assert!(check_row((8192, 8192), 3).is_err());
    }

    #[test]
    fn a_picture_is_called_as_its_scene() {
        let picture = |path: &str| Source::File(path.into()).picture();
        assert_eq!(picture("a/b/spot.obj"), Path::new("spot.png"));
        assert_eq!(picture("room.v2.toml"), Path::new("room.v2.png"));
    }

    #[test]
    fn times_have_a_fitting_unit() {
        assert_eq!(readable(Duration::from_micros(12_400)), "12 ms");
        assert_eq!(readable(Duration::from_millis(83_450)), "83.5 s");
    }
}
