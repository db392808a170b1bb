//! How does a program of an exercise's file become a student's file? Its function is cut out and stands where `todo!()` stood.

use crate::exercise::{Exercise, Program};

impl Exercise {
    /// A student's file with this program: the handed-out file, its function replaced. `None` if the program's function is not in
    /// the exercise's file, beginning in the first column.
    pub fn submission(&self, program: &Program) -> Option<String> {
        let function = cut_out(self.source, program.name)?;
        let signature = self.stub.find(&format!("pub fn {}", self.name))?;
        let body = function.find('{')?;
        let named = format!("pub fn {}{}", self.name, &function[function.find('(')?..body]);
        Some(format!("{}{named}{}\n", &self.stub[..signature], &function[body..]))
    }
}

/// The text of a top-level function, from `fn` to the brace that closes it, which stands alone in the first column.
fn cut_out<'a>(source: &'a str, name: &str) -> Option<&'a str> {
    let begin = source.find(&format!("\nfn {name}("))? + 1;
    let end = begin + source[begin..].find("\n}\n")? + 2;
    Some(&source[begin..end])
}
