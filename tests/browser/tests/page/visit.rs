//! What can a person do on the page, and see of it? Also what the browser says of it behind the scenes.

use std::time::{Duration, Instant};

use fantoccini::actions::{InputSource, MouseActions, PointerAction};
use fantoccini::elements::Element;
use fantoccini::wd::WebDriverCompatibleCommand;
use fantoccini::{Client, ClientBuilder, Locator};
use hyper_util::client::legacy::connect::HttpConnector;
use serde_json::{Value as Json, json};
use tempfile::TempDir;

use crate::stage::{self, Running, Stage};

/// No step takes longer on a busy machine; what waits for more has failed.
const TOO_LONG: Duration = Duration::from_secs(60);

/// A browser that shows the page.
pub(crate) struct Visit {
    pub(crate) stage: Stage,
    pub(crate) browser: Client,
    _driver: Running,
    _profile: TempDir,
}

/// Opens the page at a place (`L31?p=64`), does what a person does, and sees that nothing went wrong behind the scenes.
pub(crate) fn visit(place: &str, person: impl AsyncFnOnce(&Visit)) {
    visit_with(place, (1280, 900), person);
}

/// The same in a window of another size.
pub(crate) fn visit_with(place: &str, size: (u32, u32), person: impl AsyncFnOnce(&Visit)) {
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).enable_all().build().unwrap();
    runtime.block_on(async {
        let visit = Visit::begin(place, size).await;
        visit.settled().await;
        person(&visit).await;
        visit.nothing_went_wrong().await;
        visit.browser.clone().close().await.unwrap();
    });
}

impl Visit {
    async fn begin(place: &str, (width, height): (u32, u32)) -> Self {
        let stage = Stage::new();
        let (driver, address) = stage::driver();
        let profile = tempfile::tempdir().unwrap();
        let arguments = [
            "--headless=new".to_owned(),
            "--no-sandbox".to_owned(),
            "--disable-gpu".to_owned(),
            "--no-first-run".to_owned(),
            "--disable-background-networking".to_owned(),
            "--disable-component-update".to_owned(),
            "--disable-sync".to_owned(),
            "--lang=en".to_owned(),
            // Whatever asks for another machine fails, and is seen in the log.
            "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1".to_owned(),
            format!("--user-data-dir={}", profile.path().display()),
            format!("--window-size={width},{height}"),
        ];
        let capabilities = json!({
            "goog:chromeOptions": { "args": arguments },
            "goog:loggingPrefs": { "browser": "ALL", "performance": "ALL" },
        });
        let Json::Object(capabilities) = capabilities else { unreachable!() };
        let browser = ClientBuilder::new(HttpConnector::new())
            .capabilities(capabilities)
            .connect(&address)
            .await
            .expect("a browser: apt-get install chromium chromium-driver");
        let visit = Self { stage, browser, _driver: driver, _profile: profile };
        visit.browser.goto(&visit.stage.address).await.unwrap();
        visit.go(place).await;
        visit
    }

    /// Goes to another place of the page, as by a link.
    pub(crate) async fn go(&self, place: &str) {
        self.run("location.hash = arguments[0]", vec![json!(place)]).await;
        self.settled().await;
    }

    /// What there is to see, as the server lists it.
    pub(crate) async fn lecture(&self) -> Json {
        self.run("return fetch('/api/lecture').then((answer) => answer.json())", Vec::new()).await
    }

    /// Runs a script in the page.
    pub(crate) async fn run(&self, script: &str, arguments: Vec<Json>) -> Json {
        self.browser.execute(script, arguments).await.unwrap()
    }

    /// Waits until the script gives something that counts as true, and gives it back.
    pub(crate) async fn until(&self, what: &str, script: &str) -> Json {
        let begun = Instant::now();
        loop {
            let value = self.run(script, Vec::new()).await;
            if !matches!(value, Json::Null | Json::Bool(false)) && value != json!(0) && value != json!("") {
                return value;
            }
            assert!(begun.elapsed() < TOO_LONG, "{what} does not come");
            tokio::time::sleep(Duration::from_millis(30)).await;
        }
    }

    /// Waits until all that was asked for is shown, and nothing more is asked: after a coarse picture comes a fine one.
    pub(crate) async fn settled(&self) {
        const CALM: &str = "return document.querySelector('#main h1') && (document.documentElement.dataset.busy ?? 'false') === 'false'";
        let mut calm = 0;
        while calm < 4 {
            self.until("the end of work", CALM).await;
            tokio::time::sleep(Duration::from_millis(40)).await;
            calm = if self.run(CALM, Vec::new()).await == true { calm + 1 } else { 0 };
        }
    }

    /// The element of this selector; waits for it.
    pub(crate) async fn find(&self, css: &str) -> Element {
        self.browser
            .wait()
            .at_most(TOO_LONG)
            .for_element(Locator::Css(css))
            .await
            .unwrap_or_else(|e| panic!("{css}: {e}"))
    }

    /// What a person reads there.
    pub(crate) async fn text(&self, css: &str) -> String {
        self.find(css).await.text().await.unwrap()
    }

    pub(crate) async fn click(&self, css: &str) {
        let element = self.find(css).await;
        self.run("arguments[0].scrollIntoView({ block: 'center' })", vec![json!(element)]).await;
        element.click().await.unwrap_or_else(|e| panic!("{css}: {e}"));
        self.settled().await;
    }

    /// Types keys into whatever has the focus.
    pub(crate) async fn keys(&self, keys: &str) {
        self.browser.active_element().await.unwrap().send_keys(keys).await.unwrap();
    }

    /// Drags the middle of an element by so many pixels, in steps, with the mouse.
    pub(crate) async fn drag(&self, css: &str, (dx, dy): (f64, f64)) {
        self.find(css).await;
        let middle = self
            .run(
                "const e = document.querySelector(arguments[0]); e.scrollIntoView({ block: 'center' }); \
                 const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]",
                vec![json!(css)],
            )
            .await;
        let at = |k: usize| middle[k].as_f64().unwrap();
        let to = |x: f64, y: f64| PointerAction::MoveTo { duration: Some(Duration::from_millis(16)), x, y };
        let button = fantoccini::actions::MOUSE_BUTTON_LEFT;
        let mut mouse =
            MouseActions::new("mouse".to_owned()).then(to(at(0), at(1))).then(PointerAction::Down { button });
        for k in 1..=8 {
            let part = f64::from(k) / 8.0;
            mouse = mouse.then(to(at(0) + part * dx, at(1) + part * dy));
        }
        self.browser.perform_actions(mouse.then(PointerAction::Up { button })).await.unwrap();
        self.settled().await;
    }

    /// A fingerprint of what an element shows: of a canvas its pixels, of a drawing its lines, of a picture its bytes.
    pub(crate) async fn seen(&self, css: &str) -> String {
        self.find(css).await;
        let script = "const e = document.querySelector(arguments[0]); \
            const text = e.tagName === 'CANVAS' ? e.toDataURL() : e.tagName === 'IMG' ? e.src : e.innerHTML; \
            let h = 5381; for (let i = 0; i < text.length; i++) h = (h * 33 + text.charCodeAt(i)) % 2147483647; \
            return text.length + ':' + h";
        self.run(script, vec![json!(css)]).await.as_str().unwrap().to_owned()
    }

    /// The value of a parameter's field.
    pub(crate) async fn parameter(&self, name: &str) -> f64 {
        let css = format!("input[data-parameter='{name}']");
        self.find(&css).await;
        let value =
            self.run("return Number(document.querySelector(arguments[0]).value)", vec![json!(css)]).await;
        value.as_f64().unwrap()
    }

    /// What follows # in the address, once it has been brought up to date.
    pub(crate) async fn place(&self) -> String {
        // Changes are gathered for a quarter of a second.
        tokio::time::sleep(Duration::from_millis(400)).await;
        self.browser.current_url().await.unwrap().fragment().unwrap_or_default().to_owned()
    }

    /// Keeps a picture of the window for a look, if a folder is named.
    pub(crate) async fn screenshot(&self, name: &str) {
        if let Some(folder) = std::env::var_os("LIGHTLAB_SCREENSHOTS") {
            let folder = std::path::PathBuf::from(folder);
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(folder.join(format!("{name}.png")), self.browser.screenshot().await.unwrap())
                .unwrap();
        }
    }

    /// No error in the console, and no request to any other host.
    async fn nothing_went_wrong(&self) {
        let said: Vec<String> = self
            .log("browser")
            .await
            .iter()
            .filter(|entry| matches!(entry["level"].as_str(), Some("SEVERE" | "WARNING")))
            .map(|entry| entry["message"].to_string())
            .collect();
        assert!(said.is_empty(), "the console says: {said:#?}");
        let mut asked = 0;
        for entry in self.log("performance").await {
            let message: Json = serde_json::from_str(entry["message"].as_str().unwrap()).unwrap();
            let parameters = &message["message"]["params"];
            let ours = |url: &Json, more: &[&str]| {
                let url = url.as_str().unwrap_or_default();
                url.starts_with(self.stage.base()) || more.iter().any(|begin| url.starts_with(begin))
            };
            // The browser's own first tab is not the page.
            if message["message"]["method"] == "Network.requestWillBeSent"
                && ours(&parameters["documentURL"], &[])
            {
                let url = &parameters["request"]["url"];
                assert!(ours(url, &["data:", "blob:"]), "a request left this host: {url}");
                asked += 1;
            }
        }
        assert!(asked > 3, "the log of requests is empty: this test would see nothing");
    }

    async fn log(&self, kind: &'static str) -> Vec<Json> {
        let log = self.browser.issue_cmd(Log(kind)).await.unwrap();
        log.as_array().unwrap().clone()
    }
}

/// What the browser has noted: a command of its driver beyond the standard.
#[derive(Debug)]
struct Log(&'static str);

impl WebDriverCompatibleCommand for Log {
    fn endpoint(&self, base: &url::Url, session: Option<&str>) -> Result<url::Url, url::ParseError> {
        base.join(&format!("session/{}/se/log", session.unwrap_or_default()))
    }

    fn method_and_body(&self, _url: &url::Url) -> (http::Method, Option<String>) {
        (http::Method::POST, Some(json!({ "type": self.0 }).to_string()))
    }
}
