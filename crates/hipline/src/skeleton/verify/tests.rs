//! Corrupted skeletons.
