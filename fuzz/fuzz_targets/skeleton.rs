//! The skeleton of any small figure obeys the laws.
#![no_main]

mod figure;

use figure::Shape;
use hipline::{Options, Region};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|shape: Shape| {
    let Some(figure) = shape.figure() else { return };
    for region in [Region::Auto, Region::Both] {
        let skeleton = figure.skeleton(Options::default().region(region));
        if let Err(violations) = skeleton.verify(&figure) {
            panic!("{region:?}: {violations}");
        }
    }
});
