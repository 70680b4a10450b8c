//! Prints the nodes and arcs of a polygon or lines given as rows of numbers.
use hipline::{FigureBuilder, Options, Region, skeleton::NodeKind};
fn main() {
    let mut b = FigureBuilder::new();
    for a in std::env::args().skip(1) {
        let (poly, a) = a.strip_prefix("P").map_or((false, a.as_str()), |s| (true, s));
        let (a, w) = a.split_once('|').map_or((a, None), |(a, w)| (a, Some(w)));
        let pts: Vec<[f64; 2]> = a.split(';').map(|p| { let mut i = p.split(',').map(|x| x.trim().parse().unwrap()); [i.next().unwrap(), i.next().unwrap()] }).collect();
        if let Some(w) = w { b.weighted_polygon(vec![pts], vec![w.split(',').map(|x| x.parse().unwrap()).collect()]); } else if poly { b.polygon(vec![pts]); } else { b.polyline(pts); }
    }
    let f = b.build().unwrap();
    let s = f.skeleton(Options::default().region(Region::Both));
    for (i, n) in s.nodes().iter().enumerate() { if !matches!(n.kind, NodeKind::Input(_)) { println!("n{i} {} {} {} {:?}", n.x, n.y, n.time, n.kind); } }
    for a in s.arcs() { println!("{:?} {:?} {:?}", a.nodes, a.faces.map(|f| { let f = s.face(f); format!("{:?}{:?}", f.edge, f.side) }), a.kind); }
    println!("{:?}", s.stats());
}
