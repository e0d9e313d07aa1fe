//! A rotational spring and damper between two parts.

use super::{Action, Characteristic, Force};
use crate::model::{Arguments, Frame, Owner};
use crate::symbolic::Graph;

#[derive(Debug)]
struct TorsionSpring {
    owners: [Owner; 2],
    frames: [Frame; 2],
    characteristic: Characteristic,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let (parent, child) = (arguments.part("parent"), arguments.part("child"));
    let characteristic = Characteristic::read(arguments, "angle");
    let owners = [parent?, child?];
    if owners[0] == owners[1] {
        return arguments.fail(
            "child",
            "a part does not turn against itself; name another part",
        );
    }
    for (field, owner) in ["parent", "child"].into_iter().zip(owners) {
        if arguments.is_particle(owner) {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` is a particle and has no orientation; use a Body or a Bar"),
            );
        }
    }
    let frames = owners.map(|owner| arguments.frame(owner));
    Some(Box::new(TorsionSpring {
        owners,
        frames,
        characteristic: characteristic?,
    }))
}

impl Force for TorsionSpring {
    fn action(&self, graph: &mut Graph) -> Action {
        let [parent, child] = &self.frames;
        // Parts that turn against a spring have an angle: see `model::turning`.
        let zero = graph.zero();
        let angle = graph.sub(child.angle.unwrap_or(zero), parent.angle.unwrap_or(zero));
        let rate = graph.sub(child.spin[2], parent.spin[2]);
        self.characteristic.action(graph, angle, rate)
    }

    fn owners(&self) -> Vec<Owner> {
        self.owners.to_vec()
    }
}
