#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares a result folder with the expect.toml of its case; exits with 1 when an expectation is not met."""
import csv
import json
import sys
import tomllib
from pathlib import Path

KEYS = {"quantity", "history", "time", "value", "tolerance", "min", "max"}


def summary_value(summary, name):
    """A number of summary.json by its dotted name; keys may hold dots themselves."""
    if name in summary:
        return summary[name]
    for key, part in summary.items():
        if isinstance(part, dict) and name.startswith(key + "."):
            return summary_value(part, name[len(key) + 1:])
    return None


def history_value(rows, column, time):
    """A column of history.csv at a time, linear between rows; None outside the run."""
    times = [float(row["time_s"]) for row in rows]
    slack = 1e-6 * max(times[-1], 1e-3)
    if time > times[-1] + slack or time < times[0] - slack:
        return None
    after = next((i for i, t in enumerate(times) if t >= time - slack), len(times) - 1)
    if after == 0 or abs(times[after] - time) <= slack:
        return float(rows[after][column])
    share = (time - times[after - 1]) / (times[after] - times[after - 1])
    return (1 - share) * float(rows[after - 1][column]) + share * float(rows[after][column])


def bounds(entry, value):
    """Lowest and highest allowed."""
    low, high = entry.get("min", float("-inf")), entry.get("max", float("inf"))
    if value is not None:
        low, high = max(low, value - entry["tolerance"]), min(high, value + entry["tolerance"])
    return low, high


def expectations(entry):
    """Label, time and bounds of each number that an entry speaks of."""
    unknown = set(entry) - KEYS
    if unknown or ("quantity" in entry) == ("history" in entry) or ("value" in entry) != ("tolerance" in entry):
        sys.exit(f"expect.toml: {entry} was found, allowed is quantity or history with value and tolerance, min or max")
    if not {"value", "min", "max"} & set(entry):
        sys.exit(f"expect.toml: {entry} allows everything")
    if "quantity" in entry:
        return [(entry["quantity"], None, bounds(entry, entry.get("value")))]
    values = entry.get("value", [None] * len(entry["time"]))
    if len(values) != len(entry["time"]):
        sys.exit(f"expect.toml: {entry['history']} has {len(entry['time'])} times and {len(values)} values")
    return [(f"{entry['history']} at {time:g} s", time, bounds(entry, value)) for time, value in zip(entry["time"], values)]


def allowed(low, high):
    if low == float("-inf"):
        return f"at most {high:.6g}"
    return f"at least {low:.6g}" if high == float("inf") else f"{low:.6g} to {high:.6g}"


def judge(summary, rows, folder):
    """Label, found number (None where there is none) and bounds of each expectation of a case."""
    for entry in tomllib.loads((folder / "expect.toml").read_text())["expect"]:
        for label, time, limits in expectations(entry):
            if time is None:
                found = summary_value(summary, label)
            else:
                column = entry["history"]
                found = history_value(rows, column, time) if rows and column in rows[0] else None
            # Drifts have a sign, their limit has none.
            if found is not None and set(entry) <= {"quantity", "max"}:
                found = abs(found)
            yield label, found, limits


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: tools/expect.py RESULTS CASE")
    results, case = Path(sys.argv[1]), Path(sys.argv[2])
    summary = json.loads((results / "summary.json").read_text())
    with open(results / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    if (results / "solid/summary.json").exists():
        summary["solid"] = json.loads((results / "solid/summary.json").read_text())
    failures = 0
    for label, found, (low, high) in judge(summary, rows, case if case.is_dir() else case.parent):
        good = found is not None and low <= found <= high
        failures += not good
        shown = "nothing" if found is None else f"{found:.6g}"
        print(f"{'ok  ' if good else 'FAIL'}  {label}: found {shown}, allowed {allowed(low, high)}")
    if not summary["completed"]:
        print(f"FAIL  the run did not complete: {summary['reason']}")
        failures += 1
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
