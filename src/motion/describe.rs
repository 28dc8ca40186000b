//! A walk as a report: places for obstacles, names for cells.

use super::{Hit, Move, Obstacle, Stay, Touch, Walk};
use crate::geom::RationalPoint3;
use crate::num::Rational;
use crate::report::{EyeRatio, InputId, MoveBox, MoveHit, MoveReport, MoveStay};
use crate::scene::World;
use crate::scene::world::Place;

impl Obstacle {
    /// Where a world states it; the boundary is stated nowhere.
    pub fn place(self, world: &World) -> Option<&Place> {
        match self {
            Obstacle::Solid(index) => Some(&world.solids[index].place),
            Obstacle::Polygon(index) => Some(&world.polygons[index].place),
            Obstacle::Bounds => None,
        }
    }
}

impl Walk {
    /// The report of a move in a world, whose cells have these names.
    pub fn report(
        &self,
        motion: &Move,
        world: &World,
        cells: &[String],
        input: InputId,
    ) -> MoveReport {
        let mut report = MoveReport::new(input, point(&motion.from), point(&motion.to));
        report.body = motion
            .body
            .as_ref()
            .map(|body| MoveBox { low: numbers(&body.low), high: numbers(&body.high) });
        report.contact = !self.hits.is_empty();
        report.time = (&self.time).into();
        report.point = point(&self.point);
        report.hits = self.hits.iter().map(|hit| hit.described(world)).collect();
        let stay = |stay: &Stay| MoveStay {
            cell: cells[stay.cell.0 as usize].clone(),
            enter: (&stay.enter).into(),
            leave: (&stay.leave).into(),
        };
        report.cells = self.stays.iter().map(stay).collect();
        report
    }
}

impl Hit {
    fn described(&self, world: &World) -> MoveHit {
        let (kind, index) = match self.obstacle {
            Obstacle::Solid(index) => ("solid", Some(index as u64)),
            Obstacle::Polygon(index) => ("polygon", Some(index as u64)),
            Obstacle::Bounds => ("bounds", None),
        };
        let place = self.obstacle.place(world);
        let touch = match self.touch {
            Touch::Face => "face",
            Touch::BoxFace => "box-face",
            Touch::Edges => "edges",
        };
        MoveHit {
            kind: kind.to_owned(),
            index,
            name: place.map(|place| place.name.clone()),
            line: place.and_then(|place| place.line).map(|line| line as u64),
            normal: self.normal.each_ref().map(Into::into),
            offset: (&self.offset).into(),
            touch: touch.to_owned(),
        }
    }
}

fn point(point: &RationalPoint3) -> [EyeRatio; 3] {
    numbers(&point.coordinates())
}

fn numbers(numbers: &[Rational; 3]) -> [EyeRatio; 3] {
    numbers.each_ref().map(Into::into)
}
