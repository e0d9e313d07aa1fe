//! The formulas of the book: LaTeX between dollar signs becomes MathML, which browsers show without scripts, fonts or a
//! network. `$…$` is inside a line, `$$…$$` on separate lines; code spans and code blocks are not changed, and `\$` is
//! a dollar.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};
use std::fmt;

/// A formula that cannot be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Mistake {
    /// The formula.
    pub formula: String,
    /// Its error.
    pub message: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "in the formula `{}`: {}", self.formula, self.message)
    }
}

impl std::error::Error for Mistake {}

/// A page of Markdown with its formulas as MathML.
///
/// # Errors
/// The first formula that is not LaTeX, or that does not end.
pub fn render(page: &str) -> Result<String, Mistake> {
    let mut out = String::with_capacity(2 * page.len());
    let mut rest = page;
    while let Some(at) = rest.find(['`', '$', '\\', '~']) {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let length = if let Some(mark @ ('`' | '~')) = rest.chars().next() {
            let length = code(rest, mark);
            out.push_str(&rest[..length]);
            length
        } else if rest.starts_with("\\$") {
            out.push('$');
            2
        } else if rest.starts_with('\\') {
            out.push('\\');
            1
        } else if rest.starts_with("$$") {
            formula(rest, "$$", DisplayMode::Block, &mut out)?
        } else {
            formula(rest, "$", DisplayMode::Inline, &mut out)?
        };
        rest = &rest[length..];
    }
    out.push_str(rest);
    Ok(out)
}

/// How long the code is that begins here: up to a run of as many marks as it begins with. Without one it is no code.
fn code(text: &str, mark: char) -> usize {
    let run = |text: &str| text.len() - text.trim_start_matches(mark).len();
    let opening = run(text);
    if mark == '~' && opening < 3 {
        return opening;
    }
    let mut at = opening;
    while let Some(next) = text[at..].find(mark) {
        at += next;
        let closing = run(&text[at..]);
        at += closing;
        if closing == opening {
            return at;
        }
    }
    opening
}

/// Writes the formula that `text` begins with, between two `marks`; returns its length.
fn formula(
    text: &str,
    marks: &str,
    display_mode: DisplayMode,
    out: &mut String,
) -> Result<usize, Mistake> {
    let inside = &text[marks.len()..];
    let mistake = |formula: &str, message: String| Mistake {
        formula: formula.trim().to_owned(),
        message,
    };
    let paragraph = inside.split("\n\n").next().unwrap_or(inside);
    let Some(end) = paragraph.find(marks) else {
        let message = format!("no `{marks}` ends it in its paragraph; write `\\$` for a dollar");
        return Err(mistake(paragraph, message));
    };
    let latex = &paragraph[..end];
    let storage = Storage::new();
    let events: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let events = events.map_err(|error| mistake(latex, error.to_string()))?;
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    let events = events.into_iter().map(Ok::<_, fmt::Error>);
    let mut mathml = String::new();
    push_mathml(&mut mathml, events, config).map_err(|error| mistake(latex, error.to_string()))?;
    // mdBook destroys named entities in HTML, and the micro sign has no italic form, while the Greek letter has one.
    out.push_str(
        &mathml
            .replace("&nbsp;", "\u{a0}")
            .replace('\u{b5}', "\u{3bc}"),
    );
    Ok(end + 2 * marks.len())
}

#[cfg(test)]
mod tests {
    use super::render;

    #[test]
    fn formulas_become_mathml() {
        let line = render("a mass $m$ here").unwrap();
        assert!(line.starts_with("a mass <math") && line.ends_with("</math> here"));
        assert!(!line.contains('$'));
        let block = render("$$\n\\frac{a}{b}\n$$\n").unwrap();
        assert!(block.contains("display=\"block\"") && block.contains("<mfrac>"));
        assert!(
            !block.trim_end().contains('\n'),
            "Markdown would end it there"
        );
    }

    #[test]
    fn mu_is_a_greek_letter() {
        assert!(render("$\\mu$").unwrap().contains("<mi>\u{3bc}</mi>"));
    }

    #[test]
    fn code_is_left_alone() {
        for page in [
            "`$x$`",
            "```sh\necho $x `y`\n```\n",
            "``a ` $``",
            "~~~\n$\n~~~",
        ] {
            assert_eq!(render(page).unwrap(), page);
        }
        assert_eq!(render("5 \\$").unwrap(), "5 $");
    }

    #[test]
    fn mistakes_are_told() {
        assert!(render("$\\nosuchcommand$").is_err());
        assert!(render("$x\n\ny$").is_err());
    }
}
