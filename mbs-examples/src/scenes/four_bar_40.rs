//! The four-bar with 40 loops (LIM A02, N = 40): 41 cranks and 40 couplers, one degree of freedom. When all bars are
//! horizontal the rank is lower by 40. Reference: closed form of the parallelogram branch. The declaration is long, but
//! regular: crank i is on the ground at i metres, coupler i joins the tips of cranks i − 1 and i.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(FourBar40 {
    doc: "Forty parallelogram loops in a row.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

    crank0: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank1: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank2: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank3: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank4: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank5: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank6: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank7: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank8: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank9: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank10: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank11: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank12: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank13: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank14: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank15: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank16: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank17: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank18: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank19: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank20: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank21: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank22: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank23: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank24: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank25: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank26: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank27: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank28: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank29: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank30: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank31: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank32: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank33: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank34: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank35: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank36: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank37: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank38: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank39: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank40: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    coupler1: Bar(mass = mass, length = length),
    coupler2: Bar(mass = mass, length = length),
    coupler3: Bar(mass = mass, length = length),
    coupler4: Bar(mass = mass, length = length),
    coupler5: Bar(mass = mass, length = length),
    coupler6: Bar(mass = mass, length = length),
    coupler7: Bar(mass = mass, length = length),
    coupler8: Bar(mass = mass, length = length),
    coupler9: Bar(mass = mass, length = length),
    coupler10: Bar(mass = mass, length = length),
    coupler11: Bar(mass = mass, length = length),
    coupler12: Bar(mass = mass, length = length),
    coupler13: Bar(mass = mass, length = length),
    coupler14: Bar(mass = mass, length = length),
    coupler15: Bar(mass = mass, length = length),
    coupler16: Bar(mass = mass, length = length),
    coupler17: Bar(mass = mass, length = length),
    coupler18: Bar(mass = mass, length = length),
    coupler19: Bar(mass = mass, length = length),
    coupler20: Bar(mass = mass, length = length),
    coupler21: Bar(mass = mass, length = length),
    coupler22: Bar(mass = mass, length = length),
    coupler23: Bar(mass = mass, length = length),
    coupler24: Bar(mass = mass, length = length),
    coupler25: Bar(mass = mass, length = length),
    coupler26: Bar(mass = mass, length = length),
    coupler27: Bar(mass = mass, length = length),
    coupler28: Bar(mass = mass, length = length),
    coupler29: Bar(mass = mass, length = length),
    coupler30: Bar(mass = mass, length = length),
    coupler31: Bar(mass = mass, length = length),
    coupler32: Bar(mass = mass, length = length),
    coupler33: Bar(mass = mass, length = length),
    coupler34: Bar(mass = mass, length = length),
    coupler35: Bar(mass = mass, length = length),
    coupler36: Bar(mass = mass, length = length),
    coupler37: Bar(mass = mass, length = length),
    coupler38: Bar(mass = mass, length = length),
    coupler39: Bar(mass = mass, length = length),
    coupler40: Bar(mass = mass, length = length),

    bearing0: Revolute(ground.origin, crank0.a),
    bearing1: Revolute(ground.point(1.0 * length, 0.0), crank1.a),
    bearing2: Revolute(ground.point(2.0 * length, 0.0), crank2.a),
    bearing3: Revolute(ground.point(3.0 * length, 0.0), crank3.a),
    bearing4: Revolute(ground.point(4.0 * length, 0.0), crank4.a),
    bearing5: Revolute(ground.point(5.0 * length, 0.0), crank5.a),
    bearing6: Revolute(ground.point(6.0 * length, 0.0), crank6.a),
    bearing7: Revolute(ground.point(7.0 * length, 0.0), crank7.a),
    bearing8: Revolute(ground.point(8.0 * length, 0.0), crank8.a),
    bearing9: Revolute(ground.point(9.0 * length, 0.0), crank9.a),
    bearing10: Revolute(ground.point(10.0 * length, 0.0), crank10.a),
    bearing11: Revolute(ground.point(11.0 * length, 0.0), crank11.a),
    bearing12: Revolute(ground.point(12.0 * length, 0.0), crank12.a),
    bearing13: Revolute(ground.point(13.0 * length, 0.0), crank13.a),
    bearing14: Revolute(ground.point(14.0 * length, 0.0), crank14.a),
    bearing15: Revolute(ground.point(15.0 * length, 0.0), crank15.a),
    bearing16: Revolute(ground.point(16.0 * length, 0.0), crank16.a),
    bearing17: Revolute(ground.point(17.0 * length, 0.0), crank17.a),
    bearing18: Revolute(ground.point(18.0 * length, 0.0), crank18.a),
    bearing19: Revolute(ground.point(19.0 * length, 0.0), crank19.a),
    bearing20: Revolute(ground.point(20.0 * length, 0.0), crank20.a),
    bearing21: Revolute(ground.point(21.0 * length, 0.0), crank21.a),
    bearing22: Revolute(ground.point(22.0 * length, 0.0), crank22.a),
    bearing23: Revolute(ground.point(23.0 * length, 0.0), crank23.a),
    bearing24: Revolute(ground.point(24.0 * length, 0.0), crank24.a),
    bearing25: Revolute(ground.point(25.0 * length, 0.0), crank25.a),
    bearing26: Revolute(ground.point(26.0 * length, 0.0), crank26.a),
    bearing27: Revolute(ground.point(27.0 * length, 0.0), crank27.a),
    bearing28: Revolute(ground.point(28.0 * length, 0.0), crank28.a),
    bearing29: Revolute(ground.point(29.0 * length, 0.0), crank29.a),
    bearing30: Revolute(ground.point(30.0 * length, 0.0), crank30.a),
    bearing31: Revolute(ground.point(31.0 * length, 0.0), crank31.a),
    bearing32: Revolute(ground.point(32.0 * length, 0.0), crank32.a),
    bearing33: Revolute(ground.point(33.0 * length, 0.0), crank33.a),
    bearing34: Revolute(ground.point(34.0 * length, 0.0), crank34.a),
    bearing35: Revolute(ground.point(35.0 * length, 0.0), crank35.a),
    bearing36: Revolute(ground.point(36.0 * length, 0.0), crank36.a),
    bearing37: Revolute(ground.point(37.0 * length, 0.0), crank37.a),
    bearing38: Revolute(ground.point(38.0 * length, 0.0), crank38.a),
    bearing39: Revolute(ground.point(39.0 * length, 0.0), crank39.a),
    bearing40: Revolute(ground.point(40.0 * length, 0.0), crank40.a),
    left1: Revolute(crank0.b, coupler1.a),
    right1: Revolute(crank1.b, coupler1.b),
    left2: Revolute(crank1.b, coupler2.a),
    right2: Revolute(crank2.b, coupler2.b),
    left3: Revolute(crank2.b, coupler3.a),
    right3: Revolute(crank3.b, coupler3.b),
    left4: Revolute(crank3.b, coupler4.a),
    right4: Revolute(crank4.b, coupler4.b),
    left5: Revolute(crank4.b, coupler5.a),
    right5: Revolute(crank5.b, coupler5.b),
    left6: Revolute(crank5.b, coupler6.a),
    right6: Revolute(crank6.b, coupler6.b),
    left7: Revolute(crank6.b, coupler7.a),
    right7: Revolute(crank7.b, coupler7.b),
    left8: Revolute(crank7.b, coupler8.a),
    right8: Revolute(crank8.b, coupler8.b),
    left9: Revolute(crank8.b, coupler9.a),
    right9: Revolute(crank9.b, coupler9.b),
    left10: Revolute(crank9.b, coupler10.a),
    right10: Revolute(crank10.b, coupler10.b),
    left11: Revolute(crank10.b, coupler11.a),
    right11: Revolute(crank11.b, coupler11.b),
    left12: Revolute(crank11.b, coupler12.a),
    right12: Revolute(crank12.b, coupler12.b),
    left13: Revolute(crank12.b, coupler13.a),
    right13: Revolute(crank13.b, coupler13.b),
    left14: Revolute(crank13.b, coupler14.a),
    right14: Revolute(crank14.b, coupler14.b),
    left15: Revolute(crank14.b, coupler15.a),
    right15: Revolute(crank15.b, coupler15.b),
    left16: Revolute(crank15.b, coupler16.a),
    right16: Revolute(crank16.b, coupler16.b),
    left17: Revolute(crank16.b, coupler17.a),
    right17: Revolute(crank17.b, coupler17.b),
    left18: Revolute(crank17.b, coupler18.a),
    right18: Revolute(crank18.b, coupler18.b),
    left19: Revolute(crank18.b, coupler19.a),
    right19: Revolute(crank19.b, coupler19.b),
    left20: Revolute(crank19.b, coupler20.a),
    right20: Revolute(crank20.b, coupler20.b),
    left21: Revolute(crank20.b, coupler21.a),
    right21: Revolute(crank21.b, coupler21.b),
    left22: Revolute(crank21.b, coupler22.a),
    right22: Revolute(crank22.b, coupler22.b),
    left23: Revolute(crank22.b, coupler23.a),
    right23: Revolute(crank23.b, coupler23.b),
    left24: Revolute(crank23.b, coupler24.a),
    right24: Revolute(crank24.b, coupler24.b),
    left25: Revolute(crank24.b, coupler25.a),
    right25: Revolute(crank25.b, coupler25.b),
    left26: Revolute(crank25.b, coupler26.a),
    right26: Revolute(crank26.b, coupler26.b),
    left27: Revolute(crank26.b, coupler27.a),
    right27: Revolute(crank27.b, coupler27.b),
    left28: Revolute(crank27.b, coupler28.a),
    right28: Revolute(crank28.b, coupler28.b),
    left29: Revolute(crank28.b, coupler29.a),
    right29: Revolute(crank29.b, coupler29.b),
    left30: Revolute(crank29.b, coupler30.a),
    right30: Revolute(crank30.b, coupler30.b),
    left31: Revolute(crank30.b, coupler31.a),
    right31: Revolute(crank31.b, coupler31.b),
    left32: Revolute(crank31.b, coupler32.a),
    right32: Revolute(crank32.b, coupler32.b),
    left33: Revolute(crank32.b, coupler33.a),
    right33: Revolute(crank33.b, coupler33.b),
    left34: Revolute(crank33.b, coupler34.a),
    right34: Revolute(crank34.b, coupler34.b),
    left35: Revolute(crank34.b, coupler35.a),
    right35: Revolute(crank35.b, coupler35.b),
    left36: Revolute(crank35.b, coupler36.a),
    right36: Revolute(crank36.b, coupler36.b),
    left37: Revolute(crank36.b, coupler37.a),
    right37: Revolute(crank37.b, coupler37.b),
    left38: Revolute(crank37.b, coupler38.a),
    right38: Revolute(crank38.b, coupler38.b),
    left39: Revolute(crank38.b, coupler39.a),
    right39: Revolute(crank39.b, coupler39.b),
    left40: Revolute(crank39.b, coupler40.a),
    right40: Revolute(crank40.b, coupler40.b),

    b0: Output(crank0.b),
    b0_velocity: Output(crank0.b.velocity),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "four-bar-40",
    title: "Forty four-bar loops in a row",
    source: "LIM benchmark A02, N = 40",
    model: FourBar40::MODEL,
    duration: 20.0,
    step: 1e-2,
    reference: Some(Reference {
        file: "a02_four_bar_n40_lim.csv",
        columns: &[
            ("b0.x", "b0x_m"),
            ("b0.y", "b0y_m"),
            ("b0_velocity.x", "b0vx_m_per_s"),
            ("b0_velocity.y", "b0vy_m_per_s"),
        ],
    }),
    build: crate::build_scene!(FourBar40),
};
