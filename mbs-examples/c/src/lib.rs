//! A slider-crank with a motor, for programs in C: `slider_crank.h` declares its functions.

mbs_runtime::mechanism!(SliderCrank {
    doc: "A crank that a motor turns, and a rod that slides.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// From the bearing to the pin.
    crank_length: Param(0.15_m),
    /// From the pin to the slider.
    rod_length: Param(0.4_m),

    /// On the crank.
    motor_torque: Input(unit = Nm),

    crank: Bar(
        mass = 1.0_kg,
        length = crank_length,
        angle = 60.0_deg,
        rate = 10.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = rod_length, angle = -20.0_deg),

    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.origin, axis = X),

    motor: Torque(on = crank, value = motor_torque),

    /// Of the slider.
    stroke: Output(rod.b.x),
    /// Of the crank.
    speed: Output(crank.rate),
});

mbs_runtime::c_library!(slider_crank: SliderCrank);
