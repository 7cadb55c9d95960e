# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seconds to reach an error."""
import re

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


def cells(values):
    return "".join("%12s" % ("-" if value is None else "%.3g" % value) for value in values)


def cost_table(rows, quantity, clock):
    """By program, the last column the fastest peer's time over abut's."""
    programs = [program for program in PROGRAMS if any(row["program"] == program for row in rows)]
    yield "%s; %s" % (title(quantity), CLOCKS[clock])
    yield "%10s" % "at most" + "".join("%12s" % program for program in programs) + "%20s" % "fastest peer : abut"
    for level in LEVELS[quantity]:
        found = {program: fastest([row for row in rows if row["program"] == program], quantity, level, clock)
                 for program in programs}
        peers = [(row[clock], program) for program, row in found.items() if row and program != "abut"]
        ratio = "-"
        if found.get("abut") and peers:
            ratio = "%.2g (%s)" % (min(peers)[0] / found["abut"][clock], min(peers)[1])
        yield "%8g %%" % level + cells(row and row[clock] for row in found.values()) + "%20s" % ratio


def memory_table(rows, quantity):
    programs = [program for program in PROGRAMS if any(row["program"] == program for row in rows)]
    yield "%s; peak memory in MB of the run that is fastest as a whole process" % title(quantity)
    yield "%10s" % "at most" + "".join("%12s" % program for program in programs)
    for level in LEVELS[quantity]:
        found = [fastest([row for row in rows if row["program"] == program], quantity, level, "seconds")
                 for program in programs]
        yield "%8g %%" % level + cells(row and row["memory_mb"] for row in found)


def variant_table(rows, quantity, clock):
    yield "%s, each variant; %s" % (title(quantity), CLOCKS[clock])
    yield "%-40s" % "" + "".join("%10s" % ("%g %%" % level) for level in LEVELS[quantity])
    for name in dict.fromkeys((row["program"], row["variant"]) for row in rows):
        of_variant = [row for row in rows if (row["program"], row["variant"]) == name]
        found = [fastest(of_variant, quantity, level, clock) for level in LEVELS[quantity]]
        yield "%-40s" % ", ".join(name) + "".join("%10s" % ("%.3g" % row[clock] if row else "-") for row in found)


def of_scene(rows):
    """Lines, an empty one after each table."""
    lines = []
    for quantity in LEVELS:
        if any(row[quantity] is not None for row in rows):
            for table in (*(cost_table(rows, quantity, clock) for clock in CLOCKS), memory_table(rows, quantity),
                          variant_table(rows, quantity, "cpu_seconds")):
                lines += [*table, ""]
    return lines


def write_to_page(name, lines, path):
    """In place of all that stands between the figure of this name and the next heading."""
    with open(path) as file:
        page = file.read()
    text = "".join("    %s\n" % line if line else "\n" for line in lines)
    figure = r"(!\[[^\]]*\]\(figures/%s\)\n\n)" % re.escape(name)
    page, found = re.subn(figure + r".*?(?=^#)", lambda match: match[1] + text, page, flags=re.DOTALL | re.MULTILINE)
    if found != 1:
        raise SystemExit("%s has no figure %s with a heading after it" % (path, name))
    with open(path, "w") as file:
        file.write(page)
