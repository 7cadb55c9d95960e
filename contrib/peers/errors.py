# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors of a solution, by the same formulas for every program.

A solution is a dictionary of what a reader found in the files a program wrote:
    points, weights, stress    a quadrature over the body measured: (n, 2), (n), (3, n) with xx, yy, xy
    force                      normal force, optional
    pressure                   optional: pieces (start, stop, polynomial degree, values at equally spaced points), or
                               samples (x, weight, value)
"""
import numpy as np


def stress_error(solution, exact, poisson):
    """Relative, in L2 over xx, yy, zz and twice xy (plane strain)."""
    xx, yy, xy = solution["stress"]
    x, y = solution["points"].T
    exact_xx, exact_yy, exact_xy = exact(x, y)

    def square(xx, yy, xy):
        return np.sum(solution["weights"] * (xx**2 + yy**2 + (poisson * (xx + yy))**2 + 2 * xy**2))

    return np.sqrt(square(xx - exact_xx, yy - exact_yy, xy - exact_xy) / square(exact_xx, exact_yy, exact_xy))


def gauss(start, stop, n=10):
    point, weight = np.polynomial.legendre.leggauss(n)
    return (start + stop) / 2 + (stop - start) / 2 * point, (stop - start) / 2 * weight


def towards(edge, start, stop):
    """Ends of intervals that cover [start, stop] and become short towards a square root's end inside."""
    if not start < edge < stop:
        return [start, stop]
    steps = 0.2**np.arange(6)
    return [start, *(edge - (edge - start) * steps[1:]), edge, *(edge + (stop - edge) * steps[::-1])]


def lagrange(nodes, x):
    values = np.ones((len(nodes), len(x)))
    for i, node in enumerate(nodes):
        for other in np.delete(nodes, i):
            values[i] *= (x - other) / (node - other)
    return values


def piecewise(x, values, degree):
    """Pieces of a Lagrange polynomial in sorted nodes, `degree` intervals each."""
    return [(x[i], x[i + degree], degree, values[i:i + degree + 1]) for i in range(0, len(x) - 1, degree)]


def pressure_error(pressure, exact, edge):
    """Relative, in L2 over the contact side; `edge` is where the exact pressure ends."""
    wrong = total = 0.0
    if isinstance(pressure, tuple):
        x, weight, value = pressure
        wrong = np.sum(weight * (value - exact(x))**2)
    else:
        for start, stop, degree, values in pressure:
            nodes = np.linspace(start, stop, degree + 1)
            ends = towards(edge, start, stop)
            for a, b in zip(ends[:-1], ends[1:]):
                x, weight = gauss(a, b)
                wrong += np.sum(weight * (values @ lagrange(nodes, x) - exact(x))**2)
    angle, weight = gauss(0, np.pi / 2, 60)
    total = np.sum(weight * edge * np.sin(angle) * exact(edge * np.cos(angle))**2)
    return np.sqrt(wrong / total)


def pressure_of_forces(x, forces, degree):
    """Values in the sorted nodes of the piecewise polynomial whose loads on the side are the forces."""
    mass = np.zeros((len(x), len(x)))
    for i in range(0, len(x) - 1, degree):
        points, weights = gauss(x[i], x[i + degree])
        shapes = lagrange(x[i:i + degree + 1], points)
        mass[i:i + degree + 1, i:i + degree + 1] += (shapes * weights) @ shapes.T
    return np.linalg.solve(mass, forces)


def triangle_rule(corners, n):
    """Points (triangles, q, 2) and weights (triangles, q): Gauss points of the square, one side shrunk to a corner."""
    a, wa = gauss(0, 1, n)
    s, t = np.meshgrid(a, a, indexing="ij")
    first, second = (s * (1 - t)).ravel(), (s * t).ravel()
    weight = (np.multiply.outer(wa, wa) * s).ravel()
    sides = corners[:, 1:] - corners[:, :1]
    double_area = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    points = corners[:, :1] + first[None, :, None] * sides[:, :1] + second[None, :, None] * sides[:, 1:]
    return points, weight[None, :] * double_area[:, None]
