# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs abut and its peers, writes results/peers/peers.csv, the tables of doc/peers.md and its figures. Called by run."""
import argparse
import csv
import json
import os
import sys

import cases
import errors
import hertz_reference
import measure
import readers
import tables
import punch_reference
from floating_reference import FloatingReference
from layers_reference import POISSON, LayersReference

RESULTS = os.path.join(cases.ROOT, "results", "peers")
FIGURES = os.path.join(cases.ROOT, "doc", "figures")
PAGE = os.path.join(cases.ROOT, "doc", "peers.md")
COLUMNS = ["scene", "program", "variant", "level", "unknowns", "seconds", "seconds_without_start", "cpu_seconds",
           "memory_mb", "error_stress", "error_pressure", "error_force"]


def abut_errors(scene, folder):
    """From its summary. Its stress error is over all bodies; the two layers mirror each other and so do their meshes."""
    with open(os.path.join(folder, "abut", "summary.json")) as file:
        summary = json.load(file)
    energies = [body["energy"] for body in summary["bodies"]]
    if scene == "layers" and max(energies) - min(energies) > 1e-6 * max(energies):
        raise measure.Failure("abut's two layers do not mirror each other: its stress error is not that of one layer")
    true = summary["true_error"]
    return {"unknowns": sum(body["dofs"] for body in summary["bodies"]), "error_stress": true["stress"],
            "error_pressure": true.get("pressure"), "error_force": true.get("force")}


READERS = {"abut": lambda folder: readers.abut(os.path.join(folder, "abut"), "middle", "below"),
           "FreeFEM": lambda folder: readers.freefem(os.path.join(folder, "freefem.txt")),
           "GetFEM": lambda folder: readers.getfem(os.path.join(folder, "getfem.npz")),
           "CalculiX": lambda folder: readers.calculix(os.path.join(folder, "job"))}


def pressure_error(solution, exact, half_width):
    readings = solution.get("pressures") or [solution["pressure"]]  # the better reading of several
    return min(errors.pressure_error(pressure, exact, half_width) for pressure in readings)


class LayersErrors:
    def __init__(self, reference):
        self.exact = reference()

    def __call__(self, solution):
        exact = self.exact
        return {"unknowns": solution["unknowns"],
                "error_stress": errors.stress_error(solution, exact.stress, POISSON),
                "error_pressure": pressure_error(solution, exact.pressure, exact.half_width),
                "error_force": abs(solution["force"] / exact.force() - 1)}


class PunchErrors:
    """The pressure is given, the force with it."""

    def __call__(self, solution):
        return {"unknowns": solution["unknowns"], "error_pressure": None, "error_force": None,
                "error_stress": errors.stress_error(solution, punch_reference.stress, punch_reference.POISSON)}


class HertzErrors:
    """The force is given; the stress of bodies of finite size is not Hertz's."""

    def __call__(self, solution):
        return {"unknowns": solution["unknowns"], "error_stress": None,
                "error_pressure": pressure_error(solution, hertz_reference.pressure, hertz_reference.HALF_WIDTH),
                "error_force": abs(solution["force"] / hertz_reference.HALF_FORCE - 1)}


ERRORS = {"layers": lambda: LayersErrors(LayersReference), "punch": PunchErrors, "hertz": HertzErrors,
          "floating": lambda: LayersErrors(FloatingReference)}


def run_case(case, folder, error_of, start):
    os.makedirs(folder, exist_ok=True)
    if case.prepare:
        measure.run(case.prepare, folder, "prepare.txt")
    own_threads = case.program == "abut"
    cost = measure.least(case.timed, folder, own_threads)
    if case.program == "CalculiX":  # its files are those of the timed run
        os.replace(os.path.join(folder, "log.txt"), os.path.join(folder, "job.log"))
    else:
        measure.run(case.evaluated, folder, "evaluated.txt", own_threads)
    by_itself = own_threads and case.scene != "floating"  # of this scene it does not know the exact solution
    found = abut_errors(case.scene, folder) if by_itself else error_of(READERS[case.program](folder))
    return {"scene": case.scene, "program": case.program, "variant": case.variant, "level": case.level, **found, **cost,
            "seconds_without_start": max(cost["seconds"] - start[case.program]["seconds"], 1e-3)}


def start_costs():
    folder = os.path.join(RESULTS, "start")
    os.makedirs(folder, exist_ok=True)
    costs = {}
    for program, command in cases.start_commands(folder).items():
        costs[program] = measure.least(command, folder, repetitions=7)
        measure.say("start of %-9s %.3f s" % (program, costs[program]["seconds"]))
    return costs


def percent(value):
    return "-" if value is None else "%.4f %%" % (100 * value)


def run_scene(scene, quick, start, failures):
    error_of = ERRORS[scene]()
    chosen = [case for case in cases.of_scene(scene) if case.quick or not quick]
    rows = []
    for number, case in enumerate(chosen, 1):
        folder = os.path.join(RESULTS, scene, "%s-%s-%s" % (case.program, case.variant, case.level))
        folder = folder.replace(" ", "_").replace(",", "")
        try:
            row = run_case(case, folder, error_of, start)
        except measure.Failure as failure:
            measure.say("%s %d/%d  failed: %s" % (scene, number, len(chosen), failure))
            failures.append(failure)
            continue
        rows.append(row)
        measure.say("%s %d/%d  %-8s %-28s %-18s %8d unknowns %8.2f s  stress %s  pressure %s" % (
            scene, number, len(chosen), case.program, case.variant, case.level, row["unknowns"], row["seconds"],
            percent(row["error_stress"]), percent(row["error_pressure"])))
    write_csv(os.path.join(RESULTS, "peers.csv"), [row for row in kept_rows() if row["scene"] != scene] + rows)
    return rows


def publish(scene, rows, on_page):
    lines = tables.of_scene(rows)
    print("\n".join(["", "== %s ==" % scene, *lines]), flush=True)
    if on_page:
        import figures
        figures.draw(scene, rows, FIGURES)
        tables.write_to_page("peers-%s.svg" % scene, lines, PAGE)


def write_csv(path, rows):
    with open(path + ".part", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for row in rows:
            writer.writerow({key: "%.5g" % value if isinstance(value, float) else value for key, value in row.items()})
    os.replace(path + ".part", path)


def kept_rows():
    """Those of an earlier run."""
    path = os.path.join(RESULTS, "peers.csv")
    if not os.path.exists(path):
        return []
    words = ("scene", "program", "variant", "level")
    with open(path, newline="") as file:
        return [{key: value if key in words else float(value) if value else None for key, value in row.items()}
                for row in csv.DictReader(file)]


def main():
    parser = argparse.ArgumentParser(prog="contrib/peers/run", description=__doc__)
    parser.add_argument("--scene", choices=sorted(cases.SCENES), help="only this one")
    only = parser.add_mutually_exclusive_group()
    only.add_argument("--quick", action="store_true", help="a few runs of each program; the page stays as it is")
    only.add_argument("--kept", action="store_true", help="no runs; the page from results/peers/peers.csv")
    options = parser.parse_args()
    scenes, failures = [options.scene] if options.scene else list(cases.SCENES), []
    if options.kept:
        for scene in scenes:
            rows = [row for row in kept_rows() if row["scene"] == scene]
            if not rows:
                sys.exit("contrib/peers/run: results/peers/peers.csv has no runs of %s" % scene)
            publish(scene, rows, on_page=True)
        return
    cases.check_programs()
    os.makedirs(RESULTS, exist_ok=True)
    try:
        start = start_costs()
        for scene in scenes:
            publish(scene, run_scene(scene, options.quick, start, failures), on_page=not options.quick)
    except measure.Failure as failure:
        sys.exit("contrib/peers/run: %s" % failure)
    if failures:
        sys.exit("contrib/peers/run: %d runs failed, the first: %s" % (len(failures), failures[0]))


if __name__ == "__main__":
    main()
