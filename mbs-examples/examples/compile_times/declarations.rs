//! Mechanisms of any size.

use std::fmt::Write;

/// A declaration.
pub struct Declaration {
    /// What it is.
    pub name: &'static str,
    /// How many of it.
    pub size: usize,
    /// Its text.
    pub text: String,
}

/// The mechanisms of the table.
pub fn declarations() -> Vec<Declaration> {
    let of = |name, sizes: &[usize], text: fn(usize) -> String| {
        let declaration = |&size: &usize| Declaration {
            name,
            size,
            text: text(size),
        };
        sizes.iter().map(declaration).collect::<Vec<_>>()
    };
    let mut list = of("chain", &[5, 10, 20, 40], chain);
    list.extend(of("platform", &[6, 12], platform));
    list.extend(of("frame", &[2, 3, 4], frame));
    list.extend(of("loops", &[10, 40], loops));
    list.extend(of("families", &[2, 10, 40, 100, 300, 1000], families));
    list
}

/// n revolute bodies in space, one after the other.
pub fn chain(n: usize) -> String {
    let mut s = String::from("Chain { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),\n");
    for i in 0..n {
        let _ = writeln!(
            s,
            "link{i}: Body(at = [{:?}_m, 0.0, 0.0], mass = 1.0_kg, inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2, center_of_mass = [0.25_m, 0.0, 0.0]),",
            0.5 * i as f64
        );
        let axis = if i % 2 == 0 { "Y" } else { "Z" };
        if i == 0 {
            let _ = writeln!(
                s,
                "joint{i}: Revolute(ground, link{i}, at = [0.0_m, 0.0, 0.0], axis = {axis}),"
            );
        } else {
            let _ = writeln!(
                s,
                "joint{i}: Revolute(link{}.point(0.5_m, 0.0, 0.0), link{i}.point(0.0_m, 0.0, 0.0), axis = {axis}),",
                i - 1
            );
        }
    }
    s.push('}');
    s
}

/// n × n bodies in space on bushings with dampers.
pub fn frame(n: usize) -> String {
    let mut s = String::from("Frame { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),\n");
    for i in 0..n {
        for k in 0..n {
            let _ = writeln!(
                s,
                "b{i}_{k}: Body(mass = 1.0_kg, inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2, at = [{i}.0_m, {k}.0, 0.0]),"
            );
        }
    }
    let bush = |a: String, b: String, x: f64, y: f64, name: String| {
        format!(
            "{name}: Bushing({a}, {b}, at = [{x:?}_m, {y:?}, 0.0], stiffness = [1e4_N_per_m, 2e4, 3e4], damping = [10.0_N_s_per_m, 20.0, 30.0], torsion_stiffness = 100.0_Nm, torsion_damping = 1.0_N_m_s),\n"
        )
    };
    for i in 0..n {
        for k in 0..n {
            let (a, x, y) = if i == 0 {
                ("ground".to_string(), -0.5, k as f64)
            } else {
                (format!("b{}_{k}", i - 1), i as f64 - 0.5, k as f64)
            };
            s += &bush(a, format!("b{i}_{k}"), x, y, format!("h{i}_{k}"));
            let (a, x, y) = if k == 0 {
                ("ground".to_string(), i as f64, -0.5)
            } else {
                (format!("b{i}_{}", k - 1), i as f64, k as f64 - 0.5)
            };
            s += &bush(a, format!("b{i}_{k}"), x, y, format!("v{i}_{k}"));
        }
    }
    s.push('}');
    s
}

/// Four-bars in the plane, each on the last.
pub fn loops(n: usize) -> String {
    let mut s = String::from(
        "Loops { world: Planar(gravity = [0.0, -9.81_m_per_s2]),\nmass: Param(1.0_kg), length: Param(1.0_m), rate: Param(1.0_rad_per_s),\n",
    );
    for i in 0..=n {
        let _ = writeln!(
            s,
            "crank{i}: Bar(mass = mass, length = length, angle = 90.0_deg, rate = rate),\nfoot{i}: Revolute(ground.point({i}.0_m, 0.0), crank{i}.a),"
        );
        if i > 0 {
            let _ = writeln!(
                s,
                "coupler{i}: Bar(mass = mass, length = length),\nleft{i}: Revolute(crank{}.b, coupler{i}.a),\nright{i}: Revolute(coupler{i}.b, crank{i}.b),",
                i - 1
            );
        }
    }
    s.push('}');
    s
}

/// The same as families: the declaration has as many lines for any n.
pub fn families(n: usize) -> String {
    format!(
        "Loops {{ world: Planar(gravity = [0.0, -9.81_m_per_s2]),
mass: Param(1.0_kg), length: Param(1.0_m), rate: Param(1.0_rad_per_s),
crank: Each(0..={n}, |i| Bar(mass = mass, length = length, angle = 90.0_deg, rate = rate)),
foot: Each(0..={n}, |i| Revolute(ground.point(i * 1.0_m, 0.0), crank[i].a)),
coupler: Each(1..={n}, |i| Bar(mass = mass, length = length)),
left: Each(1..={n}, |i| Revolute(crank[i - 1].b, coupler[i].a)),
right: Each(1..={n}, |i| Revolute(coupler[i].b, crank[i].b)) }}"
    )
}

/// A platform on n legs, each with a universal joint, a slide and a ball.
pub fn platform(n: usize) -> String {
    let mut s = String::from(
        "Platform { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),\nplatform: Body(mass = 10.0_kg, inertia = diag(0.4, 0.4, 0.8) * 1.0_kg_m2, at = [0.0_m, 0.0, 1.0]),\n",
    );
    for i in 0..n {
        let t = 2.0 * std::f64::consts::PI * (i as f64) / n as f64;
        let (d, e) = if i % 2 == 0 { (0.1, 0.3) } else { (-0.1, -0.3) };
        let (bx, by) = (1.0 * (t + d).cos(), 1.0 * (t + d).sin());
        let (px, py) = (0.5 * (t + e).cos(), 0.5 * (t + e).sin());
        let (mx, my) = ((bx + px) / 2.0, (by + py) / 2.0);
        let along = [px - bx, py - by, 1.0];
        let dir = format!("unit([{:?}, {:?}, {:?}])", along[0], along[1], along[2]);
        let lo = [bx + along[0] / 4.0, by + along[1] / 4.0, 0.25];
        let hi = [bx + along[0] * 0.75, by + along[1] * 0.75, 0.75];
        let _ = writeln!(s, "force{i}: Input(0.0_N),
low{i}: Body(mass = 1.0_kg, inertia = diag(0.02, 0.02, 0.001) * 1.0_kg_m2, at = [{:?}_m, {:?}, {:?}]),
up{i}: Body(mass = 1.0_kg, inertia = diag(0.02, 0.02, 0.001) * 1.0_kg_m2, at = [{:?}_m, {:?}, {:?}]),
base{i}: Universal(ground, low{i}, at = [{:?}_m, {:?}, 0.0], axis = unit(cross(Z, {dir})), second_axis = unit(cross({dir}, cross(Z, {dir})))),
slide{i}: Prismatic(low{i}, up{i}, at = [{:?}_m, {:?}, 0.5], axis = {dir}),
act{i}: Force(up{i}.origin, value = force{i} * {dir}, axes = up{i}),
react{i}: Force(low{i}.origin, value = -force{i} * {dir}, axes = low{i}),
top{i}: Spherical(up{i}, platform, at = [{:?}_m, {:?}, 1.0]),", lo[0], lo[1], lo[2], hi[0], hi[1], hi[2], bx, by, mx, my, px, py);
    }
    s.push('}');
    s
}
