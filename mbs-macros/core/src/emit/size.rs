//! How much Rust is written for a mechanism.

/// Statements of what is written, by function.
#[derive(Debug, Default, Clone)]
pub struct Size {
    /// Each function with its statements, in the order in which they are written.
    pub functions: Vec<(&'static str, usize)>,
}

impl Size {
    /// All statements.
    pub fn statements(&self) -> usize {
        self.functions
            .iter()
            .map(|(_, statements)| statements)
            .sum()
    }

    /// Statements of a function; zero if there is none of this name.
    pub fn of(&self, name: &str) -> usize {
        let mut functions = self.functions.iter();
        let found = functions.find(|(known, _)| *known == name);
        found.map_or(0, |(_, statements)| *statements)
    }

    /// The function with most statements.
    pub fn largest(&self) -> Option<(&'static str, usize)> {
        let functions = self.functions.iter().copied();
        functions.max_by_key(|(_, statements)| *statements)
    }

    /// Counts a text for a function.
    pub(super) fn add(&mut self, name: &'static str, text: &str) {
        let statements = statements(text);
        match self.functions.iter_mut().find(|(known, _)| *known == name) {
            Some((_, count)) => *count += statements,
            None => self.functions.push((name, statements)),
        }
    }
}

/// Statements, fields and blocks of a text: what ends with `;`, `{` or `}`, outside of strings.
pub fn statements(text: &str) -> usize {
    let (mut count, mut inside, mut escaped) = (0, false, false);
    for byte in text.bytes() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = inside,
            b'"' => inside = !inside,
            b';' | b'{' | b'}' if !inside => count += 1,
            _ => {}
        }
    }
    count
}
