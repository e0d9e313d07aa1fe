"""Thins the reference tables: every k-th row and the columns that tests compare.

python3 thin.py <directory of the full tables>
"""
import csv
import pathlib
import sys

# table: (every, last time, columns)
TABLES = {
    "a01_pendulum_10s": (5, 10.0, "x_m y_m vx_m_per_s vy_m_per_s bar_tension_N"),
    "a02_four_bar_n2": (5, 10.0, "b0x_m b0y_m b0vx_m_per_s b0vy_m_per_s"),
    "a02_four_bar_n40_lim": (4, 20.0, "b0x_m b0y_m b0vx_m_per_s b0vy_m_per_s"),
    "a03_andrews_bari": (
        4,
        0.05,
        "beta_rad theta_rad gamma_rad phi_rad delta_rad omega_rad epsilon_rad fx_m fy_m"
        " lambda1_N lambda2_N lambda3_N lambda4_N lambda5_N lambda6_N",
    ),
    "a03_andrews_iftomm": (
        4,
        0.05,
        "beta_rad theta_rad gamma_rad phi_rad delta_rad omega_rad epsilon_rad fx_m fy_m",
    ),
    "a04_bricard_slender_rods": (5, 10.0, "p3x_m p3y_m p3z_m p2x_m p2z_m p5y_m"),
    "a04_bricard_square_rods": (5, 10.0, "p3x_m p3y_m p3z_m p2x_m p2z_m p5y_m"),
    "a05_flyball_governor": (
        5,
        10.0,
        "s_m ball1_x_m ball1_y_m ball1_z_m shaft_angle_rad shaft_omega_rad_per_s",
    ),
    "chaplygin_sleigh": (
        5,
        10.0,
        "edge_x_m edge_y_m theta_rad omega_rad_per_s forward_v_m_per_s lateral_force_N",
    ),
    "driven_slider_crank": (
        4,
        0.1,
        "slider_x_m slider_vx_m_per_s phi_rad drive_torque_on_crank_Nm ground_on_crank_fx_N"
        " ground_on_crank_fy_N crank_on_rod_fx_N crank_on_rod_fy_N rod_on_slider_fx_N rod_on_slider_fy_N"
        " guide_on_slider_fy_N",
    ),
    "heavy_top": (
        5,
        2.0,
        "x_m y_m z_m angular_momentum_z_kgm2_per_s pivot_force_on_top_x_N"
        " pivot_force_on_top_y_N pivot_force_on_top_z_N",
    ),
    "knife_edge_incline": (5, 10.0, "x_m y_m phi_rad forward_v_m_per_s lateral_force_N"),
    "knife_edge_incline_moving_start": (
        5,
        10.0,
        "x_m y_m phi_rad forward_v_m_per_s lateral_force_N",
    ),
    "rolling_disk": (
        5,
        10.0,
        "cx_m cy_m cz_m contact_x_m contact_y_m contact_force_x_N contact_force_y_N contact_force_z_N",
    ),
    "rolling_disk_tilted": (
        5,
        2.0,
        "cx_m cy_m cz_m contact_x_m contact_y_m contact_force_x_N contact_force_y_N contact_force_z_N",
    ),
    "slider_crank_singular_gravity": (
        5,
        10.0,
        "theta_rad p1x_m p1y_m p2x_m ground_on_rod1_fx_N ground_on_rod1_fy_N rod1_on_rod2_at_p1_fx_N"
        " rod1_on_rod2_at_p1_fy_N guide_on_slider_fy_N",
    ),
}

source = pathlib.Path(sys.argv[1])
for name, (every, last, columns) in TABLES.items():
    columns = ["time_s", *columns.split()]
    with open(source / f"{name}.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    with open(pathlib.Path(__file__).parent / f"{name}.csv", "w") as out:
        out.write(",".join(columns) + "\n")
        for row in rows[::every]:
            if float(row["time_s"]) <= last:
                # The shortest text that reads back as the same number.
                out.write(",".join(repr(float(row[column])) for column in columns) + "\n")
