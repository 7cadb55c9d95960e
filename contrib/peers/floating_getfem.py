# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three layers, the middle one held by contact alone (contrib/peers/floating.prm), for GetFEM.

    floating_getfem.py degree=3 cells=16 stages=2 [output=FILE.npz]

As layers_getfem.py. The middle layer's grid is fine towards both of its contact sides; Newton begins on the first grid with
half the approach for this layer, so that it touches both neighbours: without contact its matrix is singular.
"""
import getfem as gf
import numpy as np

from getfem_contact import BOTTOM, LEFT, RIGHT, TOP, ContactModel, mark_sides, options_of_command_line, solve_in_stages
from grading import graded

LENGTH = 4.0
STEEL = (2.1e5, 0.3)
APPROACH, CURVATURE = 1.366e-3, 1e-3  # the approach of each contact
ENDS = [(LEFT, 0), (RIGHT, 0)]
GAP = "%g*X(1)*X(1)" % CURVATURE


def layer(rows, columns):
    mesh = gf.Mesh("cartesian", columns, rows)
    mark_sides(mesh)
    return mesh


def layers(degree, cells, edge):
    x, depth = graded(LENGTH, edge, cells), graded(1.0, 0.0, max(2, cells // 3))
    upper, lower = layer(3 + depth, x), layer((1 - depth)[::-1].copy(), x)
    middle = layer(np.concatenate([1 + depth, (3 - depth)[-2::-1]]), x)
    bodies = [(upper, STEEL, ENDS + [(TOP, 1)]), (middle, STEEL, ENDS), (lower, STEEL, ENDS + [(BOTTOM, 1)])]
    model = ContactModel(degree, bodies, [(3, GAP), (1, GAP)], 2 * APPROACH)
    model.move(2, -APPROACH)
    return model


options = options_of_command_line(degree="2", cells="16", stages="2", output="")
model = solve_in_stages(lambda cells, edge: layers(int(options["degree"]), cells, edge), int(options["cells"]),
                        int(options["stages"]), edge=1.0)
if options["output"]:
    model.save(options["output"])
