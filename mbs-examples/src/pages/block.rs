//! Blocks on a page: `<!-- written by `mbs pages`: NAME -->`, text, `<!-- end of NAME -->`.

use std::ops::Range;

const BEGIN: &str = "<!-- written by `mbs pages`: ";
const CLOSE: &str = " -->";

/// A block that was found on a page.
#[derive(Debug, Clone, PartialEq)]
pub struct Found<'p> {
    /// Its name.
    pub name: &'p str,
    /// Where its text is, in bytes.
    pub text: Range<usize>,
    /// Whether it is a part of a line. (A comment at the beginning of a line would end the paragraph before it.)
    pub inline: bool,
}

/// The blocks of a page, in their order. Text inside a code fence is not a block.
///
/// # Errors
/// A comment that does not end, a block that does not end, or one inside another.
pub fn find(page: &str) -> Result<Vec<Found<'_>>, String> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(begin) = page[at..].find(BEGIN) {
        let begin = at + begin + BEGIN.len();
        if in_code(&page[..begin]) {
            at = begin;
            continue;
        }
        let name = page[begin..]
            .find(CLOSE)
            .map(|end| &page[begin..begin + end]);
        let name = name.filter(|name| !name.contains('\n'));
        let name = name.ok_or("a comment `written by …` does not end in its line")?;
        let start = begin + name.len() + CLOSE.len();
        let end = page[start..].find(&end_of(name)).map(|end| start + end);
        let end = end.ok_or_else(|| format!("block `{name}` has no `{}`", end_of(name)))?;
        if page[start..end].contains(BEGIN) {
            return Err(format!("block `{name}` has another one inside"));
        }
        let line = page[..begin - BEGIN.len()].rsplit('\n').next();
        found.push(Found {
            name,
            text: start..end,
            inline: line.is_some_and(|line| !line.trim().is_empty()),
        });
        at = end;
    }
    Ok(found)
}

/// Whether a fence is open at the end of a text.
fn in_code(text: &str) -> bool {
    let fences = text
        .lines()
        .filter(|line| line.trim_start().starts_with("```"));
    fences.count() % 2 == 1
}

fn end_of(name: &str) -> String {
    format!("<!-- end of {name}{CLOSE}")
}

/// The text of a block in the form for its page: a part of a line, or separate lines.
pub fn framed(found: &Found, new: &str) -> String {
    let new = new.trim();
    match found.inline {
        true => new.to_owned(),
        false => format!("\n\n{new}\n\n"),
    }
}
