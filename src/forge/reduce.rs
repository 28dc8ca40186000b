//! Shrinking an input for as long as something holds of it.
//!
//! First parts go: portals or occluders by delta debugging (Zeller and Hildebrandt 2002), cells by
//! joining two, vertices one by one. Then numbers: to whole ones, to the origin, without a common
//! factor; all coordinates of one value along an axis to zero, to a half, by one; then each by
//! itself. All of it again until nothing helps. A candidate counts only if it is valid and of less
//! measure: parts, cells, vertices, digits, magnitude, in this order; so it ends. Deterministic.
//!
//! Complexity: the number of tests is about quadratic in the parts and linear in the digits.

use super::input::{Graph, Input};
use super::own::accepts;
use crate::num::{Int, Rational};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// What is asked of the smaller inputs.
pub trait Trial {
    /// Whether what is looked for still holds of it.
    fn holds(&mut self, input: &Input) -> bool;
    /// Whether to end, with the best so far.
    fn is_interrupted(&self) -> bool;
    /// A smaller input was found.
    fn found(&mut self, _: &Input) {}
}

/// The smallest input found of which the trial holds, as it does of this one.
pub fn reduce(input: &Input, trial: &mut dyn Trial) -> Input {
    let mut work = Work { best: input.clone(), trial };
    loop {
        let before = work.best.clone();
        work.parts();
        work.cells();
        work.vertices();
        work.whole_numbers();
        work.values();
        work.coordinates();
        if work.best == before || work.trial.is_interrupted() {
            return work.best;
        }
    }
}

/// What gets less: parts, cells, vertices, digits, and the sum of all magnitudes.
pub type Measure = (usize, usize, usize, u64, Rational);

/// How large an input is.
pub fn measure(input: &Input) -> Measure {
    let polygons = input.polygons();
    let cells = match input {
        Input::Graph(graph) => graph.cells,
        Input::Sequence(_) | Input::Lines(_) | Input::Scene(_) => 0,
    };
    let vertices = polygons.iter().map(|polygon| polygon.len()).sum();
    let coordinates = || polygons.iter().copied().flatten().flatten();
    let digits = coordinates().map(|c| c.numer().bits() + c.denom().bits() - 1).sum();
    let sum = coordinates().map(Signed::abs).sum();
    (polygons.len(), cells, vertices, digits, sum)
}

struct Work<'a> {
    best: Input,
    trial: &'a mut dyn Trial,
}

impl Work<'_> {
    /// Takes the candidate over if it is less and what is looked for holds of it.
    fn try_it(&mut self, candidate: Input) -> bool {
        let is_less = measure(&candidate) < measure(&self.best);
        if !is_less || self.trial.is_interrupted() || !accepts(&candidate) {
            return false;
        }
        let holds = self.trial.holds(&candidate);
        if holds {
            self.trial.found(&candidate);
            self.best = candidate;
        }
        holds
    }

    /// Runs of parts, long ones first.
    fn parts(&mut self) {
        let mut size = part_count(&self.best).div_ceil(2);
        while size > 0 {
            let mut start = 0;
            while start < part_count(&self.best) {
                let smaller = without_parts(&self.best, start, size);
                if !smaller.is_some_and(|smaller| self.try_it(smaller)) {
                    start += size;
                }
            }
            size /= 2;
        }
    }

    /// Cells without portals, and two cells as one.
    fn cells(&mut self) {
        while let Input::Graph(graph) = &self.best {
            let mut smaller = vec![without_unused_cells(graph)];
            smaller.extend((0..graph.doors.len()).filter_map(|door| joined(graph, door)));
            if !smaller.into_iter().any(|graph| self.try_it(Input::Graph(graph))) {
                return;
            }
        }
    }

    fn vertices(&mut self) {
        for polygon in 0..self.best.polygons().len() {
            let mut vertex = 0;
            while vertex < self.best.polygons()[polygon].len() {
                let mut smaller = self.best.clone();
                smaller.polygons_mut()[polygon].remove(vertex);
                if !self.try_it(smaller) {
                    vertex += 1;
                }
            }
        }
    }

    /// All coordinates at once: whole, from the origin on, without a common factor.
    fn whole_numbers(&mut self) {
        let coordinates = self.best.polygons().into_iter().flatten().flatten();
        let common = coordinates.fold(Int::one(), |common, c| common.lcm(c.denom()));
        let whole = self.best.mapped(|p| p.iter().map(|c| c * &common).collect());
        self.try_it(whole);
        let dimension = self.best.dimension();
        for axis in 0..dimension {
            let along = self.best.polygons().into_iter().flatten().map(|p| p[axis].clone());
            let Some(least) = along.min() else { return };
            let moved = self.best.mapped(|p| {
                let mut p = p.clone();
                p[axis] -= &least;
                p
            });
            self.try_it(moved);
        }
        let coordinates = self.best.polygons().into_iter().flatten().flatten();
        let factor = coordinates.fold(Int::zero(), |factor, c| factor.gcd(c.numer()));
        if !factor.is_zero() {
            self.try_it(self.best.mapped(|p| p.iter().map(|c| c / &factor).collect()));
        }
        for divisor in [1024, 10, 2] {
            let divisor = Rational::from(Int::from(divisor));
            let divided = |input: &Input| {
                input.mapped(|p| p.iter().map(|c| (c / &divisor).round()).collect())
            };
            while self.try_it(divided(&self.best)) {}
        }
    }

    /// All coordinates of one value along an axis together: faces across the axis stay so.
    fn values(&mut self) {
        for axis in 0..self.best.dimension() {
            let along = self.best.polygons().into_iter().flatten().map(|p| p[axis].clone());
            let mut values: Vec<Rational> = along.collect();
            values.sort_unstable();
            values.dedup();
            for value in values {
                let mut value = value;
                while let Some(less) = less_than(&value).into_iter().find(|less| {
                    let moved = self.best.mapped(|p| {
                        let mut p = p.clone();
                        if p[axis] == value {
                            p[axis] = less.clone();
                        }
                        p
                    });
                    self.try_it(moved)
                }) {
                    value = less;
                }
            }
        }
    }

    /// Each coordinate by itself.
    fn coordinates(&mut self) {
        for polygon in 0..self.best.polygons().len() {
            for vertex in 0..self.best.polygons()[polygon].len() {
                for axis in 0..self.best.dimension() {
                    while let Some(value) = coordinate(&self.best, [polygon, vertex, axis]) {
                        let smaller = less_than(&value).into_iter().map(|less| {
                            let mut smaller = self.best.clone();
                            smaller.polygons_mut()[polygon][vertex][axis] = less;
                            smaller
                        });
                        let smaller: Vec<Input> = smaller.collect();
                        if !smaller.into_iter().any(|smaller| self.try_it(smaller)) {
                            break;
                        }
                    }
                }
            }
        }
    }
}

fn coordinate(input: &Input, [polygon, vertex, axis]: [usize; 3]) -> Option<Rational> {
    input.polygons().get(polygon)?.get(vertex)?.get(axis).cloned()
}

/// Numbers that are less, the least first: zero, rounded, a half, one nearer to zero.
fn less_than(value: &Rational) -> Vec<Rational> {
    if value.is_zero() {
        return Vec::new();
    }
    let half = (value / Rational::from(Int::from(2))).trunc();
    let mut less = vec![Rational::zero(), half, value.trunc()];
    if value.is_integer() {
        less.push(value - value.signum());
    }
    less.dedup();
    less.retain(|less| less != value);
    less
}

/// How many parts may be taken away.
fn part_count(input: &Input) -> usize {
    match input {
        Input::Sequence(polygons) => polygons.len(),
        Input::Lines(_) => 0,
        Input::Graph(graph) => graph.doors.len(),
        Input::Scene(scene) => scene.polygons.len() + scene.brushes.len(),
    }
}

fn without_parts(input: &Input, start: usize, size: usize) -> Option<Input> {
    let mut input = input.clone();
    let gone = |index: usize| (start..start + size).contains(&index);
    fn keep<T>(list: &mut Vec<T>, first: usize, gone: impl Fn(usize) -> bool) {
        let mut index = first;
        list.retain(|_| {
            index += 1;
            !gone(index - 1)
        });
    }
    match &mut input {
        Input::Sequence(polygons) => {
            keep(polygons, 0, gone);
            if polygons.is_empty() {
                return None;
            }
        }
        Input::Lines(_) => return None,
        Input::Graph(graph) => keep(&mut graph.doors, 0, gone),
        Input::Scene(scene) => {
            let first = scene.polygons.len();
            keep(&mut scene.polygons, 0, gone);
            keep(&mut scene.brushes, first, gone);
        }
    }
    Some(input)
}

/// The cells that a portal joins or that are asked about, by new numbers.
fn without_unused_cells(graph: &Graph) -> Graph {
    let mut used = vec![false; graph.cells];
    used[graph.from] = true;
    used[graph.to] = true;
    for cell in graph.doors.iter().flat_map(|door| door.cells) {
        used[cell] = true;
    }
    let number = |cell: usize| used[..cell].iter().filter(|used| **used).count();
    let mut smaller = graph.clone();
    smaller.cells = number(graph.cells);
    for door in &mut smaller.doors {
        door.cells = door.cells.map(number);
    }
    (smaller.from, smaller.to) = (number(graph.from), number(graph.to));
    smaller
}

/// The two cells of a portal as one, without the portals between them; not the two asked about.
fn joined(graph: &Graph, door: usize) -> Option<Graph> {
    let [kept, gone] = graph.doors[door].cells;
    let ends = [graph.from, graph.to];
    if ends.contains(&kept) && ends.contains(&gone) {
        return None;
    }
    let number = |cell: usize| if cell == gone { kept } else { cell };
    let mut smaller = graph.clone();
    for door in &mut smaller.doors {
        door.cells = door.cells.map(number);
    }
    smaller.doors.retain(|door| door.cells[0] != door.cells[1]);
    (smaller.from, smaller.to) = (number(graph.from), number(graph.to));
    Some(without_unused_cells(&smaller))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forge::shapes::polygon;
    use crate::forge::{Family, find};
    use crate::vectors::{Answer, Class};

    struct While<F>(F, usize);

    impl<F: Fn(&Input) -> bool> Trial for While<F> {
        fn holds(&mut self, input: &Input) -> bool {
            self.1 += 1;
            (self.0)(input)
        }

        fn is_interrupted(&self) -> bool {
            false
        }
    }

    #[test]
    fn what_need_not_be_there_goes() {
        // As long as some polygon has an x of 5 or more.
        let square = |x: i64| polygon(&[[x, 0, 0], [x, 0, 9], [x, 9, 9], [x, 9, 0]]);
        let input = Input::Sequence(vec![square(1), square(7), square(3), square(2)]);
        let has_five = |input: &Input| {
            let five = Rational::from(Int::from(5));
            input.polygons().into_iter().flatten().any(|p| p[0] >= five)
        };
        let smallest = reduce(&input, &mut While(has_five, 0));
        let Input::Sequence(polygons) = &smallest else { panic!("a sequence") };
        assert_eq!(polygons.len(), 1);
        assert_eq!(polygons[0].len(), 3);
        assert_eq!(polygons[0].iter().map(|p| &p[0]).max(), Some(&Rational::from(Int::from(5))));
    }

    #[test]
    fn what_is_looked_for_holds_and_the_same_comes_out_again() {
        for name in ["coplanar", "slit", "gates", "rooms", "plan"] {
            let family = Family::named(name).unwrap();
            let is_grazing = |input: &Input| {
                find(input).is_ok_and(|found| found.answer == Answer::Class(Class::Grazing))
            };
            let settings = family.settings(&[], None).unwrap();
            let inputs = (0..60).map(|number| family.input(&settings, 5, number));
            let input = inputs.into_iter().find(is_grazing).unwrap();
            let mut trial = While(is_grazing, 0);
            let smallest = reduce(&input, &mut trial);
            assert!(is_grazing(&smallest) && accepts(&smallest), "{name}");
            assert!(measure(&smallest) < measure(&input), "{name}");
            assert_eq!(reduce(&input, &mut While(is_grazing, 0)), smallest, "{name}");
            let mut again = While(is_grazing, 0);
            assert_eq!(reduce(&smallest, &mut again), smallest, "{name}");
        }
    }
}
