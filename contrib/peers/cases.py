# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is run: for each scene the programs, their variants and the steps of refinement."""
import os
import shutil
import sys
from dataclasses import dataclass, field

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
ABUT = os.path.abspath(os.environ.get("ABUT") or os.path.join(ROOT, "build", "release", "abut"))
PYTHON = "/usr/bin/python3"  # Debian's, which sees GetFEM


@dataclass
class Case:
    """`prepare` is run first and not timed, `timed` is timed, `evaluated` writes what reader(folder) reads."""
    scene: str
    program: str
    variant: str
    level: str
    timed: list
    evaluated: list
    prepare: list = field(default_factory=list)
    quick: bool = False  # belongs to --quick


def script(name):
    return os.path.join(HERE, name)


def start_commands(folder):
    """An empty program of each kind."""
    shutil.copy(script("start_calculix.inp"), os.path.join(folder, "start.inp"))
    return {"abut": [ABUT, "--print-parameters"], "FreeFEM": ["FreeFem++", "-nw", "-v", "0", script("empty.edp")],
            "GetFEM": [PYTHON, "-c", "import numpy, getfem"], "CalculiX": ["ccx", "start"]}


STEPS = [digit + power for power in ("e-2", "e-3", "e-4") for digit in ("5", "3", "2", "1.4", "1", "0.7")]
TOLERANCES = {"layers": STEPS + ["5e-5", "3e-5", "2e-5"], "punch": STEPS[:-1], "hertz": STEPS[:-3], "floating": STEPS}


def abut(scene, file):
    """A tolerance is all that it is told."""
    for level in TOLERANCES[scene]:
        command = [ABUT, script(file), "--quiet", "--output", "abut", "--set", "Tolerance=" + level]
        # the comparison with the exact solution is not timed, but where the scene's conditions need that solution
        alone = ["--set", "Reference/Exact solution=none"] if scene in ("layers", "hertz") else []
        yield Case(scene, "abut", "tolerance", level, command + alone, command, quick=level in ("1e-2", "1e-3"))


def freefem(scene, file, variant, degree, option, levels, more=()):
    for i, level in enumerate(levels):
        command = ["FreeFem++", "-nw", "-v", "0", script(file), "-Ddegree=%d" % degree, "-order", str(degree), option,
                   str(level), *more]
        yield Case(scene, "FreeFEM", variant, str(level), command, command + ["-output", "freefem.txt"],
                   quick=i in (1, 4))


def getfem(scene, file, element, degree, levels):
    """A level is the words of the command line that say how fine the mesh is."""
    for i, level in enumerate(levels):
        command = [PYTHON, script(file), "degree=%d" % degree, *level.split()]
        yield Case(scene, "GetFEM", "%s%d graded" % (element, degree), level, command, command + ["output=getfem.npz"],
                   quick=i in (1, 2))


def calculix(scene, file, variant, levels, *options):
    for i, level in enumerate(levels):
        prepare = [PYTHON, script(file), "job", *level.split(), *options]
        yield Case(scene, "CalculiX", variant, level, ["ccx", "job"], ["ccx", "job"], prepare, quick=i in (1, 2))


def cells(numbers):
    return ["cells=%d" % number for number in numbers]


def penalties(scene, file, cells_of, *options):
    for stiffness, numbers in cells_of.items():
        yield from calculix(scene, file, "CPE8R graded, penalty " + stiffness, cells(numbers), "element=CPE8R",
                            "stiffness=" + stiffness, *options)


def layers_of(scene, file, *options):
    """Two or three; `file` is that of FreeFEM and GetFEM, without its ending, the options are CalculiX's."""
    yield from freefem(scene, file + ".edp", "P3 graded", 3, "-grade",
                       [1.6, 0.8, 0.5, 0.4, 0.3, 0.24, 0.18, 0.14, 0.1, 0.07])
    yield from freefem(scene, file + ".edp", "P2 graded", 2, "-grade", [1.6, 0.8, 0.4, 0.28, 0.2, 0.14, 0.1, 0.05])
    yield from freefem(scene, file + ".edp", "P2 adaptmesh", 2, "-error", [0.3, 0.1, 0.05, 0.02, 0.01], ["-passes", "3"])
    for degree, levels in ((2, [8, 12, 16, 20, 24, 32, 48]), (3, [8, 10, 12, 14, 16, 20, 26, 32, 40]),
                           (4, [8, 10, 12, 14, 16, 20, 24])):
        yield from getfem(scene, file + "_getfem.py", "Q", degree, cells(levels))
    yield from penalties(scene, "layers_calculix.py",
                         {"1e8": [8, 12], "1e9": [8, 12, 16, 20, 24, 32, 48], "1e10": [24, 32, 48]}, *options)


def layers():
    yield from abut("layers", "two-layers.prm")
    yield from layers_of("layers", "layers")
    yield from calculix("layers", "layers_calculix.py", "CPE4 graded, penalty 1e9", cells([16, 32]), "element=CPE4")


def punch():
    yield from abut("punch", "flat-punch.prm")
    more = ["-passes", "7", "-smallest", "1e-9"]
    yield from freefem("punch", "punch.edp", "P3 graded", 3, "-grade", [1.2, 0.8, 0.5, 0.3, 0.2, 0.15, 0.1, 0.07], more)
    yield from freefem("punch", "punch.edp", "P2 graded", 2, "-grade", [1.2, 0.8, 0.4, 0.2, 0.1, 0.05], more)
    for degree in (3, 4, 5):
        yield from getfem("punch", "punch_getfem.py", "P", degree,
                          ["cells=1 levels=10", "cells=1 levels=16", "cells=2 levels=20", "cells=3 levels=24",
                           "cells=4 levels=28"])
    levels = ["cells=%d smallest=%s" % level for level in
              ((6, "3e-4"), (8, "1e-4"), (12, "1e-4"), (16, "1e-4"), (24, "3e-5"), (32, "3e-5"), (48, "1e-5"), (64, "1e-5"))]
    yield from calculix("punch", "punch_calculix.py", "CPE8R graded", levels, "element=CPE8R")


def hertz():
    yield from abut("hertz", "hertz.prm")
    for degree in (2, 3):
        yield from freefem("hertz", "hertz.edp", "P%d graded" % degree, degree, "-grade",
                           [1.5, 0.8, 0.5, 0.35, 0.25, 0.18, 0.12], ["-repeats", "4", "-passes", "3"])
    for degree, levels in ((2, [12, 16, 24, 32, 40, 48]), (3, [12, 16, 24, 32])):
        yield from getfem("hertz", "hertz_getfem.py", "Q", degree, cells(levels))
    yield from penalties("hertz", "hertz_calculix.py",
                         {"1e7": [8, 12], "1e8": [8, 12, 16, 24], "1e9": [12, 16, 24, 32, 48]})


def floating():
    yield from abut("floating", "floating.prm")
    yield from layers_of("floating", "floating", "layers=3")


SCENES = {"layers": layers, "punch": punch, "hertz": hertz, "floating": floating}


def of_scene(scene):
    return list(SCENES[scene]())


def check_programs():
    for program in ("FreeFem++", "ccx", PYTHON):
        if not shutil.which(program):
            sys.exit("contrib/peers/run: %s is missing; start contrib/peers/run, which installs it" % program)
    if not os.path.exists(ABUT):
        sys.exit("contrib/peers/run: %s is missing; contrib/build builds it" % ABUT)
