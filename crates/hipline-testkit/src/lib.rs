//! Generators, the reference engine and the laws that hipline is tested by.

pub mod reference;
