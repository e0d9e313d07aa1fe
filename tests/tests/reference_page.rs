//! The reference page of the language, in the book and in the documentation of the macro, is generated from the schema.
//! To renew it: `UPDATE_REFERENCE=1 cargo test -p mbs-tests reference_page::`.

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../mbs-macros/LANGUAGE.md");

#[test]
fn the_reference_page_is_up_to_date() {
    let page = mbs_macros_core::reference::page();
    if std::env::var_os("UPDATE_REFERENCE").is_some() {
        std::fs::write(PATH, &page).expect("the page can be written");
    }
    let written = std::fs::read_to_string(PATH).expect("the page is there");
    assert!(
        written == page,
        "mbs-macros/LANGUAGE.md is out of date; renew it with UPDATE_REFERENCE=1"
    );
}
