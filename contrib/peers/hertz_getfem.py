# SPDX-License-Identifier: LGPL-2.1-or-later
"""A roller on a block (contrib/peers/hertz.prm) for GetFEM.

    hertz_getfem.py degree=3 cells=16 [output=FILE.npz]

As layers_getfem.py; the roller's grid is bent, and its far side carries the force.
"""
import getfem as gf
import numpy as np

from getfem_contact import BOTTOM, LEFT, TOP, ContactModel, mark_sides, options_of_command_line, solve_in_stages
from grading import graded
from hertz_reference import BLOCK, HALF_FORCE, RADIUS, ROLLER

GAP = "(1-sqrt(1-X(1)*X(1)))"


def scene(degree, cells, edge):
    columns = graded(0.8, edge, cells, power=0.9, smallest=0.1 * edge, floor=0.3)
    depth = graded(1.0, 0.0, max(3, cells // 2), power=0.9, smallest=0.2 * edge, floor=0.3)
    # in the contact the nodes of both sides match: otherwise the multiplier oscillates
    upper = gf.Mesh("cartesian", columns, 1 + depth)
    lower = gf.Mesh("cartesian", np.append(columns, [0.9, 1.0]), (1 - depth)[::-1].copy())
    x, y = upper.pts()
    upper.set_pts(np.array([x, y + (RADIUS - np.sqrt(RADIUS**2 - x**2)) * (2 - y)]))
    mark_sides(upper)
    mark_sides(lower)
    bodies = [(upper, ROLLER, [(LEFT, 0), (TOP, 1)]), (lower, BLOCK, [(LEFT, 0), (BOTTOM, 1)])]
    return ContactModel(degree, bodies, [(1, GAP)], approach=4e-4, force=HALF_FORCE)


options = options_of_command_line(degree="3", cells="16", stages="2", output="")
model = solve_in_stages(lambda cells, edge: scene(int(options["degree"]), cells, edge), int(options["cells"]),
                        int(options["stages"]), edge=0.01, warm=False)
if options["output"]:
    model.save(options["output"])
