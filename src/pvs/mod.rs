//! temp
#![allow(missing_docs)]
mod arena;
mod bits;
mod bounds;
mod propose;
mod search;
mod separators;
use crate::scene::PortalGraph;
use rayon::prelude::*;

pub fn run(graph: &PortalGraph) {
    let t = std::time::Instant::now();
    let arena = arena::Arena::new(graph);
    println!("arena {:?}", t.elapsed());
    let bounds = bounds::Bounds::new(&arena);
    println!(
        "bounds {:?} total {}",
        t.elapsed(),
        (0..arena.directed()).map(|d| bounds.after(d).count() as u64).sum::<u64>()
    );
    let n = arena.cells();
    let cellsee: Vec<bits::Bits> = (0..n)
        .map(|c| {
            let mut s = arena.no_cells();
            s.insert(c);
            for &p in arena.leaving(c) {
                s.insert(arena.to(p));
                for q in bounds.after(p).iter() {
                    s.insert(arena.to(q));
                }
            }
            s
        })
        .collect();
    let mut order: Vec<u32> = (0..n).collect();
    order.sort_by_key(|&c| (cellsee[c as usize].count(), c));
    let mut rank = vec![0; n as usize];
    for (i, &c) in order.iter().enumerate() {
        rank[c as usize] = i;
    }
    println!("upper {}", cellsee.iter().map(|c| c.count() as u64).sum::<u64>());
    let shared = bounds::SharedBounds::new(&bounds);
    let res: Vec<_> = order
        .par_iter()
        .with_max_len(1)
        .map_init(
            || search::Search::new(&arena, &shared),
            |s, &a| {
                s.found.clear();
                s.stats = Default::default();
                s.wanted.clear();
                for b in cellsee[a as usize].iter() {
                    if rank[b as usize] > rank[a as usize] && cellsee[b as usize].has(a) {
                        s.wanted.insert(b);
                    }
                }
                let want = s.wanted.count();
                let t = std::time::Instant::now();
                s.run(a);
                (a, want, s.found.len(), s.stats.clone(), t.elapsed().as_secs_f64())
            },
        )
        .collect();
    println!("search {:?}", t.elapsed());
    let open: usize = res.iter().map(|r| r.2).sum();
    println!(
        "open ordered with diagonal {} wanted {}",
        2 * open + n as usize,
        2 * res.iter().map(|r| r.1 as usize).sum::<usize>() + n as usize
    );
    let mut t = search::Stats::default();
    for r in &res {
        let s = &r.3;
        macro_rules! add { ($($f:ident),*) => { $(t.$f += s.$f;)* } }
        add!(
            nodes,
            nogood,
            cones,
            cone_portals,
            cone_open,
            t_cone,
            compat,
            floods,
            no_goal,
            inherited,
            solved,
            gordan,
            gordan_unproved,
            parent_line,
            proposed,
            undecided,
            planes,
            open,
            t_flood,
            t_sep,
            t_norm,
            t_gordan,
            t_line
        );

        for i in 0..8 {
            t.support[i] += s.support[i];
        }
    }
    println!("{t:#?}");
    let mut w: Vec<_> = res.iter().map(|r| (r.4, r.0, r.3.nodes)).collect();
    w.sort_by(|a, b| b.0.total_cmp(&a.0));
    println!("{:?}", &w[..8]);
}
