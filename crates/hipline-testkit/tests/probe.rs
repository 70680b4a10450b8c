use hipline::Region;
use hipline_testkit::reference::{Graph, reference};
#[test]
fn probe() {
    let mut g = Graph::default();
    g.ring(&[[117.62484785200004, 3.283270575000117], [117.63171592083741, 3.271053337273843], [117.6321104, 3.2709415], [117.6320843, 3.2708497], [117.63180470386554, 3.2708954059271265], [117.63331139400017, 3.268215236000103], [117.659922722, 3.255275783000087]], &[]);
    let r = reference(&g, Region::Both);
    for a in &r.arcs { println!("{:?} {:?} {:?} {:?}", a.nodes.map(|n| (r.nodes[n].place, r.nodes[n].time)), a.faces.map(|f| r.faces[f]), a.kind, a.nodes); }
}
