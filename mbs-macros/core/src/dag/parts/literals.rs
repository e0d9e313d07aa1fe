//! Numbers that are the same in all uses of a shape are written in its code, not in its table.

use super::shape::{Member, Shape};
use crate::dag::Operand;
use crate::symbolic::Symbol;

pub(super) fn write(shapes: &mut [Shape], members: &mut [Member]) {
    let mut common: Vec<Option<Vec<Option<Operand>>>> = vec![None; shapes.len()];
    for member in members.iter() {
        let numbers = member.reads.iter().map(|&read| match read {
            Operand::Number(_) => Some(read),
            _ => None,
        });
        match &mut common[member.shape] {
            Some(common) => {
                for (common, number) in common.iter_mut().zip(numbers) {
                    *common = common.filter(|_| *common == number);
                }
            }
            none => *none = Some(numbers.collect()),
        }
    }
    for (shape, common) in shapes.iter_mut().zip(&common) {
        let common = common.as_deref().unwrap_or_default();
        let places: Vec<Operand> = common
            .iter()
            .scan(0, |next, common| {
                let place = Operand::Symbol(Symbol::Place(*next));
                *next += u32::from(common.is_none());
                Some(common.unwrap_or(place))
            })
            .collect();
        for operation in &mut shape.function.operations {
            *operation = operation.map_operands(|operand| match operand {
                Operand::Symbol(Symbol::Place(place)) => places[place as usize],
                other => other,
            });
        }
    }
    for member in members {
        let common = common[member.shape].as_deref().unwrap_or_default();
        let mut numbers = common.iter();
        member
            .reads
            .retain(|_| numbers.next().is_none_or(Option::is_none));
    }
}
