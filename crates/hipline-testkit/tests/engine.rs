//! The library against the reference engine, on random small cases.

use hipline_testkit::hunt::hunt;

#[test]
#[ignore = "until the kinetic engine is there"]
fn agrees_with_the_reference() {
    let count = std::env::var("HIPLINE_CASES")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(2000);
    let found = hunt(0..count, 3);
    let report: Vec<String> = found
        .iter()
        .map(|(case, how)| format!("{}{how}", case.to_text()))
        .collect();
    assert!(report.is_empty(), "{}", report.join("\n\n"));
}
