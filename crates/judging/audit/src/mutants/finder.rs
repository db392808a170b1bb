//! Where in a program can one slip? Walks through its syntax tree and has each kind of place looked at.

use std::ops::Range;

use proc_macro2::TokenStream;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, FieldValue, Stmt};

use super::{Edit, calls, choices, names, numbers, operators};

/// Collects what may be changed.
pub(super) struct Finder<'t> {
    text: &'t str,
    pub(super) edits: Vec<Edit>,
}

impl<'t> Finder<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { text, edits: Vec::new() }
    }

    /// The text of a part of the program.
    pub(super) fn text_of(&self, part: &impl Spanned) -> &'t str {
        &self.text[place(part)]
    }

    /// Notes that a part may become this text.
    pub(super) fn change(&mut self, kind: &'static str, part: &impl Spanned, text: impl Into<String>) {
        self.edits.push(Edit { kind, range: place(part), text: text.into() });
    }

    /// Notes that two parts may change places.
    pub(super) fn exchange(&mut self, kind: &'static str, first: &impl Spanned, second: &impl Spanned) {
        let (one, other) = (self.text_of(first), self.text_of(second));
        self.change_two(kind, (first, other), (second, one));
    }

    /// Notes that two parts may become these texts, both at once; the first stands before the second.
    pub(super) fn change_two(
        &mut self,
        kind: &'static str,
        (first, new_first): (&impl Spanned, &str),
        (second, new_second): (&impl Spanned, &str),
    ) {
        let (first, second) = (place(first), place(second));
        if first.end <= second.start {
            let between = &self.text[first.end..second.start];
            let text = format!("{new_first}{between}{new_second}");
            self.edits.push(Edit { kind, range: first.start..second.end, text });
        }
    }

    /// Notes that each two parts may change places.
    pub(super) fn exchange_each_two<T: Spanned>(&mut self, kind: &'static str, parts: &[&T]) {
        for (at, first) in parts.iter().enumerate() {
            for second in &parts[at + 1..] {
                self.exchange(kind, *first, *second);
            }
        }
    }

    /// Looks at what a macro is given, if that is expressions: `vec![a; n]`, `matches!(x, …)` as far as it goes.
    fn inside_a_macro(&mut self, tokens: &TokenStream) {
        let listed = Punctuated::<Expr, syn::Token![,]>::parse_terminated;
        let repeated = Punctuated::<Expr, syn::Token![;]>::parse_terminated;
        let parts: Vec<Expr> = match listed.parse2(tokens.clone()) {
            Ok(parts) => parts.into_iter().collect(),
            Err(_) => {
                repeated.parse2(tokens.clone()).map_or_else(|_| Vec::new(), |it| it.into_iter().collect())
            }
        };
        for part in &parts {
            self.visit_expr(part);
        }
    }
}

/// Where a part stands in the text, in bytes.
fn place(part: &impl Spanned) -> Range<usize> {
    part.span().byte_range()
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        match expr {
            Expr::Binary(binary) => operators::binary(self, binary),
            Expr::Unary(unary) => operators::unary(self, unary),
            Expr::Range(range) => operators::range(self, range),
            Expr::Lit(literal) => numbers::literal(self, literal),
            Expr::Call(call) => calls::call(self, call),
            Expr::MethodCall(call) => calls::method(self, call),
            Expr::Tuple(tuple) => {
                self.exchange_each_two("values exchanged", &tuple.elems.iter().collect::<Vec<_>>());
            }
            Expr::Struct(made) => calls::fields(self, made),
            Expr::Field(field) => names::field(self, field),
            Expr::Path(path) => names::path(self, path),
            Expr::Index(index) => names::index(self, index),
            Expr::If(chosen) => choices::branches(self, chosen),
            Expr::While(repeated) => choices::condition(self, &repeated.cond),
            Expr::Closure(closure) => operators::sign(self, &closure.body),
            _ => {}
        }
        visit::visit_expr(self, expr);
    }

    fn visit_field_value(&mut self, field: &'ast FieldValue) {
        // `Hit { t }` is short for `Hit { t: t }`: what changes must be written out.
        if field.colon_token.is_none() {
            let name = self.text_of(field);
            self.change("sign added", field, format!("{name}: -{name}"));
        } else {
            operators::sign(self, &field.expr);
            visit::visit_field_value(self, field);
        }
    }

    fn visit_pat_struct(&mut self, pattern: &'ast syn::PatStruct) {
        self.exchange_each_two("fields exchanged", &names::bound(pattern));
        // Nothing else in a pattern is computed.
    }

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        choices::statement(self, statement);
        visit::visit_stmt(self, statement);
    }

    fn visit_local(&mut self, local: &'ast syn::Local) {
        if let Some(init) = &local.init {
            operators::sign(self, &init.expr);
        }
        visit::visit_local(self, local);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        self.inside_a_macro(&called.tokens);
    }

    // Types hold lengths of arrays, attributes and signatures hold no computation.
    fn visit_type(&mut self, _: &'ast syn::Type) {}

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
}
