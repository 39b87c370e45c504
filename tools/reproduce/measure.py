# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of merit of the runs, held against what is required of the interface element."""
from itertools import combinations

import numpy as np

import exact

REQUIRED = {"deviation": 0.1, "spread": 0.02, "difference": 0.05}  # K


def side_exact(name, time):
    return exact.solution(time)[0 if name == "glass" else 1]


def deviation(run, first=1.0):
    """Largest distance from the exact solution at any contact node from `first` on, by body, K."""
    return {name: max(np.abs(values[i] - side_exact(name, time)).max() for i, time in enumerate(run.times) if time >= first)
            for name, values in run.side.items()}


def spread(run):
    """Highest less lowest temperature along the contact at the end, by body, K."""
    return {name: np.ptp(values[-1]) for name, values in run.side.items()}


def heat_error(run):
    """Heat exchanged less the exact one, of the exact one."""
    return run.heat / (exact.solution(run.times[-1])[2] * np.pi * exact.RADIUS**2) - 1


def difference(runs):
    """Highest temperature of any run less the lowest of any other, at any output time and side of the contact, K."""
    worst = 0.0
    for name in ("glass", "steel"):
        for a, b in combinations(runs, 2):
            high = np.maximum(a.side[name].max(1) - b.side[name].min(1), b.side[name].max(1) - a.side[name].min(1))
            worst = max(worst, high[np.array(a.times) > 0].max())
    return worst


def table(runs):
    """Rows of the table: one for each run."""
    rows = []
    for run in runs:
        off, along = deviation(run), spread(run)
        rows.append({"coupling": run.method, "divisions glass/steel": run.mesh, "slave": run.slave,
                     "glass deviation K": off["glass"], "steel deviation K": off["steel"],
                     "glass spread K": along["glass"], "steel spread K": along["steel"], "heat J": run.heat,
                     "heat error": heat_error(run)})
    return rows


def verdict(runs):
    """What was measured with the interface element for each requirement."""
    ours = [run for run in runs if run.method != "classical"]
    return {"deviation": max(max(deviation(run).values()) for run in ours),
            "spread": max(max(spread(run).values()) for run in ours), "difference": difference(ours)}


def along_contact(rows, time, name, radius):
    """A column of interface.csv at a time, at given r in mm."""
    at = np.abs(rows["time_s"] - time) < 1e-9
    return np.interp(radius, rows["r_mm"][at], rows[name][at])


def rim(rows, time):
    return rows["r_mm"][np.abs(rows["time_s"] - time) < 1e-9].max()


def weight_differences(weight, share):
    """Largest difference between any two of the meshes with self-weight at any output, over `share` of the contact's radius."""
    some = next(iter(weight.values()))[0]
    times = [t for t in np.unique(np.round(some["time_s"], 9)) if t > 0]
    result = {}
    for name in ("T_glass_degC", "T_tool_degC", "pressure_Pa"):
        worst = 0.0
        for time in times:
            radius = np.linspace(0.2, share * min(rim(rows, time) for rows, _ in weight.values()), 200)
            values = np.array([along_contact(rows, time, name, radius) for rows, _ in weight.values()])
            worst = max(worst, np.ptp(values, axis=0).max())
        result[name] = worst
    heat = [history["heat_to_tools_J"][-1] for _, history in weight.values()]
    force = np.array([history["steel_force_N"][-1] for _, history in weight.values()])
    result["heat"] = np.ptp(heat) / np.mean(heat)
    result["rim_mm"] = np.ptp([rim(rows, times[-1]) for rows, _ in weight.values()])
    result["weight"] = np.abs(force / (2500 * 9.81 * np.pi * exact.RADIUS**2 * 0.02) - 1).max()
    return result
