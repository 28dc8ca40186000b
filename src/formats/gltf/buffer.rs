//! The bytes of buffers: the container's own, embedded ones, and files beside the input.

use super::{Files, GltfError, GltfErrorKind, error};
use gltf::json::Root;

/// The bytes of every buffer.
pub(super) fn all(
    root: &Root,
    blob: Option<Vec<u8>>,
    files: Files,
) -> Result<Vec<Vec<u8>>, GltfError> {
    let mut blob = blob;
    let mut all = Vec::with_capacity(root.buffers.len());
    for (index, buffer) in root.buffers.iter().enumerate() {
        let place = || format!("buffers[{index}]");
        let bytes = match &buffer.uri {
            None if index == 0 => blob.take().ok_or_else(|| "the file has no chunk of them".into()),
            None => Err("it has no `uri`".into()),
            Some(uri) => match uri.strip_prefix("data:") {
                Some(data) => embedded(data).map_err(str::to_owned),
                None => files(&decoded(uri)),
            },
        };
        let bytes = bytes.map_err(|why| error(place(), GltfErrorKind::NoBytes(why)))?;
        if (bytes.len() as u64) < buffer.byte_length.0 {
            let kind = GltfErrorKind::Short { got: bytes.len(), expected: buffer.byte_length.0 };
            return Err(error(place(), kind));
        }
        all.push(bytes);
    }
    Ok(all)
}

/// What follows `data:`, in base 64 (RFC 2397, RFC 4648).
fn embedded(data: &str) -> Result<Vec<u8>, &'static str> {
    let (kind, text) = data.split_once(',').ok_or("its data URI has no comma")?;
    if !kind.ends_with(";base64") {
        return Err("its data URI is not in base 64");
    }
    let digits = text.trim_end_matches('=').bytes();
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut held) = (0u32, 0);
    for digit in digits {
        let value = match digit {
            b'A'..=b'Z' => digit - b'A',
            b'a'..=b'z' => digit - b'a' + 26,
            b'0'..=b'9' => digit - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return Err("its data URI has a character that base 64 has not"),
        };
        bits = bits << 6 | u32::from(value);
        held += 6;
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held) as u8);
        }
    }
    Ok(bytes)
}

/// A relative URI with its escapes (`%20`) resolved.
fn decoded(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, after @ ..] = rest {
        let code = after.first_chunk::<2>().filter(|_| *first == b'%');
        let code = code.and_then(|digits| std::str::from_utf8(digits).ok());
        match code.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
