//! All tests of the scenes, the command line and the book's pages in one program.

mod absent;
mod book;
mod cli;
mod files;
mod laboratory;
mod pages;
mod pictures;
mod readme_picture;
mod tables;
