//! Andrews' squeezer mechanism: seven bodies, three loops that meet in one point, one spring and a motor; it runs at
//! several thousand rad/s within 0.05 s. The coordinates are the seven angles of the test set, and each body's frame is
//! an expression of them: M depends on q, and three revolutes give six rows. Reference: one coordinate, with the loops
//! closed by the intersection of circles.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(Andrews {
    doc: "Andrews' squeezer mechanism in seven angles, with six rows.",
    world: Planar(),

    /// Torque of the motor on the crank.
    motor: Param(0.033_Nm),
    /// Stiffness of the spring between C and D.
    stiffness: Param(4530.0_N_per_m),
    /// Free length of the spring.
    free_length: Param(0.07785_m),

    /// Initial angle of the crank.
    beta0: Param(-0.06171389001427645_rad),
    /// Initial angle of FE relative to the crank.
    theta0: Param(0.0_rad),
    /// Initial angle of BDE.
    gamma0: Param(0.4552798191630704_rad),
    /// Initial angle of GE relative to AG.
    phi0: Param(0.22266839016588588_rad),
    /// Initial angle of AG.
    delta0: Param(0.48736497954384255_rad),
    /// Initial angle of HE relative to AH.
    omega0: Param(-0.22266839016588588_rad),
    /// Initial angle of AH.
    epsilon0: Param(1.2305474445498212_rad),

    beta: Coordinate(beta0),
    theta: Coordinate(theta0),
    gamma: Coordinate(gamma0),
    phi: Coordinate(phi0),
    delta: Coordinate(delta0),
    omega: Coordinate(omega0),
    epsilon: Coordinate(epsilon0),

    a: Point([-0.06934_m, -0.00227_m]),
    b: Point([-0.03635_m, 0.03273_m]),
    c: Point([0.014_m, 0.072_m]),

    of: Body(
        mass = 0.04325_kg,
        inertia = 2.194e-6_kg_m2,
        center_of_mass = [0.00092_m, 0.0_m],
        frame = Frame(ground.origin, beta),
    ),
    f: Let(of.point(0.007_m, 0.0_m)),
    fe: Body(
        mass = 0.00365_kg,
        inertia = 4.410e-7_kg_m2,
        center_of_mass = [-0.0115_m, 0.0_m],
        frame = Frame(f, beta + theta),
    ),
    bde: Body(
        mass = 0.02373_kg,
        inertia = 5.255e-6_kg_m2,
        center_of_mass = [0.01043_m, -0.01874_m],
        frame = Frame(b, gamma),
    ),
    d: Let(bde.point(0.02_m, -0.018_m)),
    ag: Body(
        mass = 0.07050_kg,
        inertia = 1.169e-5_kg_m2,
        center_of_mass = [0.02308_m, 0.00916_m],
        frame = Frame(a, delta),
    ),
    g: Let(ag.point(0.04_m, 0.0_m)),
    ge: Body(
        mass = 0.00706_kg,
        inertia = 5.667e-7_kg_m2,
        center_of_mass = [0.0_m, -0.00579_m],
        frame = Frame(g, phi + delta),
    ),
    ah: Body(
        mass = 0.05498_kg,
        inertia = 1.912e-5_kg_m2,
        center_of_mass = [-0.00449_m, -0.01228_m],
        frame = Frame(a, epsilon),
    ),
    h: Let(ah.point(0.0_m, -0.04_m)),
    he: Body(
        mass = 0.00706_kg,
        inertia = 5.667e-7_kg_m2,
        center_of_mass = [0.00579_m, 0.0_m],
        frame = Frame(h, omega + epsilon),
    ),
    e: Let(fe.point(-0.028_m, 0.0_m)),

    e_bde: Revolute(e, bde.point(0.0_m, -0.035_m)),
    e_ge: Revolute(e, ge.point(0.0_m, -0.02_m)),
    e_he: Revolute(e, he.point(0.02_m, 0.0_m)),

    spring: SpringDamper(c, d, stiffness = stiffness, length = free_length),
    drive: Torque(on = of, value = motor),

    beta_angle: Output(beta),
    theta_angle: Output(theta),
    gamma_angle: Output(gamma),
    phi_angle: Output(phi),
    delta_angle: Output(delta),
    omega_angle: Output(omega),
    epsilon_angle: Output(epsilon),
    f_point: Output(f),
    e_point: Output(e),
});

impl Andrews {
    /// The start of the IFToMM benchmark: the crank at −0.0620 rad, the other angles by loop closure.
    pub fn iftomm() -> Self {
        Andrews {
            beta0: -0.062,
            theta0: 2.145868537995153e-4,
            gamma0: 0.4552798121003702,
            phi0: 0.22266837590302747,
            delta0: 0.4873649811406328,
            omega0: -0.22266837590302747,
            epsilon0: 1.2305474391566008,
            ..Andrews::default()
        }
    }
}

const COLUMNS: &[(&str, &str)] = &[
    ("beta_angle", "beta_rad"),
    ("theta_angle", "theta_rad"),
    ("gamma_angle", "gamma_rad"),
    ("phi_angle", "phi_rad"),
    ("delta_angle", "delta_rad"),
    ("omega_angle", "omega_rad"),
    ("epsilon_angle", "epsilon_rad"),
    ("f_point.x", "fx_m"),
    ("f_point.y", "fy_m"),
];

/// With the data of the test set for initial value problems.
pub const SCENE: Scene = Scene {
    name: "andrews",
    title: "Andrews' squeezer mechanism (data of the IVP test set)",
    source: "Schiehlen 1990; Mazzia, Magherini: Test Set for IVP Solvers",
    model: Andrews::MODEL,
    duration: 0.05,
    step: 1e-6,
    reference: Some(Reference {
        file: "a03_andrews_bari.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(Andrews),
};

/// With the start of the IFToMM benchmark.
pub const IFTOMM: Scene = Scene {
    name: "andrews-iftomm",
    title: "Andrews' squeezer mechanism (start of the IFToMM benchmark)",
    source: "IFToMM benchmark A03",
    model: Andrews::MODEL,
    duration: 0.05,
    step: 1e-6,
    reference: Some(Reference {
        file: "a03_andrews_iftomm.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(Andrews, Andrews::iftomm()),
};
