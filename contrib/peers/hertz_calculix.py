# SPDX-License-Identifier: LGPL-2.1-or-later
"""A roller on a block (contrib/peers/hertz.prm) for CalculiX: writes FILE.inp.

    hertz_calculix.py FILE element=CPE8R cells=24 stiffness=1e8 contact=penalty smallest=0.003 overlap=2e-4

Grids like those of hertz_getfem.py, but cells at the given end of contact as small as `smallest` says, in half-widths. The roller's far side moves as one (equations) and carries the force;
in the beginning the roller overlaps the block by `overlap`, for without contact nothing holds it. Contact: surface to surface
with a linear penalty (MPa/cm).
"""
import sys

import numpy as np

from calculix_stack import Stack, node_set, step, write
from grading import graded
from hertz_reference import BLOCK, HALF_FORCE, HALF_WIDTH, RADIUS, ROLLER


def make_stack(element, cells, smallest, overlap):
    columns = graded(0.8, HALF_WIDTH, cells, power=1.0, smallest=smallest * HALF_WIDTH, floor=0.3)
    depth = graded(1.0, 0.0, max(3, cells // 2), power=1.0, smallest=2 * smallest * HALF_WIDTH, floor=0.3)

    def place(body, x, y):
        return x, y + body * ((RADIUS - np.sqrt(RADIUS**2 - x**2)) * (2 - y) - overlap)

    return Stack(element, [(np.append(columns, [0.9, 1.0]), (1 - depth)[::-1]), (columns, 1 + depth)], place)


def deck(stack, contact, stiffness):
    yield from stack.mesh((BLOCK, ROLLER))
    yield from node_set("AXIS", stack.column(0, 0) + stack.column(1, 0))
    yield from node_set("BOTTOM", stack.row(0, 0))
    carrier, *others = stack.row(1, -1)
    for node in others:
        yield "*EQUATION\n2\n%d, 2, 1., %d, 2, -1." % (node, carrier)
    yield from stack.contact(contact, stiffness)
    yield "*BOUNDARY\nAXIS, 1, 1\nBOTTOM, 2, 2"
    yield from step(["*CLOAD\n%d, 2, %.10g" % (carrier, -HALF_FORCE)], measured=0)


def main():
    options = dict(element="CPE8R", cells="24", contact="penalty", stiffness="1e8", smallest="0.003", overlap="2e-4")
    options.update(word.split("=") for word in sys.argv[2:])
    numbers = (float(options[name]) for name in ("smallest", "overlap"))
    stack = make_stack(options["element"], int(options["cells"]), *numbers)
    write(sys.argv[1], stack, 0, deck(stack, options["contact"], float(options["stiffness"])))


main()
