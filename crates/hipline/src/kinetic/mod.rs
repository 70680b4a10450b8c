//! The kinetic triangulation engine (Aichholzer & Aurenhammer 1996, section 3).

use crate::{
    input::Figure,
    skeleton::{Options, Skeleton},
};

impl Figure {
    /// The straight skeleton.
    #[must_use]
    pub fn skeleton(&self, options: Options) -> Skeleton {
        let _ = (options, self.mesh());
        todo!()
    }
}
