//! Figures and claims as a user asks for them.

use crate::desk::Desk;

#[test]
fn a_figure_is_drawn_once_and_again_only_if_something_changed() {
    let desk = Desk::new();
    let draw =
        |more: &[&str]| desk.words(&[&["figures", "L31", "L33", "--size", "48x32"], more].concat()).done();
    let names = ["L31", "L33"];
    let first = draw(&[]);
    assert!(!first.out.contains("drew 0"), "{}", first.out);
    let files = desk.files_in("figures");
    for name in names {
        assert!(files.iter().any(|file| file.starts_with(name)), "{files:?}");
    }
    assert!(files.contains(&"index.html".to_owned()), "{files:?}");
    assert!(!files.iter().any(|file| file.ends_with(".tmp")), "{files:?}");
    let before = desk.bytes("figures/L31-exponent-strip.png");

    assert!(draw(&[]).out.contains("drew 0"));
    // Another value, and back: exactly what depends on it is drawn.
    draw(&["--set", "p=5"]);
    assert_ne!(desk.bytes("figures/L31-exponent-strip.png"), before);
    draw(&[]);
    assert_eq!(desk.bytes("figures/L31-exponent-strip.png"), before);
    // A file that somebody spoilt, and a list that somebody spoilt.
    desk.put("figures/L31-exponent-strip.png", "spoilt");
    assert!(draw(&[]).out.contains("drew 1"));
    assert_eq!(desk.bytes("figures/L31-exponent-strip.png"), before);
    desk.put("figures/.lab-figures.json", "{ \"L31-exponent-strip\": 7");
    let words = [&["figures", "L31", "L33", "--size", "48x32"][..]].concat();
    let said = desk.words(&words);
    assert!(said.code == Some(0) && !said.out.contains("drew 0"), "{said:?}");
    assert!(said.err.contains(".lab-figures.json is damaged"), "{}", said.err);
}

#[test]
fn the_page_keeps_what_was_drawn_before() {
    let desk = Desk::new();
    desk.words(&["figures", "L33", "--out", "here"]).done();
    desk.words(&["figures", "exponent-strip", "--out", "here", "--size", "48x32"]).done();
    let page = String::from_utf8(desk.bytes("here/index.html")).unwrap();
    assert!(page.contains("id=\"L31-exponent-strip\"") && page.contains("id=\"L33-"), "both are on the page");
}

#[test]
fn figures_that_are_not_there_and_values_out_of_range_are_refused() {
    let desk = Desk::new();
    desk.words(&["figures", "L99"]).refused(&["no figure called L99", "L31"]);
    desk.words(&["figures", "L31", "--set", "q=3"]).refused(&["parameter q", "set one of", "p"]);
    desk.words(&["figures", "L31", "--set", "p=-1"]).refused(&["p = -1", "from 0"]);
    desk.words(&["figures", "L41", "--set", "subdivision=1.5"]).refused(&["whole number"]);
    desk.words(&["figures", "L31", "--size", "1x1"]).refused(&["1 × 1"]);
    desk.put("file", "");
    desk.words(&["figures", "L31", "--out", "file"]).refused(&["file is a file, not a folder", "--out"]);
    assert_eq!(desk.files(), ["file"], "nothing is made before all is in order");
}

#[test]
fn nobody_elses_page_is_replaced() {
    let desk = Desk::new();
    desk.put("index.html", "mine");
    desk.words(&["figures", "L33", "--out", "."]).refused(&["not from here", "--out"]);
    assert_eq!((desk.bytes("index.html"), desk.files()), (b"mine".to_vec(), vec!["index.html".to_owned()]));
}

#[test]
fn a_claim_shows_its_evidence() {
    let desk = Desk::new();
    let said = desk.words(&["claims", "E8"]).done();
    assert!(said.out.contains("E8") && said.out.contains("1.96"), "{}", said.out);
    let json = desk.words(&["claims", "E8", "--json"]).done();
    let value: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    let claim = &value["claims"][0];
    assert_eq!((claim["number"].as_str(), claim["as_recorded"].as_bool()), (Some("E8"), Some(true)));
    assert!(claim["evidence"].as_array().is_some_and(|evidence| !evidence.is_empty()), "{claim}");
    desk.words(&["claims", "E99"]).refused(&["no claim called E99"]);
}
