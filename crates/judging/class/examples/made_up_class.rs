//! What do the reports look like? Writes those of a class that was never taught into a folder: `class.html`, a `feedback/` with a page a student.
//!
//! ```sh
//! cargo run --release -p class --example made_up_class -- /tmp/made-up
//! ```

use std::path::Path;
use std::{env, fs, io};

use class::format::Format;
use class::report;

#[path = "../tests/it/made_up/mod.rs"]
mod made_up;

fn main() -> io::Result<()> {
    let folder = env::args().nth(1).unwrap_or_else(|| "made-up-class".to_owned());
    let folder = Path::new(&folder);
    fs::create_dir_all(folder.join("feedback"))?;
    let results = made_up::everyone();
    fs::write(folder.join("class.html"), report::class_page(&results))?;
    fs::write(folder.join("grades.csv"), report::grades_csv(&results))?;
    for submission in &results.submissions {
        let feedback = folder.join("feedback").join(&submission.id);
        fs::write(feedback.with_extension("html"), report::feedback_page(&results.course, submission))?;
        fs::write(feedback.with_extension("md"), report::feedback_markdown(&results.course, submission))?;
    }
    for format in Format::ALL {
        fs::create_dir_all(folder.join(format.name()))?;
        for submission in results.submissions.iter().rev().take(5) {
            let file = folder.join(format.name()).join(&submission.id).with_extension(format.extension());
            fs::write(file, format.of(&results.course, submission))?;
        }
    }
    Ok(())
}
