//! Is every claim and every error of the lecture tried, under a number and a name of its own?

use std::collections::BTreeSet;

/// What it claims, or asks to be measured, beside its errors.
const CLAIMED: [&str; 12] =
    ["L14", "L19", "L20", "L21", "L24", "L25", "L26", "L29", "L30", "L35", "L39", "L51"];

#[test]
fn every_claim_and_every_error_is_on_trial() {
    let errors = (1..=18).map(|k| format!("E{k}"));
    let asked = errors.chain(CLAIMED.map(str::to_owned));
    let missing: Vec<_> = asked.filter(|number| claims::find(number).is_empty()).collect();
    assert!(missing.is_empty(), "no claim is about {missing:?}");
    // Three advantages and three drawbacks.
    assert!(claims::find("L19").len() >= 6, "the z-buffer has six of them");
}

#[test]
fn every_number_is_one_of_the_lecture() {
    let of_figures = figures::all().into_iter().flat_map(|figure| figure.numbers.iter().copied());
    let of_claims = claims::all().into_iter().map(|claim| claim.number);
    for number in of_figures.chain(of_claims) {
        let (kind, digits) = number.split_at(1);
        let last = if kind == "L" { 58 } else { 18 };
        let place: u32 = digits.parse().unwrap_or_else(|_| panic!("{number}"));
        assert!((kind == "L" || kind == "E") && (1..=last).contains(&place), "{number}");
    }
}

#[test]
fn no_two_figures_or_claims_share_a_name() {
    let names: Vec<String> = figures::all().iter().map(|figure| figure.stem()).collect();
    let of_claims = claims::all().iter().map(|claim| claim.stem()).collect::<Vec<_>>();
    let all: Vec<&String> = names.iter().chain(&of_claims).collect();
    assert_eq!(all.iter().collect::<BTreeSet<_>>().len(), all.len(), "{all:?}");
}
