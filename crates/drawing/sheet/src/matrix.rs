//! How does a matrix stand on a sheet? As rows and columns between brackets.

use crate::{Ink, LETTER, Letters, Sheet, Side};

/// From row to row, in pixels.
const ROW: f32 = 1.45 * LETTER;
/// Between a bracket and the entries.
const GAP: f32 = 7.0;

impl Sheet {
    /// Columns of entries between brackets, from so many pixels from the left and from the top of the sheet; `column` is the
    /// width of one in pixels. Returns where the matrix ends, in pixels from the left.
    pub fn matrix(&mut self, left: f32, top: f32, column: f32, columns: &[[String; 3]]) -> f32 {
        let width = 2.0 * GAP + column * columns.len() as f32;
        for (x, inwards) in [(left, 6.0), (left + width, -6.0)] {
            let bottom = top + 3.0 * ROW;
            let bracket = [(x + inwards, top), (x, top), (x, bottom), (x + inwards, bottom)]
                .map(|(x, y)| self.place(x, y));
            self.path(&bracket, Ink::Main.pen());
        }
        for (k, entries) in columns.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                let place =
                    self.place(left + GAP + column * (k as f32 + 0.5), top + ROW * (row as f32 + 0.5));
                self.label_sized(
                    place,
                    Side::Middle,
                    entry.as_str(),
                    Letters::Plain,
                    Ink::Main,
                    0.92 * LETTER,
                );
            }
        }
        left + width
    }
}
