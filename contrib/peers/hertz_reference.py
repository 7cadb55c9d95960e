# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hertz's line contact of half-planes, for contrib/peers/hertz.prm. cm, MPa."""
import numpy as np

RADIUS, HALF_FORCE = 1.0, 0.0826735
ROLLER, BLOCK = (5.2e3, 0.3), (2.8e3, 0.4)  # Young's moduli and Poisson's ratios
STIFFNESS = 1 / sum((1 - nu**2) / young for young, nu in (ROLLER, BLOCK))
HALF_WIDTH = np.sqrt(4 * 2 * HALF_FORCE * RADIUS / (np.pi * STIFFNESS))
PEAK = 2 * 2 * HALF_FORCE / (np.pi * HALF_WIDTH)


def pressure(x):
    return PEAK * np.sqrt(np.clip(1 - (x / HALF_WIDTH)**2, 0, None))
