//! The method laboratory: speed against accuracy, maps of stability, and the cost of models. A chart is a plan of
//! points, a [`store`] that keeps each measured point, and pictures made from the store. So a long measurement can be
//! interrupted and continued.

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
