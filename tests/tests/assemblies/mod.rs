//! Assemblies of another crate, put in place here.

mod linkages;
mod messages;
mod platform;
mod scopes;
mod suspensions;
mod tables;
