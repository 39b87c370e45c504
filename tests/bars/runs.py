# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the scenes with error bars, and the references that they are compared with."""
import json
import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

from .exact import SOLUTIONS

HERE = Path(__file__).resolve().parent
SCENES, REFERENCES, MEASURED = HERE / "scenes", HERE / "references.json", HERE / "measured.json"
# References are far finer than fine: edges and steps in units of its; what a scene costs decides.
FINER = {"bottle_blow": 0.6, "vial": 0.6, "neck_press": 0.65, "slab_press": 0.65, "tube": 0.3, "gob": 0.45,
         "plate_over_ring": 0.45, "cup": 0.45, "squash": 0.45, "punch": 0.45, "bar_press": 0.45,
         "cup_force": 0.5, "dish": 0.45, "lens": 0.45, "pestle": 0.4, "bar_stroke": 0.5, "pad": 0.4}
FINEST = 0.3
QUIET = ("--set", "output.interval=1000 s")


def scene_names():
    return sorted(path.stem for path in SCENES.glob("*.toml"))


def run(command, log):
    """Runs a command on one thread, waits for it and returns its exit code and its CPU time, s."""
    log.parent.mkdir(parents=True, exist_ok=True)
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    with open(log, "w", encoding="utf-8") as file:
        process = subprocess.Popen([str(word) for word in command], stdout=file, stderr=subprocess.STDOUT, env=environment)
        _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, used.ru_utime + used.ru_stime


def cpu_of(command, log):
    """CPU time of a command and of what it starts, s; the end of the program where the command fails."""
    code, seconds = run(command, log)
    if code != 0:
        sys.exit(f"{Path(sys.argv[0]).name}: exit code {code}, see {log}")
    return seconds


def run_case(parison, case, accuracy, folder, error_bars=False):
    """The summary of a run with the CPU time of the whole command, None where it did not complete."""
    shutil.rmtree(folder, ignore_errors=True)
    command = [parison, "run", case, "--accuracy", accuracy, "--output", folder, *QUIET]
    code, seconds = run(command + ["--error-bars"] * error_bars, folder.with_suffix(".log"))
    if code != 0:
        return None
    return {**json.loads((folder / "summary.json").read_text(encoding="utf-8")), "command_cpu_seconds": seconds}


def folder_of(output, name, accuracy):
    return output / name.replace("/", "_") / accuracy.replace(" ", "_")


def rounded(value, digits):
    return None if value is None or not math.isfinite(value) else float(f"{value:.{digits}g}")


def reference_of(summary, accuracy):
    """What is kept of the run of a reference."""
    return {"accuracy": accuracy, "cpu_seconds": rounded(summary["cpu_seconds"], 3),
            "quantities": {name: rounded(quantity["value"], 9) for name, quantity in summary["quantities"].items()},
            "thickness_profile_mm": [rounded(value, 6) for value in summary["thickness_profile_mm"]]}


def make_reference(parison, name, folder):
    accuracy = f"fine coarser {FINER.get(name, FINEST)}"
    summary = run_case(parison, SCENES / f"{name}.toml", accuracy, folder)
    return reference_of(summary, accuracy) if summary else None


def write_references(found, path=REFERENCES):
    lines = [f' "{name}": {json.dumps(found[name])}' for name in sorted(found)]
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def references():
    """The references, with the exact values where a scene has them."""
    found = json.loads(REFERENCES.read_text(encoding="utf-8")) if REFERENCES.is_file() else {}
    for name, solution in SOLUTIONS.items():
        if name in found:
            found[name]["quantities"].update(solution())
            found[name]["quantities"].pop("thickness_min_at", None)  # the wall is the same everywhere
    return found
