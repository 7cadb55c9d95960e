# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two bodies in contact for GetFEM: quadrilaterals of any degree, augmented Lagrangian with a multiplier of the same
degree on the contact side, Newton, MUMPS."""
import sys

import getfem as gf
import numpy as np

LEFT, RIGHT, SUPPORT, CONTACT = 1, 2, 3, 4


def mark_sides(mesh, contact_side):
    faces = mesh.outer_faces()
    normal = np.array(mesh.normal_of_faces(faces))
    mesh.set_region(LEFT, faces[:, normal[0] < -0.5])
    mesh.set_region(RIGHT, faces[:, normal[0] > 0.5])
    mesh.set_region(CONTACT, faces[:, contact_side * normal[1] > 0.5])
    mesh.set_region(SUPPORT, faces[:, contact_side * normal[1] < -0.5])


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
    """Two bodies, one above the other. The upper one's contact side meets the lower one's at y = 1; `gap` is an expression
    of X(1). The upper support is moved down by `approach`, or by what makes the contact force `force`."""

    def __init__(self, degree, upper, lower, materials, sides, gap, approach=None, force=None):
        self.degree, self.upper, self.lower = degree, upper, lower
        self.materials, self.sides, self.gap, self.approach, self.force = materials, sides, gap, approach, force
        rule = gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)" % (2 * degree))
        self.on_upper, self.on_lower = gf.MeshIm(self.upper, rule), gf.MeshIm(self.lower, rule)
        self.spaces = {}
        self.model = self.make_model()

    def make_model(self):
        model = gf.Model("real")
        for i, (mesh, rule) in enumerate(((self.upper, self.on_upper), (self.lower, self.on_lower)), 1):
            name, (young, poisson) = "u%d" % i, self.materials[i - 1]
            self.spaces[name] = displacement_space(mesh, self.degree, self.sides[i - 1])
            model.add_fem_variable(name, self.spaces[name][1])
            model.add_initialized_data("lambda%d" % i, young * poisson / (1 + poisson) / (1 - 2 * poisson))
            model.add_initialized_data("mu%d" % i, young / 2 / (1 + poisson))
            model.add_isotropic_linearized_elasticity_brick(rule, name, "lambda%d" % i, "mu%d" % i)
        scalar = gf.MeshFem(self.upper, 1)
        scalar.set_fem(gf.Fem("FEM_QK(2,%d)" % self.degree))
        self.spaces["p"] = scalar
        model.add_filtered_fem_variable("p", scalar, CONTACT)
        # the approach of the upper support is part of the gap: the upper body's own displacement vanishes there
        if self.force is None:
            model.add_initialized_data("approach", self.approach)
        else:
            model.add_variable("approach", 1)
            model.set_variable("approach", [self.approach])
        model.add_initialized_data("r", 10 * self.materials[0][0])
        model.add_interpolate_transformation_from_expression("across", self.upper, self.lower, "[X(1);1]")
        gap = "(%s-approach+u1(2)-Interpolate(u2,across).[0;1])" % self.gap
        law = "pos_part(p-r*%s)" % gap
        test_gap = "(Test_u1(2)-Interpolate(Test_u2,across).[0;1]%s)" % ("" if self.force is None else "-Test_approach")
        width = "(-Normal(2))"  # dx along a curved side
        model.add_nonlinear_generic_assembly_brick(
            self.on_upper, "-%s*%s*%s-(1/r)*(p-%s)*Test_p*%s" % (law, test_gap, width, law, width), CONTACT)
        if self.force is not None:
            model.add_explicit_rhs("approach", [self.force])
        return model

    def start_from(self, coarser):
        """The pressure and the displacements of a coarser grid, for Newton to begin with."""
        x, p = coarser.pressure()
        space = self.model.mesh_fem_of_variable("p")
        place = space.basic_dof_nodes(space.basic_dof_on_region(CONTACT))[0]
        self.model.set_variable("p", np.interp(place, x, p))
        for name in ("u1", "u2"):
            old, (full, free) = coarser.spaces[name][1], self.spaces[name]
            field = gf.compute_interpolate_on(old, coarser.model.variable(name), full)
            self.model.set_variable(name, free.reduce_vector(field))

    def solve(self):
        smallest = 1e-9 * self.materials[0][0] * self.approach
        iterations, _ = self.model.solve("max_iter", 60, "max_res", smallest, "lsolver", "mumps",
                                         "lsearch", "simplest", "alpha max ratio", 1e12, "alpha min", 1.0)
        if iterations >= 60:
            sys.exit("GetFEM: Newton did not converge in 60 iterations")
        return iterations

    def pressure(self):
        space = self.model.mesh_fem_of_variable("p")
        x = space.basic_dof_nodes(space.basic_dof_on_region(CONTACT))[0]
        p = self.model.variable("p")
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
        points = gf.MeshImData(self.on_lower, -1, 2)
        data = gf.MeshImData(self.on_lower, -1, 3)
        x = self.model.interpolation("X", points).reshape(-1, 2)
        stress = self.model.interpolation(
            "[lambda2*Trace(Grad_u2)+2*mu2*Grad_u2(1,1);lambda2*Trace(Grad_u2)+2*mu2*Grad_u2(2,2);"
            "mu2*(Grad_u2(1,2)+Grad_u2(2,1))]", data).reshape(-1, 3)
        nodes = self.on_lower.im_nodes()
        if not np.allclose(nodes[:2].T, x):
            sys.exit("GetFEM: quadrature points and stresses are not in the same order")
        weights = nodes[2] * np.repeat(self.lower.convex_area(), nodes.shape[1] // self.lower.nbcvs())
        return x, weights, stress.T

    def save(self, path):
        x, p = self.pressure()
        points, weights, stress = self.stress()
        np.savez(path, unknowns=self.model.nbdof(), degree=self.degree, x=x, p=p, points=points, weights=weights,
                 stress=stress)


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
