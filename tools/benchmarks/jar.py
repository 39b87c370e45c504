# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections that run the bundled jar: its run time and shares, the flow step, the interface."""
import math
from functools import lru_cache

from benchmarks.common import ROOT, Figure, build, parison, read_summary, sampled, step_bench

CASE = ROOT / "cases/jar"
EVERY = 4  # steps from one bare factorisation to the next


@lru_cache
def whole_run(accuracy):
    build("parison")
    measured, folder = parison(CASE, accuracy)
    return measured, read_summary(folder)


@lru_cache
def step_rows(accuracy):
    build("step_bench")
    return step_bench(CASE, accuracy, EVERY)


def jar(options):
    measured, summary = whole_run(options.accuracy)
    process, key = summary["time_s"], f"jar.{options.accuracy}"
    target = {"draft": 1.0, "standard": 8.0}.get(options.accuracy)
    yield Figure(f"{key}.cpu", f"jar at {options.accuracy}: CPU time over process time", measured.cpu / process, target)
    yield Figure(f"{key}.wall", f"jar at {options.accuracy}: wall time over process time, this machine now",
                 measured.wall / process)
    for part, seconds in summary["timing"].items():
        if part != "remesh":
            yield Figure(f"{key}.{part}", f"  share of {part}", 100 * seconds / summary["wall_seconds"], unit="%")


def remesh(options):
    _, summary = whole_run(options.accuracy)
    share = 100 * summary["timing"]["remesh"] / summary["wall_seconds"]
    yield Figure(f"remesh.{options.accuracy}.share", f"remesh and transfer, share of the jar's run at {options.accuracy}",
                 share, 10, unit="%")


def flow(options):
    rows = step_rows(options.accuracy)
    bare, floor = math.nan, 0.0
    for row in rows:
        if not math.isnan(row["bare"]):
            bare = row["bare"]
        floor += bare
    key = f"flow.{options.accuracy}"
    yield Figure(f"{key}.step", "flow of a step over one factorisation and solve of its matrix, mean of the jar",
                 sum(row["flow"] for row in rows) / floor, 1.6)
    yield Figure(f"{key}.iterations", "  contact iterations of a step, mean",
                 sum(row["iterations"] for row in rows) / len(rows))


def interface(options):
    rows = step_rows(options.accuracy)
    whole = sum(row["step"] for row in rows)
    built = sum(row["contact"] for row in rows)
    again = sampled(rows)
    in_heat = sum(row["interface_in_heat"] for row in again) / sum(row["heat_again"] for row in again)
    assembled = in_heat * sum(row["heat"] for row in rows)
    watched = sum(row["watched"] for row in again) * len(rows) / len(again)
    key = f"interface.{options.accuracy}"
    yield Figure(f"{key}.share", "interface built, assembled and watched, share of the jar's steps",
                 100 * (built + assembled + watched) / whole, 3, unit="%")
    yield Figure(f"{key}.built", "  of which building", 100 * built / whole, unit="%")
    yield Figure(f"{key}.assembled", "  of which assembly in the heat solver", 100 * assembled / whole, unit="%")
    yield Figure(f"{key}.watched", "  of which the surface's change of temperature for the step's control",
                 100 * watched / whole, unit="%")
    yield Figure(f"{key}.milliseconds", "interface built, assembled and watched, a step",
                 1e3 * (built + assembled + watched) / len(rows), unit="ms")
