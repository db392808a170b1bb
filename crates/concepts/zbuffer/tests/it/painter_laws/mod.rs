//! Laws of the painter's algorithm (L13, L14): the order is right pair by pair, and so is the picture.

mod inputs;
mod picture;

use geometry::shapes;
use proptest::prelude::*;
use testkit::{Classes, Law, Outcome, ensure, strategy};
use zbuffer::painter::{self, OcclusionCycle, Relation};
use zbuffer::{ScreenTriangle, rasterize};

use self::inputs::{cycle_of_three, mixed_triangles, on_screen, seen_from, sheets, triangle, triangles};
use self::picture::{HEIGHT, Pixels, WIDTH, nearest, painted, painted_by_plan, place};

fn opposite(relation: Relation) -> Relation {
    match relation {
        Relation::Behind => Relation::InFront,
        Relation::InFront => Relation::Behind,
        Relation::Free | Relation::Piercing => relation,
    }
}

#[test]
fn exact_sides_say_the_same_as_clipping_in_floating_point() {
    let shared_corner = (triangle(2.0), triangle(2.0), 0..3_usize, 0..3_usize, any::<bool>()).prop_map(
        |(a, mut b, from, to, shares)| {
            if shares {
                b.vertices[to] = a.vertices[from];
            }
            (a, b)
        },
    );
    Law::new("what hides what does not depend on how it is found, nor on who asks")
        .cases(4000)
        .demand("free", 0.2)
        .demand("behind", 0.08)
        .demand("in front", 0.08)
        .demand("piercing", 0.04)
        .holds_for(shared_corner, |(a, b), seen| {
            let relation = painter::relation(&a, &b);
            seen.class("free", relation == Relation::Free);
            seen.class("behind", relation == Relation::Behind);
            seen.class("in front", relation == Relation::InFront);
            seen.class("piercing", relation == Relation::Piercing);
            prop_assert_eq!(relation, painter::relation_by_clipping(&a, &b));
            prop_assert_eq!(painter::relation(&b, &a), opposite(relation));
            Ok(())
        });
}

#[test]
fn an_overlap_as_thin_as_the_grid_counts_for_both_ways_of_finding_it() {
    use glam::vec3;
    // Two long triangles that share the part of their long sides between x = 0 and x = 9000, but for 1/256 pixel.
    let below =
        |rise: f32| on_screen([vec3(0.0, rise, 0.2), vec3(9000.0, rise, 0.3), vec3(4000.0, -700.0, 0.1)]);
    let above = on_screen([vec3(9000.0, 5.0, -0.2), vec3(0.0, 5.0, -0.4), vec3(5000.0, 600.0, -0.1)]);
    for (rise, relation) in [(5.0, Relation::Free), (5.0 + 1.0 / 256.0, Relation::Behind)] {
        assert_eq!(painter::relation(&above, &below(rise)), relation);
        assert_eq!(painter::relation_by_clipping(&above, &below(rise)), relation);
    }
}

fn ensure_right_order(order: &[usize], triangles: &[ScreenTriangle]) -> Outcome {
    let mut listed = order.to_vec();
    listed.sort_unstable();
    prop_assert_eq!(listed, (0..triangles.len()).collect::<Vec<_>>());
    for (first, a) in order.iter().enumerate() {
        for b in &order[first + 1..] {
            let relation = painter::relation_by_clipping(&triangles[*a], &triangles[*b]);
            ensure(!matches!(relation, Relation::InFront | Relation::Piercing), || {
                format!("{a} is drawn before {b}, but it is {relation:?}")
            })?;
        }
    }
    Ok(())
}

fn ensure_real_cycle(cycle: &OcclusionCycle, triangles: &[ScreenTriangle]) -> Outcome {
    let polygons = &cycle.polygons;
    prop_assert!(2 <= polygons.len());
    prop_assert_eq!(polygons.iter().min(), polygons.first(), "the smallest comes first");
    for (k, hidden) in polygons.iter().enumerate() {
        let hiding = polygons[(k + 1) % polygons.len()];
        let relation = painter::relation_by_clipping(&triangles[*hidden], &triangles[hiding]);
        let expected = if cycle.is_piercing() { Relation::Piercing } else { Relation::Behind };
        ensure(relation == expected, || {
            format!("{hidden} is not hidden by {hiding} in {polygons:?}: {relation:?}")
        })?;
    }
    Ok(())
}

#[test]
fn the_order_is_right_for_every_pair_and_a_cycle_is_real() {
    Law::new(
        "order gives an order just where there is one, and else a cycle of polygons each hidden by the next",
    )
    .cases(1500)
    .demand("an order exists", 0.3)
    .demand("polygons pierce", 0.1)
    .demand("a cycle without piercing", 0.1)
    .holds_for(
        prop_oneof![4 => mixed_triangles(), 1 => cycle_of_three().prop_map(|(_, all)| all)],
        |triangles, seen| {
            let found = painter::order(&triangles);
            let is_piercing = found.as_ref().err().map(OcclusionCycle::is_piercing);
            seen.class("an order exists", found.is_ok());
            seen.class("polygons pierce", is_piercing == Some(true));
            seen.class("a cycle without piercing", is_piercing == Some(false));
            prop_assert_eq!(found.is_ok(), painter::order_of_all_pairs(&triangles).is_some());
            match found {
                Ok(order) => ensure_right_order(&order, &triangles),
                Err(cycle) => ensure_real_cycle(&cycle, &triangles),
            }
        },
    );
}

#[test]
fn painting_in_order_gives_the_picture_of_the_depth_buffer() {
    let pixels = Pixels::default();
    Law::new("where an order exists, painter's picture is the z-buffer's")
        .demand("an order exists", 0.3)
        .demand("sorting by depth fails", 0.02)
        .holds_for(mixed_triangles(), |triangles, seen| {
            let Ok(order) = painter::order(&triangles) else {
                return Ok(());
            };
            seen.class("an order exists", true);
            let nearest = nearest(&triangles);
            let by_depth = painted(&painter::order_by_depth(&triangles), &triangles);
            seen.class("sorting by depth fails", Pixels::default().ensure_same(&by_depth, &nearest).is_err());
            pixels.ensure_same(&painted(&order, &triangles), &nearest)
        });
    pixels.assert_nearly_all_decided();
}

fn ensure_every_fragment_once(plan: &painter::Plan, triangles: &[ScreenTriangle]) -> Outcome {
    let mut times = vec![0_u32; triangles.len() * (WIDTH * HEIGHT) as usize];
    painter::for_each_fragment(plan, triangles, WIDTH, HEIGHT, |k, fragment| {
        times[k * (WIDTH * HEIGHT) as usize + place(&fragment)] += 1;
    });
    for (k, triangle) in triangles.iter().enumerate() {
        rasterize(triangle, WIDTH, HEIGHT, |fragment| {
            times[k * (WIDTH * HEIGHT) as usize + place(&fragment)] += 10;
        });
    }
    // 10 by the rasterizer, 1 by the plan.
    ensure(times.iter().all(|count| *count == 0 || *count == 11), || {
        "a fragment is drawn twice or not at all".into()
    })
}

/// Every two polygons that pierce each other are named, once, and nothing else is a pair.
fn ensure_piercing_pairs_are_named(plan: &painter::Plan, triangles: &[ScreenTriangle]) -> Outcome {
    let pierce = |a: usize, b: usize| {
        painter::relation_by_clipping(&triangles[a], &triangles[b]) == Relation::Piercing
    };
    let all = (0..triangles.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    let mut pairs: Vec<_> = all.filter(|(a, b)| pierce(*a, *b)).map(|(a, b)| vec![a, b]).collect();
    pairs.sort_unstable();
    let named = plan.cycles.iter().filter(|cycle| cycle.is_piercing());
    let mut named: Vec<_> = named.map(|cycle| cycle.polygons.clone()).collect();
    named.sort_unstable();
    ensure(named == pairs, || format!("named are {named:?}, but {pairs:?} pierce each other"))
}

fn ensure_plan_is_right(pixels: &Pixels, triangles: &[ScreenTriangle], seen: &Classes) -> Outcome {
    let plan = painter::plan(triangles);
    seen.class("cut", plan.splits > 0);
    prop_assert_eq!(plan.pieces.len(), triangles.len() + plan.splits);
    prop_assert_eq!(plan.cycles.is_empty(), painter::order(triangles).is_ok());
    plan.cycles.iter().try_for_each(|cycle| ensure_real_cycle(cycle, triangles))?;
    ensure_piercing_pairs_are_named(&plan, triangles)?;
    ensure_every_fragment_once(&plan, triangles)?;
    pixels.ensure_same(&painted_by_plan(&plan, triangles), &nearest(triangles))
}

#[test]
fn a_plan_draws_polygons_that_pierce_each_other_right() {
    let pixels = Pixels::default();
    Law::new("a plan has every fragment of every triangle once and shows the nearest")
        .demand("cut", 0.7)
        .holds_for(triangles(2..9, 2.0), |triangles, seen| ensure_plan_is_right(&pixels, &triangles, seen));
    pixels.assert_nearly_all_decided();
}

#[test]
fn the_cycle_of_three_is_named_cut_and_drawn_right() {
    let pixels = Pixels::default();
    Law::new("the three long triangles of Fig 8.9 are found, named and cut").demand("cut", 1.0).holds_for(
        cycle_of_three(),
        |([first, second, third], triangles), seen| {
            // Each lies over the next, so each is hidden by the one before.
            let hidden_to_hiding = [third, second, first];
            let cycle = painter::order(&triangles).expect_err("there is no order");
            let start = hidden_to_hiding.iter().position(|k| *k == cycle.polygons[0]).unwrap_or(0);
            prop_assert_eq!(&cycle.polygons, &[0, 1, 2].map(|k| hidden_to_hiding[(start + k) % 3]).to_vec());
            prop_assert_eq!(painter::plan(&triangles).cycles, vec![cycle]);
            ensure_plan_is_right(&pixels, &triangles, seen)
        },
    );
    pixels.assert_nearly_all_decided();
}

#[test]
fn neighbours_in_a_mesh_do_not_constrain_each_other_and_a_convex_one_has_an_order() {
    let ball = shapes::icosphere(2).expect("a small level");
    let neighbours: Vec<_> = (0..ball.len())
        .flat_map(|a| (0..a).map(move |b| (a, b)))
        .filter(|(a, b)| ball.triangles()[*a].iter().any(|corner| ball.triangles()[*b].contains(corner)))
        .collect();
    // A triangle touches 12 others; the 60 at the icosahedron's corners, where five meet, touch 11.
    assert_eq!(neighbours.len(), (260 * 12 + 60 * 11) / 2);
    let pixels = Pixels::default();
    Law::new("a closed convex mesh has an order, and its neighbours are free").cases(40).holds_for(
        strategy::rotation(),
        |turn, _| {
            let triangles = seen_from(&ball, turn);
            for (a, b) in &neighbours {
                let (a, b) = (&triangles[*a], &triangles[*b]);
                let same_side = a.doubled_area().signum() == b.doubled_area().signum();
                prop_assert!(!same_side || painter::relation(a, b) == Relation::Free);
            }
            let order = painter::order(&triangles).map_err(|cycle| TestCaseError::fail(cycle.to_string()))?;
            ensure_right_order(&order, &triangles)?;
            pixels.ensure_same(&painted(&order, &triangles), &nearest(&triangles))
        },
    );
    pixels.assert_nearly_all_decided();
}

#[test]
fn three_thousand_polygons_on_top_of_each_other_are_ordered() {
    let triangles = sheets(3000);
    let order = painter::order(&triangles).expect("parallel sheets have an order");
    let depth = |k: usize| triangles[k].vertices[0].position.z;
    assert!(order.windows(2).all(|pair| depth(pair[0]) < depth(pair[1])));
}
