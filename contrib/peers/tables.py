# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seconds to reach an error."""
LEVELS = {"error_stress": [5, 1, 0.5, 0.1, 0.02, 0.005], "error_pressure": [5, 1, 0.1, 0.02]}  # per cent
CLOCKS = {"seconds": "whole process, seconds", "seconds_without_start": "less the start of an empty program, seconds",
          "cpu_seconds": "whole process, processor seconds"}
PROGRAMS = ["abut", "FreeFEM", "GetFEM", "CalculiX"]


def fastest(rows, quantity, level, clock):
    """The row that reaches the error in the least time, or None."""
    reaching = [row for row in rows if row[quantity] is not None and 100 * row[quantity] <= level]
    return min(reaching, key=lambda row: row[clock], default=None)


def title(quantity):
    return quantity.replace("error_", "").capitalize() + " error"


def print_table(rows, quantity, clock):
    programs = [program for program in PROGRAMS if any(row["program"] == program for row in rows)]
    print("\n%s; %s" % (title(quantity), CLOCKS[clock]))
    print("%10s" % "at most" + "".join("%12s" % program for program in programs) + "%20s" % "fastest peer : abut")
    for level in LEVELS[quantity]:
        found = {program: fastest([row for row in rows if row["program"] == program], quantity, level, clock)
                 for program in programs}
        cells = ["%12s" % ("%.3g" % row[clock] if row else "-") for row in found.values()]
        peers = [(row[clock], program) for program, row in found.items() if row and program != "abut"]
        ratio = "-"
        if found.get("abut") and peers:
            ratio = "%.2g (%s)" % (min(peers)[0] / found["abut"][clock], min(peers)[1])
        print("%8g %%" % level + "".join(cells) + "%20s" % ratio)


def print_variants(rows, quantity, clock):
    print("\n%s, each variant; %s" % (title(quantity), CLOCKS[clock]))
    print("%-40s" % "" + "".join("%10s" % ("%g %%" % level) for level in LEVELS[quantity]))
    for name in dict.fromkeys((row["program"], row["variant"]) for row in rows):
        of_variant = [row for row in rows if (row["program"], row["variant"]) == name]
        found = [fastest(of_variant, quantity, level, clock) for level in LEVELS[quantity]]
        print("%-40s" % ", ".join(name) + "".join("%10s" % ("%.3g" % row[clock] if row else "-") for row in found))


def print_scene(scene, rows):
    print("\n== %s ==" % scene)
    for quantity in LEVELS:
        if not any(row[quantity] is not None for row in rows):
            continue
        for clock in CLOCKS:
            print_table(rows, quantity, clock)
        print_variants(rows, quantity, "cpu_seconds")
