//! How is a function drawn pixel by pixel? Each pixel asks a question, or some share one, and the answers are painted.

use canvas::{Image, Rgb};
use course::{Plain, Value};

/// What one pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Dot {
    /// Nothing is there, and nobody was asked.
    Ground,
    /// Linear RGB; below zero too, where a function takes light away.
    Color(Rgb),
    /// There should be a colour, and none came, or no number.
    Missing,
}

/// From the answers to all questions of a panel, in their order, to its pixels: rows from below.
type Paint = dyn Fn(&[Option<Value>]) -> Vec<Dot> + Send + Sync;

/// One picture, that stands beside others.
pub(super) struct Panel {
    /// Width and height in pixels.
    pub(super) size: (u32, u32),
    /// What the function is asked.
    pub(super) questions: Vec<Vec<Value>>,
    paint: Box<Paint>,
}

impl Panel {
    /// Asks a question for each pixel (i, j), j upwards, where there is one; `color` says what an answer of type `T` looks like there.
    pub(super) fn of_pixels<T: Plain>(
        size: (u32, u32),
        question: impl Fn(u32, u32) -> Option<Vec<Value>>,
        color: impl Fn(u32, u32, T) -> Option<Rgb> + Send + Sync + 'static,
    ) -> Self {
        let asked: Vec<Option<Vec<Value>>> = places(size).map(|(i, j)| question(i, j)).collect();
        let is_asked: Vec<bool> = asked.iter().map(Option::is_some).collect();
        let paint = move |answers: &[Option<Value>]| {
            let mut answers = answers.iter();
            let dot = |((i, j), asked): ((u32, u32), &bool)| {
                if !*asked {
                    return Dot::Ground;
                }
                let answer = answers.next().and_then(Clone::clone).and_then(T::from_value);
                dot(answer.and_then(|answer| color(i, j, answer)))
            };
            places(size).zip(&is_asked).map(dot).collect()
        };
        Self { size, questions: asked.into_iter().flatten().collect(), paint: Box::new(paint) }
    }

    /// Asks some questions, and looks at all their answers for each pixel. Where one is missing, all is.
    pub(super) fn of_all<T: Plain>(
        size: (u32, u32),
        questions: Vec<Vec<Value>>,
        color: impl Fn(u32, u32, &[Option<T>]) -> Dot + Send + Sync + 'static,
    ) -> Self {
        let paint = move |answers: &[Option<Value>]| {
            let read = |answer: &Option<Value>| answer.clone().and_then(T::from_value);
            let answers: Vec<Option<T>> = answers.iter().map(read).collect();
            places(size).map(|(i, j)| color(i, j, &answers)).collect()
        };
        Self { size, questions, paint: Box::new(paint) }
    }

    /// The pixels that these answers make.
    pub(super) fn painted(&self, answers: &[Option<Value>]) -> Dots {
        Dots { size: self.size, dots: (self.paint)(answers) }
    }
}

/// A colour if it is one of numbers.
pub(super) fn dot(color: Option<Rgb>) -> Dot {
    color.filter(|color| color.is_finite()).map_or(Dot::Missing, Dot::Color)
}

/// All pixels, rows from below.
fn places((width, height): (u32, u32)) -> impl Iterator<Item = (u32, u32)> {
    (0..height).flat_map(move |j| (0..width).map(move |i| (i, j)))
}

/// The pixels of a panel.
#[derive(Debug)]
pub(super) struct Dots {
    size: (u32, u32),
    dots: Vec<Dot>,
}

/// Beside a thing is neither black nor white, so that both are seen.
const GROUND: Rgb = Rgb::splat(0.08);

/// No colour of a scene: where an answer is missing.
const MISSING: [Rgb; 2] = [Rgb::new(0.8, 0.0, 0.6), Rgb::new(0.15, 0.0, 0.12)];

/// What a colour below zero is shown in.
const BELOW: Rgb = Rgb::new(0.1, 0.25, 1.0);

impl Dots {
    /// The brightest channel.
    pub(super) fn brightest(&self) -> f32 {
        let brightest = |dot: &Dot| if let Dot::Color(c) = dot { c.max_element() } else { 0.0 };
        self.dots.iter().map(brightest).fold(0.0, f32::max)
    }

    /// How many pixels are asked for, and how many of these are missing.
    pub(super) fn counted(&self) -> (usize, usize) {
        let of = |wanted: fn(&Dot) -> bool| self.dots.iter().filter(|dot| wanted(dot)).count();
        (of(|dot| *dot != Dot::Ground), of(|dot| *dot == Dot::Missing))
    }

    /// As it is looked at: what is missing is hatched, what takes light away is blue.
    pub(super) fn image(&self, exposure: f32) -> Image {
        Image::from_fn(self.size.0, self.size.1, |i, j| match self.at(i, j) {
            Dot::Missing => MISSING[((i + j) / 2 % 2) as usize],
            dot => shown(dot, exposure),
        })
    }

    /// As it is compared: what is missing is no number.
    pub(super) fn comparable(&self, exposure: f32) -> Image {
        Image::from_fn(self.size.0, self.size.1, |i, j| shown(self.at(i, j), exposure))
    }

    fn at(&self, i: u32, j: u32) -> Dot {
        self.dots[(j * self.size.0 + i) as usize]
    }
}

fn shown(dot: Dot, exposure: f32) -> Rgb {
    match dot {
        Dot::Ground => GROUND,
        Dot::Missing => Rgb::NAN,
        Dot::Color(color) if color.min_element() < 0.0 => BELOW * (-exposure * color.min_element()).min(1.0),
        Dot::Color(color) => exposure * color,
    }
}

/// So many times as large, each pixel a square: what is counted is seen.
pub(super) fn enlarged(image: &Image, times: u32) -> Image {
    Image::from_fn(image.width() * times, image.height() * times, |i, j| image.get(i / times, j / times))
}
