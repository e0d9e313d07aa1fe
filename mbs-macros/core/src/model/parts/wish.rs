//! The `coordinates =` of a part.

use crate::diagnostics::Place;
use crate::model::formulation::{COORDINATES, Formulation, asked};
use crate::model::resolver::Resolver;
use crate::syntax::Entry;

impl Resolver<'_> {
    /// The `coordinates =` of a part, one of those possible for it; `None` is the choice of the mechanism.
    pub(super) fn wish(&mut self, entry: &Entry, possible: &[Formulation]) -> Option<Formulation> {
        entry.named(COORDINATES)?;
        if let Some(frame) = entry.named("frame") {
            let place = Place::of(&frame.value);
            return self.fail(
                place,
                "the frame says what describes this part: remove `coordinates =` or `frame =`",
            );
        }
        asked(entry, possible, self.errors)
    }
}
