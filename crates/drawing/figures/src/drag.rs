//! Which values bring a handle to a place? Those for which it comes nearest, found by trying.
//!
//! No figure knows its own inverse. It says where a handle is for given values; from there this is least squares by the
//! method of Gauss and Newton, with the derivatives taken as differences and Levenberg's damping, inside the ranges of the
//! parameters. Where that stops short (angles wrap, a place hardly moves), values all over the ranges are tried first.

use std::error::Error;

use glam::{Mat2, Vec2, vec2};

use crate::figure::Figure;
use crate::parameter::{Parameter, Values};

/// Why a handle cannot be dragged.
#[derive(Debug, thiserror::Error)]
pub enum DragError {
    /// No such drawing, or no such handle in it.
    #[error("drawing {drawing} of {figure} has no handle {handle}")]
    NoHandle {
        /// The figure, by its stem.
        figure: String,
        /// The drawing, counted from 0.
        drawing: usize,
        /// The handle, counted from 0.
        handle: usize,
    },
    /// The figure does not know where its handles are for the values that were given.
    #[error(transparent)]
    Figure(#[from] Box<dyn Error + Send + Sync>),
}

/// The values for which a handle comes nearest to the place `to`, given as shares of the drawing's width and height from
/// its top left corner. Only the parameters of this handle change; they stay in their ranges, and whole ones whole. A place
/// beyond reach brings the handle to the nearest end; one that is no place leaves it.
///
/// # Errors
/// [`DragError`] if there is no such handle, or if the figure cannot say where it is.
pub fn drag(
    figure: &Figure,
    values: &Values,
    drawing: usize,
    handle: usize,
    to: Vec2,
) -> Result<Values, DragError> {
    let lists = (figure.handles)(values)?;
    let taken = lists.get(drawing).and_then(|list| Some((list.size, list.handles.get(handle)?)));
    let (size, taken) =
        taken.ok_or_else(|| DragError::NoHandle { figure: figure.stem(), drawing, handle })?;
    if !to.is_finite() {
        return Ok(values.clone());
    }
    let moved = |name: &&str| figure.parameters.iter().find(|parameter| parameter.name == *name).copied();
    let parameters: Vec<Parameter> = taken.moves.iter().filter_map(moved).collect();
    let scale = size / size.max_element();
    let start = parameters.iter().map(|parameter| values.number(parameter.name)).collect();
    let search = Search { figure, values, which: (drawing, handle), scale, to, parameters };
    Ok(search.nearest(start))
}

/// Nearer than this, in widths of the drawing, nobody sees a difference: a quarter of a pixel in a thousand.
const NEAR: f32 = 2.5e-4;
/// So near it is as exact as f32 places are.
const EXACT: f32 = 1e-6;

/// Values of the parameters that move, in their order.
type Point = Vec<f32>;

struct Search<'a> {
    figure: &'a Figure,
    values: &'a Values,
    /// The drawing and the handle.
    which: (usize, usize),
    /// From shares to widths (or heights, if it is higher than wide) of the drawing, so that distances are what the eye sees.
    scale: Vec2,
    to: Vec2,
    parameters: Vec<Parameter>,
}

/// A point that was tried.
#[derive(Clone)]
struct Tried {
    point: Point,
    /// From the place that is asked for to where the handle is.
    gap: Vec2,
}

impl Tried {
    fn distance(&self) -> f32 {
        self.gap.length()
    }
}

impl Search<'_> {
    fn nearest(&self, start: Point) -> Values {
        let Some(here) = self.tried(start) else { return self.values.clone() };
        let mut best = self.best_neighbour(self.descended(here));
        if self.parameters.iter().all(|parameter| parameter.whole) {
            best = self.swept(best);
        } else if best.distance() > NEAR {
            for start in self.scanned() {
                let other = self.descended(start);
                // What is not clearly better is not worth a jump.
                if other.distance() + NEAR < best.distance() {
                    best = other;
                }
                if best.distance() <= NEAR {
                    break;
                }
            }
        }
        self.at(&best.point)
    }

    /// The values with these numbers in place of those that move.
    fn at(&self, point: &[f32]) -> Values {
        let mut values = self.values.clone();
        for (parameter, number) in self.parameters.iter().zip(point) {
            // In range and whole by `allowed`.
            let set = values.set(parameter.name, *number);
            debug_assert!(set.is_ok(), "{set:?}");
        }
        values
    }

    fn tried(&self, point: Point) -> Option<Tried> {
        let lists = (self.figure.handles)(&self.at(&point)).ok()?;
        let at = lists.get(self.which.0)?.handles.get(self.which.1)?.at;
        let gap = self.scale * (at - self.to);
        gap.is_finite().then_some(Tried { point, gap })
    }

    /// The number nearest to `number` that the parameter may have.
    fn allowed(&self, k: usize, number: f32) -> f32 {
        let Parameter { least, greatest, whole, .. } = self.parameters[k];
        let inside = number.clamp(least, greatest);
        if whole { inside.round() } else { inside }
    }

    /// From `start` downhill, until it is near or gets no nearer.
    fn descended(&self, start: Tried) -> Tried {
        const STEPS: usize = 8;
        const FIRST_DAMPING: f32 = 1e-3;
        const MOST_DAMPING: f32 = 1e3;
        let (mut best, mut damping) = (start, FIRST_DAMPING);
        for _ in 0..STEPS {
            if best.distance() < EXACT || damping > MOST_DAMPING {
                break;
            }
            let columns = self.slopes(&best);
            let next = self.step(&best, &columns, damping);
            if next == best.point {
                break;
            }
            match self.tried(next) {
                Some(next) if next.distance() < best.distance() => {
                    best = next;
                    damping *= 0.1;
                }
                _ => damping *= 30.0,
            }
        }
        best
    }

    /// How the place changes with each parameter, over its whole range.
    fn slopes(&self, here: &Tried) -> Vec<Vec2> {
        /// Of the range: small against what bends, large against the rounding of places.
        const SHARE: f32 = 1e-3;
        let slope = |k: usize| {
            let Parameter { least, greatest, whole, .. } = self.parameters[k];
            let range = greatest - least;
            let length = if whole { 1.0 } else { SHARE * range };
            // Forwards, or backwards at the end of the range or where forwards nothing changes.
            let along = |length: f32| {
                let mut point = here.point.clone();
                point[k] = self.allowed(k, point[k] + length);
                let change = point[k] - here.point[k];
                let there = (change != 0.0).then(|| self.tried(point)).flatten()?;
                let slope = (there.gap - here.gap) * (range / change);
                (slope != Vec2::ZERO).then_some(slope)
            };
            along(length).or_else(|| along(-length)).unwrap_or(Vec2::ZERO)
        };
        (0..self.parameters.len()).map(slope).collect()
    }

    /// One damped step of Gauss and Newton from `here`. A parameter at the end of its range that would leave it stays there,
    /// and the other is asked again without it.
    fn step(&self, here: &Tried, columns: &[Vec2], damping: f32) -> Point {
        let mut columns = columns.to_vec();
        loop {
            let change = solved(&columns, here.gap, damping);
            let mut point = here.point.clone();
            let mut blocked = None;
            for (k, number) in point.iter_mut().enumerate() {
                let Parameter { least, greatest, .. } = self.parameters[k];
                let wanted = *number + change[k] * (greatest - least);
                *number = self.allowed(k, wanted);
                if *number == here.point[k] && !(least..=greatest).contains(&wanted) {
                    blocked = Some(k);
                }
            }
            match blocked {
                Some(k) if columns[k] != Vec2::ZERO => columns[k] = Vec2::ZERO,
                _ => return point,
            }
        }
    }

    /// The best few of some values all over the ranges: many, since at a pole all azimuths are at one place, and
    /// an angle is at both ends of its range.
    fn scanned(&self) -> Vec<Tried> {
        /// For one parameter, and for each of two.
        const COUNTS: [usize; 2] = [17, 9];
        const BEST: usize = 12;
        let last = if self.parameters.len() == 1 { COUNTS[0] - 1 } else { COUNTS[1] - 1 };
        let mut points = vec![Vec::new()];
        for (k, Parameter { least, greatest, .. }) in self.parameters.iter().enumerate() {
            let number = |n: usize| self.allowed(k, least + n as f32 / last as f32 * (greatest - least));
            let longer = |point: Point| (0..=last).map(move |n| [&point[..], &[number(n)]].concat());
            points = points.into_iter().flat_map(longer).collect();
        }
        let mut tried: Vec<Tried> = points.into_iter().filter_map(|point| self.tried(point)).collect();
        tried.sort_by(|a, b| a.distance().total_cmp(&b.distance()));
        tried.truncate(BEST);
        tried
    }

    /// All values of each whole parameter, one parameter after the other: where a pixel lies beyond its screen, a step
    /// changes nothing.
    fn swept(&self, start: Tried) -> Tried {
        let mut best = start;
        for k in 0..self.parameters.len() {
            let Parameter { least, greatest, .. } = self.parameters[k];
            let values = (0..=(greatest - least) as usize).map(|n| least + n as f32);
            let points = values.map(|value| {
                let mut point = best.point.clone();
                point[k] = value;
                point
            });
            let tried = points.filter_map(|point| self.tried(point));
            let nearest = tried.min_by(|a, b| a.distance().total_cmp(&b.distance()));
            best = nearest.filter(|other| other.distance() + EXACT < best.distance()).unwrap_or(best);
        }
        best
    }

    /// Rounding may have missed the best whole numbers by one.
    fn best_neighbour(&self, here: Tried) -> Tried {
        let reach = |k: usize| if self.parameters[k].whole { 1_i8 } else { 0 };
        let count = self.parameters.len();
        let ranges: Vec<i8> = (0..2).map(|k| if k < count { reach(k) } else { 0 }).collect();
        let mut best = here.clone();
        for x in -ranges[0]..=ranges[0] {
            for y in -ranges[1]..=ranges[1] {
                let steps = [x, y];
                let point: Point = here
                    .point
                    .iter()
                    .enumerate()
                    .map(|(k, number)| self.allowed(k, number + f32::from(steps[k.min(1)])))
                    .collect();
                let other = if point == here.point { None } else { self.tried(point) };
                best = other.filter(|other| other.distance() + EXACT < best.distance()).unwrap_or(best);
            }
        }
        best
    }
}

/// The change that brings the gap nearest to nothing, if places change along `columns`; each damped as it is steep.
fn solved(columns: &[Vec2], gap: Vec2, damping: f32) -> [f32; 2] {
    let column = |k: usize| columns.get(k).copied().unwrap_or(Vec2::ZERO);
    let (a, b) = (column(0), column(1));
    // A column of zeros gets a one on the diagonal, so that its parameter stays.
    let diagonal = |c: Vec2| {
        let square = c.length_squared();
        if square > 0.0 { square * (1.0 + damping) } else { 1.0 }
    };
    let squares = Mat2::from_cols(vec2(diagonal(a), a.dot(b)), vec2(a.dot(b), diagonal(b)));
    let change = squares.inverse() * -vec2(a.dot(gap), b.dot(gap));
    if change.is_finite() { change.to_array() } else { [0.0; 2] }
}
