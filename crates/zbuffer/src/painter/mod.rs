//! In which order must polygons be drawn? From back to front, if there is such an order (L13, L14).
