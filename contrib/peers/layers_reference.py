# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact solution of two layers with roller ends, prm/two-layers-rollers.prm.

Rollers continue each layer periodically, so that a pressure p = p_0 + sum p_n cos(l_n x), l_n = n pi / length, moves its
surface by
    w_n = 2 (1 - nu^2) / E  p_n L(l_n H) / l_n,   L(t) = (cosh 2t - 1) / (sinh 2t + 2t),
    w_0 = p_0 H (1 + nu) (1 - 2 nu) / (E (1 - nu)).
With p = sum c_j sin((2j + 1) arccos(x/a)) on [0, a] the condition 2 w = approach - curvature x^2 becomes a small linear
system, its logarithmic kernel integrated exactly; a is where approach comes out as it is given. cm, MPa.
Written for this comparison, independently of source/reference of abut.
"""
import numpy as np
from scipy.interpolate import RectBivariateSpline
from scipy.optimize import brentq
from scipy.special import jv

LENGTH, HEIGHT = 4.0, 1.0
YOUNG, POISSON = 2.1e5, 0.3
APPROACH, CURVATURE = 1.366e-3, 1e-3
SLOPE = 2 * (1 - POISSON**2) / YOUNG
UNIFORM = HEIGHT * (1 + POISSON) * (1 - 2 * POISSON) / (YOUNG * (1 - POISSON))
TERMS = 32


def layer_factor(t):
    e = np.exp(-2 * t)
    return (0.5 * (1 + e * e) - e) / (0.5 * (1 - e * e) + 2 * t * e)


def smooth_kernel(a, t):
    """The displacement at distance t from a unit load, without its part -SLOPE/pi log|t/a|."""
    z = np.pi * t / (2 * LENGTH)
    kernel = SLOPE / np.pi * (-np.log(np.abs(np.sinc(z / np.pi))) - np.log(np.pi / LENGTH) - np.log(a))
    for n in range(1, 200):
        wave = n * np.pi / LENGTH
        kernel += SLOPE / LENGTH * (layer_factor(wave * HEIGHT) - 1) / wave * np.cos(wave * t)
    return kernel + UNIFORM / (2 * LENGTH)


def solve(a):
    """Coefficients c and the approach of a contact of half-width a whose pressure ends with zero."""
    n, m = TERMS, 4 * TERMS + 60
    j = np.arange(1, m + 1)
    angle = j * np.pi / (m + 1)
    weight = np.pi / (m + 1) * np.sin(angle)**2
    place = np.cos((2 * np.arange(1, n + 2) - 1) * np.pi / (4 * (n + 1)))
    kernel = smooth_kernel(a, a * (place[:, None] - np.cos(angle)[None, :]))
    matrix = np.zeros((n + 1, n + 1))
    for c in range(n):
        chebyshev = lambda k: np.cos(k * np.arccos(place))
        first = -np.pi * np.log(2) if c == 0 else -np.pi / (2 * c) * chebyshev(2 * c)
        second = -np.pi / (2 * c + 2) * chebyshev(2 * c + 2)
        basis = np.sin((2 * c + 1) * angle) / np.sin(angle)
        matrix[:, c] = 2 * YOUNG * a * (-SLOPE / (2 * np.pi) * (first - second) + kernel @ (weight * basis))
    matrix[:, n] = -1
    x = np.linalg.solve(matrix, -CURVATURE * (a * place)**2)
    return YOUNG * x[:n], x[n]


class LayersReference:
    def __init__(self):
        self.half_width = brentq(lambda a: solve(a)[1] - APPROACH, 0.05, 2.5, xtol=1e-15, rtol=1e-14)
        self.c = solve(self.half_width)[0]
        self.splines = None
        self.waves = self.pressure_waves(1 << 15)

    def pressure(self, x):
        angle = np.arccos(np.clip(np.abs(x) / self.half_width, 0, 1))
        return sum(c * np.sin((2 * j + 1) * angle) for j, c in enumerate(self.c))

    def force(self):
        return 0.25 * np.pi * self.half_width * self.c[0]

    def pressure_waves(self, n):
        """p_0, ..., p_(n-1)."""
        z = np.arange(1, n) * np.pi / LENGTH * self.half_width
        j = np.arange(TERMS)
        modes = np.pi * self.half_width * (-1.0)**j * (2 * j + 1) * jv(2 * j + 1, z[:, None]) / z[:, None]
        return np.concatenate([[self.force() / LENGTH], modes @ self.c / LENGTH])

    @staticmethod
    def depth_factors(wave, y):
        """Amplitudes of xx, yy (cosines) and xy (sine) at the height y for a unit amplitude of pressure."""
        u, v = wave * HEIGHT, wave * y
        up, down = np.exp(v - u), np.exp(-v - u)
        determinant = 0.25 * (1 - np.exp(-4 * u)) + u * np.exp(-2 * u)
        sinh_u, cosh_u = 0.5 * (1 - np.exp(-2 * u)), 0.5 * (1 + np.exp(-2 * u))
        first, second = (sinh_u + u * cosh_u) / determinant, -sinh_u / determinant
        cosh_v, sinh_v = 0.5 * (up + down), 0.5 * (up - down)
        return (first * cosh_v + second * (2 * cosh_v + v * sinh_v), -(first * cosh_v + second * v * sinh_v),
                first * sinh_v + second * (sinh_v + v * cosh_v))

    def stress_table(self, x, y):
        """xx, yy, xy on the grid of x and y, by summation."""
        p = self.waves
        wave = np.arange(1, len(p)) * np.pi / LENGTH
        phase = np.multiply.outer(wave, x)
        cosine, sine = np.cos(phase), np.sin(phase)
        table = np.zeros((3, len(y), len(x)))
        table[0] -= POISSON / (1 - POISSON) * p[0]
        table[1] -= p[0]
        for row, height in enumerate(y):
            depth = HEIGHT - height
            n = int(min(len(p), max(64, 40 / max(depth * np.pi / LENGTH, 1e-9))))  # nothing is left of what is below e^-40
            xx, yy, xy = self.depth_factors(wave[:n - 1], height)
            table[0, row] += (p[1:n] * xx) @ cosine[:n - 1]
            table[1, row] += (p[1:n] * yy) @ cosine[:n - 1]
            table[2, row] += (p[1:n] * xy) @ sine[:n - 1]
        return table

    def stress(self, x, y):
        """xx, yy, xy at scattered points of the lower layer: splines in the cube roots of the distances to the end of
        contact, in which the stress, like a square root there, is smooth."""
        if self.splines is None:
            a = self.half_width
            s = np.linspace(-np.cbrt(a), np.cbrt(LENGTH - a), 501)
            t = np.linspace(0, 1, 251)
            table = self.stress_table(np.clip(a + s**3, 0, LENGTH), HEIGHT - t**3)
            self.splines = [RectBivariateSpline(t, s, component) for component in table]
        depth, distance = np.cbrt(np.clip(HEIGHT - y, 0, HEIGHT)), np.cbrt(x - self.half_width)
        return [spline.ev(depth, distance) for spline in self.splines]


if __name__ == "__main__":
    r = LayersReference()
    print("half-width %.8f cm, p(0) %.6f MPa, force %.6f MPa cm" % (r.half_width, r.pressure(0.0), r.force()))
    random = np.random.default_rng(1)
    x, y = random.uniform(0, LENGTH, 300), HEIGHT - random.uniform(0, 1, 300)**3
    x[::2] = r.half_width + 0.2 * random.uniform(-1, 1, 150)**3
    table = np.array(r.stress(x, y))
    series = np.array([r.stress_table(x[i:i + 1], y[i:i + 1])[:, 0, 0] for i in range(300)]).T
    print("stress from splines and by summation differ by at most %.1e MPa" % np.abs(table - series).max())
