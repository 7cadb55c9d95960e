# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adaptive against uniform meshes, by true error; called by run. The scene is contrib/peers/two-layers.prm."""
import argparse
import csv
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "contrib", "peers"))

import numpy as np

import measure
import tables
from cases import ABUT
from figures import front, plt

RESULTS = os.path.join(ROOT, "results", "claim")
CSV = os.path.join(RESULTS, "claim.csv")
FIGURE = os.path.join(ROOT, "doc", "figures", "claim.svg")
PAGE = os.path.join(ROOT, "doc", "reproducing-the-paper.md")
SCENE = os.path.join(ROOT, "contrib", "peers", "two-layers.prm")
LEVELS = [10, 5, 2, 1, 0.5, 0.2, 0.1]  # per cent of the energy norm
COLUMNS = ["variant", "step", "unknowns", "boundary_unknowns", "cpu_seconds", "cpu_seconds_without_start", "error_energy",
           "error_stress"]


def cells(columns):
    return ["Body %s/Cells=%d, %d" % (body, columns, columns // 4) for body in ("upper", "lower")]


def adaptive(estimator, passes):
    return cells(16) + ["Body upper/Adapt=true", "Body lower/Adapt=true", "Discretisation/Degree=1",
                        "Adaptation/Estimator=" + estimator, "Adaptation/Marking=doerfler", "Adaptation/Fraction=0.5",
                        "Adaptation/Maximum passes=%d" % passes]


VARIANTS = {
    "uniform, degree 1": {str(n): cells(n) + ["Discretisation/Degree=1"] for n in (16, 32, 64, 128, 256, 512)},
    "fe-be, degree 1": {str(n): adaptive("fe-be", n) for n in range(2, 15)},
    "spr, degree 1": {str(n): adaptive("spr", n) for n in range(2, 15)},
    "uniform, degree 3": {str(n): cells(n) + ["Discretisation/Degree=3"] for n in (4, 8, 16, 32, 64, 128, 256)},
    "Tolerance": {t: ["Tolerance=" + t] for t in ("5e-2", "2e-2", "1e-2", "5e-3", "2e-3", "1e-3", "5e-4", "2e-4")},
}


def measured(overrides, folder, start):
    """The comparison with the exact solution is not timed."""
    os.makedirs(folder, exist_ok=True)
    command = [ABUT, SCENE, "--quiet", "--output", "abut"]
    for override in overrides:
        command += ["--set", override]
    cost = measure.least(command + ["--set", "Reference/Exact solution=none"], folder, own_threads=True)["cpu_seconds"]
    measure.run(command, folder, "evaluated.txt", own_threads=True)
    with open(os.path.join(folder, "abut", "summary.json")) as file:
        summary = json.load(file)
    by_boundary_elements = summary["pass_table"][-1]["estimated_by"] == "fe-be"
    return {"unknowns": sum(body["dofs"] for body in summary["bodies"]), "cpu_seconds": cost,
            "boundary_unknowns": sum(body["boundary_dofs"] for body in summary["bodies"]) * by_boundary_elements,
            "cpu_seconds_without_start": max(cost - start, 1e-3), "error_energy": summary["true_error"]["energy"],
            "error_stress": summary["true_error"]["stress"]}


def all_rows():
    os.makedirs(RESULTS, exist_ok=True)
    start = measure.least([ABUT, "--print-parameters"], RESULTS, own_threads=True, repetitions=7)["cpu_seconds"]
    measure.say("start %.3f processor seconds" % start)
    for variant, steps in VARIANTS.items():
        for step, overrides in steps.items():
            folder = os.path.join(RESULTS, "%s-%s" % (variant.replace(", ", "-").replace(" ", "-"), step))
            row = {"variant": variant, "step": step, **measured(overrides, folder, start)}
            measure.say("%-18s %5s %8d unknowns %8.3f s  energy %.4f %%" % (
                variant, step, row["unknowns"], row["cpu_seconds_without_start"], 100 * row["error_energy"]))
            yield row


def write_csv(rows):
    with open(CSV, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for row in rows:
            writer.writerow({key: "%.5g" % value if isinstance(value, float) else value for key, value in row.items()})


def kept_rows():
    with open(CSV, newline="") as file:
        return [{key: value if key in ("variant", "step") else float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


def all_unknowns(row):
    return row["unknowns"] + row["boundary_unknowns"]


def cost_at(level, rows, cost):
    """Between runs along straight lines in double logarithmic scale; above the first run's error its own cost, below the
    last one's none."""
    points = front((cost(row), 100 * row["error_energy"]) for row in rows)
    costs, errors = np.log(points[::-1]).T
    return None if np.log(level) < errors[0] else np.exp(np.interp(np.log(level), errors, costs))


def table(rows, heading, cost):
    yield heading
    yield "%10s" % "error" + "".join("%20s" % variant for variant in VARIANTS)
    for level in LEVELS:
        found = [cost_at(level, [row for row in rows if row["variant"] == variant], cost) for variant in VARIANTS]
        yield "%8g %%" % level + "".join("%20s" % ("-" if value is None else shown(value)) for value in found)


def shown(value):
    return "%.0f" % value if value >= 100 else "%.3g" % value


def draw(rows):
    figure, axes = plt.subplots(1, 2, figsize=(9.2, 3.8))
    costs = (("unknowns, those of boundary elements included", all_unknowns),
             ("processor seconds, less the start", lambda row: row["cpu_seconds_without_start"]))
    for axis, (label, cost) in zip(axes, costs):
        for variant in VARIANTS:
            of_variant = [row for row in rows if row["variant"] == variant]
            axis.loglog([cost(row) for row in of_variant], [100 * row["error_energy"] for row in of_variant], "o-",
                        markersize=4, label=variant)
        axis.set_xlabel(label)
        axis.set_ylabel("true error in %, energy norm")
        axis.grid(True, which="both", alpha=0.2)
    axes[1].legend(loc="upper right")
    figure.tight_layout()
    figure.savefig(FIGURE, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(prog="contrib/claim/run", description=__doc__)
    parser.add_argument("--kept", action="store_true", help="no runs; the page from results/claim/claim.csv")
    if parser.parse_args().kept:
        rows = kept_rows()
    else:
        try:
            rows = list(all_rows())
        except measure.Failure as failure:
            sys.exit("contrib/claim/run: %s" % failure)
        write_csv(rows)
    lines = []
    for heading, cost in (("unknowns, those of boundary elements included", all_unknowns),
                          ("processor seconds, whole process", lambda row: row["cpu_seconds"]),
                          ("processor seconds, less the start of an empty program",
                           lambda row: row["cpu_seconds_without_start"])):
        lines += [*table(rows, "True error in the energy norm; " + heading, cost), ""]
    print("\n".join(lines))
    draw(rows)
    tables.write_to_page("claim.svg", lines, PAGE)


if __name__ == "__main__":
    main()
