//! The painter's algorithm: an order from back to front, if there is one (L13, L14).

use proptest::prelude::*;
use vocabulary::Occlusion;

use super::drawing;
use crate::exercise::{arguments, signature};
use crate::law::{Stop, typed};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, Value, that};

const STUB: &str = r#"//! The painter's order, from back to front (L13, L14).
//!
//! The painter's algorithm draws polygons one over the other, so a polygon must be drawn after all those that it hides. Given is
//! which polygon hides a part of which; give an order in which they can be drawn, the first one drawn first.
//!
//! - `count`: how many polygons there are; they have the numbers 0 … count − 1.
//! - `occlusions`: pairs of polygons, the one `behind` partly hidden by the one `in_front`. In any order; a pair may be there
//!   twice. No polygon hides itself. Polygons without a pair may be drawn at any time, but they are drawn too.
//! - The answer holds every polygon once. Where several orders are possible, each is right.
//! - `None` if no order is possible: there is an occlusion cycle, as in Fig 8.9.

use vocabulary::Occlusion;

pub fn painters_order(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    todo!()
}
"#;

signature!((count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>>);

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "painters_order",
        concept: Concept::Zbuffer,
        items: "L13, L14",
        title: Title { english: "The painter's order", dutch: "De volgorde van de schilder" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Which polygon may be drawn first? And once it is drawn, which one next?",
            "A polygon may be drawn as soon as everything behind it has been drawn. If some are left and none of them may \
                be drawn, they wait for each other.",
            "Until all are drawn: find a polygon that is not in the order yet, such that each occlusion with it `in_front` \
                has its `behind` in the order already; push it. If there is none, return None.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(nothing_left_behind_it),
        variants: vec![program!(from_the_front), program!(depth_first), program!(by_levels)],
        misconceptions: misconceptions(),
        explanation: "This is a topological order; a graph has one exactly if it has no cycle. Three polygons can already \
            hide each other in a ring, and then the painter must cut one of them. The z-buffer decides for each pixel \
            instead, and in a single pixel there is always a nearest polygon.",
        draw: drawing::orders,
        source: include_str!("painters_order.rs"),
    }
}

/// (behind, in front).
fn occlusions(pairs: &[(usize, usize)]) -> Vec<Occlusion> {
    pairs.iter().map(|&(behind, in_front)| Occlusion { behind, in_front }).collect()
}

fn examples() -> Vec<Example> {
    let order = |caption, count: usize, pairs: &[(usize, usize)], right: Vec<usize>| {
        let occlusions = occlusions(pairs);
        let pairs = occlusions.clone();
        let check = move |given: &Value| {
            let given = typed::<Option<Vec<usize>>>(given)?;
            from_back_to_front(given.as_deref(), count, &pairs)
        };
        Example::with_check(caption, arguments![count, occlusions], Some(right), check)
    };
    let none = |caption, count: usize, pairs: &[(usize, usize)]| {
        Example::new(caption, arguments![count, occlusions(pairs)], None::<Vec<usize>>, 0.0)
    };
    vec![
        order("2 lies behind 0, and 0 behind 1", 3, &[(0, 1), (2, 0)], vec![2, 0, 1]),
        order(
            "1 lies behind 0 and behind 2; of 0 and 2 either may come first",
            3,
            &[(1, 0), (1, 2)],
            vec![1, 0, 2],
        ),
        none(
            "the slide's left cycle (Fig 8.9): two polygons, each partly behind the other",
            2,
            &[(0, 1), (1, 0)],
        ),
        none("three polygons in a ring, each partly behind the next", 3, &[(0, 1), (1, 2), (2, 0)]),
    ]
}

/// Demands every polygon once, and what is behind before what is in front of it.
fn from_back_to_front(order: Option<&[usize]>, count: usize, occlusions: &[Occlusion]) -> Result<(), Stop> {
    every_polygon_once(order, count)?;
    let place = |polygon: usize| order.and_then(|order| order.iter().position(|other| *other == polygon));
    for Occlusion { behind, in_front } in occlusions {
        that(place(*behind) < place(*in_front), || {
            format!("{behind} is drawn after {in_front}, which hides it")
        })?;
    }
    Ok(())
}

fn every_polygon_once(order: Option<&[usize]>, count: usize) -> Result<(), Stop> {
    let Some(order) = order else {
        return that(false, || "the answer is None, though an order exists".to_owned());
    };
    for polygon in 0..count {
        let times = order.iter().filter(|other| **other == polygon).count();
        that(times == 1, || format!("polygon {polygon} is drawn {times} times, should be drawn once"))?;
    }
    that(order.len() == count, || format!("{} polygons are drawn, there are {count}", order.len()))
}

/// Polygons, and what hides what.
#[derive(Clone, Debug)]
struct Scene {
    count: usize,
    occlusions: Vec<Occlusion>,
    /// The pair that closes a cycle, if there is one.
    closing: Option<Occlusion>,
}

impl Scene {
    /// The question, without the pair that closes a cycle.
    fn open(&self) -> Vec<Value> {
        arguments![self.count, self.occlusions.clone()]
    }

    /// The question, with that pair in the middle of the others.
    fn closed(&self) -> Vec<Value> {
        let mut occlusions = self.occlusions.clone();
        let middle = occlusions.len() / 2;
        occlusions.splice(middle..middle, self.closing);
        arguments![self.count, occlusions]
    }
}

/// Two to seven polygons that can be drawn: some pairs, all forward in a hidden order.
fn drawable() -> impl Strategy<Value = Scene> + Clone {
    (2..=7_usize).prop_flat_map(|count| {
        let hidden = Just((0..count).collect::<Vec<usize>>()).prop_shuffle();
        let pairs = prop::collection::vec((0..count, 0..count), 0..=8);
        (hidden, pairs).prop_map(move |(hidden, pairs)| {
            let occlusions = pairs
                .into_iter()
                .filter(|(x, y)| x != y)
                .map(|(x, y)| Occlusion { behind: hidden[x.min(y)], in_front: hidden[x.max(y)] })
                .collect();
            Scene { count, occlusions, closing: None }
        })
    })
}

/// The same, with a chain of two polygons or more that `closing` makes a cycle.
fn nearly_cyclic() -> impl Strategy<Value = Scene> + Clone {
    (2..=7_usize).prop_flat_map(|count| {
        let hidden = Just((0..count).collect::<Vec<usize>>()).prop_shuffle();
        let pairs = prop::collection::vec((0..count, 0..count), 0..=3);
        (hidden, pairs, 2..=count).prop_map(move |(hidden, pairs, length)| {
            let pair = |x: usize, y: usize| Occlusion { behind: hidden[x], in_front: hidden[y] };
            let chain = (1..length).rev().map(|at| pair(at - 1, at));
            let others = pairs.into_iter().filter(|(x, y)| x != y).map(|(x, y)| pair(x.min(y), x.max(y)));
            let occlusions = chain.chain(others).collect();
            Scene { count, occlusions, closing: Some(pair(length - 1, 0)) }
        })
    })
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "every_polygon_once",
            2,
            "An order holds every polygon once.",
            "Something is missing or drawn twice. Where do you meet a polygon that hides nothing and that nothing hides, \
                and one that several others hide?",
        )
        .over(drawable(), |scene, program| {
            let order: Option<Vec<usize>> = program.ask(scene.open())?;
            every_polygon_once(order.as_deref(), scene.count)
        }),
        Law::of(
            "from_back_to_front",
            3,
            "What is behind is drawn before what is in front of it.",
            "A polygon is drawn over one that hides it. When you choose the next one, is all that lies behind it drawn already?",
        )
        .over(drawable(), |scene, program| {
            let order: Option<Vec<usize>> = program.ask(scene.open())?;
            from_back_to_front(order.as_deref(), scene.count, &scene.occlusions)
        }),
        Law::of(
            "a_cycle_has_no_order",
            3,
            "Polygons that hide each other in a ring cannot be drawn in any order: None.",
            "There is a cycle, of two polygons or of more, and an order came out. What does your program do when it can \
                choose none?",
        )
        .over(nearly_cyclic(), |scene, program| {
            let order: Option<Vec<usize>> = program.ask(scene.closed())?;
            that(order.is_none(), || "an order came out, though there is a cycle".to_owned())
        }),
        Law::of(
            "without_its_last_pair_a_cycle_can_be_drawn",
            2,
            "If one pair of the only ring is taken away, there is an order again.",
            "This is a long chain, not a cycle: each polygon is behind the next one only. An order for a chain must respect \
                all of it, not only neighbours in the list.",
        )
        .over(nearly_cyclic(), |scene, program| {
            let order: Option<Vec<usize>> = program.ask(scene.open())?;
            from_back_to_front(order.as_deref(), scene.count, &scene.occlusions)
        }),
    ]
}

fn nothing_left_behind_it(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = Vec::new();
    while order.len() < count {
        let may_be_drawn = |polygon: &usize| {
            let waits = |o: &Occlusion| o.in_front == *polygon && !order.contains(&o.behind);
            !order.contains(polygon) && !occlusions.iter().any(waits)
        };
        // None if all that are left wait for each other.
        let next = (0..count).find(may_be_drawn)?;
        order.push(next);
    }
    Some(order)
}

fn from_the_front(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    // How many polygons still hide each one; the frontmost is drawn last.
    let mut hidden_by = vec![0; count];
    for occlusion in occlusions {
        hidden_by[occlusion.behind] += 1;
    }
    let mut frontmost: Vec<usize> = (0..count).filter(|polygon| hidden_by[*polygon] == 0).collect();
    let mut order = Vec::new();
    while let Some(polygon) = frontmost.pop() {
        order.push(polygon);
        for occlusion in occlusions.iter().filter(|occlusion| occlusion.in_front == polygon) {
            hidden_by[occlusion.behind] -= 1;
            if hidden_by[occlusion.behind] == 0 {
                frontmost.push(occlusion.behind);
            }
        }
    }
    order.reverse();
    (order.len() == count).then_some(order)
}

fn depth_first(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        Waiting,
        Drawn,
    }

    // Draws a polygon after all that lies behind it; false if it waits for itself.
    fn draw(polygon: usize, occlusions: &[Occlusion], marks: &mut [Mark], order: &mut Vec<usize>) -> bool {
        if marks[polygon] != Mark::New {
            return marks[polygon] == Mark::Drawn;
        }
        marks[polygon] = Mark::Waiting;
        for occlusion in occlusions.iter().filter(|occlusion| occlusion.in_front == polygon) {
            if !draw(occlusion.behind, occlusions, marks, order) {
                return false;
            }
        }
        marks[polygon] = Mark::Drawn;
        order.push(polygon);
        true
    }

    let mut marks = vec![Mark::New; count];
    let mut order = Vec::new();
    let drawn = (0..count).all(|polygon| draw(polygon, occlusions, &mut marks, &mut order));
    drawn.then_some(order)
}

fn by_levels(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    // The length of the longest chain that ends at each polygon. In `count` rounds it is found, or it grows for ever.
    let mut level = vec![0; count];
    for _ in 0..=count {
        let before = level.clone();
        for occlusion in occlusions {
            level[occlusion.in_front] = level[occlusion.in_front].max(level[occlusion.behind] + 1);
        }
        if level == before {
            let mut order: Vec<usize> = (0..count).rev().collect();
            order.sort_by_key(|polygon| level[*polygon]);
            return Some(order);
        }
    }
    None
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(from_front_to_back),
            looks_like: "the order runs from front to back",
            help: "The painter covers what is drawn already: what is behind must be drawn first.",
        },
        Misconception {
            program: program!(leaves_out_the_cycle),
            looks_like: "the polygons of a cycle are left out, and the others are drawn",
            help: "If polygons are left and none may be drawn next, there is no order: return None.",
        },
        Misconception {
            program: program!(cycle_in_any_order),
            looks_like: "the polygons of a cycle are drawn in some order",
            help: "Whichever comes last in a ring covers one that should hide it. There is no order: return None.",
        },
        Misconception {
            program: program!(met_twice_is_a_cycle),
            looks_like: "a polygon that is met twice counts as a cycle",
            help: "Two polygons may both be in front of a third. A cycle is a way that leads back to a polygon that still \
                waits; one that is drawn already is no harm.",
        },
        Misconception {
            program: program!(only_those_with_a_pair),
            looks_like: "polygons that neither hide nor are hidden are left out",
            help: "Go through 0 … count − 1, not through the pairs alone: who stands alone is drawn too.",
        },
        Misconception {
            program: program!(counted_only),
            looks_like: "polygons are sorted by how many others each one hides",
            help: "A polygon may hide only one, and that one many: it must still come after it. Counts do not see chains.",
        },
        Misconception {
            program: program!(pairs_only_once),
            looks_like: "each pair is put in order once, and later exchanges disturb it",
            help: "Exchanging two polygons may break a pair that was in order before. Look again until nothing changes, or \
                choose one polygon at a time.",
        },
    ]
}

fn from_front_to_back(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = Vec::new();
    while order.len() < count {
        let may_be_drawn = |polygon: &usize| {
            let waits = |o: &Occlusion| o.behind == *polygon && !order.contains(&o.in_front);
            !order.contains(polygon) && !occlusions.iter().any(waits)
        };
        let next = (0..count).find(may_be_drawn)?;
        order.push(next);
    }
    Some(order)
}

fn leaves_out_the_cycle(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = Vec::new();
    while order.len() < count {
        let may_be_drawn = |polygon: &usize| {
            let waits = |o: &Occlusion| o.in_front == *polygon && !order.contains(&o.behind);
            !order.contains(polygon) && !occlusions.iter().any(waits)
        };
        let Some(next) = (0..count).find(may_be_drawn) else { break };
        order.push(next);
    }
    Some(order)
}

fn cycle_in_any_order(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = Vec::new();
    while order.len() < count {
        let left = |polygon: &usize| !order.contains(polygon);
        let may_be_drawn = |polygon: &usize| {
            let waits = |o: &Occlusion| o.in_front == *polygon && !order.contains(&o.behind);
            left(polygon) && !occlusions.iter().any(waits)
        };
        let next = (0..count).find(may_be_drawn).or((0..count).find(left))?;
        order.push(next);
    }
    Some(order)
}

fn met_twice_is_a_cycle(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    fn draw(polygon: usize, occlusions: &[Occlusion], met: &mut [bool], order: &mut Vec<usize>) -> bool {
        if met[polygon] {
            return false;
        }
        met[polygon] = true;
        for occlusion in occlusions.iter().filter(|occlusion| occlusion.in_front == polygon) {
            if !draw(occlusion.behind, occlusions, met, order) {
                return false;
            }
        }
        order.push(polygon);
        true
    }

    let mut met = vec![false; count];
    let mut order = Vec::new();
    let hidden = |polygon: usize| occlusions.iter().any(|occlusion| occlusion.behind == polygon);
    for polygon in (0..count).filter(|polygon| !hidden(*polygon)) {
        if !draw(polygon, occlusions, &mut met, &mut order) {
            return None;
        }
    }
    (order.len() == count).then_some(order)
}

fn only_those_with_a_pair(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let paired = |polygon: &usize| occlusions.iter().any(|o| o.behind == *polygon || o.in_front == *polygon);
    let polygons: Vec<usize> = (0..count).filter(paired).collect();
    let mut order: Vec<usize> = Vec::new();
    while order.len() < polygons.len() {
        let may_be_drawn = |polygon: &usize| {
            let waits = |o: &Occlusion| o.in_front == *polygon && !order.contains(&o.behind);
            !order.contains(polygon) && !occlusions.iter().any(waits)
        };
        let next = polygons.iter().copied().find(may_be_drawn)?;
        order.push(next);
    }
    Some(order)
}

fn counted_only(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let hides = |polygon: usize| occlusions.iter().filter(|o| o.in_front == polygon).count();
    // The farthest hides nobody; if every polygon hides one, there is no farthest.
    if (0..count).all(|polygon| hides(polygon) > 0) {
        return None;
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|polygon| hides(*polygon));
    Some(order)
}

fn pairs_only_once(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = (0..count).collect();
    let place = |order: &[usize], polygon: usize| order.iter().position(|other| *other == polygon);
    for Occlusion { behind, in_front } in occlusions {
        let (first, second) = (place(&order, *behind)?, place(&order, *in_front)?);
        if first > second {
            order.swap(first, second);
        }
    }
    Some(order)
}
