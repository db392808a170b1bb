//! Does the page work offline, and for those who cannot see it?

use std::collections::BTreeSet;
use std::sync::OnceLock;

use album::{Entry, Medium, Shown, Trial};
use canvas::{Format, codec};
use figures::{Content, Drawing, Values};

fn shown(drawing: Drawing) -> Shown {
    let medium = match drawing.content {
        Content::Picture(image) => Medium::Png(codec::encode(&image, Format::Png8).unwrap()),
        Content::Diagram(svg) => Medium::Svg(svg),
    };
    Shown { name: drawing.name, alt: drawing.alt, medium }
}

/// The page of all figures, small, and all claims. The verdicts are the recorded ones: what they come from is tested elsewhere.
fn whole_page() -> &'static str {
    static PAGE: OnceLock<String> = OnceLock::new();
    PAGE.get_or_init(|| {
        let entries = figures::all().into_iter().map(|figure| {
            let mut values = Values::of(figure);
            values.set_size(32, 24).unwrap();
            let drawings =
                (figure.draw)(&values).unwrap_or_else(|error| panic!("{}: {error}", figure.stem()));
            Entry::new(figure, values.summary(), drawings.into_iter().map(shown).collect())
        });
        let entries: Vec<Entry> = entries.collect();
        let trials = claims::all().into_iter();
        let trials = trials
            .map(|claim| Trial::new(claim, (claim.expected, true), vec!["a < b".to_owned()], Vec::new()));
        album::html(&entries, &trials.collect::<Vec<_>>())
    })
}

/// The values of an attribute, wherever it stands in a tag.
fn attributes<'a>(html: &'a str, name: &str) -> Vec<&'a str> {
    let pattern = format!(" {name}=\"");
    html.split(&pattern).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// The opening tags of an element.
fn tags<'a>(html: &'a str, element: &str) -> Vec<&'a str> {
    let pattern = format!("<{element} ");
    html.split(&pattern).skip(1).filter_map(|rest| rest.split('>').next()).collect()
}

#[test]
fn every_link_leads_somewhere_on_the_page() {
    let ids: Vec<&str> = attributes(whole_page(), "id");
    let unique: BTreeSet<&&str> = ids.iter().collect();
    assert_eq!(unique.len(), ids.len(), "an id stands twice");
    let links = attributes(whole_page(), "href");
    assert!(links.len() > 30, "{links:?}");
    for link in links {
        let target = link.strip_prefix('#');
        assert!(link == "data:," || target.is_some_and(|id| ids.contains(&id)), "{link} leads nowhere");
    }
}

#[test]
fn every_drawing_says_in_both_languages_what_it_shows() {
    let (pictures, diagrams) = (tags(whole_page(), "img"), tags(whole_page(), "svg"));
    assert!(pictures.len() > 25 && diagrams.len() > 15, "{} and {}", pictures.len(), diagrams.len());
    for (tag, name) in
        pictures.iter().map(|tag| (tag, "alt")).chain(diagrams.iter().map(|tag| (tag, "aria-label")))
    {
        let tag = format!(" {tag}");
        for attribute in [name, "data-en", "data-nl"] {
            let words = attributes(&tag, attribute);
            assert!(words.len() == 1 && words[0].len() > 10, "{attribute} in {}", &tag[..tag.len().min(300)]);
        }
        assert_eq!(attributes(&tag, name), attributes(&tag, "data-en"));
    }
}

#[test]
fn nothing_is_asked_of_the_network() {
    let page = whole_page();
    for source in attributes(page, "src") {
        assert!(source.starts_with("data:image/png;base64,"), "{}", &source[..source.len().min(80)]);
    }
    // Names of the SVG format look like addresses; nobody asks for them.
    let rest = page.replace("http://www.w3.org/2000/svg", "");
    for word in
        ["http:", "https:", "url(", "@import", "srcset", "<iframe", "<object", "fetch(", "XMLHttp", "import("]
    {
        assert!(!rest.contains(word), "the page has {word}");
    }
    assert!(page.contains("default-src 'none'"));
}

#[test]
fn figures_and_claims_carry_their_numbers() {
    let page = whole_page();
    let numbers = figures::all().into_iter().map(|figure| (figure.number(), figure.stem()));
    let numbers = numbers.chain(claims::all().into_iter().map(|claim| (claim.number, claim.stem())));
    for (number, stem) in numbers {
        let start =
            page.find(&format!("id=\"{stem}\"")).unwrap_or_else(|| panic!("{stem} is not on the page"));
        let head = &page[start..(start + 200).min(page.len())];
        assert!(head.contains(&format!("<span class=\"number\">{number}</span>")), "{head}");
    }
}

#[test]
fn what_a_drawing_says_cannot_break_the_page() {
    let alt = figures::Words::new("a \"<script>\" & b, long enough", "een \"<script>\" & b, lang genoeg");
    let drawing = Shown { name: "<b>".to_owned(), alt, medium: Medium::Png(vec![1, 2, 3]) };
    let html = album::html(&[Entry::new(figures::all()[0], "p=<1>".to_owned(), vec![drawing])], &[]);
    assert_eq!(html.matches("<script>").count(), 1, "only the page's own");
    assert!(html.contains("data:image/png;base64,AQID") && html.contains("p=&lt;1&gt;"));
}
