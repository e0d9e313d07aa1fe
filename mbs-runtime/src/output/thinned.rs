//! Evenly spaced instants of a run whose number of instants is not known before its end.

use super::Frame;
use super::motion::data::MOST_FRAMES;

/// Every `stride`-th frame, and the last one: between one and two times as many as an animation shows, once there are
/// that many.
pub(super) struct Thinned {
    kept: Vec<Frame>,
    stride: usize,
    count: usize,
    last: Option<Frame>,
}

impl Thinned {
    pub(super) fn new() -> Self {
        Thinned {
            kept: Vec::new(),
            stride: 1,
            count: 0,
            last: None,
        }
    }

    pub(super) fn push(&mut self, frame: Frame) {
        self.last = match self.count.is_multiple_of(self.stride) {
            true => {
                self.kept.push(frame);
                None
            }
            false => Some(frame),
        };
        self.count += 1;
        // With an odd number of frames the newest one is kept.
        if self.kept.len() > 2 * MOST_FRAMES {
            let mut index = 0;
            self.kept.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.stride *= 2;
        }
    }

    /// The time of the last instant, s.
    pub(super) fn time(&self) -> Option<f64> {
        self.last.as_ref().or(self.kept.last()).map(|f| f.time)
    }

    /// The number of all instants.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    pub(super) fn finish(mut self) -> Vec<Frame> {
        self.kept.extend(self.last);
        self.kept
    }
}

#[cfg(test)]
mod tests {
    use super::{Frame, MOST_FRAMES, Thinned};

    #[test]
    fn frames_are_evenly_spaced_and_end_with_the_last() {
        for count in [0, 1, 5, 4002, 4003, 4004, 4005, 50_001, 50_002] {
            let mut thinned = Thinned::new();
            for index in 0..count {
                let time = index as f64;
                thinned.push(Frame {
                    time,
                    ..Frame::default()
                });
                assert_eq!(thinned.time(), Some(time));
            }
            assert_eq!(thinned.count(), count);
            let times: Vec<f64> = thinned.finish().iter().map(|frame| frame.time).collect();
            assert!(times.len() >= count.min(MOST_FRAMES) && times.len() <= 2 * MOST_FRAMES + 1);
            assert_eq!(times.first().copied(), (count > 0).then_some(0.0));
            assert_eq!(
                times.last().copied(),
                count.checked_sub(1).map(|last| last as f64)
            );
            let stride = if times.len() > 1 { times[1] } else { 1.0 };
            let even = times.windows(2).rev().skip(1);
            assert!(even.into_iter().all(|pair| pair[1] - pair[0] == stride));
        }
    }
}
