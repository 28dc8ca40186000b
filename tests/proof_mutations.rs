//! Proofs that were tampered with are rejected: as they are by their seal, and with the seal made
//! right again by what they say, unless what they say is true, by an argument of its own.
//!
//! `STABLINE_MUTATIONS=N` sets how many are tried (default 2000), `STABLINE_SEED=S` the first seed.

mod support;

use stabline::oracle::Random;
use stabline::scene;
use stabline::verify::verify;
use std::collections::BTreeMap;
use std::process::Command;
use std::sync::OnceLock;
use support::arguments::is_true;
use support::graphs::{Family, Graph};
use support::mutations::{Kind, Parts, cuts_of, mutated, sealed, with_seal_of, without_field};
use support::proofs::proof;

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}

/// Random graphs; the proofs of all but the first two have refutations.
const GRAPHS: [(Family, u64); 16] = [
    (Family::Rooms, 500),
    (Family::Wild, 500),
    (Family::Rooms, 623),
    (Family::Rooms, 805),
    (Family::Convex, 586),
    (Family::Skew, 510),
    (Family::Skew, 620),
    (Family::Skew, 628),
    (Family::Skew, 844),
    (Family::Skew, 870),
    (Family::Wild, 519),
    (Family::Wild, 531),
    (Family::Wild, 687),
    (Family::Wild, 729),
    (Family::Wild, 760),
    (Family::Wild, 890),
];

/// The proofs of all scenes and of random graphs, each with its name, made once.
fn proofs() -> &'static [(String, String)] {
    static PROOFS: OnceLock<Vec<(String, String)>> = OnceLock::new();
    PROOFS.get_or_init(|| {
        let scenes = support::scenes("scenes/pvs").into_iter().map(|path| {
            let bytes = std::fs::read(&path).unwrap();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let graph = scene::read_graph(&name, &bytes).unwrap();
            (name, proof(&graph, true))
        });
        let random = GRAPHS.into_iter().enumerate().map(|(index, (family, seed))| {
            let text = proof(&Graph::random(family, seed).validated(), false);
            assert!(index < 2 || text.lines().any(is_refuted), "{family:?} {seed}");
            (format!("{family:?} {seed}"), text)
        });
        scenes.chain(random).collect()
    })
}

fn is_refuted(line: &str) -> bool {
    let fields: Vec<&str> = line.split(' ').take(3).collect();
    fields[0].parse::<usize>().is_ok() && matches!(fields.get(2), Some(&("l" | "i" | "s")))
}

/// The code with which `stabline verify` would end, and why.
fn verdict(text: &str) -> (i32, String) {
    match verify(text.as_bytes()) {
        Ok(_) => (0, String::new()),
        Err(flaw) => (if flaw.0 == 1 { 3 } else { 5 }, flaw.to_string()),
    }
}

#[test]
fn the_seal_rejects_every_change() {
    let mut random = Random::new(setting("STABLINE_SEED", 1));
    let mut texts = Vec::new();
    for (name, text) in proofs() {
        let parts = Parts::of(text);
        for kind in Kind::ALL {
            let Some(lines) = mutated(&parts, kind, &mut random) else { continue };
            let changed = with_seal_of(&lines, text);
            let (code, why) = verdict(&changed);
            assert_ne!(code, 0, "{name}: {kind:?}");
            texts.push((code, why, changed));
        }
        for _ in 0..10 {
            let end = random.between(0, text.len() as i64 - 1) as usize;
            let is_rejected = text.is_char_boundary(end).then(|| verdict(&text[..end]).0 != 0);
            assert_ne!(is_rejected, Some(false), "{name}: truncated to {end} bytes");
        }
        assert_eq!(verdict(text).0, 0, "{name}");
        assert_eq!(verdict(&format!("{text}\n")).0, 5, "{name}: a line after the seal");
        texts.push((5, "a line after the seal".to_owned(), format!("{text}\n")));
    }
    agree(&texts);
}

#[test]
fn what_is_sealed_again_is_rejected_unless_true() {
    let proofs: Vec<_> = proofs().iter().map(|(name, text)| (name, Parts::of(text))).collect();
    let count = setting("STABLINE_MUTATIONS", 2000);
    let mut random = Random::new(setting("STABLINE_SEED", 1));
    let mut counts: BTreeMap<Kind, [usize; 2]> = BTreeMap::new();
    let mut texts = Vec::new();
    let mut tried = 0;
    while tried < count {
        let (name, parts) = &proofs[random.bits() as usize % proofs.len()];
        let kind = Kind::ALL[random.bits() as usize % Kind::ALL.len()];
        let Some(lines) = mutated(parts, kind, &mut random) else { continue };
        tried += 1;
        let text = sealed(&lines);
        let (code, why) = verdict(&text);
        counts.entry(kind).or_default()[usize::from(code != 0)] += 1;
        if code == 0 {
            let changed = Parts::of(&text);
            let new = lines.iter().filter(|line| !parts.lines.contains(line)).collect::<Vec<_>>();
            assert!(!kind.breaks(), "{name}: {kind:?} accepted: {new:?}");
            let argument = is_true(parts, &changed);
            assert_eq!(argument, Ok(()), "{name}: {kind:?} accepted: {new:?}");
        }
        texts.push((code, why, text));
    }
    println!("kind: accepted and true, rejected");
    counts.iter().for_each(|(kind, [accepted, rejected])| {
        println!("{kind:?}: {accepted}, {rejected}");
    });
    assert_eq!(counts.len(), Kind::ALL.len(), "every kind was tried");
    // The other checker sees a share of them.
    let share: Vec<_> = texts.into_iter().step_by(3).collect();
    agree(&share);
}

/// The checker in Python has the same verdicts.
fn agree(texts: &[(i32, String, String)]) {
    let folder = tempfile::tempdir().unwrap();
    let script = support::root().join("examples/verify.py");
    if Command::new("python3").arg("--version").output().is_err() {
        println!("skipped: there is no python3");
        return;
    }
    for (part, texts) in texts.chunks(2000).enumerate() {
        let names: Vec<String> = (0..texts.len()).map(|n| format!("{part}-{n}")).collect();
        for (name, (_, _, text)) in names.iter().zip(texts) {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let mut python = Command::new("python3");
        python.arg(&script).arg("--each").args(&names).current_dir(folder.path());
        let output = python.output().unwrap();
        let told = support::stdout(&output);
        assert_eq!(told.lines().count(), texts.len(), "{}", support::stderr(&output));
        for (line, (code, why, text)) in told.lines().zip(texts) {
            let is_same = line.starts_with(&format!("{code} "));
            assert!(is_same, "Python: {line}\nRust: {code} {why}\n{text}");
        }
    }
}

/// No proof here needs a split, so refutations are split by an edge that they may use: on its
/// negative side the edge refutes the sequence alone, on the other the refutation stays as it is.
#[test]
fn splits() {
    let mut texts = Vec::new();
    for (name, text) in proofs() {
        let parts = Parts::of(text);
        for node in parts.nodes().filter(|&node| is_refuted(&parts.lines[node])) {
            let fields: Vec<&str> = parts.lines[node].splitn(3, ' ').collect();
            let [head, refutation] = [fields[..2].join(" "), fields[2].to_owned()];
            let edge = parts.first_edge(node);
            let plane = edge.each_ref().map(ToString::to_string).join(" ");
            let moved = edge.each_ref().map(|c| (c + 1i32).to_string()).join(" ");
            let negative = "l 2 0.0 1 h0 1";
            let zero = "0 0 0 0 0 0";
            // Each split's second part follows those of the splits within it.
            let nested = |count: usize| {
                let second = (0..count).rev().map(|split| format!(" l 2 0.0 1 h{split} 1"));
                let first = format!("s {plane} ").repeat(count);
                format!("{first}{refutation}{}", second.collect::<String>())
            };
            for (holds, refutation) in [
                (true, nested(1)),
                (true, format!("s {plane} {refutation} {refutation}")),
                (true, format!("s {plane} s {zero} {refutation} {refutation} {negative}")),
                (true, format!("s {plane} {refutation} s {zero} {negative} {negative}")),
                (true, nested(64)),
                (false, nested(65)),
                (false, format!("s {plane} {negative} {refutation}")),
                (false, format!("s {plane} {refutation}")),
                (false, format!("s {plane} {refutation} {negative} {negative}")),
                (false, format!("s {moved} {refutation} {negative}")),
                (false, format!("s {plane} {refutation} l 2 0.0 1 h1 1")),
                (false, format!("s {plane} {refutation} l 1 h0 1")),
                (false, format!("s {zero} l 1 h0 1 l 1 h0 1")),
                (false, format!("s {zero} l 0 l 0")),
                (false, format!("s {zero} i 1 0 i 1 0")),
                (false, format!("{refutation} {negative}")),
            ] {
                let mut lines = parts.lines.clone();
                lines[node] = format!("{head} {refutation}");
                let text = sealed(&lines);
                let (code, why) = verdict(&text);
                assert_eq!(code, if holds { 0 } else { 5 }, "{name}: {why}: {refutation}");
                texts.push((code, why, text));
            }
        }
    }
    assert!(texts.len() > 200, "{}", texts.len());
    // Sixteen texts a node: all of them are among these.
    let share: Vec<_> = texts.into_iter().step_by(3).collect();
    agree(&share);
}

/// Every node with what is below it, and every portal of every cut, is needed.
#[test]
fn nothing_is_superfluous() {
    let (mut nodes, mut cuts) = (0, 0);
    for (name, text) in proofs() {
        let parts = Parts::of(text);
        for node in parts.nodes() {
            let mut lines = parts.lines.clone();
            lines.drain(parts.branch(node));
            assert_ne!(verdict(&sealed(&lines)).0, 0, "{name}: without {:?}", parts.lines[node]);
            nodes += 1;
            for at in cuts_of(&parts.lines[node]) {
                let mut lines = parts.lines.clone();
                lines[node] = without_field(&lines[node], at);
                let place = format!("{name}: {:?} without field {at}", parts.lines[node]);
                assert_ne!(verdict(&sealed(&lines)).0, 0, "{place}");
                cuts += 1;
            }
        }
    }
    println!("{nodes} nodes and {cuts} cut portals, all of them needed");
    assert!(nodes > 100 && cuts > 100, "{nodes} nodes, {cuts} cut portals");
}

#[test]
fn real_maps() {
    let Some(maps) = support::maps() else {
        println!("skipped: the shared maps are not here");
        return;
    };
    let bytes = std::fs::read(maps.join("lqdm1/lqdm1.prt")).unwrap();
    let text = proof(&scene::read_graph("lqdm1.prt", &bytes).unwrap(), false);
    let parts = Parts::of(&text);
    let mut random = Random::new(setting("STABLINE_SEED", 1));
    let count = setting("STABLINE_MUTATIONS", 2000) / 300;
    let mut share = Vec::new();
    while share.len() < count as usize {
        let kind = Kind::ALL[random.bits() as usize % Kind::ALL.len()];
        if !kind.breaks() {
            continue;
        }
        let Some(lines) = mutated(&parts, kind, &mut random) else { continue };
        let text = sealed(&lines);
        let (code, why) = verdict(&text);
        assert_ne!(code, 0, "{kind:?}");
        share.push((code, why, text));
    }
    agree(&share[..share.len().min(3)]);
}
