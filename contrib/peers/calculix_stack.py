# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies one on the other for CalculiX: quadrilaterals, CPE4 or CPE8R, on tensor grids, and contact between neighbours."""
import numpy as np

from grading import with_middles

KINDS = {"penalty": "SURFACE TO SURFACE", "node": "NODE TO SURFACE", "mortar": "MORTAR", "linmortar": "LINMORTAR"}


class Stack:
    """Of bodies (x, y), the lowest first, their ends of cells, and place(body, x, y), where a node of the grid stands. Nodes
    are counted over all places of a grid with middles; cell middles stay unused."""

    def __init__(self, element, bodies, place):
        self.element, self.bodies, self.place = element, bodies, place
        self.step = 2 if element.startswith("CPE8") else 1
        refine = with_middles if self.step == 2 else np.array
        self.grids = [(refine(x), refine(y)) for x, y in bodies]
        self.first_node = 1 + np.cumsum([0, *[len(x) * len(y) for x, y in self.grids]])
        self.first_element = 1 + np.cumsum([0, *[(len(x) - 1) * (len(y) - 1) for x, y in bodies]])

    def node(self, body, i, j):
        return self.first_node[body] + i * len(self.grids[body][1]) + j

    def elements(self, body):
        corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
        middles = [(0.5, 0), (1, 0.5), (0.5, 1), (0, 0.5)] if self.step == 2 else []
        number = self.first_element[body]
        for i in range(len(self.bodies[body][0]) - 1):
            for j in range(len(self.bodies[body][1]) - 1):
                yield number, [self.node(body, int(self.step * (i + a)), int(self.step * (j + b)))
                               for a, b in corners + middles]
                number += 1

    def row(self, body, j):
        """Nodes along x, row 0 or -1."""
        columns, rows = self.grids[body]
        return [self.node(body, i, j % len(rows)) for i in range(len(columns))]

    def column(self, body, i):
        columns, rows = self.grids[body]
        return [self.node(body, i % len(columns), j) for j in range(len(rows))]

    def faces(self, body, top):
        """Elements along the lowest or the uppermost row, and the number of their face there."""
        columns, rows = (len(ends) - 1 for ends in self.bodies[body])
        first = self.first_element[body] + (rows - 1 if top else 0)
        return ["%d, S%d" % (first + i * rows, 3 if top else 1) for i in range(columns)]

    def mesh(self, materials):
        """Lines that define nodes, elements LAYER0, ... and materials (Young's modulus, Poisson's ratio)."""
        yield "*NODE, NSET=ALL"
        for body, (columns, rows) in enumerate(self.grids):
            for i, x in enumerate(columns):
                for j, y in enumerate(rows):
                    if self.step == 1 or i % 2 == 0 or j % 2 == 0:
                        yield "%d, %.17g, %.17g, 0." % (self.node(body, i, j), *self.place(body, x, y))
        for body, material in enumerate(materials):
            yield "*ELEMENT, TYPE=%s, ELSET=LAYER%d" % (self.element, body)
            for number, nodes in self.elements(body):
                yield "%d, %s" % (number, ", ".join(map(str, nodes)))
            yield "*MATERIAL, NAME=MATERIAL%d\n*ELASTIC\n%g, %g" % (body, *material)
            yield "*SOLID SECTION, ELSET=LAYER%d, MATERIAL=MATERIAL%d\n1." % (body, body)

    def contact(self, kind, stiffness):
        yield "*SURFACE INTERACTION, NAME=TOUCH"
        yield ("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD" if "mortar" in kind else
               "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n%g" % stiffness)
        for below in range(len(self.bodies) - 1):
            yield "*SURFACE, NAME=SLAVE%d, TYPE=ELEMENT" % below
            yield from self.faces(below + 1, top=False)
            yield "*SURFACE, NAME=MASTER%d, TYPE=ELEMENT" % below
            yield from self.faces(below, top=True)
            yield "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=%s\nSLAVE%d, MASTER%d" % (KINDS[kind], below, below)


def node_set(name, nodes):
    yield "*NSET, NSET=%s" % name
    yield from ("%d," % node for node in nodes)


def step(conditions, measured):
    """The load in one step; CalculiX shortens its increments where Newton asks for it. What the reader needs is written."""
    yield "*STEP, INC=100\n*STATIC\n1., 1."
    yield from conditions
    yield ("*EL PRINT, ELSET=LAYER%d\nS\n*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY\nRF\n*CONTACT FILE\nCDIS, CSTR\n*END STEP" %
           measured)


def write(job, stack, measured, lines):
    """FILE.inp, and FILE.grid.npz for the reader."""
    with open(job + ".inp", "w") as file:
        file.writelines(line + "\n" for line in lines)
    x, y = stack.bodies[measured]
    np.savez(job + ".grid.npz", x=x, y=y, columns=stack.grids[measured][0])
