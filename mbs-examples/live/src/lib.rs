//! The live mechanisms of the book: three scenes in a WebAssembly module, integrated in the reader's browser.
//!
//! The page draws and has the clock; this crate has the mechanisms and the runtime. They share a few functions
//! ([`exports`]), a buffer of numbers and a text: no generator of bindings is needed. A [`Figure`] has two runs of one
//! mechanism, with the two-level method and with a baseline; if a call fails it returns a message for the page.
//!
//! # Building the module
//!
//! ```text
//! rustup target add wasm32-unknown-unknown
//! bash mbs-examples/live/build
//! ```
//!
//! writes `book/src/live/module.js`. The module is in there as text: a page that was opened as a file may load a script
//! from beside it, but not fetch a module. It is compressed, and the browser unpacks it.
//!
//! The file is kept in the repository. The book then needs no second target to be built, here or anywhere, and the test
//! `digits` interprets the module of that file, takes the same steps with this crate as a native program, and compares
//! all digits. A module that is older than the runtime passes as long as its results are the same. Otherwise the test
//! fails, and the module has to be built again.
//!
//! # Where digits may differ
//!
//! WebAssembly has the arithmetic of IEEE 754 and the square root, with all roundings prescribed, and the compiler
//! reorders nothing: additions, products, quotients and roots are the same bits everywhere. Sines and cosines are not
//! prescribed. In the module they are those of Rust's own port of the C library musl, in a native program those of the
//! platform's C library. Both have an error of less than a unit in the last place, but not always the same last bit.
//! The test states the effect.

pub mod description;
pub mod exports;
mod figure;
mod mechanisms;
mod refusal;
#[path = "../../src/scene.rs"]
pub mod scene;
mod start;

pub use figure::{Figure, HEAD, METHODS, STEPS};
pub use mechanisms::{MECHANISMS, Mechanism};
pub use refusal::Refusal;
pub(crate) use start::start;
