//! The engine against its twins and against the checker, on as many cases of every family as there
//! is time for:
//!
//!     cargo run --release --example soak -- --cases 100000 --threads 2
//!
//! Each case is answered by the engine, whose witness or certificate is held by the definitions
//! (`forge::check`), and by a brute-force twin (`forge::twin`) that shares nothing with it. The
//! first disagreement ends the run with its seed and number. `--input MAP` adds the family that is
//! made from a portal graph. The digest of a family is the BLAKE3 hash of all its answers, the same
//! on every machine: `--check FILE` compares them with those kept there, `--write FILE` keeps them.

use stabline::forge::{
    self, FAMILIES, Family, Finding, Graph, Input, Scene, find, graph_of, occluders_of, twin,
};
use stabline::formats::blake3;
use stabline::num::{Int, Rational};
use stabline::pvs::{self, Found};
use stabline::report::{InputId, Matrix, ProofHead, Silent, Verdict};
use stabline::scene::{PortalGraph, read_graph};
use stabline::vectors::{Answer, Class};
use stabline::verify::verify;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Cases that a thread takes at a time.
const BLOCK: u64 = 50;

struct Options {
    cases: u64,
    seed: u64,
    seconds: Option<u64>,
    threads: usize,
    family: Option<String>,
    input: Option<String>,
    check: Option<String>,
    write: Option<String>,
}

fn options() -> Result<Options, String> {
    let mut options = Options {
        cases: 1000,
        seed: 1,
        seconds: None,
        threads: 1,
        family: None,
        input: None,
        check: None,
        write: None,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        let value = arguments.next().ok_or_else(|| format!("{name}: expected a value"))?;
        let number = || value.parse::<u64>().map_err(|_| format!("{name}: not a number: {value}"));
        match name.as_str() {
            "--cases" => options.cases = number()?,
            "--seed" => options.seed = number()?,
            "--seconds" => options.seconds = Some(number()?),
            "--threads" => options.threads = number()?.max(1) as usize,
            "--family" => options.family = Some(value),
            "--input" => options.input = Some(value),
            "--check" => options.check = Some(value),
            "--write" => options.write = Some(value),
            _ => return Err(format!("{name}: no such option")),
        }
    }
    Ok(options)
}

fn main() -> ExitCode {
    match options().and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("error: {what}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let map = options.input.as_ref().map(read_map).transpose()?;
    let chosen = |family: &&Family| {
        let is_named = options.family.as_ref().is_none_or(|name| name == family.name);
        is_named && (map.is_some() || !family.from_map)
    };
    let families: Vec<&Family> = FAMILIES.iter().filter(chosen).collect();
    if families.is_empty() {
        return Err("no such family, or no --input for it".to_owned());
    }
    let mut lines = String::new();
    for family in families {
        let start = Instant::now();
        let Soaked { count, digest, open, grazing } = soak(family, options, map.as_ref())?;
        let line = format!("{} {count} seed {} {digest}\n", family.name, options.seed);
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{} {open} open {grazing} grazing, {seconds:.1} s, {:.0} a second",
            line.trim_end(),
            count as f64 / seconds
        );
        lines.push_str(&line);
    }
    if let Some(path) = &options.write {
        std::fs::write(path, &lines).map_err(|error| format!("{path}: {error}"))?;
    }
    if let Some(path) = &options.check {
        let kept = std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
        if let Some(line) = lines.lines().find(|line| !kept.lines().any(|kept| kept == *line)) {
            return Err(format!("{path} does not have: {line}"));
        }
    }
    Ok(())
}

/// The portal graph in a file, `.prt` or JSON.
fn read_map(path: &String) -> Result<Graph, String> {
    let bytes = std::fs::read(path).map_err(|error| format!("{path}: {error}"))?;
    let graph = read_graph(path, &bytes).map_err(|error| error.to_string())?;
    Ok(graph_of(&graph))
}

struct Soaked {
    count: u64,
    digest: String,
    open: u64,
    grazing: u64,
}

/// A block's hash of answers, and how many were open and grazing.
type Block = (String, u64, u64);

fn soak(family: &Family, options: &Options, map: Option<&Graph>) -> Result<Soaked, String> {
    let deadline = options.seconds.map(|seconds| Instant::now() + Duration::from_secs(seconds));
    let map = map.filter(|_| family.from_map).cloned();
    let settings = family.settings(&[], map).map_err(|error| error.to_string())?;
    let (next, stop) = (AtomicU64::new(0), AtomicBool::new(false));
    let blocks: Mutex<Vec<(u64, Block)>> = Mutex::new(Vec::new());
    let failure: Mutex<Option<(u64, String)>> = Mutex::new(None);
    let work = || {
        while !stop.load(Ordering::Relaxed) && deadline.is_none_or(|end| Instant::now() < end) {
            let block = next.fetch_add(1, Ordering::Relaxed);
            let (first, last) = (block * BLOCK, ((block + 1) * BLOCK).min(options.cases));
            if first >= last {
                return;
            }
            let (mut text, mut open, mut grazing) = (String::new(), 0, 0);
            for number in first..last {
                let input = family.input(&settings, options.seed, number);
                match compare(&input) {
                    Ok(said) => {
                        open += u64::from(said.answer == Answer::Class(Class::Open));
                        grazing += u64::from(said.answer == Answer::Class(Class::Grazing));
                        text.push_str(&format!("{number} {:?} {}\n", said.answer, said.evidence));
                    }
                    Err(what) => {
                        stop.store(true, Ordering::Relaxed);
                        let name = family.name;
                        let case = input.case(number as u32, name, &[name]).to_line();
                        let seed = options.seed;
                        let what = format!("{name}, seed {seed}, case {number}: {what}\n{case}");
                        let mut failure = failure.lock().unwrap();
                        if failure.as_ref().is_none_or(|(other, _)| number < *other) {
                            *failure = Some((number, what));
                        }
                        return;
                    }
                }
            }
            blocks.lock().unwrap().push((block, (blake3::hex(text.as_bytes()), open, grazing)));
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..options.threads {
            scope.spawn(work);
        }
    });
    if let Some((_, what)) = failure.into_inner().unwrap() {
        return Err(what);
    }
    let mut blocks = blocks.into_inner().unwrap();
    blocks.sort_unstable_by_key(|(block, _)| *block);
    let all: String = blocks.iter().map(|(_, (hash, ..))| hash.as_str()).collect();
    let count = (blocks.len() as u64 * BLOCK).min(options.cases);
    let open = blocks.iter().map(|(_, (_, open, _))| open).sum();
    let grazing = blocks.iter().map(|(_, (_, _, grazing))| grazing).sum();
    Ok(Soaked { count, digest: blake3::hex(all.as_bytes()), open, grazing })
}

/// The engine's answer, if the checker and the twin agree with it.
fn compare(input: &Input) -> Result<Finding, String> {
    let found = find(input).map_err(|fault| fault.to_string())?;
    let expected = match input {
        Input::Graph(graph) => Some(Answer::Class(twin_of_graph(graph)?)),
        // The sightline of what is open was held; sampled points must not see more than that.
        Input::Scene(scene) if found.answer != Answer::Class(Class::Open) => {
            if let Some(points) = sampled_sight(scene) {
                return Err(format!("{points:?} see each other: {found:?}"));
            }
            None
        }
        input => twin::answer(input).map_err(|fault| fault.to_string())?,
    };
    match expected {
        Some(expected) if found.answer != expected => {
            Err(format!("the engine says {:?}, the twin {expected:?}", found.answer))
        }
        Some(_) | None => Ok(found),
    }
}

/// Two points of the regions between which nothing stands, if some of these do.
fn sampled_sight(scene: &Scene) -> Option<[[Rational; 3]; 2]> {
    let occluders = occluders_of(scene);
    let [from, to] = [&scene.from, &scene.to].map(|region| samples(region));
    let pairs = from.iter().flat_map(|p| to.iter().map(move |q| [p.clone(), q.clone()]));
    pairs.into_iter().find(|[p, q]| forge::check::is_clear(p, q, &occluders))
}

/// Inner points of a box by two corners, or of a polygon of the plane: near the corners, and
/// towards the middle.
fn samples(region: &[Vec<Rational>]) -> Vec<[Rational; 3]> {
    let ratio = |p: i64, q: i64| Rational::new(Int::from(p), Int::from(q));
    let corners: Vec<[Rational; 3]> = match region {
        [low, high] => {
            (0..8).map(|bits| [0, 1, 2].map(|i| [low, high][bits >> i & 1][i].clone())).collect()
        }
        polygon => polygon.iter().map(|p| [p[0].clone(), p[1].clone(), ratio(1, 2)]).collect(),
    };
    let count = ratio(corners.len() as i64, 1);
    let middle = [0, 1, 2].map(|i| corners.iter().map(|p| &p[i]).sum::<Rational>() / &count);
    let mut points = vec![middle.clone()];
    for share in [ratio(1, 1000), ratio(1, 3)] {
        points.extend(
            corners.iter().map(|p| [0, 1, 2].map(|i| &p[i] + (&middle[i] - &p[i]) * &share)),
        );
    }
    points
}

/// The proof of the graph's PVS, grazing pairs included, as the independent checker takes it.
fn check_proof(
    graph: &Graph,
    built: &PortalGraph,
    matrix: &Matrix,
    rows: &[pvs::Row],
) -> Result<(), String> {
    let mut matrix = matrix.clone();
    let grazing =
        forge::classify_grazing(graph, built, &mut matrix).map_err(|fault| fault.to_string())?;
    let found = Found { matrix: &matrix, rows, grazing: &grazing };
    let input = InputId { name: "a graph".to_owned(), blake3: "0".repeat(64) };
    let head = ProofHead { program: "stabline", input: &input };
    let text = pvs::write_proof(Vec::new(), &head, built, &found, &Silent);
    let text = text.map_err(|error| error.to_string())?.ok_or("interrupted")?;
    verify(text.as_slice()).map(drop).map_err(|flaw| format!("the proof does not hold: {flaw}"))
}

/// What the walk over all sequences says of the pair; of all other pairs, that it says the same.
fn twin_of_graph(graph: &Graph) -> Result<Class, String> {
    let open = twin::open_cells(graph).map_err(|fault| fault.to_string())?;
    let (built, matrix, rows) = forge::pvs_of(graph).map_err(|fault| fault.to_string())?;
    check_proof(graph, &built, &matrix, &rows)?;
    for (a, row) in open.iter().enumerate() {
        for (b, &is_open) in row.iter().enumerate() {
            if is_open != (matrix.get(a, b) == Verdict::Open) {
                return Err(format!("cells {a} and {b}: the twin says open: {is_open}"));
            }
        }
    }
    twin::class_of_pair(graph, open[graph.from][graph.to]).map_err(|fault| fault.to_string())
}
