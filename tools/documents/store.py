# SPDX-License-Identifier: GPL-3.0-or-later
"""Stored figures: those of the benchmarks, of the verification tests, and of the bundled cases, which this module also runs."""
import csv
import json
import os
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
DIFFERENCE_BARS = ROOT / "tests/bars/what_ifs_measured.json"
DIFFERENCE_COSTS = ROOT / "tests/bars/what_if_costs.json"
SWEEP_COSTS = ROOT / "tests/sweeps/costs.json"
COVERAGE = ROOT / "tests/coverage.json"
VERIFICATION = ROOT / "tests/figures.json"
PERFECT = '"1e9 W/m2/K"'

# Runs whose figures a README quotes: a name, the accuracy, and what replaces the case's own values.
RUNS = {
    "jar": {
        "draft": ("draft", []),
        "standard": ("standard", []),
        "fine": ("fine", []),
        "dwell_500N": ("draft", ["stage.dwell.motion.plunger.force=500 N"]),
        "dwell_8kN": ("draft", ["stage.dwell.motion.plunger.force=8 kN"]),
        "perfect": ("standard", [f"interface.0.h0={PERFECT}", f"interface.0.h1={PERFECT}"]),
        "mould_perfect": ("standard", [f"interface.blow_mould.h0={PERFECT}", f"interface.blow_mould.h1={PERFECT}"]),
    },
    "bottle": {"draft": ("draft", []), "standard": ("standard", []), "fine": ("fine", [])},
    "tumbler": {"draft": ("draft", []), "standard": ("standard", []), "fine": ("fine", [])},
    "nnpb": {"draft": ("draft", []), "standard": ("standard", [])},
    "flute": {"draft": ("draft", []), "standard": ("standard", [])},
    "uneven": {"draft": ("draft", []), "even": ("draft", ["dimension.dwell=1.2 s", "dimension.reheat=1.8 s", "dimension.run=0.5 s"])},
    "sag": {"draft": ("draft", []), "standard": ("standard", [])},
    "vial": {"draft": ("draft", []), "standard": ("standard", [])},
    "contact_cylinders": {"draft": ("draft", [])},
    "shell_inflation": {"draft": ("draft", []), "standard": ("standard", [])},
}
KEPT = ("accuracy", "overrides", "time_s", "cpu_seconds", "steps", "remeshes", "timing", "volume_drift", "max_volume_drift",
        "energy_imbalance", "max_work_imbalance", "max_penetration_mm", "max_reynolds", "outer_within_0.2mm_of_tools",
        "temperature_overshoot_K", "remeshing", "glass", "tools", "thickness", "quantities")
OF_STAGE_END = ("glass_mean_degC", "heat_to_tools_J", "heat_to_air_J")


class Missing(Exception):
    """A figure that no command has stored yet; the text names the command."""


def read(path, command):
    if not path.exists():
        raise Missing(f"{path.relative_to(ROOT)} is missing: {command} writes it")
    return json.loads(path.read_text())


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
    kept = {key: summary[key] for key in KEPT if key in summary}
    kept["stages"] = stage_ends(summary, rows)
    kept["expectations"] = {label: found for label, found, _ in expect.judge(summary, rows, ROOT / "cases" / case)}
    kept["thickness_profile_mm"] = summary["thickness_profile_mm"]
    return rounded(kept)


def write(case, stored):
    """One line for each run and key: what changed is seen in a diff."""
    text = ",\n".join(
        f" {json.dumps(name)}: {{\n" + ",\n".join(f"  {json.dumps(key)}: {json.dumps(value)}" for key, value in run.items()) +
        "\n }" for name, run in stored.items())
    (ROOT / "cases" / case / "figures.json").write_text("{\n" + text + "\n}\n")


def measure(which):
    """Runs a case, or one of its runs as CASE.NAME, and stores the figures."""
    case, _, only = which.partition(".")
    if case not in RUNS or (only and only not in RUNS[case]):
        raise Missing(f"\"{which}\" was found, allowed are {', '.join(RUNS)}, with .NAME behind it for one run of "
                      f"{', '.join(RUNS.get(case, ['a case']))}")
    path = ROOT / "cases" / case / "figures.json"
    stored = json.loads(path.read_text()) if path.exists() else {}
    one_thread = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    for name, (accuracy, overrides) in RUNS[case].items():
        if only and name != only:
            continue
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
        write(case, {name: stored[name] for name in RUNS[case] if name in stored})
