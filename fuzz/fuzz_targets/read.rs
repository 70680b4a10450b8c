//! Every reader on any bytes: a document or an error that says something, never a panic.
//!
//! The first byte chooses the reader.
#![no_main]

use hipline_io::{Format, read, read_skeletons};
use libfuzzer_sys::fuzz_target;

/// Larger figures are read, but not built: that is not what is tested here.
const MOST: usize = 60;

fuzz_target!(|bytes: &[u8]| {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    let choice = usize::from(first) % (Format::ALL.len() + 2);
    let result = match Format::ALL.get(choice) {
        Some(&format) => read(rest, format),
        None if choice == Format::ALL.len() => {
            Format::from_content(rest).and_then(|format| read(rest, format))
        }
        None => {
            if let Err(error) = read_skeletons(rest) {
                assert!(!error.to_string().is_empty());
            }
            return;
        }
    };
    let document = match result {
        Ok(document) => document,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    let points: usize = document.features.iter().map(|f| f.case.points()).sum();
    assert!(points <= rest.len(), "{points} points in {} bytes", rest.len());
    if points <= MOST {
        let features = document.features.iter().map(hipline_io::Feature::figure);
        for figure in features.chain([document.together()]) {
            if let Err(error) = figure {
                assert!(!error.to_string().is_empty());
            }
        }
    }
});
