//! No bytes make a reader panic, and none make it take memory that the file does not pay
//! for.

mod common;

use hipline_io::{Format, read, read_settings, read_skeletons, write};

/// SplitMix64: small, seeded, the same everywhere.
struct Random(u64);

impl Random {
    const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}

fn samples() -> Vec<Vec<u8>> {
    let mut samples: Vec<Vec<u8>> = [
        r#"{"type":"FeatureCollection","features":[{"type":"Feature","id":1,"properties":{"edge_weights":[[1,2,3]]},
        "geometry":{"type":"Polygon","coordinates":[[[0,0],[1e3,0.5],[0,-1,7],[0,0]]]}}]}"#,
        r#"{"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":[[1,2]]},
        {"type":"MultiLineString","coordinates":[[[1,2],[3,4]],[]]}]}"#,
        "# c\nSRID=1;MULTIPOLYGON Z (((0 0 1,1 0 1,0 1 1,0 0 1)),EMPTY)\nGEOMETRYCOLLECTION(POINT(1 2),LINESTRING(0 0,1 1))",
        r#"<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "b">]><graphml><key id="x" attr.name="vertex-coordinate-x"/>
        <key id="y" attr.name="vertex-coordinate-y"><default>1</default></key><key id="w" attr.name="edge-weight"/>
        <graph id="g"><node id="&lt;"><data key="x">1<![CDATA[2]]>&#48;</data></node><node id="b"><data key="x">2</data>
        </node><edge source="&lt;" target="b"><data key="w">2</data></edge></graph></graphml>"#,
        "2\n3\n0 0\n1 0\n0 1\n2\n5 5\n6 6\n",
        r#"{"type":"Feature","properties":{"profile":[[0,1],[2,4]],"edge_starts":[[0,1,0]],"edge_profiles":[null,[[0,1],[1,0]],null],
        "vertex_heights":[[0,0.5,0]],"heights_from_z":true},"geometry":{"type":"Polygon","coordinates":[[[0,0,1],[9,0,2],[0,9,1],[0,0,1]]]}}"#,
        "feature,ring,edge,side,speed,time,start\n0,0,1,both,2,3,\n*,*,*,,1,,0.5\n",
        "4 0 0 1 0 1 1 0 1",
        "# c\no a b\nv 0 0 0\nv 1 0\\\n 0\nv 0 1 0\nf 1/1 2//2 -1\nl 1 2 3 1\n",
    ]
    .into_iter()
    .map(|s| s.as_bytes().to_vec())
    .collect();
    for skeleton in [common::hip_roof(), common::segment(), common::with_hole()] {
        let mut json = Vec::new();
        write::json(&mut json, &skeleton).unwrap();
        samples.push(json);
    }
    samples
}

fn feed(bytes: &[u8]) {
    let _ = Format::from_content(bytes);
    for format in Format::ALL {
        if let Ok(mut document) = read(bytes, format) {
            if let Ok(settings) = read_settings(b"edge,speed,start,time\n1,2,3,4\n*,0,,\n", "t") {
                let _ = document.set(&settings);
            }
            let _ = document.heights_from_z();
            for feature in &document.features {
                let _ = (feature.name().to_string(), feature.case.points());
                let _ = feature.figure();
            }
        }
    }
    let _ = read_settings(bytes, "t");
    for record in read_skeletons(bytes).into_iter().flatten() {
        if let Ok(skeleton) = record.result {
            let mut picture = write::Picture::new();
            picture.skeleton(&skeleton);
            picture.svg(std::io::sink()).unwrap();
            write::json(std::io::sink(), &skeleton).unwrap();
            write::obj(std::io::sink(), &skeleton, 1.0).unwrap();
            write::wkt(std::io::sink(), &skeleton).unwrap();
            let view = write::RoofView {
                size: 20,
                ..write::RoofView::default()
            };
            if let Ok(mesh) = skeleton.roof(1.0) {
                write::roof_png(std::io::sink(), &[&mesh], &view).unwrap();
            }
        }
    }
}

#[test]
fn truncated_files() {
    for sample in samples() {
        for end in 0..=sample.len() {
            feed(&sample[..end]);
        }
    }
}

#[test]
fn mutated_files() {
    const SEED: u64 = 20_261_122;
    const ROUNDS: usize = 6000;
    println!("seed {SEED}");
    let mut random = Random(SEED);
    let samples = samples();
    let pieces: [&[u8]; 16] = [
        b"1e999",
        b"-",
        b"nan",
        b"inf",
        b"99999999999999999999",
        b"[",
        b"]",
        b"(",
        b")",
        b"<",
        b"\xff\xfe",
        b"\0",
        b"\n",
        b"null",
        b"-1",
        b"0",
    ];
    for _ in 0..ROUNDS {
        let mut bytes = samples[random.below(samples.len())].clone();
        for _ in 0..=random.below(4) {
            let at = random.below(bytes.len());
            match random.below(5) {
                0 => bytes[at] = random.next() as u8,
                1 => drop(bytes.remove(at)),
                2 => bytes
                    .splice(at..at, pieces[random.below(pieces.len())].iter().copied())
                    .for_each(drop),
                3 => bytes[at] ^= 1 << random.below(8),
                _ => {
                    let end = at + random.below(bytes.len() - at);
                    let copy = bytes[at..end].to_vec();
                    let to = random.below(bytes.len());
                    bytes.splice(to..to, copy).for_each(drop);
                }
            }
            if bytes.is_empty() {
                break;
            }
        }
        feed(&bytes);
    }
}

#[test]
fn random_bytes() {
    const SEED: u64 = 7;
    const ROUNDS: usize = 4000;
    println!("seed {SEED}");
    let mut random = Random(SEED);
    let alphabet = b"{}[]()<>,:;\"'\\/&#=.+-eE0123456789 \n\tvlfotypecoordinatesPOLYGON";
    for round in 0..ROUNDS {
        let length = random.below(200);
        let bytes: Vec<u8> = (0..length)
            .map(|_| {
                if round % 2 == 0 {
                    random.next() as u8
                } else {
                    alphabet[random.below(alphabet.len())]
                }
            })
            .collect();
        feed(&bytes);
    }
}

#[test]
fn deep_nesting_and_absurd_counts() {
    for (piece, times) in [
        ("[", 1_000_000),
        ("{\"geometry\":", 500_000),
        ("{\"type\":\"GeometryCollection\",\"geometries\":[", 300_000),
        ("{\"type\":\"LineString\",\"coordinates\":[[", 1000),
        ("GEOMETRYCOLLECTION(", 500_000),
        ("MULTIPOLYGON(((", 100_000),
        ("<graphml>", 100_000),
        ("<graphml><graph>", 50_000),
        ("18446744073709551615\n", 1000),
        ("9223372036854775807 ", 1000),
        ("4294967296\n0 0\n", 1000),
        ("f 18446744073709551615 -9223372036854775808\n", 10),
    ] {
        feed(piece.repeat(times).as_bytes());
    }
}
