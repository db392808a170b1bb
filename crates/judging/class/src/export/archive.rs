//! How does a folder become one file, always the same? A zip without dates, its entries in order.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::File;

/// A zip with these files, in order of their paths.
pub(super) fn archive(files: &[File]) -> Vec<u8> {
    let mut files: Vec<&File> = files.iter().collect();
    files.sort_by(|a, b| a.path.cmp(&b.path));
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for file in files {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            // The first that a zip knows: 1980.
            .last_modified_time(DateTime::DEFAULT)
            .unix_permissions(if file.executable { 0o755 } else { 0o644 });
        // In memory nothing fails but what is over 4 GiB or twice there; sources are neither.
        zip.start_file(&file.path, options).expect("the paths of a folder differ");
        zip.write_all(&file.bytes).expect("memory takes everything");
    }
    zip.finish().expect("memory takes everything").into_inner()
}
