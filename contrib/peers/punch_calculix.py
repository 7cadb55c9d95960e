# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid flat punch on a half-plane (prm/flat-punch.prm) for CalculiX: writes FILE.inp.

    punch_calculix.py FILE element=CPE8 cells=12 smallest=1e-6

Quadratic quadrilaterals on a tensor grid whose cells shrink geometrically towards the punch's edge. The exact displacement
stands in the nodes of the two cuts, the punch's pressure on the top as its consistent loads of the nodes.
"""
import sys

import numpy as np

import punch_reference as exact
from errors import gauss, lagrange
from grading import around, with_middles


class Grid:
    """Nodes are counted over a grid with middles; those in the middles of cells are left out."""

    def __init__(self, cells, smallest):
        self.x, depth = around(1.0, exact.HALF_WIDTH, cells, smallest)
        self.y = (1 - depth)[::-1]
        self.columns, self.rows = with_middles(self.x), with_middles(self.y)

    def node(self, i, j):
        return 1 + i * len(self.rows) + j

    def nodes(self):
        for i, x in enumerate(self.columns):
            for j, y in enumerate(self.rows):
                if not (i % 2 and j % 2):
                    yield self.node(i, j), x, y

    def elements(self):
        places = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
        number = 0
        for i in range(0, len(self.columns) - 1, 2):
            for j in range(0, len(self.rows) - 1, 2):
                number += 1
                yield number, [self.node(i + a, j + b) for a, b in places]

    def loads(self):
        """Vertical forces on the nodes of the top."""
        forces = np.zeros(len(self.columns))
        for i in range(0, len(self.columns) - 2, 2):
            points, weights = gauss(self.columns[i], self.columns[i + 2])
            forces[i:i + 3] -= lagrange(self.columns[i:i + 3], points) @ (weights * exact.pressure(points))
        return forces


def deck(grid, element):
    last_column, last_row = len(grid.columns) - 1, len(grid.rows) - 1
    yield "*NODE, NSET=ALL"
    for number, x, y in grid.nodes():
        yield "%d, %.17g, %.17g, 0." % (number, x, y)
    yield "*ELEMENT, TYPE=%s, ELSET=GROUND" % element
    for number, nodes in grid.elements():
        yield "%d, %s" % (number, ", ".join(map(str, nodes)))
    yield "*MATERIAL, NAME=STEEL\n*ELASTIC\n%g, %g" % (exact.YOUNG, exact.POISSON)
    yield "*SOLID SECTION, ELSET=GROUND, MATERIAL=STEEL\n1."
    yield "*BOUNDARY"
    for j in range(1, last_row + 1):
        yield "%d, 1, 1" % grid.node(0, j)
    yield "*STEP\n*STATIC\n*BOUNDARY"
    cuts = [(i, 0) for i in range(last_column + 1)] + [(last_column, j) for j in range(1, last_row + 1)]
    for i, j in cuts:
        u = exact.displacement(grid.columns[i], grid.rows[j])
        yield "%d, 1, 1, %.14g\n%d, 2, 2, %.14g" % (grid.node(i, j), u[0], grid.node(i, j), u[1])
    yield "*CLOAD"
    for i, force in enumerate(grid.loads()):
        if force:
            yield "%d, 2, %.14g" % (grid.node(i, last_row), force)
    yield "*EL PRINT, ELSET=GROUND\nS\n*END STEP"


def main():
    options = dict(element="CPE8", cells="8", smallest="1e-6")
    options.update(word.split("=") for word in sys.argv[2:])
    grid = Grid(int(options["cells"]), float(options["smallest"]))
    with open(sys.argv[1] + ".inp", "w") as file:
        file.writelines(line + "\n" for line in deck(grid, options["element"]))
    np.savez(sys.argv[1] + ".grid.npz", x=grid.x, y=grid.y)


main()
