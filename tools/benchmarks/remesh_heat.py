# SPDX-License-Identifier: GPL-3.0-or-later
"""By how much a new mesh in mid-stage changes the heat that leaves the glass at that instant, in all bundled containers."""
import re

from benchmarks.common import BUILD, ROOT, Figure, build, new_path, run

CASES = ("jar", "bottle", "tumbler", "flute", "nnpb", "uneven")
LAST_LINE = re.compile(r"(\d+) new meshes in mid-stage; largest change of all heat ([\d.]+) %")


def section(options):
    build("remesh_heat")
    for accuracy in (options.accuracy or "draft",):
        worst = 0
        for case in CASES:
            log = new_path(f"{case}.log")
            run([BUILD / "tools/benchmarks/programs/remesh_heat", ROOT / f"cases/{case}/case.toml", accuracy, new_path("run")], log)
            text = open(log).read()
            found = LAST_LINE.search(text)
            if not found:
                raise RuntimeError(f"{case} at {accuracy}: {text.splitlines()[-1]}")
            meshes, change = int(found[1]), float(found[2])
            worst = max(worst, change)
            yield Figure(f"remesh_heat.{accuracy}.{case}", f"{case} at {accuracy}: heat from the glass, largest change by one of {meshes} new meshes",
                         change, 0.3, unit="%")
        yield Figure(f"remesh_heat.{accuracy}.worst", "  the largest of all", worst, 0.3, unit="%")
