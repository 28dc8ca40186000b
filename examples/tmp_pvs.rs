//! temp
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let g = stabline::scene::read_graph(&name, &std::fs::read(&name).unwrap()).unwrap();
    println!("skew {} planar {}", g.skew_portals, g.portals.len());
    stabline::pvs::run(&g);
}
