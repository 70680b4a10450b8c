//! The trivial method, exactly: a slow, obvious oracle for small inputs.
//!
//! Follows section 3 of Aichholzer and Aurenhammer (1996), where it mentions the "trivial method"
//! that checks each wavefront vertex against each wavefront edge for the next event. There is no
//! triangulation, no queue and no floating point. At each event the wavefront is rebuilt from the
//! places of its vertices alone (`rebuild`), so that no kind of event needs a rule of its own.
//!
//! It shares no code with the engines it tests, not even the numbers.

mod eaves;
mod events;
mod graph;
mod heading;
mod laws;
mod model;
mod motion;
mod motorcycles;
mod number;
mod ratio;
mod rebuild;
mod result;
mod wave;

pub use graph::{Graph, GraphChange, GraphEdge};
pub use laws::check_laws;
pub use motorcycles::{RefMotorcycle, reference_launches, reference_motorcycles};
pub use result::{RefArc, RefKind, RefNode, Reference, reference};
