//! Needles, slivers and slits.

use super::{Family, PORTALS, Parameter, Settings};
use crate::forge::input::{Input, Point};
use crate::forge::shapes::{
    SQUARE, TRIANGLE, Vector, add, cross, lay_out, one_of, polygons, scale, sub, vector, whole,
};
use crate::num::{Int, Random, Rational};
use crate::vectors::Kind;

pub(super) const SLIVER: Family = Family {
    name: "sliver",
    kind: Kind::Sequence,
    purpose: "needles and slivers: triangles and parallelograms many times longer than wide",
    from_map: false,
    parameters: &[
        PORTALS,
        Parameter {
            name: "aspect",
            purpose: "how many times longer than wide",
            default: 1000,
            range: [2, 1_000_000_000],
        },
    ],
    make: sliver,
};

pub(super) const SLIT: Family = Family {
    name: "slit",
    kind: Kind::Sequence,
    purpose: "walls one behind the other, each with a slit of width 10^-1 to 10^-20, placed so \
              that lines pass all, graze the ends, or miss by less than a width",
    from_map: false,
    parameters: &[
        PORTALS,
        Parameter {
            name: "digits",
            purpose: "the width is 10 to minus this; 0 takes any from 1 to 20",
            default: 0,
            range: [0, 60],
        },
    ],
    make: slit,
};

fn sliver(random: &mut Random, settings: &Settings) -> Input {
    let (most, aspect) = (settings.get("portals"), settings.get("aspect"));
    let count = random.between(most.min(2), most);
    let mut portals: Vec<Vec<Vector>> = Vec::new();
    for index in 0..count {
        let [long, wide] = loop {
            let long = add(scale(vector(random, 1), aspect), vector(random, 2));
            let wide = vector(random, 2);
            if cross(long, wide)[1] != 0 {
                break [long, wide];
            }
        };
        // Slivers that cross each other near the axis.
        let middle = add(vector(random, 4), [0, (aspect / 2 + 1) * index, 0]);
        let along = random.between(0, 2);
        let origin = sub(middle, long.map(|c| c * along / 2));
        let corners: &[[i64; 2]] = if random.one_in(2) { &SQUARE } else { &TRIANGLE };
        portals.push(lay_out([origin, long, wide], corners, [0, 1, 0]));
    }
    Input::Sequence(polygons(&portals))
}

/// Walls across the y axis with slits along x or z, whose ends lie on lines through one point, and
/// some of them a part of a width beside.
fn slit(random: &mut Random, settings: &Settings) -> Input {
    let most = settings.get("portals");
    let count = random.between(most.min(3), most);
    let digits = match settings.get("digits") {
        0 => random.between(1, 20),
        digits => digits,
    };
    let width = Rational::new(Int::from(1), Int::from(10).pow(digits as u32));
    let slope = [(); 2].map(|()| whole(random.between(-2, 2)));
    let same_axis = random.one_in(3);
    let portals = (0..count).map(|index| {
        let y = whole(index * random.between(1, 3) + index);
        let axis = if same_axis { 0 } else { random.between(0, 1) as usize };
        // In widths: how far the slit lies beside the line through (0, 0, 0) with that slope.
        let offset = Rational::new(
            Int::from(one_of(random, &[-4, -3, -2, -2, -1, -1, 0, 0, 1])),
            Int::from(2),
        );
        let across_low = &slope[axis] * &y + &offset * &width;
        let along_low = &slope[1 - axis] * &y - whole(random.between(0, 2));
        let across = [across_low.clone(), &across_low + &width];
        let along = [along_low.clone(), along_low + whole(random.between(1, 2))];
        let [x, z] = if axis == 0 { [across, along] } else { [along, across] };
        // Seen from where the line goes, counter-clockwise: the normal is along y.
        let corner = |i: usize, k: usize| -> Point { vec![x[i].clone(), y.clone(), z[k].clone()] };
        vec![corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)]
    });
    Input::Sequence(portals.collect())
}
