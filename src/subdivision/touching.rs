//! Which of many boxes a box touches: a binary tree of boxes around boxes.
//!
//! The boxes are halved at the median of their low corners along the axis on which these are
//! spread most, until few are left. A query visits the branches whose box it touches: O(log n + k)
//! for k hits in a building, where boxes are small beside the whole; building takes O(n log² n).

use crate::construct::IntegerBox;

/// Few enough to try one by one.
const FEW: usize = 4;

/// Boxes in a tree.
pub(super) struct Boxes<'a> {
    boxes: Vec<&'a IntegerBox>,
    root: Option<Branch>,
}

struct Branch {
    around: IntegerBox,
    below: Below,
}

enum Below {
    Few(Vec<usize>),
    Two(Box<[Branch; 2]>),
}

impl<'a> Boxes<'a> {
    pub(super) fn new(boxes: impl Iterator<Item = &'a IntegerBox>) -> Boxes<'a> {
        let boxes: Vec<&IntegerBox> = boxes.collect();
        let mut all: Vec<usize> = (0..boxes.len()).collect();
        let root = (!all.is_empty()).then(|| branch(&boxes, &mut all));
        Boxes { boxes, root }
    }

    /// The boxes that have a point in common with this one, ascending.
    pub(super) fn touching(&self, query: &IntegerBox) -> Vec<usize> {
        let mut found = Vec::new();
        let mut stack: Vec<&Branch> = self.root.iter().collect();
        while let Some(branch) = stack.pop() {
            if !branch.around.touches(query) {
                continue;
            }
            match &branch.below {
                Below::Few(few) => {
                    found.extend(few.iter().filter(|&&i| self.boxes[i].touches(query)));
                }
                Below::Two(both) => stack.extend(both.iter()),
            }
        }
        found.sort_unstable();
        found
    }
}

/// The branch of one or more boxes. The depth of the recursion is the logarithm of their number.
fn branch(boxes: &[&IntegerBox], members: &mut [usize]) -> Branch {
    let extreme = |i: usize| {
        let low = members.iter().map(|&b| &boxes[b].low[i]).min().expect("there is a box");
        let high = members.iter().map(|&b| &boxes[b].high[i]).max().expect("there is a box");
        let last = members.iter().map(|&b| &boxes[b].low[i]).max().expect("there is a box");
        (low.clone(), high.clone(), last - low)
    };
    let [x, y, z] = [0, 1, 2].map(extreme);
    let axis = if x.2 >= y.2 && x.2 >= z.2 { 0 } else { 1 + usize::from(z.2 > y.2) };
    let around = IntegerBox { low: [x.0, y.0, z.0], high: [x.1, y.1, z.1] };
    if members.len() <= FEW {
        return Branch { around, below: Below::Few(members.to_vec()) };
    }
    members.sort_unstable_by_key(|&b| (&boxes[b].low[axis], b));
    let (first, second) = members.split_at_mut(members.len() / 2);
    let both = [branch(boxes, first), branch(boxes, second)];
    Branch { around, below: Below::Two(Box::new(both)) }
}
