//! How do figures and claims come onto one page?
