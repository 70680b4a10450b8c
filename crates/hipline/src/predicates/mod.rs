//! Every geometric decision.
