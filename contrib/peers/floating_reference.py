# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact solution of contrib/peers/floating.prm: above and below the plane y = 2, one of symmetry, that of two layers."""
import numpy as np

from layers_reference import HEIGHT, LayersReference


class FloatingReference(LayersReference):
    """The stress is that of the middle layer, which lies between y = 1 and 3."""

    def stress(self, x, y):
        below = y < 2 * HEIGHT
        xx, yy, xy = super().stress(x, np.where(below, 2 * HEIGHT - y, y - 2 * HEIGHT))
        return [xx, yy, np.where(below, -xy, xy)]
