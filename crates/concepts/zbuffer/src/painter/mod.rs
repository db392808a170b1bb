//! In which order must polygons be drawn? From back to front, if there is such an order (L13, L14).
//!
//! - [`order_by_depth`]: the slide's painter's algorithm, sorted by depth; short, and wrong for long polygons.
//! - [`order`]: the order that is right, or the [`OcclusionCycle`] that makes one impossible.
//! - [`plan()`]: right in any case, as it cuts what no order can draw; [`for_each_fragment`] draws it.
//! - [`relation()`]: what hides what, pair by pair; [`order_of_all_pairs`] does nothing else.
//!
//! Read `order.rs` first, then `relation.rs`; `plan.rs` is what Newell, Newell and Sancha added.

mod all_pairs;
mod boxes;
mod budget;
mod clipping;
mod cycle;
mod draw;
#[cfg(test)]
mod example;
mod facet;
mod graph;
mod order;
mod outlined_piece;
mod piece;
mod plan;
mod relation;

pub use all_pairs::order_of_all_pairs;
pub use clipping::relation_by_clipping;
pub use cycle::OcclusionCycle;
pub use draw::for_each_fragment;
pub use order::{order, order_by_depth};
pub use piece::{Cut, Piece, Side};
pub use plan::{Plan, plan, plan_within};
pub use relation::{DEPTH_TOLERANCE, Relation, relation};
