use stabline::formats::wad::Archive;
use stabline::portal::doom::DoomAreas;
use stabline::portal::plan::cells_of_plan;
use stabline::report::Silent;
use stabline::scene::plan::{DoomOddity, plan_of_map};
use stabline::subdivision::plan::{PlanMethod, divide};
use std::time::Instant;
fn main() {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(path).unwrap();
        let archive = Archive::read(&bytes).unwrap();
        for name in archive.maps() {
            let t0 = Instant::now();
            let map = archive.map(name).unwrap();
            let doom = plan_of_map(&map).unwrap();
            let t1 = Instant::now();
            let tree = divide(&doom.plan, &PlanMethod::default(), &Silent).unwrap();
            let t2 = Instant::now();
            let cells = cells_of_plan(&doom.plan, tree, false).unwrap();
            let t3 = Instant::now();
            let areas = DoomAreas::of(&doom, &cells);
            let t4 = Instant::now();
            println!(
                "{name} sectors {} lines {} leaves {} portals {} depth {} areas {} ; {:?} {:?} {:?} {:?}",
                map.sectors,
                map.linedefs.len(),
                cells.tree.leaves.len(),
                cells.graph.portals.len(),
                cells.tree.depth(),
                areas.sectors.len(),
                t1 - t0,
                t2 - t1,
                t3 - t2,
                t4 - t3
            );
            let cover = stabline::pvs::plan::Cover::new(
                doom.sectors,
                (0..cells.tree.leaves.len() as u32).map(|l| areas.sectors_of_leaf(l)),
            );
            let crossings = cells.graph.crossings();
            let m =
                stabline::pvs::plan::plan_matrix(&cells.graph, &crossings, cover.groups(), &Silent)
                    .unwrap();
            let m = cover.matrix(m);
            let t5 = Instant::now();
            let rj = stabline::formats::wad::RejectTable::read(
                &map.reject.clone().unwrap(),
                map.sectors,
            )
            .unwrap();
            let (mut holes, mut waste) = (0, 0);
            for a in 0..map.sectors {
                for b in 0..map.sectors {
                    let open = m.get(a, b) == stabline::report::Verdict::Open;
                    if open && rj.rejects(a, b) {
                        holes += 1;
                    }
                    if !open && !rj.rejects(a, b) {
                        waste += 1;
                    }
                }
            }
            println!("     pvs {:?} open {} holes {holes} waste {waste}", t5 - t4, m.counts().open);
            for o in &areas.oddities {
                if !matches!(o, DoomOddity::SelfReferencing { .. }) {
                    println!("   {o:?}");
                }
            }
        }
    }
}
