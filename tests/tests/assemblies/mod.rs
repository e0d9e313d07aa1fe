//! Assemblies of another crate, put in place here.

mod linkages;
mod platform;
mod suspensions;
mod tables;
