use hipline::FigureBuilder;
#[test]
fn smoke() {
    let mut b = FigureBuilder::new();
    b.polygon(vec![vec![[0.,0.],[8.,0.],[8.,6.],[0.,6.],[0.,0.]], vec![[1.,1.],[2.,1.],[2.,2.]]]);
    b.polyline(vec![[4.,0.],[4.,3.],[5.,3.]]);
    let f=b.build().unwrap();
    println!("{f:?}");
    assert_eq!(f.edges().len(), 10);
    let mut b = FigureBuilder::new();
    b.polyline(vec![[4.,0.],[4.,3.]]);
    println!("{:?}", b.build().unwrap());
    let mut b = FigureBuilder::new();
    b.graph(vec![[4.,0.],[4.,3.],[4.,1.],[4.,5.],[4.,7.],[4.,6.5]], vec![[1,0],[2,0],[3,4]]);
    println!("{:?}", b.build());
    let mut b = FigureBuilder::new();
    b.graph(vec![[4.,0.],[4.,3.],[4.,5.],[4.,7.],[4.,6.5],[4.,9.]], vec![[1,0],[3,2],[4,5]]);
    println!("{:?}", b.build());
    let mut b = FigureBuilder::new();
    b.polygon(vec![vec![[0.,0.],[8e300,0.],[8e300,6e-2],[0.,6.]]]);
    println!("{}", b.build().unwrap_err());
    for s in [1e-320, 1e-300,1e300,1e-310] {
    let mut b = FigureBuilder::new();
    b.polygon(vec![vec![[0.,0.],[8.*s,0.],[8.*s,6.*s],[0.,6.*s]]]);
    b.build().unwrap();
    }
}
