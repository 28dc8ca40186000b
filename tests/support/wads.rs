//! Small Doom levels: their geometry by lines, and their bytes in each form.

use stabline::formats::wad::{DoomMap, MapForm, RejectTable};
use stabline::num::{Int, Number};
use stabline::portal::doom::DoomAreas;
use stabline::portal::plan::{PlanCells, cells_of_plan};
use stabline::predicates::PlanPoint;
use stabline::report::Silent;
use stabline::scene::plan::{DoomPlan, plan_of_map};
use stabline::subdivision::plan::{PlanMethod, divide};
use std::path::PathBuf;

/// A map, built line by line.
#[derive(Clone, Debug, Default)]
pub struct Level {
    pub vertices: Vec<[i16; 2]>,
    pub lines: Vec<Line>,
    /// The sector of each sidedef.
    pub sides: Vec<u16>,
    pub sectors: u16,
    pub reject: Option<Vec<u8>>,
}

/// A linedef.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    pub start: u16,
    pub end: u16,
    pub flags: u16,
    pub front: Option<u16>,
    pub back: Option<u16>,
}

impl Level {
    /// Adds a line with the sectors on its right and on its left.
    pub fn line(&mut self, start: [i16; 2], end: [i16; 2], front: Option<u16>, back: Option<u16>) {
        let (start, end) = (self.vertex(start), self.vertex(end));
        let flags = if back.is_some() { 4 } else { 1 };
        let (front, back) = (front.map(|s| self.side(s)), back.map(|s| self.side(s)));
        self.lines.push(Line { start, end, flags, front, back });
    }

    /// Adds the lines from each point to the next, all with the same sectors.
    pub fn path(&mut self, points: &[[i16; 2]], front: u16, back: Option<u16>) {
        for pair in points.windows(2) {
            self.line(pair[0], pair[1], Some(front), back);
        }
    }

    fn vertex(&mut self, at: [i16; 2]) -> u16 {
        let known = self.vertices.iter().position(|&vertex| vertex == at);
        known.unwrap_or_else(|| {
            self.vertices.push(at);
            self.vertices.len() - 1
        }) as u16
    }

    fn side(&mut self, sector: u16) -> u16 {
        self.sectors = self.sectors.max(sector + 1);
        self.sides.push(sector);
        self.sides.len() as u16 - 1
    }

    /// The map's lumps behind its marker.
    pub fn lumps(&self, form: MapForm) -> Vec<(&'static str, Vec<u8>)> {
        let reject = self.reject.iter().map(|bytes| ("REJECT", bytes.clone()));
        if form == MapForm::Udmf {
            let text = [("TEXTMAP", self.text().into_bytes())];
            return text.into_iter().chain(reject).chain([("ENDMAP", Vec::new())]).collect();
        }
        let record = |fields: &[u16], length: usize| {
            let mut bytes: Vec<u8> = fields.iter().flat_map(|field| field.to_le_bytes()).collect();
            bytes.resize(length, 0);
            bytes
        };
        let none = |side: Option<u16>| side.unwrap_or(0xffff);
        let line = |line: &Line| {
            let middle = vec![0u16; if form == MapForm::Hexen { 3 } else { 2 }];
            let start = [line.start, line.end, line.flags];
            let end = [none(line.front), none(line.back)];
            let fields = [&start[..], &middle, &end].concat();
            record(&fields, 2 * fields.len())
        };
        let side = |&sector: &u16| [vec![0; 28], sector.to_le_bytes().to_vec()].concat();
        let vertex = |&[x, y]: &[i16; 2]| record(&[x as u16, y as u16], 4);
        let behavior = (form == MapForm::Hexen).then(|| ("BEHAVIOR", b"ACS\0".to_vec()));
        [
            ("THINGS", Vec::new()),
            ("LINEDEFS", self.lines.iter().flat_map(line).collect()),
            ("SIDEDEFS", self.sides.iter().flat_map(side).collect()),
            ("VERTEXES", self.vertices.iter().flat_map(vertex).collect()),
            ("SECTORS", vec![0; 26 * usize::from(self.sectors)]),
        ]
        .into_iter()
        .chain(reject)
        .chain(behavior)
        .collect()
    }

    fn text(&self) -> String {
        let mut text = "namespace = \"doom\"; // a text\nthing { x = 1.5; type = 1; }\n".to_owned();
        for [x, y] in &self.vertices {
            text += &format!("vertex {{ x = {x}.0; Y = {y}.000; }}\n");
        }
        for Line { start, end, flags, front, back } in &self.lines {
            text += &format!("linedef\n{{\nv1 = {start}; v2 = {end};");
            for (field, side) in [("sidefront", front), ("sideback", back)] {
                if let Some(side) = side {
                    text += &format!(" {field} = {side};");
                }
            }
            text +=
                if flags & 4 != 0 { " twosided = true;\n}\n" } else { " blocking = true;\n}\n" };
        }
        for sector in &self.sides {
            text += &format!("sidedef {{ sector = {sector}; texturemiddle = \"A\\\"{{\"; }}\n");
        }
        text + &"sector /* flat */ { heightceiling = 128; }\n".repeat(self.sectors.into())
    }

    /// An archive with this map alone.
    pub fn archive(&self, name: &str, form: MapForm) -> Vec<u8> {
        let mut lumps = vec![(name, Vec::new())];
        lumps.extend(self.lumps(form));
        archive(&lumps)
    }
}

/// An archive of lumps, the directory behind them.
pub fn archive(lumps: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut bytes = [&b"PWAD"[..], &(lumps.len() as u32).to_le_bytes(), &[0; 4]].concat();
    let mut directory = Vec::new();
    for (name, content) in lumps {
        for number in [bytes.len(), content.len()] {
            directory.extend_from_slice(&(number as u32).to_le_bytes());
        }
        let mut padded = name.as_bytes().to_vec();
        padded.resize(8, 0);
        directory.extend_from_slice(&padded);
        bytes.extend_from_slice(content);
    }
    let place = (bytes.len() as u32).to_le_bytes();
    bytes[8..12].copy_from_slice(&place);
    bytes.extend_from_slice(&directory);
    bytes
}

/// Two rooms of 128 by 128 side by side, sectors 0 and 1, with an open line between them.
pub fn two_rooms() -> Level {
    let mut level = Level::default();
    level.path(&[[128, 0], [0, 0], [0, 128], [128, 128]], 0, None);
    level.path(&[[128, 128], [256, 128], [256, 0], [128, 0]], 1, None);
    level.line([128, 128], [128, 0], Some(0), Some(1));
    level.reject = Some(vec![0b0110]);
    level
}

/// A map as a plan, divided, and the sectors of its leaves.
pub fn divided(map: &DoomMap) -> (DoomPlan, PlanCells, DoomAreas) {
    let doom = plan_of_map(map).unwrap();
    let tree = divide(&doom.plan, &PlanMethod::default(), &Silent).unwrap();
    let cells = cells_of_plan(&doom.plan, tree, false).unwrap();
    let areas = DoomAreas::of(&doom, &cells);
    (doom, cells, areas)
}

/// The point with half of these coordinates.
pub fn half_point([x, y]: [i64; 2]) -> PlanPoint {
    PlanPoint::new([Int::from(x), Int::from(y), Int::from(2)])
}

/// The sector that the first line to the right of a point faces it with, by brute force: `None`
/// for the void or nothing at all. The coordinates are halves, odd, and those of the map whole.
pub fn faced(map: &DoomMap, doom: &DoomPlan, [x, y]: [i64; 2]) -> Option<u32> {
    let doubled = |vertex: u32| {
        map.vertices[vertex as usize].each_ref().map(|number| match number {
            Number::Small(c, 1) => i128::from(2 * c),
            other => panic!("{other:?} is not whole"),
        })
    };
    let (x, y) = (i128::from(x), i128::from(y));
    // How far to the right each line is met, as a ratio with a positive denominator.
    let hits = map.linedefs.iter().zip(&doom.lines).filter_map(|(line, sides)| {
        let ([x0, y0], [x1, y1]) = (doubled(line.start), doubled(line.end));
        if (y0 < y) == (y1 < y) {
            return None;
        }
        let ahead = (x1 - x0) * (y - y0) - (x - x0) * (y1 - y0);
        // A line that goes up has its front on the right, and the point left of it.
        let (distance, side) = if y0 < y1 { (ahead, sides.back) } else { (-ahead, sides.front) };
        (distance > 0).then_some(([distance, (y1 - y0).abs()], side))
    });
    let nearer = |[p, q]: &[i128; 2], [r, s]: &[i128; 2]| (p * s).cmp(&(r * q));
    hits.min_by(|(one, _), (other, _)| nearer(one, other)).and_then(|(_, side)| side)
}

/// The two archives of Freedoom, where they are installed: in the folder that `STABLINE_FREEDOOM`
/// names, else where the Debian package puts them.
pub fn freedoom() -> Option<[Vec<u8>; 2]> {
    let named = std::env::var_os("STABLINE_FREEDOOM").map(PathBuf::from);
    let folder = named.unwrap_or_else(|| PathBuf::from("/usr/share/games/doom"));
    let read = |name: &str| std::fs::read(folder.join(name)).ok();
    match (read("freedoom1.wad"), read("freedoom2.wad")) {
        (Some(first), Some(second)) => Some([first, second]),
        _ => {
            eprintln!("skipped: no freedoom1.wad and freedoom2.wad in {}", folder.display());
            None
        }
    }
}

/// Four rooms in a row, sectors 0 to 3, whose doors are low, high and low: the first and the last
/// see each other's neighbours and not each other. The REJECT table lacks the pair of 0 and 2, and
/// has that of 0 and 3.
pub fn four_rooms() -> Level {
    let mut level = Level::default();
    let walls = [(0, [0, 0]), (128, [0, 16]), (256, [112, 128]), (384, [0, 16]), (512, [0, 0])];
    for (room, pair) in walls.windows(2).enumerate() {
        let (room, [(x0, west), (x1, east)]) = (room as u16, [pair[0], pair[1]]);
        level.path(&[[x0, 128], [x1, 128]], room, None);
        level.path(&[[x1, 0], [x0, 0]], room, None);
        for (from, to) in [(0, west[0]), (west[1], 128)].into_iter().filter(|(y0, y1)| y0 < y1) {
            level.path(&[[x0, from], [x0, to]], room, None);
        }
        for (from, to) in [(128, east[1]), (east[0], 0)].into_iter().filter(|(y0, y1)| y0 > y1) {
            level.path(&[[x1, from], [x1, to]], room, None);
        }
        if room < 3 {
            level.line([x1, east[1]], [x1, east[0]], Some(room), Some(room + 1));
        }
    }
    let mut table = RejectTable::new(4);
    for (from, to) in [(0, 2), (1, 3)] {
        table.reject(from, to);
        table.reject(to, from);
    }
    level.reject = Some(table.bytes().to_vec());
    level
}
