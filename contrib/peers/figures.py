# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error against seconds, one line a program: its pareto front."""
import os

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.fonttype"] = "none"
matplotlib.rcParams["svg.hashsalt"] = "abut"  # the same numbers give the same file
import matplotlib.pyplot as plt

from tables import PROGRAMS

TITLES = {"layers": "Two layers with roller ends", "punch": "Flat punch", "hertz": "Hertz, a hundredth of the force",
          "floating": "A layer held by contact alone"}
COLOURS = {"abut": "black", "FreeFEM": "tab:blue", "GetFEM": "tab:orange", "CalculiX": "tab:green"}


def front(points):
    """Those that no other point beats in both."""
    best, result = float("inf"), []
    for seconds, error in sorted(points):
        if error < best:
            best = error
            result.append((seconds, error))
    return result


def draw(scene, rows, folder):
    quantities = [q for q in ("error_stress", "error_pressure") if any(row[q] is not None for row in rows)]
    figure, axes = plt.subplots(1, len(quantities), figsize=(4.6 * len(quantities), 3.8), squeeze=False)
    for axis, quantity in zip(axes[0], quantities):
        for program in PROGRAMS:
            points = [(row["seconds"], 100 * row[quantity]) for row in rows
                      if row["program"] == program and row[quantity] is not None]
            if points:
                axis.loglog(*zip(*points), ".", color=COLOURS[program], alpha=0.3)
                axis.loglog(*zip(*front(points)), "o-", color=COLOURS[program], markersize=4, label=program)
        axis.set_xlabel("seconds, whole process")
        axis.set_ylabel(quantity.replace("error_", "") + " error in %")
        axis.grid(True, which="both", alpha=0.2)
    axes[0][0].legend()
    figure.suptitle(TITLES[scene])
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "peers-%s.svg" % scene), metadata={"Date": None})
    plt.close(figure)
