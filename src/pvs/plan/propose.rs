//! Proposals in floats of where a line may pass a sequence's first and last portal.
//!
//! A line from a given point of the first portal passes the portals between if it meets the last
//! one within an interval: each end of a portal is a bound on one side. Among the simple points of
//! the first portal, one with an interval that has room is taken; else the point with the widest
//! one is searched for. Nothing is decided here: who asks checks each proposal exactly.
//! O(k) for each point of the first portal that is tried, for k portals.

/// The point p/q of the way from the left end of a portal to the right one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part(pub(super) i64, pub(super) i64);

impl Part {
    fn float(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }
}

/// A portal's left and right end.
type Gate = [[f64; 2]; 2];

/// The points that are tried first, in this order.
const SIMPLE: [Part; 7] =
    [Part(1, 2), Part(1, 3), Part(2, 3), Part(1, 4), Part(3, 4), Part(1, 8), Part(7, 8)];

/// How often the range of points of the first portal is narrowed, to two thirds each time.
const NARROWINGS: usize = 48;

/// The finest parts are multiples of 2^-40.
const FINEST: u32 = 40;

/// Pairs of points, of the first and of the last portal, whose line may pass all; the simplest
/// first. Requires two portals or more.
pub(super) fn parts(gates: &[Gate]) -> impl Iterator<Item = [Part; 2]> + '_ {
    let simple = SIMPLE.into_iter().flat_map(move |start| {
        let room = room(gates, start.float());
        SIMPLE.into_iter().filter(move |end| room.holds(end.float())).map(move |end| [start, end])
    });
    let finer = SIMPLE.into_iter().filter_map(move |start| {
        let end = room(gates, start.float()).middle()?;
        Some([start, end])
    });
    simple.chain(finer).chain(std::iter::once_with(move || widest(gates)).flatten())
}

/// An interval of points of the last portal.
#[derive(Clone, Copy)]
struct Room {
    low: f64,
    high: f64,
}

impl Room {
    fn holds(&self, part: f64) -> bool {
        self.low < part && part < self.high
    }

    /// The coarsest part in the middle half.
    fn middle(&self) -> Option<Part> {
        let quarter = (self.high - self.low) / 4.0;
        let inner = Room { low: self.low + quarter, high: self.high - quarter };
        let rounded = |bits: u32| {
            let denominator = 1i64 << bits;
            let numerator = ((inner.low + inner.high) / 2.0 * denominator as f64).round();
            Part(numerator as i64, denominator)
        };
        (1..=FINEST).map(rounded).find(|part| inner.holds(part.float()))
    }
}

/// Where lines from a point of the first portal may meet the last one.
fn room(gates: &[Gate], start: f64) -> Room {
    let mut room = Room { low: 0.0, high: 1.0 };
    let [Some(&[l, r]), Some(&[last_l, last_r])] = [gates.first(), gates.last()] else {
        return room;
    };
    let from = [l[0] + start * (r[0] - l[0]), l[1] + start * (r[1] - l[1])];
    let along = minus(last_r, last_l);
    let to_left = minus(last_l, from);
    for gate in &gates[1..gates.len() - 1] {
        for (end, is_left) in gate.iter().zip([true, false]) {
            let ahead = minus(*end, from);
            // The end's side of the line to part t is a + t b: positive for the left end.
            let (a, b) = (cross(to_left, ahead), cross(along, ahead));
            let (a, b) = if is_left { (a, b) } else { (-a, -b) };
            if b > 0.0 {
                room.low = room.low.max(-a / b);
            } else if b < 0.0 {
                room.high = room.high.min(-a / b);
            } else if a <= 0.0 {
                room.high = f64::NEG_INFINITY;
            }
        }
    }
    room
}

/// The pair with the most room at the last portal, by narrowing.
fn widest(gates: &[Gate]) -> Option<[Part; 2]> {
    let width = |start: f64| {
        let room = room(gates, start);
        room.high - room.low
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..NARROWINGS {
        let third = (high - low) / 3.0;
        if width(low + third) < width(high - third) {
            low += third;
        } else {
            high -= third;
        }
        let middle = (low + high) / 2.0;
        // Room at all is enough, and the coarser the point the better.
        if width(middle) > 0.0
            && let Some(start) = (Room { low, high }).middle()
            && let Some(end) = room(gates, start.float()).middle()
        {
            return Some([start, end]);
        }
    }
    None
}

fn minus([px, py]: [f64; 2], [qx, qy]: [f64; 2]) -> [f64; 2] {
    [px - qx, py - qy]
}

fn cross([px, py]: [f64; 2], [qx, qy]: [f64; 2]) -> f64 {
    px * qy - py * qx
}
