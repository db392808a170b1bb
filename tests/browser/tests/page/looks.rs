//! The page on a projector and on a telephone.

use fantoccini::wd::WebDriverCompatibleCommand;
use serde_json::json;

use crate::visit::{Visit, visit_with};

/// Where there is most to see.
const PLACES: [&str; 8] =
    ["", "L27", "L31-exponent-strip", "L17", "L56-shadows", "loops", "steps?kind=solve&how=cramer", "claims"];

#[test]
#[ignore = "visits every page: for .ci/nightly"]
fn nothing_is_wider_than_a_telephone() {
    visit_with("", (500, 844), async |page| {
        telephone(page).await;
        for place in PLACES {
            page.go(place).await;
            let width = page
                .run("return [document.documentElement.scrollWidth, window.innerWidth]", Vec::new())
                .await;
            assert_eq!(width[1], 390);
            assert!(width[0].as_i64() <= width[1].as_i64(), "{place:?} is {} pixels wide", width[0]);
            page.screenshot(&format!("390-{}", name(place))).await;
        }
    });
}

#[test]
#[ignore = "visits every page: for .ci/nightly"]
fn nothing_is_wider_than_a_projector_in_the_dark_either() {
    visit_with("", (1920, 1080), async |page| {
        for dark in [false, true] {
            if dark {
                page.run("document.documentElement.dataset.theme = 'dark'", Vec::new()).await;
            }
            for place in PLACES {
                page.go(place).await;
                let width = page
                    .run("return [document.documentElement.scrollWidth, window.innerWidth]", Vec::new())
                    .await;
                assert!(width[0].as_i64() <= width[1].as_i64(), "{place:?} is {} pixels wide", width[0]);
                page.screenshot(&format!("1920-{}{}", name(place), if dark { "-dark" } else { "" })).await;
            }
        }
    });
}

fn name(place: &str) -> String {
    let name = place.split('?').next().unwrap_or_default();
    if name.is_empty() { "overview".to_owned() } else { name.to_owned() }
}

/// Makes the window as narrow as a telephone, which no window of the browser is by itself.
async fn telephone(page: &Visit) {
    page.browser.issue_cmd(Metrics).await.unwrap();
}

#[derive(Debug)]
struct Metrics;

impl WebDriverCompatibleCommand for Metrics {
    fn endpoint(&self, base: &url::Url, session: Option<&str>) -> Result<url::Url, url::ParseError> {
        base.join(&format!("session/{}/goog/cdp/execute", session.unwrap_or_default()))
    }

    fn method_and_body(&self, _url: &url::Url) -> (http::Method, Option<String>) {
        let parameters = json!({ "width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": true });
        let command = json!({ "cmd": "Emulation.setDeviceMetricsOverride", "params": parameters });
        (http::Method::POST, Some(command.to_string()))
    }
}
