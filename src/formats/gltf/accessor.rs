//! Vertices and indices from the bytes of buffers.

use super::{GltfError, GltfErrorKind, error};
use crate::geom::RationalPoint3;
use crate::num::{Int, Rational};
use gltf::json::Root;
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::validation::Checked;

/// The accessors of a file, and the bytes they read.
pub(super) struct Accessors<'a> {
    pub root: &'a Root,
    pub buffers: &'a [Vec<u8>],
}

impl Accessors<'_> {
    /// The points of an accessor.
    pub fn points(&self, index: usize) -> Result<Vec<RationalPoint3>, GltfError> {
        let place = || format!("accessors[{index}]");
        if self.shape(index) != Some((Type::Vec3, ComponentType::F32)) {
            let what = "positions that are not three 32-bit floats each are not read";
            return Err(error(place(), GltfErrorKind::Unsupported(what)));
        }
        let mut points = Vec::new();
        for (element, bytes) in self.elements(index, 12)?.enumerate() {
            let mut point = [(); 3].map(|()| Rational::from(Int::ZERO));
            for (coordinate, four) in bytes.as_chunks::<4>().0.iter().enumerate() {
                let kind = GltfErrorKind::NotFinite { element, coordinate };
                point[coordinate] =
                    dyadic(u32::from_le_bytes(*four)).ok_or_else(|| error(place(), kind))?;
            }
            points.push(RationalPoint3::from(&point));
        }
        Ok(points)
    }

    /// The indices of an accessor.
    pub fn indices(&self, index: usize) -> Result<Vec<u32>, GltfError> {
        let (size, read): (usize, fn(&[u8]) -> u32) = match self.shape(index) {
            Some((Type::Scalar, ComponentType::U8)) => (1, |b| u32::from(b[0])),
            Some((Type::Scalar, ComponentType::U16)) => {
                (2, |b| u32::from(u16::from_le_bytes([b[0], b[1]])))
            }
            Some((Type::Scalar, ComponentType::U32)) => {
                (4, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
            }
            Some(_) | None => {
                let what = "indices that are not unsigned integers are not read";
                let place = format!("accessors[{index}]");
                return Err(error(place, GltfErrorKind::Unsupported(what)));
            }
        };
        Ok(self.elements(index, size)?.map(read).collect())
    }

    fn shape(&self, index: usize) -> Option<(Type, ComponentType)> {
        let accessor = &self.root.accessors[index];
        match (accessor.type_, accessor.component_type) {
            (Checked::Valid(shape), Checked::Valid(component)) => Some((shape, component.0)),
            (Checked::Invalid, _) | (_, Checked::Invalid) => None,
        }
    }

    /// The bytes of each element, `size` of them.
    fn elements(
        &self,
        index: usize,
        size: usize,
    ) -> Result<impl Iterator<Item = &[u8]>, GltfError> {
        let place = || format!("accessors[{index}]");
        let accessor = &self.root.accessors[index];
        let unsupported = |what| error(place(), GltfErrorKind::Unsupported(what));
        if accessor.sparse.is_some() {
            return Err(unsupported("sparse accessors are not read"));
        }
        let view = accessor.buffer_view.ok_or_else(|| unsupported("it has no buffer view"))?;
        let bytes = self.view(view.value())?;
        let view = &self.root.buffer_views[view.value()];
        let stride = view.byte_stride.map_or(0, |stride| stride.0 as u64);
        let stride = if stride == 0 { size as u64 } else { stride };
        if stride < size as u64 {
            return Err(unsupported("its elements overlap: the stride is less than their size"));
        }
        let count = accessor.count.0;
        let offset = accessor.byte_offset.map_or(0, |offset| offset.0);
        let expected = match count {
            0 => 0,
            _ => (count - 1).saturating_mul(stride).saturating_add(offset + size as u64),
        };
        if expected > bytes.len() as u64 {
            let kind = GltfErrorKind::Short { got: bytes.len(), expected };
            return Err(error(place(), kind));
        }
        let first = bytes.get(offset as usize..).unwrap_or_default();
        Ok(first.chunks(stride as usize).take(count as usize).map(move |chunk| &chunk[..size]))
    }

    fn view(&self, index: usize) -> Result<&[u8], GltfError> {
        let view = &self.root.buffer_views[index];
        let buffer = &self.buffers[view.buffer.value()];
        let start = view.byte_offset.map_or(0, |offset| offset.0);
        let expected = start.saturating_add(view.byte_length.0);
        if expected > buffer.len() as u64 {
            let kind = GltfErrorKind::Short { got: buffer.len(), expected };
            return Err(error(format!("bufferViews[{index}]"), kind));
        }
        Ok(&buffer[start as usize..expected as usize])
    }
}

/// The number that the bits of a 32-bit float stand for (IEEE 754-2019, section 3.4); `None` for
/// what is infinite or not a number.
pub(super) fn dyadic(bits: u32) -> Option<Rational> {
    let (fraction, exponent) = (bits & ((1 << 23) - 1), (bits >> 23) & 0xff);
    let (significand, power) = match exponent {
        0xff => return None,
        0 => (fraction, -149),
        _ => (fraction | 1 << 23, exponent as i32 - 150),
    };
    let significand = Int::from(significand);
    let size = match power {
        0.. => Rational::from(significand << power),
        _ => Rational::new(significand, Int::from(1) << -power),
    };
    Some(if bits >> 31 == 1 { -size } else { size })
}
