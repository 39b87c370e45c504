# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of searches and of studies of tolerances: made by the commands themselves, stored beside the case, written as blocks."""
import csv
import json
import os
import subprocess
import tempfile
import tomllib
from pathlib import Path

import numpy as np

from documents.store import ROOT, Missing, read, rounded
from documents.tables import digits, table

SEARCHED = ("jar", "bottle")
TOLERANCES = {"jar": ("tool.blank.temperature.plus=0 +- 10 K", "tool.plunger.temperature.plus=0 +- 15 K", "interface.0.h0=500 +- 200 W/m2/K",
                      "glass.temperature=1150 +- 5 degC", "stage.reheat.duration=1.6 +- 0.05 s")}
QUANTITIES = ("thickness_min", "glass_mean", "glass_skin", "heat_blank", "heat_plunger")


def parison(*words):
    one_thread = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    print(*words, flush=True)
    subprocess.run([ROOT / "build/parison", *words], env=one_thread, check=True, stdout=subprocess.DEVNULL)


def path_of(case, study):
    return ROOT / "cases" / case / f"{study}.json"


def even_wall(thickness, lowest):
    """The rms deviation of a wall above a height, % of its mean by area of the outer side, and its thinnest place, mm, at the 201 places of the
    outer arc at which a search takes them (`sample` and `add_wall` of forming/study/search/outcome.cpp)."""
    with open(thickness, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    places = np.linspace(0, max(float(row["arc_mm"]) for row in rows), 201)
    known = [row for row in rows if row["thickness_mm"] != "nan"]
    arc, radius, height, wall = (np.array([float(row[key]) for row in known]) for key in ("arc_mm", "r_outer_mm", "z_outer_mm", "thickness_mm"))
    counts = np.interp(places, arc, height) >= lowest
    area, wall = np.interp(places, arc, radius)[counts], np.interp(places, arc, wall)[counts]
    mean = np.average(wall, weights=area)
    return {"value": float(100 * np.sqrt(np.average((wall - mean) ** 2, weights=area)) / mean), "wall_min": float(wall.min())}


def measure_search(case, folder=None):
    """Runs the search of a case, or takes the folder of one that was run, and stores what the README says of it."""
    with tempfile.TemporaryDirectory(prefix="parison_search_") as scratch:
        goal = ROOT / "cases" / case / "even_wall.toml"
        if not folder:
            folder = Path(scratch) / "search"
            parison("optimise", goal, "--output", folder)
        drawn = Path(scratch) / "drawn"
        parison("run", ROOT / "cases" / case, "--accuracy", "draft", "--output", drawn)
        lowest = float(tomllib.loads(goal.read_text())["goal"]["from"].split()[0])
        result = json.loads((Path(folder) / "result.json").read_text())
        kept = {"runs": result["runs"], "failed": result["failed"], "ending": result["ending"],
                "drawn": even_wall(drawn / "thickness.csv", lowest)}
    for name in ("start", "best"):
        kept[name] = {"value": result[name]["value"], "wall_min": result[name]["quantities"]["wall_min"],
                      "confirmed": {key: result[name]["confirmed"][key] for key in ("accuracy", "value", "error")}}
    path_of(case, "search").write_text(json.dumps(rounded(kept), indent=1) + "\n")


def measure_tolerances(case, folder=None):
    """The same of the study of tolerances of a case."""
    with tempfile.TemporaryDirectory(prefix="parison_uncertainty_") as scratch:
        if not folder:
            folder = Path(scratch) / "study"
            parison("uncertainty", ROOT / "cases" / case, "--output", folder, *(word for one in TOLERANCES[case] for word in ("--set", one)))
        study = json.loads((Path(folder) / "uncertainty.json").read_text())
    kept = {key: study[key] for key in ("accuracy", "runs_done", "runs_failed")}
    kept["tolerances"] = [one["key"] for one in study["tolerances"]]
    kept["quantities"] = {name: study["quantities"][name] for name in QUANTITIES}
    path_of(case, "uncertainty").write_text(json.dumps(rounded(kept), indent=1) + "\n")


def searches():
    """A row for each case whose search was run."""
    rows = []
    for case in SEARCHED:
        if not path_of(case, "search").exists():
            continue
        found = read(path_of(case, "search"), f"tools/readme_figures --search {case}")
        best, confirmed = found["best"], found["best"]["confirmed"]
        rows.append([case, *(f"{digits(found[name]['value'])} %" for name in ("drawn", "start")), f"{digits(best['value'])} %",
                     f"{digits(confirmed['value'])} ± {digits(confirmed['error'])} %",
                     f"{digits(found['drawn']['wall_min'], 3)}, {digits(best['wall_min'], 3)} mm", str(found["runs"]), found["ending"]])
    if not rows:
        raise Missing(f"no search is stored; tools/readme_figures --search {SEARCHED[0]} runs one")
    return table(["case", "rms over mean as drawn, draft", "at the start of the search", "of the answer", "of the answer at standard",
                  "thinnest as drawn, of the answer", "draft runs", "why it ended"], rows)


def tolerances(case):
    found = read(path_of(case, "uncertainty"), f"tools/readme_figures --uncertainty {case}")
    rows = []
    for name, quantity in found["quantities"].items():
        totals = {key: index["total"] for key, index in quantity["tolerances"].items()}
        most = max(totals, key=lambda key: totals[key]["value"])
        rows.append([name, f"{digits(quantity['mean'], 4)} {quantity['unit']}", digits(quantity["numerical_bar"]), digits(quantity["tolerance_bar"]),
                     digits(quantity["bar"]), f"{most}: {digits(totals[most]['value'])} ({digits(totals[most]['low'])} to {digits(totals[most]['high'])})",
                     digits(quantity["q2"])])
    return table(["quantity", "mean", "numerical bar", "bar of the tolerances", "both", "largest total index, with its interval", "Q2"], rows)


BLOCKS = {function.__name__: function for function in (searches, tolerances)}


def measure(what, names):
    """NAME or NAME=FOLDER of searches or studies."""
    allowed = SEARCHED if what is measure_search else tuple(TOLERANCES)
    for name in names:
        case, _, folder = name.partition("=")
        if case not in allowed:
            raise Missing(f"\"{case}\" was found, allowed are {', '.join(allowed)}")
        what(case, folder)
