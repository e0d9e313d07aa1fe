//! A torque on a part, with its reaction on another.

use super::{Action, Force, Load};
use crate::model::{Arguments, Frame, Owner};
use crate::symbolic::{Expr, Graph};

#[derive(Debug)]
struct Torque {
    owners: [Owner; 2],
    frames: [Frame; 2],
    value: Expr,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let (on, value) = (arguments.part("on"), arguments.scalar("value"));
    let from = if arguments.has("from") {
        arguments.part("from")?
    } else {
        Owner::Ground
    };
    let (on, value) = (on?, value?);
    if on == from {
        return arguments.fail("on", match on {
            Owner::Ground => "a torque on the ground does nothing; apply it to a part",
            Owner::Part(_) => "a torque of a part on itself does nothing; name another part in `from`, or leave it out",
        });
    }
    for (field, owner) in [("on", on), ("from", from)] {
        if arguments.is_particle(owner) {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` is a particle: a torque cannot turn it"),
            );
        }
    }
    let owners = [on, from];
    let frames = owners.map(|owner| arguments.frame(owner));
    Some(Box::new(Torque {
        owners,
        frames,
        value,
    }))
}

impl Force for Torque {
    fn action(&self, graph: &mut Graph) -> Action {
        let rate = graph.sub(self.frames[0].spin[2], self.frames[1].spin[2]);
        Action {
            potential: None,
            loads: vec![Load {
                rate,
                force: self.value,
            }],
        }
    }

    fn owners(&self) -> Vec<Owner> {
        self.owners.to_vec()
    }
}
