//! The preprocessor: a context and a book as JSON on standard input, the book on standard output.

use serde_json::Value;
use std::error::Error;
use std::io;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    if arguments.next().as_deref() == Some("supports") {
        let html = arguments.next().as_deref() == Some("html");
        std::process::exit(if html { 0 } else { 1 });
    }
    let mut input: Vec<Value> = serde_json::from_reader(io::stdin().lock())?;
    let mut book = input.pop().ok_or("mdBook sent no book")?;
    render(&mut book)?;
    serde_json::to_writer(io::stdout().lock(), &book)?;
    Ok(())
}

/// Renders the content of every chapter.
fn render(value: &mut Value) -> Result<(), Box<dyn Error>> {
    match value {
        Value::Array(values) => values.iter_mut().try_for_each(render),
        Value::Object(fields) => {
            let path = fields
                .get("path")
                .and_then(Value::as_str)
                .map(str::to_owned);
            if let Some(Value::String(content)) = fields.get_mut("content") {
                let page = path.unwrap_or_default();
                *content = mbs_book_math::render(content)
                    .map_err(|mistake| format!("{page}: {mistake}"))?;
            }
            fields.values_mut().try_for_each(render)
        }
        _ => Ok(()),
    }
}
