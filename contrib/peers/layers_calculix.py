# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers with roller ends for CalculiX: two (prm/two-layers-rollers.prm), or three, the middle one held by contact alone
(contrib/peers/floating.prm). Writes FILE.inp.

    layers_calculix.py FILE element=CPE8R cells=16 stiffness=1e9 contact=penalty layers=2 overlap=0.5

Grids become finer towards the end of contact and match; the measured layer, the last but one, has straight sides, its
neighbours curved ones. Contact: surface to surface with a linear penalty (MPa/cm), or mortar. `overlap` is the part of the
approach by which the layers overlap to begin with: it saves increments, and contact holds the middle layer from the first
iteration on, without a spring.
"""
import sys

import numpy as np

from calculix_stack import Stack, node_set, step, write
from grading import graded

LENGTH = 4.0
STEEL, APPROACH, CURVATURE = (2.1e5, 0.3), 1.366e-3, 1e-3  # the approach of each contact
END_OF_CONTACT = 1.015  # from a run on a coarse grid


def make_stack(element, cells, layers, overlap):
    x, depth = graded(LENGTH, END_OF_CONTACT, cells), graded(1.0, 0.0, max(2, cells // 3))
    rows = [(1 - depth)[::-1], 1 + depth]
    if layers == 3:
        rows[1:] = [np.concatenate([1 + depth, (3 - depth)[-2::-1]]), 3 + depth]
    measured, top = layers - 2, rows[-1][-1]

    def place(layer, x, y):
        if layer != measured:
            y += CURVATURE * x**2 * (-y if layer < measured else top - y)
        return x, y - layer * overlap * APPROACH

    return Stack(element, [(x, y) for y in rows], place), measured


def deck(stack, measured, contact, stiffness, rest):
    layers = range(len(stack.bodies))
    yield from stack.mesh([STEEL for _ in layers])
    yield from node_set("ENDS", [node for layer in layers for i in (0, -1) for node in stack.column(layer, i)])
    yield from node_set("BOTTOM", stack.row(0, 0))
    yield from node_set("TOP", stack.row(layers[-1], -1))
    yield from stack.contact(contact, stiffness)
    yield "*BOUNDARY\nENDS, 1, 1\nBOTTOM, 2, 2"
    yield from step(["*BOUNDARY\nTOP, 2, 2, %.10g" % -rest], measured)


def main():
    options = dict(element="CPE8R", cells="16", contact="penalty", stiffness="1e9", layers="2", overlap="0.5")
    options.update(word.split("=") for word in sys.argv[2:])
    layers, overlap = int(options["layers"]), float(options["overlap"])
    stack, measured = make_stack(options["element"], int(options["cells"]), layers, overlap)
    rest = (layers - 1) * APPROACH * (1 - overlap)
    write(sys.argv[1], stack, measured, deck(stack, measured, options["contact"], float(options["stiffness"]), rest))


main()
