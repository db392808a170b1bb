//! Names that are taken for one another: x for y, near for far, minimum for maximum.

use syn::{Expr, ExprField, ExprIndex, ExprPath, Member, PatStruct};

use super::finder::Finder;

const KIND: &str = "another name";

/// Functions.
pub(super) const METHODS: [&[&str]; 13] = [
    &["min", "max"],
    &["sin", "cos"],
    &["floor", "ceil", "round"],
    &["any", "all"],
    &["min_by", "max_by"],
    &["length", "length_squared"],
    &["normalize", "normalize_or_zero"],
    &["is_none_or", "is_some_and"],
    &["perp_dot", "dot"],
    &["transpose", "inverse"],
    &["x_axis", "y_axis", "z_axis"],
    &["row", "col"],
    &["find", "rfind"],
];

/// Fields.
const FIELDS: [&[&str]; 9] = [
    &["x", "y", "z"],
    &["u", "v", "w"],
    &["a", "b", "c"],
    &["alpha", "beta", "gamma"],
    &["left", "right", "bottom", "top"],
    &["near", "far"],
    &["i", "j"],
    &["origin", "direction"],
    &["behind", "in_front"],
];

/// Variables and constants.
const VARIABLES: [&[&str]; 20] = [
    &["x", "y", "z"],
    &["u", "v", "w"],
    &["a", "b", "c"],
    &["i", "j", "k"],
    &["n", "f"],
    &["l", "r"],
    &["b", "t"],
    &["s", "t"],
    &["alpha", "beta", "gamma"],
    &["near", "far"],
    &["left", "right", "bottom", "top"],
    &["low", "high"],
    &["width", "height"],
    &["n_x", "n_y"],
    &["u_s", "v_s"],
    &["from", "to"],
    &["entry", "exit"],
    &["t0", "t1"],
    &["c_0", "c_1", "c_2"],
    &["to_light", "to_eye"],
];

/// The names that one is mistaken for.
pub(super) fn mistaken_for(groups: &[&[&'static str]], name: &str) -> Vec<&'static str> {
    let groups = groups.iter().filter(|group| group.contains(&name));
    groups.flat_map(|group| group.iter().copied()).filter(|other| *other != name).collect()
}

pub(super) fn field(finder: &mut Finder<'_>, field: &ExprField) {
    let Member::Named(name) = &field.member else { return };
    for other in mistaken_for(&FIELDS, &name.to_string()) {
        finder.change(KIND, name, other);
    }
}

pub(super) fn path(finder: &mut Finder<'_>, path: &ExprPath) {
    let name = finder.text_of(path);
    for other in mistaken_for(&VARIABLES, name) {
        finder.change(KIND, path, other);
    }
    for (one, other) in [("::ZERO", "::ONE"), ("::from_translation", "::from_scale")] {
        if let Some(kind) = name.strip_suffix(one) {
            finder.change(KIND, path, format!("{kind}{other}"));
        }
    }
}

/// `z[j][i]`: rows and columns exchanged.
pub(super) fn index(finder: &mut Finder<'_>, index: &ExprIndex) {
    if let Expr::Index(row) = &*index.expr {
        finder.exchange("row and column exchanged", &*row.index, &*index.index);
    }
}

/// The names that a pattern `Triangle { a, b, c }` gives to fields: of two that are exchanged each has the other's value.
pub(super) fn bound(pattern: &PatStruct) -> Vec<&syn::Pat> {
    pattern.fields.iter().filter(|field| field.colon_token.is_some()).map(|field| &*field.pat).collect()
}
