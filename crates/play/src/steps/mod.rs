//! What happens one step after the other?
