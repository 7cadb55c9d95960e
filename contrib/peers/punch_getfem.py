# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid flat punch on a half-plane (prm/flat-punch.prm) for GetFEM.

    punch_getfem.py degree=4 cells=2 levels=20 [output=FILE.npz]

Triangles of any degree, of a grid of 2 x 2 squares times `cells`, then halved `levels` times where they touch the punch's
edge (on a tensor grid as fine GetFEM takes different nodes of long cells for one); the exact displacement on the two cuts is
interpolated and eliminated.
"""
import sys

import getfem as gf
import numpy as np

import punch_reference as exact

TOP, LEFT, CUTS = 1, 2, 3


def refined(cells, levels):
    lines = np.linspace(0, 1, 2 * cells + 1)
    mesh = gf.Mesh("regular simplices", lines, lines)
    for _ in range(levels):
        edge = mesh.pid_from_coords([[exact.HALF_WIDTH], [1]])
        mesh.refine(mesh.cvid_from_pid(edge, True))
    return mesh


def mark_sides(mesh):
    faces = mesh.outer_faces()
    normal = np.array(mesh.normal_of_faces(faces))
    mesh.set_region(TOP, faces[:, normal[1] > 0.5])
    mesh.set_region(LEFT, faces[:, normal[0] < -0.5])
    mesh.set_region(CUTS, faces[:, (normal[0] > 0.5) | (normal[1] < -0.5)])


def held_values(space):
    """Unknowns given and their values."""
    values = np.zeros(space.nbdof())
    left, cuts = space.basic_dof_on_region(LEFT), space.basic_dof_on_region(CUTS)
    nodes = space.basic_dof_nodes()
    for component in (0, 1):
        dofs = cuts[cuts % 2 == component]
        values[dofs] = exact.displacement(*nodes[:, dofs])[component]
    held = np.union1d(left[left % 2 == 0], cuts)
    values[left[left % 2 == 0]] = 0
    return held, values


def solve(mesh, degree, rule):
    """The displacement: stiffness and load are assembled by GetFEM, what is given is eliminated, MUMPS solves."""
    space = gf.MeshFem(mesh, 2)
    space.set_fem(gf.Fem("FEM_PK(2,%d)" % degree))
    lame, mu = exact.YOUNG * exact.POISSON / (1 + exact.POISSON) / (1 - 2 * exact.POISSON), exact.MU
    constant = gf.MeshFem(mesh, 1)
    constant.set_fem(gf.Fem("FEM_PK(2,0)"))
    ones = np.ones(constant.nbdof())
    stiffness = gf.asm_linear_elasticity(rule, space, constant, lame * ones, mu * ones)
    pressure = "%.17g/(pi*sqrt(abs(%.17g-X(1)*X(1))))" % (exact.FORCE, exact.HALF_WIDTH**2)
    load = gf.asm_generic(rule, 1, "-Heaviside(%.17g-X(1))*%s*Test_u(2)" % (exact.HALF_WIDTH, pressure), TOP, "u", 1, space,
                          np.zeros(space.nbdof()))
    held, displacement = held_values(space)
    free = np.setdiff1d(np.arange(space.nbdof()), held)
    right_side = load - stiffness.mult(displacement)
    stiffness = gf.Spmat("copy", stiffness, free, free)
    displacement[free] = gf.linsolve_mumps(stiffness, right_side[free]).ravel()
    return space, displacement, len(free), lame, mu


def stress(mesh, rule, space, displacement, lame, mu):
    """In the quadrature points, with their places and weights."""
    model = gf.Model("real")
    model.add_fem_variable("u", space)
    model.set_variable("u", displacement)
    trace = "%.17g*Trace(Grad_u)" % lame
    expression = "[%s+%.17g*Grad_u(1,1);%s+%.17g*Grad_u(2,2);%.17g*(Grad_u(1,2)+Grad_u(2,1))]" % (
        trace, 2 * mu, trace, 2 * mu, mu)
    values = model.interpolation(expression, gf.MeshImData(rule, -1, 3)).reshape(-1, 3)
    points = model.interpolation("X", gf.MeshImData(rule, -1, 2)).reshape(-1, 2)
    nodes = rule.im_nodes()
    if not np.allclose(nodes[:2].T, points):
        sys.exit("punch_getfem.py: quadrature points and stresses are not in the same order")
    return points, 2 * nodes[2] * np.repeat(mesh.convex_area(), nodes.shape[1] // mesh.nbcvs()), values.T


def main():
    options = dict(degree="4", cells="1", levels="20", output="")
    options.update(word.split("=") for word in sys.argv[1:])
    degree, cells, levels = (int(options[name]) for name in ("degree", "cells", "levels"))
    gf.util_trace_level(0)
    mesh = refined(cells, levels)
    mark_sides(mesh)
    rule = gf.MeshIm(mesh, gf.Integ("IM_TRIANGLE(%d)" % (2 * degree)))
    space, displacement, unknowns, lame, mu = solve(mesh, degree, rule)
    if options["output"]:
        points, weights, values = stress(mesh, rule, space, displacement, lame, mu)
        np.savez(options["output"], unknowns=unknowns, degree=degree, points=points, weights=weights, stress=values)


main()
