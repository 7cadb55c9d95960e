# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two layers with roller ends (prm/two-layers-rollers.prm) for CalculiX: writes FILE.inp.

    layers_calculix.py FILE element=CPE8R cells=16 stiffness=1e9 contact=penalty

Quadrilaterals, CPE4 or CPE8R, on a tensor grid that becomes finer towards the end of contact, the same in both layers; the
upper one's lower side is curved. Contact: surface to surface with a linear penalty (MPa/cm), or mortar.
"""
import sys

import numpy as np

from grading import graded, with_middles

LENGTH = 4.0
YOUNG, POISSON, APPROACH, CURVATURE = 2.1e5, 0.3, 1.366e-3, 1e-3
END_OF_CONTACT = 1.015  # from a run on a coarse grid
KINDS = {"penalty": "SURFACE TO SURFACE", "node": "NODE TO SURFACE", "mortar": "MORTAR", "linmortar": "LINMORTAR"}


class Grid:
    """Layer 0 is the lower one. Nodes are counted over all places of a grid with middles; cell middles stay unused."""

    def __init__(self, element, cells):
        self.element, self.step = element, 2 if element.startswith("CPE8") else 1
        self.x, self.depth = graded(LENGTH, END_OF_CONTACT, cells), graded(1.0, 0.0, max(2, cells // 3))
        refine = with_middles if self.step == 2 else np.array
        self.columns, self.rows = refine(self.x), [refine((1 - self.depth)[::-1]), refine(1 + self.depth)]

    @property
    def nx(self):
        return len(self.x) - 1

    @property
    def ny(self):
        return len(self.depth) - 1

    def node(self, layer, i, j):
        return 1 + (layer * len(self.columns) + i) * len(self.rows[0]) + j

    def nodes(self):
        for layer in (0, 1):
            for i, x in enumerate(self.columns):
                for j, y in enumerate(self.rows[layer]):
                    if self.step == 2 and i % 2 and j % 2:
                        continue
                    yield self.node(layer, i, j), x, y + layer * CURVATURE * x**2 * (2 - y)

    def elements(self, layer):
        corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
        middles = [(0.5, 0), (1, 0.5), (0.5, 1), (0, 0.5)] if self.step == 2 else []
        number = 1 + layer * self.nx * self.ny
        for i in range(self.nx):
            for j in range(self.ny):
                yield number, [self.node(layer, int(self.step * (i + a)), int(self.step * (j + b)))
                               for a, b in corners + middles]
                number += 1

    def side(self, layer, row):
        return [self.node(layer, i, row) for i in range(len(self.columns))]

    def ends(self):
        return [self.node(layer, i, j) for layer in (0, 1) for i in (0, len(self.columns) - 1)
                for j in range(len(self.rows[0]))]


def deck(grid, contact, stiffness):
    yield "*NODE, NSET=ALL"
    for number, x, y in grid.nodes():
        yield "%d, %.17g, %.17g, 0." % (number, x, y)
    for layer, name in enumerate(("LOWER", "UPPER")):
        yield "*ELEMENT, TYPE=%s, ELSET=%s" % (grid.element, name)
        for number, nodes in grid.elements(layer):
            yield "%d, %s" % (number, ", ".join(map(str, nodes)))
    last = len(grid.rows[0]) - 1
    for name, nodes in (("ENDS", grid.ends()), ("BOTTOM", grid.side(0, 0)), ("TOP", grid.side(1, last))):
        yield "*NSET, NSET=%s" % name
        yield from ("%d," % node for node in nodes)
    yield "*SURFACE, NAME=SLAVE, TYPE=ELEMENT"
    yield from ("%d, S1" % (grid.nx * grid.ny + 1 + i * grid.ny) for i in range(grid.nx))
    yield "*SURFACE, NAME=MASTER, TYPE=ELEMENT"
    yield from ("%d, S3" % ((i + 1) * grid.ny) for i in range(grid.nx))
    yield "*MATERIAL, NAME=STEEL\n*ELASTIC\n%g, %g" % (YOUNG, POISSON)
    for name in ("LOWER", "UPPER"):
        yield "*SOLID SECTION, ELSET=%s, MATERIAL=STEEL\n1." % name
    yield "*SURFACE INTERACTION, NAME=TOUCH"
    yield ("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD" if "mortar" in contact else
           "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n%g" % stiffness)
    yield "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=%s\nSLAVE, MASTER" % KINDS[contact]
    yield "*BOUNDARY\nENDS, 1, 1\nBOTTOM, 2, 2"
    yield "*STEP, INC=100\n*STATIC\n1., 1.\n*BOUNDARY\nTOP, 2, 2, %.10g" % -APPROACH
    yield "*EL PRINT, ELSET=LOWER\nS\n*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY\nRF\n*CONTACT FILE\nCDIS, CSTR\n*END STEP"


def main():
    options = dict(element="CPE8R", cells="16", contact="penalty", stiffness="1e9")
    options.update(word.split("=") for word in sys.argv[2:])
    grid = Grid(options["element"], int(options["cells"]))
    with open(sys.argv[1] + ".inp", "w") as file:
        file.writelines(line + "\n" for line in deck(grid, options["contact"], float(options["stiffness"])))
    np.savez(sys.argv[1] + ".grid.npz", x=grid.x, y=(1 - grid.depth)[::-1], columns=grid.columns)


main()
