//! Each error of the slides is a switch between the slide's version and the right one.

use crate::visit::visit;

#[test]
fn every_error_of_the_slides_is_switched_to_the_right_version() {
    visit("claims", async |page| {
        for number in 1..=18 {
            page.go(&format!("E{number}")).await;
            page.until(
                "the trial",
                "return document.querySelector('article.erratum[data-version]') !== null",
            )
            .await;
            page.settled().await;
            let slide = page.seen("article.erratum[data-version]").await;
            page.run("document.querySelector('[data-test=claim-version]:not(:checked)').scrollIntoView({ block: 'center' })", Vec::new()).await;
            page.run("document.querySelector('[data-test=claim-version]:not(:checked)').click()", Vec::new())
                .await;
            page.settled().await;
            assert_ne!(page.seen("article.erratum[data-version]").await, slide, "E{number}");
        }
        page.screenshot("E18").await;
    });
}
