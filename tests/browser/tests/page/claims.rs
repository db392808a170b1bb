//! Each error of the slides is a switch between the slide's version and the right one.

use std::collections::BTreeSet;

use crate::visit::visit;

#[test]
#[ignore = "visits every page: for .ci/nightly"]
fn every_error_of_the_slides_is_switched_to_the_right_version() {
    visit("claims", async |page| {
        let lecture = page.lecture().await;
        let mut numbers = BTreeSet::new();
        for claim in lecture["claims"].as_array().unwrap().iter().filter(|claim| claim["erratum"] == true) {
            let (number, stem) = (claim["number"].as_str().unwrap(), claim["stem"].as_str().unwrap());
            page.go(&format!("{number}?claim={stem}")).await;
            let shown = format!("article[data-claim='{stem}']");
            page.until(
                stem,
                &format!(
                    "return !(document.querySelector(\"{shown} [data-test='claim-switch']\")?.hidden ?? true)"
                ),
            )
            .await;
            let seen = |version: &str| {
                format!(
                    "return document.querySelector(\"{shown}\").dataset.version === '{version}' && document.querySelector(\"{shown} [data-test='says']\").textContent + document.querySelector(\"{shown} .drawings\").innerHTML"
                )
            };
            let slide = page.until("the slide's version", &seen("slide")).await;
            page.run(&format!("document.querySelector(\"{shown} [value='right']\").click()"), Vec::new())
                .await;
            let begun = std::time::Instant::now();
            // A picture is shown as soon as it is decoded.
            while page.until("the right version", &seen("right")).await == slide {
                assert!(begun.elapsed().as_secs() < 20, "{stem}: both versions look the same");
            }
            numbers.insert(number.to_owned());
        }
        let wanted: BTreeSet<String> = (1..=18).map(|k| format!("E{k}")).collect();
        assert_eq!(numbers, wanted);
        page.screenshot("claim").await;
    });
}
