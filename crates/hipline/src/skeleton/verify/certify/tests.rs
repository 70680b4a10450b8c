//! Tracks that are wrong on purpose.
