# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies in contact for GetFEM: quadrilaterals of any degree, augmented Lagrangian with a multiplier of the same
degree on the contact side, Newton, MUMPS."""
import sys

import getfem as gf
import numpy as np

LEFT, RIGHT, BOTTOM, TOP = 1, 2, 3, 4


def mark_sides(mesh):
    faces = mesh.outer_faces()
    normal = np.array(mesh.normal_of_faces(faces))
    for side, component, sign in ((LEFT, 0, -1), (RIGHT, 0, 1), (BOTTOM, 1, -1), (TOP, 1, 1)):
        mesh.set_region(side, faces[:, sign * normal[component] > 0.5])


def displacement_space(mesh, degree, sides):
    """Vector elements, and those without the unknowns that the sides (side, component) hold at zero; both must be kept
    alive."""
    space = gf.MeshFem(mesh, 2)
    space.set_fem(gf.Fem("FEM_QK(2,%d)" % degree))
    held = []
    for side, component in sides:
        dofs = space.basic_dof_on_region(side)
        held.append(dofs[dofs % 2 == component])
    free = np.setdiff1d(np.arange(space.nb_basic_dof()), np.concatenate(held))
    return space, gf.MeshFem("partial", space, free)


class ContactModel:
    """Bodies from the top down, (mesh, material, held sides) each, and for each but the last the contact of its lower side
    with the next body: (height, gap), an expression of X(1). The support of the first one is moved down by `approach`, or by
    what makes the contact force `force`."""

    def __init__(self, degree, bodies, contacts, approach, force=None):
        self.degree, self.bodies, self.contacts = degree, bodies, contacts
        self.young, self.approach, self.force = bodies[0][1][0], approach, force
        rule = gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)" % (2 * degree))
        self.rules = [gf.MeshIm(mesh, rule) for mesh, _, _ in bodies]
        self.spaces = {}
        self.model = gf.Model("real")
        for i in range(1, len(bodies) + 1):
            self.add_body(i)
        # the approach of the upper support is part of the gap: the upper body's own displacement vanishes there
        if force is None:
            self.model.add_initialized_data("approach", approach)
        else:
            self.model.add_variable("approach", 1)
            self.model.set_variable("approach", [approach])
            self.model.add_explicit_rhs("approach", [force])
        self.model.add_initialized_data("r", 10 * self.young)
        for i in range(1, len(contacts) + 1):
            self.add_contact(i)

    def add_body(self, i):
        mesh, (young, poisson), held = self.bodies[i - 1]
        space = displacement_space(mesh, self.degree, held)
        self.spaces["u%d" % i] = space
        self.model.add_fem_variable("u%d" % i, space[1])
        self.model.add_initialized_data("lambda%d" % i, young * poisson / (1 + poisson) / (1 - 2 * poisson))
        self.model.add_initialized_data("mu%d" % i, young / 2 / (1 + poisson))
        self.model.add_isotropic_linearized_elasticity_brick(self.rules[i - 1], "u%d" % i, "lambda%d" % i, "mu%d" % i)

    def add_contact(self, i):
        mesh, (height, gap) = self.bodies[i - 1][0], self.contacts[i - 1]
        scalar = gf.MeshFem(mesh, 1)
        scalar.set_fem(gf.Fem("FEM_QK(2,%d)" % self.degree))
        self.spaces["p%d" % i] = scalar
        self.model.add_filtered_fem_variable("p%d" % i, scalar, BOTTOM)
        self.model.add_interpolate_transformation_from_expression("across%d" % i, mesh, self.bodies[i][0],
                                                                  "[X(1);%g]" % height)
        moved = "-approach" if i == 1 else ""
        test_moved = "-Test_approach" if i == 1 and self.force is not None else ""
        names = {"p": "p%d" % i, "above": "u%d" % i, "below": "u%d" % (i + 1), "across": "across%d" % i}
        gap = "(%s%s+{above}(2)-Interpolate({below},{across}).[0;1])" % (gap, moved)
        test_gap = "(Test_{above}(2)-Interpolate(Test_{below},{across}).[0;1]%s)" % test_moved
        law = "pos_part({p}-r*%s)" % gap
        width = "(-Normal(2))"  # dx along a curved side
        form = "-%s*%s*%s-(1/r)*({p}-%s)*Test_{p}*%s" % (law, test_gap, width, law, width)
        self.model.add_nonlinear_generic_assembly_brick(self.rules[i - 1], form.format(**names), BOTTOM)

    def move(self, i, distance):
        """Newton begins with the body lifted by a distance: what contact alone holds must touch its neighbours."""
        full, free = self.spaces["u%d" % i]
        self.model.set_variable("u%d" % i, free.reduce_vector(np.tile([0.0, distance], full.nb_basic_dof() // 2)))

    def start_from(self, coarser):
        """The pressures and the displacements of a coarser grid, for Newton to begin with."""
        for i in range(1, len(self.contacts) + 1):
            space = self.model.mesh_fem_of_variable("p%d" % i)
            place = space.basic_dof_nodes(space.basic_dof_on_region(BOTTOM))[0]
            self.model.set_variable("p%d" % i, np.interp(place, *coarser.pressure(i)))
        for i in range(1, len(self.bodies) + 1):
            name = "u%d" % i
            old, (full, free) = coarser.spaces[name][1], self.spaces[name]
            field = gf.compute_interpolate_on(old, coarser.model.variable(name), full)
            self.model.set_variable(name, free.reduce_vector(field))

    def solve(self):
        smallest = 1e-9 * self.young * self.approach
        iterations, _ = self.model.solve("max_iter", 60, "max_res", smallest, "lsolver", "mumps",
                                         "lsearch", "simplest", "alpha max ratio", 1e12, "alpha min", 1.0)
        if iterations >= 60:
            sys.exit("GetFEM: Newton did not converge in 60 iterations")
        return iterations

    def pressure(self, i=1):
        space = self.model.mesh_fem_of_variable("p%d" % i)
        x = space.basic_dof_nodes(space.basic_dof_on_region(BOTTOM))[0]
        p = self.model.variable("p%d" % i)
        order = np.argsort(x)
        return x[order], p[order]

    def end_of_contact(self):
        """Where the square of the pressure, nearly linear in x, falls to zero."""
        x, p = self.pressure()
        inside = np.flatnonzero(p > 0.05 * p.max())[-1]
        near = slice(max(0, inside - 2 * self.degree), inside + 1)
        slope, value = np.polyfit(x[near], p[near]**2, 1)
        return float(np.clip(-value / slope, x[inside], x[min(inside + self.degree, len(x) - 1)]))

    def stress(self):
        """Of the second body."""
        mesh, rule = self.bodies[1][0], self.rules[1]
        x = self.model.interpolation("X", gf.MeshImData(rule, -1, 2)).reshape(-1, 2)
        stress = self.model.interpolation(
            "[lambda2*Trace(Grad_u2)+2*mu2*Grad_u2(1,1);lambda2*Trace(Grad_u2)+2*mu2*Grad_u2(2,2);"
            "mu2*(Grad_u2(1,2)+Grad_u2(2,1))]", gf.MeshImData(rule, -1, 3)).reshape(-1, 3)
        nodes = rule.im_nodes()
        if not np.allclose(nodes[:2].T, x):
            sys.exit("GetFEM: quadrature points and stresses are not in the same order")
        weights = nodes[2] * np.repeat(mesh.convex_area(), nodes.shape[1] // mesh.nbcvs())
        return x, weights, stress.T

    def save(self, path):
        x, p = self.pressure()
        points, weights, stress = self.stress()
        force = -np.sum(weights * stress[1]) / np.ptp(self.bodies[1][0].pts()[1])  # the mean over its sections
        np.savez(path, unknowns=self.model.nbdof(), degree=self.degree, x=x, p=p, points=points, weights=weights,
                 stress=stress, force=force)


def solve_in_stages(make, cells, stages, edge, warm=True):
    """make(cells, edge) is a model on a grid graded towards the end of contact; each stage has twice the cells of the one
    before, its end of contact and, warm, its solution to begin with (GetFEM finds no values outside the coarser grid,
    where sides are curved)."""
    coarser = None
    for stage in range(stages):
        model = make(max(8, cells // 2**(stages - 1 - stage)), edge)
        if coarser and warm:
            model.start_from(coarser)
        iterations = model.solve()
        edge, coarser = model.end_of_contact(), model
        print("stage", stage, "unknowns", model.model.nbdof(), "iterations", iterations, "end of contact", edge)
    return model


def options_of_command_line(**defaults):
    gf.util_trace_level(0)
    defaults.update(word.split("=") for word in sys.argv[1:])
    return defaults
