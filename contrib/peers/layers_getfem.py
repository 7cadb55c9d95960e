# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two layers with roller ends (prm/two-layers-rollers.prm) for GetFEM.

    layers_getfem.py degree=3 cells=16 stages=2 [output=FILE.npz]

Quadrilaterals of any degree on a tensor grid that becomes finer towards the end of contact, augmented Lagrangian with a
multiplier of the same degree on the contact side, Newton, MUMPS. Rollers are eliminated. The first stages, on coarser
grids, find the end of contact that the last grid is graded towards; Newton begins with what they found.
"""
import getfem as gf

from getfem_contact import BOTTOM, LEFT, RIGHT, TOP, ContactModel, mark_sides, options_of_command_line, solve_in_stages
from grading import graded

LENGTH = 4.0
STEEL = (2.1e5, 0.3)
APPROACH, CURVATURE = 1.366e-3, 1e-3
ENDS = [(LEFT, 0), (RIGHT, 0)]


def layers(degree, cells, edge):
    x, depth = graded(LENGTH, edge, cells), graded(1.0, 0.0, max(2, cells // 3))
    upper = gf.Mesh("cartesian", x, 1 + depth)
    lower = gf.Mesh("cartesian", x, (1 - depth)[::-1].copy())
    mark_sides(upper)
    mark_sides(lower)
    bodies = [(upper, STEEL, ENDS + [(TOP, 1)]), (lower, STEEL, ENDS + [(BOTTOM, 1)])]
    return ContactModel(degree, bodies, [(1, "%g*X(1)*X(1)" % CURVATURE)], APPROACH)


options = options_of_command_line(degree="2", cells="16", stages="2", output="")
model = solve_in_stages(lambda cells, edge: layers(int(options["degree"]), cells, edge), int(options["cells"]),
                        int(options["stages"]), edge=1.0)
if options["output"]:
    model.save(options["output"])
