//! How an axial face lies to a cell of the k-D tree (Teller and Séquin 1991, §2.3).

/// An axial face.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AxialFace<T> {
    /// The dimension in which it has one abscissa: 0 for a vertical face, 1 for a horizontal one.
    pub dimension: usize,
    /// Its abscissa.
    pub at: T,
    /// Its ends in the other dimension, the lesser first.
    pub span: [T; 2],
}

/// The extents of a cell: in each dimension from the first bound, which is included, to the second,
/// which is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extents<T>(pub [[T; 2]; 2]);

/// How a face lies to a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceClass {
    /// It meets neither the cell's inside nor the inside of one of its edges, or that only in a
    /// point: it lies outside, or touches from there.
    Disjoint,
    /// It divides the cell's inside in two.
    Spanning,
    /// It lies on the cell's boundary, along some of an edge.
    Covering,
    /// It meets the inside and does not divide it.
    Incident,
}

/// How a face lies to a cell. Only the order of coordinates is asked for.
///
/// The paper calls incident what is nothing else, and a cell's inside empty where no face is
/// incident; so a face that comes from outside and ends on the boundary, or on a corner, is
/// disjoint here.
pub fn classify<T: Ord>(face: &AxialFace<T>, cell: &Extents<T>) -> FaceClass {
    let [least, most] = &cell.0[face.dimension];
    let [low, high] = &cell.0[1 - face.dimension];
    let [start, end] = &face.span;
    let is_beside = end <= low || start >= high;
    if is_beside || face.at < *least || face.at > *most {
        FaceClass::Disjoint
    } else if face.at == *least || face.at == *most {
        FaceClass::Covering
    } else if start <= low && end >= high {
        FaceClass::Spanning
    } else {
        FaceClass::Incident
    }
}
