//! Programs with `assembly!` and `mechanism!`, expanded without rustc: an assembly hands out its tokens as its macro
//! would.

use proc_macro2::{Delimiter, LineColumn, TokenStream, TokenTree};
use std::collections::HashMap;
use std::ops::Range;

/// A message and where it is shown.
pub type Message = (String, Range<LineColumn>);

/// The code generated for each `assembly!` and `mechanism!` of a program, in order.
///
/// # Panics
/// The program is wrong in a way that is no matter of these macros, such as an assembly that nobody declares.
pub fn expanded(program: &str) -> Vec<TokenStream> {
    let tokens: TokenStream = program.parse().expect("these are tokens of Rust");
    let mut bundles = HashMap::new();
    let mut outputs = Vec::new();
    for (macro_name, tokens) in declarations(tokens) {
        let compile = match macro_name.as_str() {
            "assembly" => mbs_macros_core::compile_assembly,
            _ => mbs_macros_core::compile,
        };
        let mut output = compile(tokens);
        while let Some((path, next)) = asked(&output) {
            let bundle: &TokenTree = bundles
                .get(&path)
                .unwrap_or_else(|| panic!("there is no macro `{path}`"));
            output = compile(next.into_iter().chain([bundle.clone()]).collect());
        }
        if let Some((name, bundle)) = handed_out(&output) {
            bundles.insert(name, bundle);
        }
        outputs.push(output);
    }
    outputs
}

/// The messages of a program, in order.
pub fn messages(program: &str) -> Vec<Message> {
    expanded(program)
        .into_iter()
        .flat_map(|output| errors(output).expect("the generated code is Rust"))
        .collect()
}

/// A program is refused as written below its lines: `~` under the wrong tokens, and behind them the message.
pub fn refused(marked: &str) {
    let (marks, lines): (Vec<&str>, Vec<&str>) = marked
        .lines()
        .partition(|line| line.trim_start().starts_with('~'));
    let program = lines.join("\n");
    let mut shown = String::new();
    let mut found = messages(&program);
    found.sort_by_key(|(_, place)| (place.start.line, place.start.column));
    for (number, line) in lines.iter().enumerate() {
        shown.push_str(line);
        shown.push('\n');
        for (message, Range { start, end }) in &found {
            if start.line == number + 1 {
                let (before, under) = (" ".repeat(start.column), end.column - start.column);
                shown.push_str(&format!("{before}{} {message}\n", "~".repeat(under)));
            }
        }
    }
    assert!(!marks.is_empty(), "no message is expected");
    assert_eq!(shown.trim_end(), marked.trim_end(), "shown:\n{shown}");
}

/// A program has no messages.
pub fn accepted(program: &str) {
    let found = messages(program);
    assert!(found.is_empty(), "{found:#?}");
}

/// The errors in generated code.
///
/// # Errors
/// It is not Rust: it also has the correct parts of the declaration, which must not give errors.
pub fn errors(output: TokenStream) -> Result<Vec<Message>, String> {
    syn::parse2::<syn::File>(output.clone())
        .map_err(|error| format!("what was emitted is not Rust: {error}"))?;
    invocations(output, "compile_error")
        .into_iter()
        .map(|error| {
            let message: syn::LitStr =
                syn::parse2(error.tokens).map_err(|error| error.to_string())?;
            Ok((message.value(), error.place))
        })
        .collect()
}

/// `name!(…)` somewhere in tokens, by its path from the root or without one.
pub struct Invocation {
    pub tokens: TokenStream,
    pub place: Range<LineColumn>,
}

/// All invocations of a macro.
pub fn invocations(tokens: TokenStream, name: &str) -> Vec<Invocation> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = Vec::new();
    for (i, tree) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = tree else {
            continue;
        };
        let named = i >= 2
            && group.delimiter() != Delimiter::None
            && matches!(&tokens[i - 2], TokenTree::Ident(ident) if ident == name)
            && matches!(&tokens[i - 1], TokenTree::Punct(mark) if mark.as_char() == '!');
        if named {
            found.push(Invocation {
                tokens: group.stream(),
                place: tokens[i - 2].span().start()..group.span().end(),
            });
        } else {
            found.extend(invocations(group.stream(), name));
        }
    }
    found
}

/// The declarations of a program: which macro, and its tokens.
fn declarations(program: TokenStream) -> Vec<(String, TokenStream)> {
    let mut list = Vec::new();
    for item in syn::parse2::<syn::File>(program).expect("Rust").items {
        if let syn::Item::Macro(item) = item
            && let Some(name) = item.mac.path.segments.last()
        {
            list.push((name.ident.to_string(), item.mac.tokens));
        }
    }
    list
}

/// The last word of the path of the macro that generated code only calls, and what it is to call back with, but for the
/// tokens of the assembly.
fn asked(output: &TokenStream) -> Option<(String, TokenStream)> {
    let list: Vec<TokenTree> = output.clone().into_iter().collect();
    let [
        ..,
        TokenTree::Ident(name),
        TokenTree::Punct(mark),
        TokenTree::Group(call),
    ] = list.as_slice()
    else {
        return None;
    };
    let mut inside = call.stream().into_iter();
    let is_callback = matches!(inside.next(), Some(TokenTree::Group(callback))
        if callback.stream().to_string().contains("mbs_runtime"));
    (mark.as_char() == '!' && is_callback).then(|| (name.to_string(), inside.collect()))
}

/// The name of the assembly that generated code declares, and what its macro hands out.
fn handed_out(output: &TokenStream) -> Option<(String, TokenTree)> {
    let list: Vec<TokenTree> = output.clone().into_iter().collect();
    let rules = list
        .iter()
        .position(|token| matches!(token, TokenTree::Ident(word) if word == "macro_rules"))?;
    let TokenTree::Group(rules) = list.get(rules + 3)? else {
        return None;
    };
    let transcriber = groups(rules.stream()).pop()?;
    let call = groups(transcriber.stream()).pop()?;
    let bundle = groups(call.stream()).pop()?;
    let name = list
        .iter()
        .rev()
        .find(|token| matches!(token, TokenTree::Ident(_)))?;
    let delimiter = bundle.delimiter();
    let bundle = proc_macro2::Group::new(delimiter, without_dollars(bundle.stream()));
    Some((name.to_string(), bundle.into()))
}

fn groups(tokens: TokenStream) -> Vec<proc_macro2::Group> {
    let groups = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) => Some(group),
        _ => None,
    });
    groups.collect()
}

/// `$crate` is `crate` here: a program is one crate.
fn without_dollars(tokens: TokenStream) -> TokenStream {
    let tokens = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Punct(dollar) if dollar.as_char() == '$' => None,
        TokenTree::Group(group) => {
            let mut inner =
                proc_macro2::Group::new(group.delimiter(), without_dollars(group.stream()));
            inner.set_span(group.span());
            Some(inner.into())
        }
        other => Some(other),
    });
    tokens.collect()
}
