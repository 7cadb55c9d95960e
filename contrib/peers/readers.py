# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the programs wrote, as a solution of errors.py."""
import base64
import csv
import json
import os
import re
import zlib

import numpy as np

from errors import gauss, lagrange, piecewise, pressure_of_forces, triangle_rule


def monomials(points, degree):
    x, y = points[..., 0], points[..., 1]
    return np.stack([x**i * y**j for i in range(degree + 1) for j in range(degree + 1 - i)], axis=-1)


def freefem(path):
    """A file of layers.edp or punch.edp: contact nodes and forces, then triangles with stresses in their nodes."""
    with open(path) as file:
        degree, unknowns, contact_nodes, triangles, nodes = map(int, file.readline().split())
        numbers = np.array(file.read().split(), dtype=float)
    contact = numbers[:2 * contact_nodes].reshape(-1, 2)
    table = numbers[2 * contact_nodes:].reshape(triangles, 6 + 5 * nodes)
    corners = table[:, :6].reshape(-1, 3, 2)
    values = table[:, 6:].reshape(triangles, nodes, 5)
    points, weights = triangle_rule(corners, degree + 3)
    center = corners.mean(axis=1, keepdims=True)
    size = np.abs(corners - center).max(axis=(1, 2))[:, None, None]
    basis = monomials((values[..., :2] - center) / size, degree - 1)
    stress = monomials((points - center) / size, degree - 1) @ np.linalg.solve(basis, values[..., 2:])
    solution = {"unknowns": unknowns, "points": points.reshape(-1, 2), "weights": weights.ravel(),
                "stress": stress.reshape(-1, 3).T}
    if contact_nodes:
        x, force = contact.T
        solution["pressure"] = piecewise(x, pressure_of_forces(x, force, degree), degree)
        solution["force"] = force.sum()
    return solution


def getfem(path):
    """A file of layers_getfem.py or punch_getfem.py: quadrature points of the body measured, nodes of the multiplier."""
    file = np.load(path)
    solution = {"unknowns": int(file["unknowns"]), "points": file["points"], "weights": file["weights"],
                "stress": file["stress"]}
    if "p" in file:
        solution["pressure"] = piecewise(file["x"], file["p"], int(file["degree"]))
        solution["force"] = float(file["force"])
    return solution


def calculix_tables(path):
    """Stresses (element, point, xx, yy, ...) and the total force of the nodes at the end, from a .dat file."""
    stress, force, section = [], None, None
    with open(path) as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if "stresses" in line or "force" in line:
                section = "stress" if "stresses" in line else "force"
                if section == "stress":
                    stress = []  # the last increment counts
            elif section == "stress":
                stress.append([float(word) for word in words])
            elif section == "force":
                force = float(words[1])
    return np.array(stress), force


def calculix_contact(path):
    """Places and contact pressures of the nodes, from a .frd file."""
    places, pressures, section = {}, {}, None
    with open(path) as file:
        for line in file:
            if line.startswith("    2C"):
                section = places
            elif line.startswith(" -4"):
                section = pressures if "CONTACT" in line else None
            elif line.startswith(" -3"):
                section = None
            elif line.startswith(" -1") and section is not None:
                line = line.rstrip("\n")
                section[int(line[3:13])] = [float(line[13 + i:25 + i]) for i in range(0, len(line) - 13, 12)]
    return np.array([(*places[node][:2], values[3]) for node, values in pressures.items()])


def gauss_stresses(table, grid):
    """Stresses of a tensor grid in the Gauss points of the first of the two layers of points that CalculiX gives a plane
    element: cell columns and rows, numbers of the points in a row of a cell, and a solution."""
    x, y = grid["x"], grid["y"]
    element, point = table[:, 0].astype(int), table[:, 1].astype(int) - 1
    element -= element.min()
    n = 3 if point.max() == 26 else 2
    keep = point < n * n
    element, point, stress = element[keep], point[keep], table[keep, 2:]
    place, weight = np.polynomial.legendre.leggauss(n)
    column, row = np.divmod(element, len(y) - 1)
    width, height = np.diff(x)[column], np.diff(y)[row]
    points = np.stack([x[column] + width * (1 + place[point % n]) / 2,
                       y[row] + height * (1 + place[point // n]) / 2], axis=1)
    return row, n, {"points": points, "weights": weight[point % n] * weight[point // n] * width * height / 4,
                    "stress": stress[:, [0, 1, 3]].T}


def pressure_from_stress(row, n, solution, grid):
    """-yy on the upper side, extrapolated along the columns of Gauss points: samples (x, weight, value)."""
    top = row == len(grid["y"]) - 2
    x, y = solution["points"][top].T
    order = np.lexsort((y, x))
    place, weight = np.polynomial.legendre.leggauss(n)
    to_side = np.prod([[(1 - g) / (h - g) if g != h else 1 for g in place] for h in place], axis=1)
    values = -solution["stress"][1][top][order].reshape(-1, n) @ to_side
    return x[order].reshape(-1, n)[:, 0], np.multiply.outer(np.diff(grid["x"]) / 2, weight).ravel(), values


def pressure_of_nodes(job, columns):
    """The contact pressure that CalculiX gives for the nodes, linear between them."""
    contact = calculix_contact(job + ".frd")
    contact = contact[np.abs(contact[:, 1] - 1) < 0.1]  # the slave side; the file has five digits
    nodes = np.unique(contact[:, 0])
    values = np.array([contact[contact[:, 0] == node, 2].max() for node in nodes])
    return piecewise(columns, np.interp(columns, nodes, values, right=0), 1)


def calculix(job):
    """The files of a job of layers_calculix.py or punch_calculix.py. Of contact there are two readings of the pressure."""
    grid = np.load(job + ".grid.npz")
    table, force = calculix_tables(job + ".dat")
    row, n, solution = gauss_stresses(table, grid)
    with open(job + ".log") as file:
        solution["unknowns"] = int(file.read().split("number of equations")[1].split()[0])
    if "columns" in grid:
        solution["force"] = force
        solution["pressures"] = [pressure_from_stress(row, n, solution, grid), pressure_of_nodes(job, grid["columns"])]
    return solution


def vtu_array(text):
    """A compressed array of a VTU file: number of blocks, their size, that of the last, those compressed, the blocks."""
    blocks = int(np.frombuffer(base64.b64decode(text[:8])[:4], "<u4")[0])
    end = 4 * ((4 * (3 + blocks) + 2) // 3)
    sizes = np.frombuffer(base64.b64decode(text[:end]), "<u4")[3:3 + blocks]
    data, starts = base64.b64decode(text[end:]), np.cumsum([0, *sizes], dtype=int)
    return b"".join(zlib.decompress(data[a:b]) for a, b in zip(starts[:-1], starts[1:]))


def vtu(path):
    """Points, connectivity and the fields by their names."""
    kinds = {"Float32": "<f4", "Int32": "<i4", "UInt8": "u1"}
    with open(path) as file:
        arrays = re.findall(r"<DataArray([^>]*)>([^<]*)<", file.read())
    result = {}
    for head, text in arrays:
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', head))
        data = np.frombuffer(vtu_array(text.strip()), kinds[attributes["type"]]).astype(float)
        result[attributes.get("Name", "points")] = data.reshape(-1, int(attributes.get("NumberOfComponents", 1)))
    return result


def abut(folder, body, contact):
    """The stress of a body of rectangles, whose file has them in a lattice of (degree + 1)^2 points of each cell, and the
    pressure of a contact, the polyline through the places that its file names."""
    fields = vtu(os.path.join(folder, "solution_%s.vtu" % body))
    degree = int(fields["connectivity"][3, 0]) - 1
    corners = fields["points"].reshape(-1, (degree + 1)**2, 3)[:, [0, -1], :2]
    place, weight = gauss(0, 1, degree + 2)  # as it integrates itself
    shapes = np.kron(*2 * [lagrange(np.linspace(0, 1, degree + 1), place)])
    share = np.stack([np.tile(place, len(place)), np.repeat(place, len(place))], axis=1)
    size = corners[:, 1] - corners[:, 0]
    points = corners[:, None, 0] + share * size[:, None]
    weights = np.prod(size, axis=1)[:, None] * np.kron(weight, weight)
    stress = [(fields["stress_" + name].reshape(-1, (degree + 1)**2) @ shapes).ravel() for name in ("xx", "yy", "xy")]
    with open(os.path.join(folder, "contact_%s.csv" % contact), newline="") as file:
        x, pressure = np.array(sorted((float(row["x"]), float(row["pressure"])) for row in csv.DictReader(file))).T
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    return {"unknowns": sum(of_body["dofs"] for of_body in summary["bodies"]), "points": points.reshape(-1, 2),
            "weights": weights.ravel(), "stress": np.array(stress), "pressure": piecewise(x, pressure, 1),
            "force": next(pair["normal_force"] for pair in summary["contacts"] if pair["name"] == contact)}
