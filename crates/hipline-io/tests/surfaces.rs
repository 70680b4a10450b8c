//! Rasters, contour lines, catchments and paths are read back as what was written.

use std::io::Cursor;

use hipline::{
    Figure, FigureBuilder, Options, Skeleton,
    observe::{Grid, Index, Terrain, Window, contours},
    topology::FaceId,
};
use hipline_io::write::{
    Heights, catchments_geojson, contours_geojson, drops_geojson, terrain_obj,
};
use serde_json::Value;
use tiff::{
    decoder::{Decoder, DecodingResult},
    tags::Tag,
};

/// A river with a tributary, and a lake beside it.
fn figure() -> Figure {
    let mut builder = FigureBuilder::new();
    builder.polyline(vec![[0.0, 0.0], [10.0, 2.0], [20.0, 0.0]]);
    builder.polyline(vec![[10.0, 2.0], [12.0, 9.0]]);
    builder.polyline(vec![[3.0, 7.0], [6.0, 7.0], [5.0, 10.0]]);
    builder.build().unwrap()
}

fn skeleton(figure: &Figure) -> Skeleton {
    figure.skeleton(Options::default())
}

fn raster(skip: usize) -> (Grid, Vec<Option<f64>>) {
    let figure = figure();
    let skeleton = skeleton(&figure);
    let window = Window::new([-1.5, -2.0], [21.0, 12.25]).unwrap();
    let grid = Grid::new(window, 0.75).unwrap();
    let answers = Index::new(&skeleton, &figure).locate_grid(&grid);
    let values = answers.iter().enumerate();
    let values = values.map(|(i, a)| (i % 7 != skip).then(|| a.as_ref().unwrap().time));
    (grid, values.collect())
}

#[test]
fn an_ascii_grid_is_read_back() {
    let (grid, values) = raster(3);
    let mut text = Vec::new();
    let heights = Heights::new(grid, values.clone()).unwrap();
    heights.ascii(&mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let head: Vec<&str> = text.lines().take(6).collect();
    let expected = [
        "ncols 30",
        "nrows 19",
        "xllcorner -1.5",
        "yllcorner -2",
        "cellsize 0.75",
        "NODATA_value -9999",
    ];
    assert_eq!(head, expected);
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(6)
        .map(|line| line.split(' ').map(|n| n.parse().unwrap()).collect())
        .collect();
    let back: Vec<f64> = rows.into_iter().rev().flatten().collect();
    let expected: Vec<f64> = values.iter().map(|v| v.unwrap_or(-9999.0)).collect();
    assert_eq!(back, expected);
}

#[test]
fn no_height_is_taken_for_no_data() {
    let (grid, _) = raster(7);
    let values = vec![Some(-9999.0); grid.columns() * grid.rows()];
    let mut text = Vec::new();
    let heights = Heights::new(grid, values).unwrap();
    heights.ascii(&mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    assert!(text.contains("NODATA_value -100000\n"), "{}", &text[..120]);
    assert!(Heights::new(grid, vec![None]).is_err(), "too few heights");
}

#[test]
fn a_geotiff_is_read_back() {
    let (grid, values) = raster(3);
    let mut bytes = Vec::new();
    let heights = Heights::new(grid, values.clone()).unwrap();
    heights.geotiff(&mut bytes).unwrap();
    let mut decoder = Decoder::new(Cursor::new(bytes)).unwrap();
    assert_eq!(decoder.dimensions().unwrap(), (30, 19));
    let mut numbers = |tag: u16| decoder.get_tag_f64_vec(Tag::Unknown(tag)).unwrap();
    assert_eq!(numbers(33550), [0.75, 0.75, 0.0]);
    // The upper left corner: 19 rows of 0.75 above -2.
    assert_eq!(numbers(33922), [0.0, 0.0, 0.0, -1.5, 12.25, 0.0]);
    let keys = decoder.get_tag_u16_vec(Tag::Unknown(34735)).unwrap();
    assert_eq!(keys, [1, 1, 0, 2, 1024, 0, 1, 32767, 1025, 0, 1, 1]);
    let nothing = decoder.get_tag_ascii_string(Tag::Unknown(42113)).unwrap();
    assert_eq!(nothing, "nan");
    let DecodingResult::F64(back) = decoder.read_image().unwrap() else {
        panic!("not f64")
    };
    let rows = values.chunks(30).rev().flatten();
    for (back, value) in back.iter().zip(rows) {
        match value {
            Some(value) => assert_eq!(back.to_bits(), value.to_bits()),
            None => assert!(back.is_nan()),
        }
    }
}

fn features(bytes: &[u8]) -> Vec<Value> {
    let all: Value = serde_json::from_slice(bytes).unwrap();
    assert_eq!(all["type"], "FeatureCollection");
    all["features"].as_array().unwrap().clone()
}

#[test]
fn lines_polygons_and_paths_are_geojson() {
    let figure = figure();
    let skeleton = skeleton(&figure);
    let window = Window::new([-1.5, -2.0], [21.0, 12.25]).unwrap();
    let elevation = |time: f64| 100.0 + 2.0 * time;

    let lines = contours(&skeleton, &figure, window, &[1.0, 2.0]).unwrap();
    let mut bytes = Vec::new();
    contours_geojson(&mut bytes, &lines, elevation).unwrap();
    let features_of_lines = features(&bytes);
    assert_eq!(features_of_lines.len(), lines.len());
    for (feature, line) in features_of_lines.iter().zip(&lines) {
        assert_eq!(feature["properties"]["elevation"], elevation(line.time));
        let count = line.points.len() + usize::from(line.is_closed);
        let coordinates = feature["geometry"]["coordinates"].as_array().unwrap();
        assert_eq!(coordinates.len(), count);
    }

    let terrain = Terrain::new(&skeleton, &figure, window).unwrap();
    let found = terrain.catchments(|face: FaceId| skeleton.face(face).edge.index() / 3);
    let mut bytes = Vec::new();
    let named = found.iter().map(|c| (c, format!("\"group\":{}", c.key)));
    catchments_geojson(&mut bytes, named).unwrap();
    let mut sum = 0.0;
    for (i, feature) in features(&bytes).iter().enumerate() {
        assert_eq!(feature["properties"]["group"], i);
        sum += feature["properties"]["area"].as_f64().unwrap();
        let kind = &feature["geometry"]["type"];
        assert!(kind == "Polygon" || kind == "MultiPolygon");
    }
    assert!((sum - window.area()).abs() < 1e-9 * sum, "{sum}");

    let index = Index::new(&skeleton, &figure);
    let drops = [[4.0, 3.0], [10.0, 2.0]].map(|p| index.path(p).unwrap());
    let mut bytes = Vec::new();
    let named = drops.iter().map(|d| (d, "\"n\":1".to_owned()));
    drops_geojson(&mut bytes, named, elevation).unwrap();
    let paths = features(&bytes);
    let start = &paths[0]["geometry"]["coordinates"][0];
    assert_eq!(start[2], elevation(drops[0].points[0][2]));
    assert_eq!(paths[1]["geometry"]["type"], "Point", "on the river itself");

    let mut obj = Vec::new();
    terrain_obj(&mut obj, &terrain, elevation).unwrap();
    let obj = String::from_utf8(obj).unwrap();
    let count = |lead: &str| obj.lines().filter(|l| l.starts_with(lead)).count();
    assert_eq!(count("v "), terrain.vertices().len());
    assert_eq!(count("f "), terrain.triangles().len());
}
