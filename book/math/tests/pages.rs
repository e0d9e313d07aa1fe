//! Every formula of the book can be shown.

use std::fs;
use std::path::Path;

#[test]
fn every_formula_is_rendered() {
    let mut formulas = 0;
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src");
    let mut folders = vec![source];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                let page = fs::read_to_string(&path).unwrap();
                let rendered = mbs_book_math::render(&page)
                    .unwrap_or_else(|mistake| panic!("{}: {mistake}", path.display()));
                formulas += rendered.matches("<math").count();
            }
        }
    }
    assert!(formulas > 50, "{formulas} formulas found");
}
