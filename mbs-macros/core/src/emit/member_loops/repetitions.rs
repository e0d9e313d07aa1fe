//! Members whose places grow by the same steps.

use super::{Array, FEWEST, Loops, Repetition, Spot};

/// The most members of a turn that are looked for.
const LONGEST: usize = 8;
/// More operations are not written out: then parts have tables.
const MOST: usize = 2000;

impl Loops<'_> {
    /// The members as loops; `None` if more is left to write than is worth it.
    pub(super) fn plan(&self, ends: Vec<usize>) -> Option<Vec<Repetition>> {
        let (mut plan, mut first, mut operations) = (Vec::new(), 0, 0);
        for end in ends {
            while first < end {
                let next = self.repetition(first, end);
                for member in &self.members[first..first + next.period] {
                    let code = member.shape.map(|shape| &self.parts.shapes[shape].function);
                    operations += 1 + code.map_or(0, |code| code.operations.len());
                }
                if operations > MOST {
                    return None;
                }
                first += next.period * next.times;
                plan.push(next);
            }
        }
        Some(plan)
    }

    /// The repetition at the beginning that takes the most members.
    fn repetition(&self, first: usize, end: usize) -> Repetition {
        let mut best = Repetition {
            first,
            period: 1,
            times: 1,
        };
        for period in 1..=LONGEST.min((end - first) / FEWEST) {
            let mut at = first + period;
            while at < end && self.continues(first, period, at) {
                at += 1;
            }
            let times = (at - first) / period;
            if times >= FEWEST && period * times > best.period * best.times {
                best = Repetition {
                    first,
                    period,
                    times,
                };
            }
        }
        best
    }

    /// Whether a member differs from that of the turn before as in the first turn.
    fn continues(&self, first: usize, period: usize, at: usize) -> bool {
        let within = first + (at - first) % period;
        let [before, now] = [at - period, at].map(|member| &self.members[member]);
        before.shape == now.shape
            && before.goes == now.goes
            && before.spots.len() == now.spots.len()
            && self.grows_evenly([at - period, at], [within, within + period], None)
    }

    /// Whether the places of two members differ as those of the first ones; with `packed` those of the array of values
    /// count as the places that it names.
    fn grows_evenly(
        &self,
        pair: [usize; 2],
        first: [usize; 2],
        packed: Option<(usize, &[usize])>,
    ) -> bool {
        let place = |spot: &Spot, index: usize| match packed {
            Some((values, packed)) if spot.array == values && index == 0 => packed[spot.at[0]],
            _ => spot.at[index],
        };
        let [before, now] = pair.map(|member| self.members[member].spots.as_slice());
        let [a, b] = first.map(|member| self.members[member].spots.as_slice());
        let mut k = 0;
        // Plain loops: this is where the unoptimised compiler of a large family would spend its time.
        while k < now.len() {
            let mut index = 0;
            while index < 3 {
                let step = place(&now[k], index).wrapping_sub(place(&before[k], index));
                if step != place(&b[k], index).wrapping_sub(place(&a[k], index)) {
                    return false;
                }
                index += 1;
            }
            if before[k].array != now[k].array {
                return false;
            }
            k += 1;
        }
        true
    }

    /// Where each place of the array is if those that nothing uses are left out, and their number; `None` if steps are
    /// uneven then.
    pub(super) fn packed(&self, plan: &[Repetition]) -> Option<Vec<usize>> {
        let mut used = vec![false; self.parts.places];
        let values = self.known.get(&Array::Values).copied();
        let values = values.unwrap_or(usize::MAX);
        for member in &self.members {
            for spot in &member.spots {
                if spot.array == values {
                    used[spot.at[0]] = true;
                }
            }
        }
        let mut packed = vec![0];
        let mut count = 0;
        for used in used {
            count += usize::from(used);
            packed.push(count);
        }
        let is_even = |loops: &Repetition| {
            let (first, period) = (loops.first, loops.period);
            (first + period..first + period * loops.times).all(|at| {
                let within = first + (at - first) % period;
                self.grows_evenly(
                    [at - period, at],
                    [within, within + period],
                    Some((values, &packed)),
                )
            })
        };
        let all = plan.iter().filter(|loops| loops.times > 1).all(is_even);
        all.then_some(packed)
    }
}
