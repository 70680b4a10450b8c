//! Generators, the reference engine and the laws that hipline is tested by.
//!
//! - [`case`]: one test case as plain data, and the text format of the corpus
//! - [`data`]: where inputs from the field are
//! - [`generate`]: cases from seeds, small degenerate ones and large families
//! - [`reference`](mod@reference): an independent exact engine for small cases
//! - [`agreement`]: arc for arc, bit for bit
//! - [`metamorphic`]: maps of cases under which results must map along
//! - [`hunt`](mod@hunt): the library against the reference, case by case
//! - [`measure`]: areas and windings, in the plainest way
//! - [`reduce`](mod@reduce): the smallest case that still fails

pub mod agreement;
pub mod case;
pub mod data;
pub mod generate;
pub mod hunt;
pub mod measure;
pub mod metamorphic;
pub mod reduce;
pub mod reference;

pub use case::Case;

/// The examples of the project's README run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

/// The examples of the page on queries run as tests, too.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/queries.md")]
struct Queries;
