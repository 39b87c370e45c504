# SPDX-License-Identifier: GPL-3.0-or-later
"""How long the program takes to start: commands that need no mesher, and one that does."""
import statistics

from benchmarks.common import BUILD, Figure, ROOT, build, new_path, run

STARTS = 41


def median_start(*arguments):
    log = new_path("start.log")
    return statistics.median(run([BUILD / "parison", *arguments], log).cpu for _ in range(STARTS))


def section(_options):
    build("parison")
    yield Figure("start.version", f"`parison --version`, median of {STARTS} starts", median_start("--version"), 0.05, unit="s")
    yield Figure("start.check", "`parison check` of a case that is not meshed by gmsh",
                 median_start("check", ROOT / "cases/shell_inflation"), unit="s")
    yield Figure("start.mesher", "`parison check` of one that is", median_start("check", ROOT / "cases/sag"), unit="s")
