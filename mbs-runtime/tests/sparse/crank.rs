//! One crank as the reference of mechanisms that move like one.

/// θ̈ = −(moment cos θ + damping θ̇)/inertia.
pub struct Crank {
    pub inertia: f64,
    pub moment: f64,
    pub damping: f64,
}

impl Crank {
    /// θ after `time` seconds from θ and θ̇, by the classical Runge–Kutta method.
    pub fn angle(&self, start: [f64; 2], time: f64) -> f64 {
        let rate = |[angle, speed]: [f64; 2]| {
            let moment = self.moment * f64::cos(angle) + self.damping * speed;
            [speed, -moment / self.inertia]
        };
        let h = 1e-4;
        let mut x = start;
        for _ in 0..(time / h).round() as usize {
            let along = |k: [f64; 2], s: f64| [x[0] + s * k[0], x[1] + s * k[1]];
            let k1 = rate(x);
            let k2 = rate(along(k1, 0.5 * h));
            let k3 = rate(along(k2, 0.5 * h));
            let k4 = rate(along(k3, h));
            for i in 0..2 {
                x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
            }
        }
        x[0]
    }
}
