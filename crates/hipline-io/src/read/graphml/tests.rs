use super::*;

const HEAD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
<key attr.name="vertex-coordinate-x" attr.type="string" for="node" id="x"/>
<key attr.name="vertex-coordinate-y" attr.type="string" for="node" id="y"/>
<key attr.name="edge-weight" attr.type="string" for="edge" id="w"/>
<key attr.name="edge-weight-additive" attr.type="string" for="edge" id="wa"><default>0.0</default></key>
"#;

fn file(graph: &str) -> String {
    format!("{HEAD}<graph edgedefault=\"undirected\">\n{graph}</graph>\n</graphml>\n")
}

fn node(id: &str, x: &str, y: &str) -> String {
    format!("<node id=\"{id}\"><data key=\"x\">{x}</data><data key=\"y\">{y}</data></node>\n")
}

fn ok(text: &str) -> GraphShape {
    let mut document = read(text.as_bytes()).unwrap_or_else(|e| panic!("{text}: {e}"));
    match document.features.remove(0).case {
        Shape::Graph(graph) => graph,
        other => panic!("{other:?}"),
    }
}

fn err(graph: &str) -> String {
    read(file(graph).as_bytes())
        .map(|d| panic!("{graph}: {d:?}"))
        .unwrap_err()
        .to_string()
}

#[test]
fn a_graph_with_weights() {
    let edge = r#"<edge source="c" target="a &amp; b"><data key="w">2.5</data><data key="wa">0</data></edge>
            <edge source="c" target="c"/>"#;
    // Edges may come before their nodes; an entity in an id, a character reference in a number.
    let graph = ok(&file(&format!(
        "{edge}{}{}",
        node("a &amp; b", " 0.1 ", "1e&#48;"),
        node("c", "-3", "4")
    )));
    assert_eq!(graph.vertices, [[0.1, 1.0], [-3.0, 4.0]]);
    assert_eq!(graph.edges, [[1, 0], [1, 1]]);
    assert_eq!(graph.speeds, Some(vec![[2.5; 2], [1.0; 2]]));
}

#[test]
fn without_weights_and_with_default_weight() {
    let graph = format!(
        "{}{}<edge source=\"0\" target=\"1\"/>",
        node("0", "0", "0"),
        node("1", "1", "1")
    );
    assert_eq!(ok(&file(&graph)).speeds, None);
    let weighted = file(&graph).replace(r#"id="w"/>"#, r#"id="w"><default>3</default></key>"#);
    assert_eq!(ok(&weighted).speeds, Some(vec![[3.0; 2]]));
}

#[test]
fn several_graphs_and_none() {
    let two = file("").replace("</graph>", "</graph><graph id=\"g\"/>");
    let document = read(two.as_bytes()).unwrap();
    assert_eq!(document.features.len(), 2);
    assert_eq!(document.features[1].name().to_string(), "feature 1 (\"g\")");
    assert_eq!(document.features[1].case, Shape::Empty);
    assert_eq!(
        read(b"<graphml></graphml>").unwrap_err().to_string(),
        "GraphML: there is no <graph>"
    );
    assert_eq!(
        read(b"").unwrap_err().to_string(),
        "GraphML: there is no <graph>"
    );
}

#[test]
fn errors_name_the_place() {
    let nodes = format!("{}{}", node("0", "0", "0"), node("1", "1", "1"));
    assert_eq!(
        err(&node("0", "NaN", "0")),
        "GraphML, line 8, column 14: `NaN` is not a finite number"
    );
    assert_eq!(
        err("<node id='7'/>"),
        "GraphML, line 8, column 1: node `7` has no vertex-coordinate-x"
    );
    assert_eq!(
        err("<node/>"),
        "GraphML, line 8, column 1: <node> without id"
    );
    assert_eq!(
        err("<edge source='a'/>"),
        "GraphML, line 8, column 1: <edge> without target"
    );
    assert_eq!(
        err(&format!("{nodes}<edge source='0' target='2'/>")),
        "GraphML, line 10, column 1: an edge leads to node `2`, but there is none"
    );
    assert_eq!(
        err(&format!("{nodes}{nodes}")),
        "GraphML, line 10, column 1: node `0` is there twice"
    );
    assert_eq!(
        err(&format!(
            "{nodes}<edge source='0' target='1'><data key='wa'>-2</data></edge>"
        )),
        "GraphML, line 10, column 1: no edge starts before the time 0 (edge-weight-additive is -2)"
    );
    assert_eq!(
        err("<node id='0'><graph/></node>"),
        "GraphML, line 8, column 14: a graph inside a graph"
    );
    assert_eq!(
        err("<node id='0'><node id='1'/></node>"),
        "GraphML, line 8, column 14: nodes and edges belong directly into a <graph>"
    );
    assert_eq!(
        err("<hyperedge/>"),
        "GraphML, line 8, column 1: hyperedges have no place in the plane"
    );
    assert!(err("<node id='0'>").starts_with("GraphML, line 8, column 14: "));
    let text = file("");
    let cut = read(&text.as_bytes()[..text.len() - 12])
        .unwrap_err()
        .to_string();
    assert_eq!(
        cut,
        "GraphML, line 8, column 9: the file ends inside an element"
    );
    assert_eq!(
        read(b"<svg/>").unwrap_err().to_string(),
        "GraphML, line 1, column 1: the outermost element is not <graphml>"
    );
}
