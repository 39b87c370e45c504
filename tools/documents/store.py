# SPDX-License-Identifier: GPL-3.0-or-later
"""Stored figures: those of the benchmarks, of the verification tests, and of the bundled cases, which this module also runs."""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BENCHMARKS = ROOT / "tools/benchmarks/last.json"
REFERENCES = ROOT / "tools/benchmarks/references.json"
CALIBRATION = ROOT / "forming/scene/calibration.json"
BARS = ROOT / "tests/bars/measured.json"
ASKED = ROOT / "tests/bars/asked_accuracies.json"
DIFFERENCE_BARS = ROOT / "tests/bars/what_ifs_measured.json"
DIFFERENCE_COSTS = ROOT / "tests/bars/what_if_costs.json"
PRODUCTION_COSTS = ROOT / "tests/bars/production_costs.json"
SWEEP_COSTS = ROOT / "tests/sweeps/costs.json"
SLURM_COSTS = ROOT / "tests/sweeps/slurm_costs.json"
VERIFICATION = ROOT / "tests/figures.json"

# What light does in the glass of a case: as it stands, and by other models of radiation.
MODELS = ("enclosure", "transfer", "p1", "none", "rosseland")


def with_light(model):
    """What replaces values of a bundled case for a model of radiation; `enclosure` is the case itself: transfer whose surfaces see each other."""
    alone = ["enclosure=false"] if model in ("transfer", "p1") else []
    return [] if model == "enclosure" else [f"material.flint.radiation.model={model}", *alone]


def light_runs():
    return {f"light_{model}": ("draft", with_light(model)) for model in MODELS}


# Gob and tools of the blank side of the jar hotter by 5 K.
WARMER = {"": [], "_gob": ["glass.temperature=1155 degC"],
          "_tools": [f"tool.{tool}.temperature.plus=5 K" for tool in ("ring", "plate", "blank", "plunger")]}
SLOPE_MODELS = ("enclosure", "none", "rosseland")


def slope_runs():
    return {f"slope_{model}{warmer}": ("draft", with_light(model) + sets) for model in SLOPE_MODELS
            for warmer, sets in WARMER.items() if warmer}


# Runs whose figures a README quotes: a name, the accuracy, and what replaces the case's own values.
RUNS = {
    "jar": {
        "draft": ("draft", []),
        "standard": ("standard", []),
        "fine": ("fine", []),
        "dwell_500N": ("draft", ["stage.dwell.motion.plunger.force=500 N"]),
        "dwell_8kN": ("draft", ["stage.dwell.motion.plunger.force=8 kN"]),
        **light_runs(),
        **slope_runs(),
    },
    "bottle": {"draft": ("draft", []), "standard": ("standard", []), **light_runs()},
    "tumbler": {"draft": ("draft", []), "standard": ("standard", []), **light_runs()},
    "nnpb": {"draft": ("draft", []), "standard": ("standard", [])},
    "flute": {"draft": ("draft", []), "standard": ("standard", [])},
    "uneven": {"draft": ("draft", []), "even": ("draft", ["dimension.dwell=1.7 s", "dimension.reheat=1.6 s", "dimension.run=0.5 s"])},
    "square_jar": {"draft": ("draft", [])},
    "square_spirit": {"sketch": ("draft coarser 2", [])},
    "flask": {"sketch": ("draft coarser 2", [])},
    "sag": {"draft": ("draft", []), "standard": ("standard", [])},
    "vial": {"draft": ("draft", []), "standard": ("standard", [])},
    "contact_cylinders": {"draft": ("draft", [])},
    "shell_inflation": {"draft": ("draft", []), "standard": ("standard", [])},
}


LIT = [case for case, runs in RUNS.items() if "light_enclosure" in runs]  # cases whose models of radiation are compared


KEPT = ("accuracy", "time_s", "cpu_seconds", "steps", "remeshes", "volume_drift", "max_volume_drift",
        "energy_imbalance", "max_work_imbalance", "max_penetration_mm", "outer_within_0.2mm_of_tools",
        "remeshing", "glass", "tools", "thickness", "quantities", "solid")
OF_STAGE_END = ("glass_mean_degC", "heat_to_tools_J", "heat_to_air_J", "skin_mean_degC")
SKIN_ROWS = 120  # of the skin over time, at the most


class Missing(Exception):
    """A figure that no command has stored yet; the text names the command."""


def read(path, command):
    if not path.exists():
        raise Missing(f"{path.relative_to(ROOT)} is missing: {command} writes it")
    return json.loads(path.read_text())


def files(pattern):
    """All files of the repository by a pattern of git, those not committed yet too; where there is no git those in the folder."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", pattern], capture_output=True, text=True)
    paths = [ROOT / line for line in listed.stdout.split("\n") if line]
    return [path for path in paths or sorted(ROOT.rglob(pattern)) if path.is_file()]


@lru_cache
def benchmarks():
    return read(BENCHMARKS, "tools/bench --save")


def benchmark(key):
    """A figure of tools/bench by its key."""
    if key not in benchmarks():
        raise Missing(f"{BENCHMARKS.relative_to(ROOT)} has no \"{key}\": tools/bench {key.split('.')[0]} --save writes it")
    return benchmarks()[key]


@lru_cache
def verification():
    return read(VERIFICATION, "tools/verification_table")


@lru_cache
def runs(case):
    return read(ROOT / "cases" / case / "figures.json", f"tools/readme_figures --run {case}")


def run(case, name):
    """The stored figures of one of RUNS."""
    if name not in runs(case):
        raise Missing(f"cases/{case}/figures.json has no run \"{name}\": tools/readme_figures --run {case}.{name} writes it")
    return runs(case)[name]


def rounded(value):
    """Six digits are enough for any README and keep round-off out of the stored files."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    return [rounded(item) for item in value] if isinstance(value, list) else value


def stage_ends(summary, rows):
    """Figures of the history at the end of each stage."""
    ends = []
    for stage in summary["stages"]:
        row = min(rows, key=lambda r: abs(float(r["time_s"]) - stage["end_s"]))
        positions = {key[:-len("_position_mm")]: float(value) for key, value in row.items() if key.endswith("_position_mm")}
        ends.append({"name": stage["name"], "end_s": stage["end_s"], "positions_mm": positions,
                     **{key: float(row[key]) for key in OF_STAGE_END if row.get(key, "nan") != "nan"}})
    return ends


def figures(case, results):
    """What is kept of a result folder."""
    sys.path.insert(0, str(ROOT / "tools"))
    import expect  # the comparison that the tests make

    summary = json.loads((results / "summary.json").read_text())
    with open(results / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    if (results / "solid/summary.json").exists():
        summary["solid"] = json.loads((results / "solid/summary.json").read_text())
    kept = {key: summary[key] for key in KEPT if key in summary}
    kept["stages"] = stage_ends(summary, rows)
    kept["expectations"] = {label: found for label, found, _ in expect.judge(summary, rows, ROOT / "cases" / case)}
    if "thickness_profile_mm" in summary:
        kept["thickness_profile_mm"] = summary["thickness_profile_mm"]
    return rounded(kept)


OF_PHYSICS = re.compile(r"thickness_mean|glass_mean|heat_\w+")  # quantities that scatter little from run to run
LARGEST_CHANGE = 0.01  # of their scale; walls of containers scatter by 0.1 to 0.3 % (tools/bench noise container_noise)


def changes(case, results):
    """A sentence for each quantity of a draft run that is no longer what is stored: the figures are older than the physics."""
    known = run(case, "draft")["quantities"]
    now = figures(case, results)["quantities"]
    all_heat = sum(quantity["value"] for name, quantity in known.items() if name.startswith("heat_"))
    for name in sorted(name for name in now.keys() | known.keys() if OF_PHYSICS.fullmatch(name)):
        if name not in now or name not in known:
            yield f"cases/{case}/figures.json: {name} is in one of the stored and the present results alone"
            continue
        # The heat of a tool counts against the geometric mean of its own and all heat, as in error bars.
        scale = (known[name]["scale"] * all_heat) ** 0.5 if name.startswith("heat_") else known[name]["scale"]
        change = abs(now[name]["value"] - known[name]["value"]) / scale
        if change > LARGEST_CHANGE:
            yield (f"cases/{case}/figures.json: {name} was {known[name]['value']:g} {known[name]['unit']} and is {now[name]['value']:g}, a change of "
                   f"{100 * change:.1f} %; tools/readme_figures --run {case} stores what the program gives")


def skin_over_time(rows):
    """Time in s and mean skin of the glass in degC at places all along the run."""
    known = [[float(row["time_s"]), float(row["skin_mean_degC"])] for row in rows if row.get("skin_mean_degC", "nan") != "nan"]
    return known[::max(1, len(known) // SKIN_ROWS)]


def write(case, stored):
    """One line for each run and key: what changed is seen in a diff."""
    text = ",\n".join(
        f" {json.dumps(name)}: {{\n" + ",\n".join(f"  {json.dumps(key)}: {json.dumps(value)}" for key, value in run.items()) +
        "\n }" for name, run in stored.items())
    (ROOT / "cases" / case / "figures.json").write_text("{\n" + text + "\n}\n")


def measure(which):
    """Runs a case, or those of its runs that CASE.NAME names or begins, and stores the figures."""
    case, _, only = which.partition(".")
    chosen = {name: run for name, run in RUNS.get(case, {}).items() if only in ("", name) or name.startswith(only + "_")}
    if not chosen:
        raise Missing(f"\"{which}\" was found, allowed are {', '.join(RUNS)}, with .NAME behind it for one run of "
                      f"{', '.join(RUNS.get(case, ['a case']))}")
    path = ROOT / "cases" / case / "figures.json"
    stored = json.loads(path.read_text()) if path.exists() else {}
    one_thread = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    for name, (accuracy, overrides) in chosen.items():
        with tempfile.TemporaryDirectory(prefix="parison_figures_") as folder:
            results = Path(folder) / "results"
            command = [ROOT / "build/parison", "run", ROOT / "cases" / case, "--accuracy", accuracy, "--output", results]
            for assignment in overrides:
                command += ["--set", assignment]
            print(f"{case}, {name}", flush=True)
            done = subprocess.run(command, env=one_thread, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if done.returncode:
                raise RuntimeError(f"parison run {case} ended with {done.returncode}:\n{done.stdout[-800:]}")
            stored[name] = figures(case, results)
            if name.startswith("light_"):
                with open(results / "history.csv", newline="") as file:
                    stored[name]["skin"] = rounded(skin_over_time(list(csv.DictReader(file))))
        write(case, {name: stored[name] for name in RUNS[case] if name in stored})
