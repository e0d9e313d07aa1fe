//! The method laboratory: speed against accuracy, stability where methods fail, and what a model costs.
//!
//! A chart is a plan of points, a [`store`] that keeps each point as it comes, and pictures of what the store holds: long
//! work can be interrupted and goes on where it was.

pub mod diagram;
pub mod measure;
pub mod methods;
pub mod model_size;
pub mod outcome;
pub mod outcome_map;
pub mod page;
pub mod paper;
pub mod provenance;
pub mod stability;
pub mod store;
pub mod svg;
pub mod tables;
pub mod tuning;
pub mod work_precision;
pub mod yardstick;
