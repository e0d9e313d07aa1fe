//! The module that the book carries, interpreted; or another one, at the path `LIVE_MODULE` within the workspace.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::read::GzDecoder;
use std::io::Read;
use std::path::PathBuf;
use std::{env, fs};
use wasmi::{Engine, Instance, Linker, Memory, Module, Store, WasmParams, WasmResults};

/// Where the page has its files.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../book/src/live")
}

/// The module as the browser unpacks it.
fn binary() -> Vec<u8> {
    if let Some(path) = env::var_os("LIVE_MODULE") {
        let workspace = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
        return fs::read(workspace.join(path)).expect("the module of LIVE_MODULE was built");
    }
    let script = fs::read_to_string(folder().join("module.js")).expect("the module was built");
    let text = script.split('"').nth(1).expect("a text in quotes");
    let packed = STANDARD.decode(text).expect("base64");
    let mut binary = Vec::new();
    let mut unpacking = GzDecoder::new(packed.as_slice());
    unpacking.read_to_end(&mut binary).expect("gzip");
    binary
}

/// An instance, with the calls that the page makes.
pub struct Page {
    store: Store<()>,
    instance: Instance,
    memory: Memory,
}

impl Page {
    pub fn open() -> Self {
        let engine = Engine::default();
        let module = Module::new(&engine, binary()).expect("a module");
        let mut store = Store::new(&engine, ());
        let linker = Linker::new(&engine);
        let instance = linker
            .instantiate_and_start(&mut store, &module)
            .expect("it needs nothing from outside");
        let memory = instance.get_memory(&store, "memory").expect("a memory");
        Page {
            store,
            instance,
            memory,
        }
    }

    fn call<P: WasmParams, R: WasmResults>(&mut self, name: &str, parameters: P) -> R {
        let function = self.instance.get_typed_func::<P, R>(&self.store, name);
        let function = function.expect("the function");
        let result = function.call(&mut self.store, parameters);
        result.unwrap_or_else(|trap| panic!("{name} trapped: {trap}"))
    }

    fn bytes(&mut self, pointer: &str, count: usize) -> &mut [u8] {
        let start: i32 = self.call(pointer, ());
        let start = usize::try_from(start).expect("an address");
        &mut self.memory.data_mut(&mut self.store)[start..start + count]
    }

    fn answer(&mut self, number: i32) -> Result<usize, String> {
        match usize::try_from(number) {
            Ok(count) => Ok(count),
            Err(_) => Err(self.text(number.unsigned_abs() as usize)),
        }
    }

    fn text(&mut self, length: usize) -> String {
        String::from_utf8(self.bytes("live_text", length).to_vec()).expect("UTF-8")
    }

    pub fn describe(&mut self, mechanism: usize) -> String {
        let length: i32 = self.call("live_describe", mechanism as i32);
        let length = self.answer(length).expect("a mechanism");
        self.text(length)
    }

    pub fn start(
        &mut self,
        run: usize,
        mechanism: usize,
        method: usize,
        step: f64,
        parameters: &[f64],
    ) -> Result<(), String> {
        let places = self.bytes("live_buffer", 8 * parameters.len());
        for (place, value) in places.chunks_exact_mut(8).zip(parameters) {
            place.copy_from_slice(&value.to_le_bytes());
        }
        let [run, mechanism, method] = [run, mechanism, method].map(|index| index as i32);
        let count = parameters.len() as i32;
        let started: i32 = self.call("live_start", (run, mechanism, method, step, count));
        self.answer(started).map(|_| ())
    }

    pub fn advance(&mut self, run: usize, time: f64, most: usize) -> Result<usize, String> {
        let taken: i32 = self.call("live_advance", (run as i32, time, most as i32));
        self.answer(taken)
    }

    pub fn read(&mut self, run: usize) -> Result<Vec<f64>, String> {
        let count: i32 = self.call("live_read", run as i32);
        let count = self.answer(count)?;
        let bytes = self.bytes("live_buffer", 8 * count);
        let numbers = bytes.chunks_exact(8);
        let numbers = numbers.map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes")));
        Ok(numbers.collect())
    }
}
