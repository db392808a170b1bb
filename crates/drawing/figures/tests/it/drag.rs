//! Does a dragged handle follow the hand, in every figure?

use figures::{Content, DragError, Figure, Handle, Parameter, Values, drag};
use glam::{Vec2, vec2};

/// Small, so that pictures take no time; not square, so that width and height are told apart.
const SIZE: (u32, u32) = (48, 36);
/// Values that are tried for each handle.
const TRIALS: usize = 40;

/// Numbers without a pattern, the same in every run (SplitMix64).
struct Random(u64);

impl Random {
    /// From 0 to 1.
    fn share(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / (1 << 24) as f32
    }

    /// A value that the parameter may have.
    fn value(&mut self, parameter: &Parameter) -> f32 {
        let Parameter { least, greatest, whole, .. } = *parameter;
        let value = (least + self.share() * (greatest - least)).clamp(least, greatest);
        if whole { value.round() } else { value }
    }

    /// The values with others for these parameters.
    fn values(&mut self, figure: &Figure, names: &[&str], values: &Values) -> Values {
        let mut values = values.clone();
        for parameter in figure.parameters.iter().filter(|parameter| names.contains(&parameter.name)) {
            values.set(parameter.name, self.value(parameter)).expect("a value in the range");
        }
        values
    }
}

fn usual(figure: &Figure) -> Values {
    let mut values = Values::of(figure);
    values.set_size(SIZE.0, SIZE.1).expect("a size for a figure");
    values
}

/// A handle of a figure: drawing and handle, counted from 0.
type Which = (&'static Figure, usize, usize);

/// `None` where nothing is to be seen of it for these values: a shadow behind the eye.
fn visible(which: Which, values: &Values) -> Option<Handle> {
    let (figure, drawing, handle) = which;
    let lists = (figure.handles)(values).unwrap_or_else(|error| panic!("{}: {error}", figure.stem()));
    lists[drawing].handles.get(handle).cloned()
}

fn handle(which: Which, values: &Values) -> Handle {
    visible(which, values).unwrap_or_else(|| panic!("{} has no such handle", which.0.stem()))
}

/// The drawing's width and height as shares of the longer one: places times this are as far apart as the eye sees them.
fn proportions((figure, drawing, _): Which, values: &Values) -> Vec2 {
    let size = (figure.handles)(values).expect("handles")[drawing].size;
    size / size.max_element()
}

fn dragged((figure, drawing, handle): Which, values: &Values, to: Vec2) -> Values {
    drag(figure, values, drawing, handle, to).unwrap_or_else(|error| panic!("{}: {error}", figure.stem()))
}

/// Every handle of every figure.
fn all() -> Vec<Which> {
    let mut all = Vec::new();
    for figure in figures::all() {
        let lists = (figure.handles)(&usual(figure)).unwrap_or_else(|e| panic!("{}: {e}", figure.stem()));
        for (drawing, list) in lists.iter().enumerate() {
            all.extend((0..list.handles.len()).map(|handle| (figure, drawing, handle)));
        }
    }
    all
}

#[test]
fn every_handle_is_in_its_drawing_and_moves_what_the_figure_has() {
    assert!(all().len() >= 35, "{} handles", all().len());
    for which in all() {
        let (figure, ..) = which;
        let handle = handle(which, &usual(figure));
        let name = format!("{}: {}", figure.stem(), handle.name.en);
        assert!(
            handle.at.cmpge(Vec2::ZERO).all() && handle.at.cmple(Vec2::ONE).all(),
            "{name} {}",
            handle.at
        );
        assert!((1..=2).contains(&handle.moves.len()), "{name} moves {:?}", handle.moves);
        assert!(!handle.name.en.is_empty() && !handle.name.nl.is_empty(), "{name}");
        for parameter in &handle.moves {
            assert!(figure.parameters.iter().any(|known| known.name == *parameter), "{name}: {parameter}");
        }
    }
}

#[test]
fn drawings_have_the_handles_that_their_figure_gives() {
    for figure in figures::all() {
        let values = usual(figure);
        let drawings = (figure.draw)(&values).expect("a drawing");
        let lists = (figure.handles)(&values).expect("handles");
        assert!(lists.len() <= drawings.len(), "{}", figure.stem());
        for (k, drawing) in drawings.iter().enumerate() {
            let expected = lists.get(k).map_or(&[][..], |list| &list.handles);
            assert_eq!(drawing.handles, expected, "{} {}", figure.stem(), drawing.name);
        }
    }
}

/// Dots, tips and ends of lines of an SVG file, in pixels.
fn places(svg: &str) -> Vec<Vec2> {
    let numbers = |text: &str| -> Vec<f32> {
        text.split(|c: char| !c.is_ascii_digit() && c != '.' && c != '-')
            .filter_map(|n| n.parse().ok())
            .collect()
    };
    let document = roxmltree::Document::parse(svg).expect("SVG");
    let mut places = Vec::new();
    for node in document.descendants() {
        let center = [node.attribute("cx"), node.attribute("cy")].map(|n| n.and_then(|n| n.parse().ok()));
        if let [Some(x), Some(y)] = center {
            places.push(vec2(x, y));
        }
        for attribute in ["points", "d"] {
            let numbers = node.attribute(attribute).map(numbers).unwrap_or_default();
            places.extend(numbers.chunks_exact(2).map(|pair| vec2(pair[0], pair[1])));
        }
    }
    places
}

#[test]
fn a_handle_of_a_diagram_lies_on_something_that_is_drawn() {
    let mut random = Random(3);
    for figure in figures::all() {
        let names: Vec<&str> = figure.parameters.iter().map(|parameter| parameter.name).collect();
        if all().iter().all(|(other, ..)| other.name != figure.name) {
            continue;
        }
        for values in [usual(figure), random.values(figure, &names, &usual(figure))] {
            let drawings = (figure.draw)(&values).expect("a drawing");
            for drawing in &drawings {
                let Content::Diagram(svg) = &drawing.content else { continue };
                let root = roxmltree::Document::parse(svg).expect("SVG");
                let side = |name| root.root_element().attribute(name).and_then(|n| n.parse().ok());
                let size = vec2(side("width").expect("a width"), side("height").expect("a height"));
                let places = places(svg);
                for handle in &drawing.handles {
                    let at = handle.at * size;
                    // Files have hundredths of a pixel.
                    let nearest = places.iter().map(|p| p.distance(at)).fold(f32::INFINITY, f32::min);
                    assert!(
                        nearest < 0.05,
                        "{}: {} at {at}, {nearest} away",
                        values.summary(),
                        handle.name.en
                    );
                }
            }
        }
    }
}

#[test]
fn a_handle_that_is_dragged_to_where_it_is_stays() {
    let mut random = Random(1);
    for which in all() {
        let (figure, ..) = which;
        let moves = handle(which, &usual(figure)).moves;
        for _ in 0..TRIALS {
            let values = random.values(figure, &moves, &usual(figure));
            let Some(Handle { at, .. }) = visible(which, &values) else { continue };
            let after = dragged(which, &values, at);
            for parameter in figure.parameters {
                let change = after.number(parameter.name) - values.number(parameter.name);
                // A thousandth of the range is less than a pixel of any slider.
                let most = 1e-3 * (parameter.greatest - parameter.least);
                assert!(change.abs() <= most, "{} {}: {change}", values.summary(), parameter.name);
            }
        }
    }
}

#[test]
fn a_handle_reaches_every_place_that_it_can_have() {
    let mut random = Random(2);
    let mut missed = Vec::new();
    for which in all() {
        let (figure, ..) = which;
        let usual = usual(figure);
        let moves = handle(which, &usual).moves;
        let names: Vec<&str> = figure.parameters.iter().map(|parameter| parameter.name).collect();
        for _ in 0..TRIALS {
            let from = random.values(figure, &names, &usual);
            let to = random.values(figure, &moves, &from);
            let (Some(_), Some(Handle { at: place, .. })) = (visible(which, &from), visible(which, &to))
            else {
                continue;
            };
            let after = dragged(which, &from, place);
            let distance = handle(which, &after).at.distance(place);
            if distance > 0.01 {
                missed.push(format!(
                    "{} {:?}: {distance} from {} to {}, ended at {}",
                    figure.stem(),
                    moves,
                    from.summary(),
                    to.summary(),
                    after.summary()
                ));
            }
        }
    }
    assert!(missed.is_empty(), "{}:\n{}", missed.len(), missed.join("\n"));
}

#[test]
fn only_the_parameters_of_the_handle_change_and_they_stay_in_their_ranges() {
    let mut random = Random(4);
    for which in all() {
        let (figure, ..) = which;
        let before = usual(figure);
        let moves = handle(which, &before).moves;
        for _ in 0..TRIALS {
            // Far beyond the drawing, too.
            let to = 9.0 * vec2(random.share() - 0.5, random.share() - 0.5);
            let after = dragged(which, &before, to);
            for parameter in figure.parameters {
                let Parameter { name, least, greatest, whole, .. } = *parameter;
                let number = after.number(name);
                assert!((least..=greatest).contains(&number), "{}: {name} = {number}", figure.stem());
                assert!(!whole || number.fract() == 0.0, "{}: {name} = {number}", figure.stem());
                let may_change = moves.contains(&name);
                assert!(may_change || number == before.number(name), "{}: {name} changed", figure.stem());
            }
            let scale = proportions(which, &before);
            let gap = |values: &Values| (scale * (handle(which, values).at - to)).length();
            assert!(gap(&after) <= gap(&before), "{}: away from {to}", figure.stem());
        }
    }
}

#[test]
fn out_of_reach_is_the_end_of_the_range() {
    let point = figures::find("barycentric-plane")[0];
    // Far to the right and below: beyond the corner with the greatest β and the least γ.
    let after = drag(point, &Values::of(point), 0, 0, vec2(40.0, 30.0)).unwrap();
    assert_eq!((after.number("beta"), after.number("gamma")), (1.25, -0.5));
    let light = figures::find("lambert")[0];
    // Straight to the left is beyond 0°, straight below beyond 90°.
    let left = drag(light, &Values::of(light), 0, 0, vec2(-30.0, -30.0)).unwrap();
    assert_eq!(left.number("theta"), 0.0);
    let below = drag(light, &Values::of(light), 0, 0, vec2(0.9, 30.0)).unwrap();
    assert_eq!(below.number("theta"), 90.0);
}

#[test]
fn angles_follow_all_the_way_round() {
    let figure = figures::find("facing-away")[0];
    let mut values = Values::of(figure);
    for (from, to) in [(0.0, 180.0), (180.0, 0.0), (3.0, 177.0), (125.0, 20.0)] {
        values.set("theta", to).unwrap();
        let place = handle((figure, 0, 0), &values).at;
        values.set("theta", from).unwrap();
        let after = dragged((figure, 0, 0), &values, place).number("theta");
        assert!((after - to).abs() < 0.1, "from {from} to {to}: {after}");
    }
}

#[test]
fn what_is_no_place_or_no_handle_is_told_apart() {
    let figure = figures::find("lambert")[0];
    let values = Values::of(figure);
    for to in [Vec2::NAN, Vec2::INFINITY, vec2(0.5, f32::NEG_INFINITY)] {
        assert_eq!(drag(figure, &values, 0, 0, to).unwrap(), values);
    }
    for (drawing, handle) in [(0, 1), (2, 0), (usize::MAX, usize::MAX)] {
        let error = drag(figure, &values, drawing, handle, Vec2::ZERO).unwrap_err();
        assert!(matches!(error, DragError::NoHandle { .. }), "{error}");
    }
    // The greatest floats are places too.
    let far = drag(figure, &values, 0, 0, Vec2::splat(f32::MAX)).unwrap();
    assert!((0.0..=90.0).contains(&far.number("theta")));
}
