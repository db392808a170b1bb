//! `cargo lab merge`: the parts of a class become one report.

use std::fs;

use class::{KEPT, RUN, merge, run_json};

use super::args::MergeArgs;
use super::report::{self, write};
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::say;

/// Puts the parts together and writes the report: the same bytes as if one machine had judged all.
///
/// # Errors
/// [`Failure`] for parts that cannot be read, do not fit together, or are not all there.
pub(crate) fn run(asked: &MergeArgs) -> Result<Outcome, Failure> {
    let results = merge(&asked.parts).map_err(|e| Failure::new(e.to_string(), e.remedy()))?;
    report::prepare(&asked.out, false)?;
    let run = asked.out.join(RUN);
    write(&run, &run_json(&results.seeds)).map_err(|e| report::unwritten(&run, &e))?;
    for part in &asked.parts {
        let folder = part.join(KEPT);
        let entries =
            fs::read_dir(&folder).map_err(|e| Failure::io("read", &folder, &e, "see that it can be read"))?;
        for path in entries.flatten().map(|entry| entry.path()) {
            let bytes =
                fs::read(&path).map_err(|e| Failure::io("read", &path, &e, "see that it can be read"))?;
            let target = asked.out.join(KEPT).join(path.file_name().unwrap_or_default());
            write(&target, &bytes).map_err(|e| report::unwritten(&target, &e))?;
        }
    }
    report::write_all(&asked.out, &results, &asked.format)?;
    say(&format!("{} submissions of {} parts", results.submissions.len(), asked.parts.len()))?;
    say(&format!("{}", asked.out.join("class.html").display()))?;
    let failed = results.submissions.iter().any(super::grade::failed);
    Ok(if failed { Outcome::Unexpected } else { Outcome::Done })
}
