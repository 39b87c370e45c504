# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of case folders: check, run within a CPU limit, what their summaries say."""
import json
import os
import re
import resource
import signal
import subprocess

WALL_PER_CPU = 10  # a run on a busy machine may take so many times its CPU limit
COLUMNS = ("name", "completed", "max_volume_drift", "max_work_imbalance", "max_penetration_mm", "max_edge_penetration_mm",
           "short_mm", "laps", "cpu_seconds", "reason")


def command(arguments, cpu_limit, log):
    """Exit code of a command on one thread, negative for a signal; None where its time ran out."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (cpu_limit, cpu_limit + 5))

    try:
        with open(log, "w", encoding="utf-8") as out:
            code = subprocess.run(arguments, stdout=out, stderr=subprocess.STDOUT, env=environment, preexec_fn=limit,
                                  timeout=WALL_PER_CPU * cpu_limit, check=False).returncode
    except subprocess.TimeoutExpired:
        return None
    return None if code in (-24, -9) else code  # SIGXCPU, SIGKILL


def last_lines(log, count=3):
    lines = log.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return " | ".join(lines[-count:])


def last_progress(log):
    """The last line of progress of a run, as far as stage, time and step."""
    found = re.findall(r"^\s*(\w+)\s+t\s+([\d.]+ s)\s+step\s+(\d+)", log.read_text(encoding="utf-8", errors="replace"), re.M)
    return "stage {} at {}, step {}".format(*found[-1]) if found else "no step"


def shortfall(folder, full):
    """How far the plunger stood from its place in the full cavity at the end of the press, mm; nan where it is not known."""
    rows = (folder / "history.csv").read_text(encoding="utf-8").splitlines()
    head = rows[0].split(",")
    if "plunger_position_mm" not in head:
        return float("nan")
    stage, position = head.index("stage"), head.index("plunger_position_mm")
    pressed = [row.split(",") for row in rows[1:] if row.split(",")[stage] in ("press", "fill")]
    return abs(float(pressed[-1][position]) - full) if pressed else float("nan")


def run_container(parison, folder, facts, accuracy, cpu_limit):
    """The row of a container whose case.toml stands in `folder`."""
    row = {"name": folder.name, "completed": False, "checked": False, "reason": "", **facts}
    check = command([parison, "check", folder, "--accuracy", accuracy], 60, folder / "check.log")
    if check != 0:
        return {**row, "reason": f"refused by check: {last_lines(folder / 'check.log')}"}
    row["checked"] = True
    results = folder / "results"
    code = command([parison, "run", folder, "--accuracy", accuracy, "--output", results], cpu_limit, folder / "run.log")
    if code is None:
        return {**row, "reason": f"more than {cpu_limit} s of CPU, last: {last_progress(folder / 'run.log')}"}
    if code < 0:
        return {**row, "reason": f"crashed with {signal.Signals(-code).name}, last: {last_progress(folder / 'run.log')}"}
    if not (results / "summary.json").is_file():
        return {**row, "reason": f"exit code {code} without a summary: {last_lines(folder / 'run.log')}"}
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    for key in ("completed", "reason", "max_volume_drift", "max_work_imbalance", "max_penetration_mm",
                "max_edge_penetration_mm", "cpu_seconds", "steps", "rejected_steps", "remeshes"):
        row[key] = summary[key]
    if code not in (0, 1):
        row.update(completed=False, reason=f"exit code {code}: {last_lines(folder / 'run.log')}")
    if not row["completed"] and not row["reason"]:
        row["reason"] = "stopped without a reason"
    row["laps"] = summary["remeshing"]["laps"]
    row["thickness_min_mm"], row["thickness_mean_mm"] = (summary["thickness"].get(key) for key in ("min_mm", "mean_mm"))
    row["outer_within"] = summary["outer_within_0.2mm_of_tools"]
    if facts.get("full_mm") is not None:
        row["short_mm"] = shortfall(results, facts["full_mm"])
    return row


def shown(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def line(row):
    """One line of the table."""
    widths = (18, 9, 9, 9, 9, 9, 9, 4, 6, 0)
    return "  ".join(f"{shown(row.get(key, '-')):>{width}}" for key, width in zip(COLUMNS, widths))


HEADING = ("              name  completed   drift  work off  depth, mm  edge, mm  short, mm  laps  CPU, s  reason")
