//! The scenes, one module each.

use crate::scene::Scene;

/// All scenes, in the order in which they are listed.
pub fn scenes() -> &'static [Scene] {
    SCENES
}

const SCENES: &[Scene] = &[];
