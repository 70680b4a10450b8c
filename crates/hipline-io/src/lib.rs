//! File formats and pictures for hipline.
