# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene run and held against its exact values."""
import json
import os
import shutil
import subprocess
from dataclasses import dataclass

ALLOWED = 0.01  # error of a result of which nothing need be said


@dataclass
class Outcome:
    status: str  # holds, flagged, refused, stopped, silent, crash
    error: float = float("nan")
    said: str = ""
    seconds: float = 0.0


def value(summary, key):
    for part in key.split("."):
        summary = summary[part]
    return float("nan") if summary is None else float(summary)


def error_of(scene, summary):
    errors = [] if scene.error is None else [scene.error(summary)]
    for key, wanted in scene.exact.items():
        got = value(summary, key)
        errors.append(abs(got - wanted) / abs(wanted) if wanted else abs(got))
    return max(errors, key=lambda e: float("inf") if e != e else e)


def run(parison, scene, folder, accuracy="draft", limit=60, allowed=ALLOWED):
    """Runs a scene in a folder of its own, which is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    with open(f"{folder}/case.toml", "w", encoding="utf-8") as case:
        case.write(scene.text)
    try:
        done = subprocess.run([parison, "run", folder, "--accuracy", accuracy, "--output", f"{folder}/results"], capture_output=True,
                              text=True, timeout=limit, check=False,
                              env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"})
    except subprocess.TimeoutExpired:
        return Outcome("hangs", said=f"no end within {limit} s")
    message = (done.stderr.strip().splitlines() or [""])[0]
    if done.returncode == 2:
        return Outcome("refused", said=message)
    if done.returncode not in (0, 1, 3):
        return Outcome("crash", said=f"exit code {done.returncode}: {message}")
    with open(f"{folder}/results/summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    if done.returncode == 1:
        return Outcome("stopped", said=summary["reason"], seconds=summary["cpu_seconds"])
    beyond = [check for check in summary["checks"] if check["verdict"] != "inside"]
    said = "; ".join(f"{check['name']} {check['value']:.2g}" if check["value"] is not None else check["name"] for check in beyond)
    error = error_of(scene, summary)
    status = "flagged" if beyond else "holds" if error <= allowed else "silent"
    return Outcome(status, error, said or "; ".join(summary["warnings"]), summary["cpu_seconds"])
