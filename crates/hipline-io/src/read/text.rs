//! What the readers of plain text share: places in the text, and numbers.

use crate::ReadError;

/// A text and what it is read as.
#[derive(Clone, Copy)]
pub(super) struct Text<'a> {
    pub format: &'static str,
    pub text: &'a str,
}

impl<'a> Text<'a> {
    /// The bytes as text, without a byte order mark.
    pub fn new(format: &'static str, bytes: &'a [u8]) -> Result<Self, ReadError> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        match std::str::from_utf8(bytes) {
            Ok(text) => Ok(Self { format, text }),
            Err(e) => {
                let good = std::str::from_utf8(&bytes[..e.valid_up_to()]).unwrap_or_default();
                Err(Self { format, text: good }.error(good.len(), "not UTF-8 text"))
            }
        }
    }

    /// An error at a byte offset.
    pub fn error(&self, at: usize, message: impl Into<String>) -> ReadError {
        let before = self.text.get(..at).unwrap_or(self.text);
        let start = before.rfind('\n').map_or(0, |i| i + 1);
        ReadError::Syntax {
            format: self.format,
            line: before.matches('\n').count() + 1,
            column: before[start..].chars().count() + 1,
            message: message.into(),
        }
    }

    /// An error about the file as a whole.
    pub fn content(&self, message: impl Into<String>) -> ReadError {
        ReadError::Content {
            format: self.format,
            message: message.into(),
        }
    }

    /// The f64 nearest to a decimal number.
    pub fn number(&self, at: usize, token: &str) -> Result<f64, ReadError> {
        number(token).map_err(|message| self.error(at, message))
    }
}

/// The f64 nearest to a decimal number; `str::parse` rounds correctly.
pub(super) fn number(token: &str) -> Result<f64, String> {
    match token.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) if token.bytes().any(|b| b.is_ascii_digit()) => {
            Err(format!("{} is too large for a double", short(token)))
        }
        Ok(_) => Err(format!("{} is not a finite number", short(token))),
        Err(_) => Err(format!("{} is not a number", short(token))),
    }
}

/// A token in backticks, cut if it is long.
pub(crate) fn short(token: &str) -> String {
    match token.char_indices().nth(40) {
        None => format!("`{token}`"),
        Some((end, _)) => format!("`{}...`", &token[..end]),
    }
}
