# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact solution under a rigid flat punch, prm/flat-punch.prm: Westergaard's form [Westergaard1939] in [Johnson1985, sec. 2.8].

With z = x + i d, d the depth below the top, and G = i P / (pi sqrt(z^2 - a^2)), H its integral:
    xx = -(Re G - d Im G'),  yy = -(Re G + d Im G'),  xy = -d Re G',
    2 mu u_x = -((1 - 2 nu) Re H - d Im G),  2 mu u_y = 2 (1 - nu) Im H - d Re G,
u_x zero on the axis; u_y has a constant that is free. cm, MPa.
"""
import numpy as np

HALF_WIDTH, FORCE = 0.5, 100.0
YOUNG, POISSON = 2.1e5, 0.3
MU = YOUNG / 2 / (1 + POISSON)


def functions(x, y):
    depth = 1 - np.asarray(y, dtype=float)
    z = x + 1j * depth
    root = np.sqrt(z - HALF_WIDTH) * np.sqrt(z + HALF_WIDTH)
    g = 1j * FORCE / np.pi / root
    return depth, g, -g * z / root**2, 1j * FORCE / np.pi * np.log(z + root) + FORCE / 2


def stress(x, y):
    depth, g, derivative, _ = functions(x, y)
    return -(g.real - depth * derivative.imag), -(g.real + depth * derivative.imag), -depth * derivative.real


def displacement(x, y):
    depth, g, _, integral = functions(x, y)
    return (-((1 - 2 * POISSON) * integral.real - depth * g.imag) / (2 * MU),
            (2 * (1 - POISSON) * integral.imag - depth * g.real) / (2 * MU))


def pressure(x):
    return np.where(x < HALF_WIDTH, FORCE / (np.pi * np.sqrt(np.abs(HALF_WIDTH**2 - x**2))), 0)


if __name__ == "__main__":
    h, x, y = 1e-5, np.array([0.2, 0.6, 0.9]), np.array([0.7, 0.95, 0.1])
    ux_x = (displacement(x + h, y)[0] - displacement(x - h, y)[0]) / (2 * h)
    ux_y = (displacement(x, y + h)[0] - displacement(x, y - h)[0]) / (2 * h)
    uy_x = (displacement(x + h, y)[1] - displacement(x - h, y)[1]) / (2 * h)
    uy_y = (displacement(x, y + h)[1] - displacement(x, y - h)[1]) / (2 * h)
    lame = YOUNG * POISSON / (1 + POISSON) / (1 - 2 * POISSON)
    of_strain = (lame * (ux_x + uy_y) + 2 * MU * ux_x, lame * (ux_x + uy_y) + 2 * MU * uy_y, MU * (ux_y + uy_x))
    print("stress and Hooke's law of the displacement differ by at most %.1e MPa"
          % np.abs(np.array(stress(x, y)) - np.array(of_strain)).max())
