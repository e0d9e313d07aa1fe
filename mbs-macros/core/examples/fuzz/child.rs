//! The process that compiles: texts in, one line of answer for each out.

use mbs_macros_core::{analyse, emit};
use proc_macro2::TokenStream;
use std::io::{BufRead, Read, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;

/// The argument that starts a process in this way.
#[allow(dead_code)] // For the program.
pub const MODE: &str = "--child";
/// The stack that the compiler of Rust has.
const STACK: usize = 8 << 20;

static PANIC: Mutex<String> = Mutex::new(String::new());

/// Answers until the input ends. Each text has its length on a line before it.
pub fn serve() {
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(ToString::to_string);
        let text = panic
            .payload()
            .downcast_ref::<&str>()
            .map(ToString::to_string);
        let text = text.or_else(|| panic.payload().downcast_ref::<String>().cloned());
        let message = format!(
            "{} at {}",
            text.unwrap_or_default(),
            place.unwrap_or_default()
        );
        *PANIC
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner()) = message;
    }));
    // Ends the line that a test begins with its name.
    println!();
    let thread = std::thread::Builder::new().stack_size(STACK);
    let running = thread.spawn(|| {
        let mut input = std::io::stdin().lock();
        let mut line = String::new();
        while let Ok(1..) = input.read_line(&mut line) {
            let length = line.trim().parse().unwrap_or(0);
            let mut text = vec![0; length];
            if input.read_exact(&mut text).is_err() {
                return;
            }
            let answer = answer(&String::from_utf8_lossy(&text)).replace('\n', " ");
            // Texts are kept for messages; those of a million inputs would fill the memory.
            proc_macro2::extra::invalidate_current_thread_spans();
            let mut out = std::io::stdout().lock();
            if writeln!(out, "{answer}")
                .and_then(|()| out.flush())
                .is_err()
            {
                return;
            }
            line.clear();
        }
    });
    let _ = running.map(std::thread::JoinHandle::join);
}

/// `accepted`, `refused`, or what is wrong.
fn answer(text: &str) -> String {
    let Ok(tokens) = text.parse::<TokenStream>() else {
        return "refused".to_owned();
    };
    match catch_unwind(AssertUnwindSafe(|| verdict(tokens))) {
        Ok(verdict) => verdict,
        Err(_) => {
            let message = PANIC
                .lock()
                .unwrap_or_else(|poisoned| poisoned.into_inner());
            format!("panic: {message}")
        }
    }
}

fn verdict(tokens: TokenStream) -> String {
    let (declaration, outcome) = analyse(tokens);
    match (declaration, outcome) {
        (Some(declaration), Ok(analysis)) => {
            let written = emit::mechanism(&declaration, &analysis, &analysis.program).to_string();
            match written.contains("please report this declaration") {
                true => "unwritten: the generated code does not parse".to_owned(),
                false => "accepted".to_owned(),
            }
        }
        (declaration, Err(failure)) => {
            if let Some(declaration) = declaration {
                let _ = emit::fallback(&declaration).to_string();
            }
            let messages = failure.messages();
            let silent =
                |message: &str| message.trim().is_empty() || message.contains("without saying why");
            let odd = |message: &str| message.contains("NaN");
            let texts: Vec<&str> = messages.iter().map(|(text, _)| text.as_str()).collect();
            if texts.is_empty() || texts.iter().any(|text| silent(text)) {
                return "silent: no reason".to_owned();
            }
            match texts.into_iter().find(|text| odd(text)) {
                Some(text) => format!("odd: {text}"),
                None => "refused".to_owned(),
            }
        }
        (None, Ok(_)) => "silent: nothing was parsed, yet it was analysed".to_owned(),
    }
}
