# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grids by hand: finer towards one place."""
import numpy as np


def graded(length, place, cells, power=0.8, smallest=3e-3, floor=0.5):
    """Ends of cells on [0, length], whose density falls like (smallest + distance to place)^-power, but not to zero."""
    around = np.concatenate([place + sign * np.geomspace(1e-9, length, 2000) for sign in (-1, 1)])
    x = np.unique(np.clip(np.concatenate([around, [0, length]]), 0, length))
    density = 1 / (smallest + np.abs((x[1:] + x[:-1]) / 2 - place))**power + floor
    total = np.concatenate([[0], np.cumsum(density * np.diff(x))])
    return np.interp(np.linspace(0, total[-1], cells + 1), total, x)


def around(length, place, cells, smallest, floor=1.0):
    """Geometric grids about a place that becomes a node: along a line, 2 * cells, and down to the depth `length`."""
    left = graded(place, 0, cells, 1.0, smallest, floor)
    right = graded(length - place, 0, cells, 1.0, smallest, floor)
    return np.concatenate([place - left[::-1], place + right[1:]]), graded(length, 0, cells, 1.0, smallest, floor)


def with_middles(x):
    """The ends of cells and their middles."""
    both = np.empty(2 * len(x) - 1)
    both[::2], both[1::2] = x, (x[1:] + x[:-1]) / 2
    return both
