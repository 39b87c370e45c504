# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections that run the bundled jar: its run time, errors and shares, the flow step, the interface, solvers and threads."""
import json
import math
import os
import re
from functools import lru_cache
from statistics import median

from benchmarks import bars, references
from benchmarks.common import (BUILD, ROOT, Figure, Skipped, build, new_path, parison, read_summary, run, sampled,
                               step_bench)
from documents import store

CASE = ROOT / "cases/jar"
RADIATION_ROUNDS = 3  # of the models of radiation
# The bands of flint, with an absorption of each that rises by a fifth to either side of its value.
BY_TEMPERATURE = """[{ up_to = "2.75 um", absorption = [["800 degC", "28 1/m"], ["1200 degC", "42 1/m"]] },
  { up_to = "4.3 um", absorption = [["800 degC", "276 1/m"], ["1200 degC", "414 1/m"]] }]"""
EVERY = 4  # steps from one bare factorisation to the next
ERRORS = {"draft": (3, 8, 2), "standard": (1, 2.5, 0.5)}  # wanted: wall in the mean, wall at the most, heat; %
STUDY = ROOT / "results/tradeoff/tradeoff.json"


@lru_cache
def whole_run(accuracy):
    build("parison")
    measured, folder = parison(CASE, accuracy)
    return measured, read_summary(folder)


@lru_cache
def step_rows(accuracy):
    build("step_bench")
    return step_bench(CASE, accuracy, EVERY)


def accuracies(options):
    return [options.accuracy] if options.accuracy else ["draft", "standard"]


def jar(options):
    for accuracy in accuracies(options):
        measured, summary = whole_run(accuracy)
        process, key = summary["time_s"], f"jar.{accuracy}"
        target = {"draft": 1.0, "standard": 8.0}.get(accuracy)
        yield Figure(f"{key}.cpu", f"jar at {accuracy}: CPU time over process time", measured.cpu / process, target)
        yield Figure(f"{key}.wall", f"jar at {accuracy}: wall time over process time, this machine now",
                     measured.wall / process)
        for part, seconds in summary["timing"].items():
            if part != "remesh":
                yield Figure(f"{key}.{part}", f"  share of {part}", 100 * seconds / summary["wall_seconds"], unit="%")


def light_sets(kind):
    """What replaces values of the jar for a kind of radiation."""
    model, _, table = kind.partition("_")
    return store.with_light(model) + ([f"material.flint.radiation.bands={BY_TEMPERATURE}"] if table else [])


def radiation(options):
    """Runs in turn, so that what else the machine does falls on all alike; the cheapest of each counts."""
    build("parison")
    kinds = {"rosseland": "Rosseland", "transfer": "transfer in bands", "enclosure": "transfer in bands, enclosure",
             "transfer_table": "transfer, absorption by temperature", "enclosure_table": "transfer, absorption by temperature, enclosure"}
    for accuracy in accuracies(options):
        spent, imbalance = {model: [] for model in kinds}, {}
        for _ in range(RADIATION_ROUNDS):
            for model in kinds:
                sets = [word for value in light_sets(model) for word in ("--set", value)]
                measured, folder = parison(CASE, accuracy, *sets)
                spent[model].append(measured.cpu)
                imbalance[model] = read_summary(folder)["energy_imbalance"]
        for model in ("transfer", "enclosure"):
            target = {"draft": 2.0, "standard": 1.6}.get(accuracy) if model == "enclosure" else None
            yield Figure(f"radiation.{accuracy}.{model}", f"jar at {accuracy}: CPU time by {kinds[model]} over that by Rosseland",
                         min(spent[model]) / min(spent["rosseland"]), target)
        for model in ("transfer", "enclosure"):
            ratios = [table / constant for table, constant in zip(spent[f"{model}_table"], spent[model])]
            yield Figure(f"radiation.{accuracy}.{model}.table", f"  by {kinds[model]}: absorption by temperature over constant, median of {len(ratios)} pairs in turn",
                         median(ratios))
        for model, what in kinds.items():
            yield Figure(f"radiation.{accuracy}.{model}.imbalance", f"  heat balance of the glass by {what}, over its heat at the start: open by",
                         abs(imbalance[model]))


def remesh(options):
    for accuracy in accuracies(options):
        _, summary = whole_run(accuracy)
        share = 100 * summary["timing"]["remesh"] / summary["wall_seconds"]
        yield Figure(f"remesh.{accuracy}.share", f"remesh and transfer, share of the jar's run at {accuracy}", share, 10,
                     unit="%")


def flow(options):
    for accuracy in accuracies(options):
        rows = step_rows(accuracy)
        bare, floor = math.nan, 0.0
        for row in rows:
            if not math.isnan(row["bare"]):
                bare = row["bare"]
            floor += bare
        key = f"flow.{accuracy}"
        yield Figure(f"{key}.step", f"flow of a step over one factorisation and solve of its matrix, jar at {accuracy}",
                     sum(row["flow"] for row in rows) / floor, 1.6)
        yield Figure(f"{key}.iterations", "  contact iterations of a step, mean",
                     sum(row["iterations"] for row in rows) / len(rows))


def interface(options):
    for accuracy in accuracies(options):
        rows = step_rows(accuracy)
        whole = sum(row["step"] for row in rows)
        built = sum(row["contact"] for row in rows)
        again = sampled(rows)
        in_heat = sum(row["interface_in_heat"] for row in again) / sum(row["heat_again"] for row in again)
        assembled = in_heat * sum(row["heat"] for row in rows)
        watched = sum(row["watched"] for row in again) * len(rows) / len(again)
        key = f"interface.{accuracy}"
        yield Figure(f"{key}.share", f"interface built and assembled, share of the jar's steps at {accuracy}",
                     100 * (built + assembled) / whole, 3, unit="%")
        yield Figure(f"{key}.built", "  of which building", 100 * built / whole, unit="%")
        yield Figure(f"{key}.assembled", "  of which assembly in the heat solver", 100 * assembled / whole, unit="%")
        yield Figure(f"{key}.watched", "  in addition, the surface's change of temperature for the step's control",
                     100 * watched / whole, unit="%")
        yield Figure(f"{key}.milliseconds", "interface built and assembled, a step", 1e3 * (built + assembled) / len(rows),
                     unit="ms")


def errors(options):
    reference = references.of_case("jar")
    for accuracy, wanted in ERRORS.items():
        _, summary = whole_run(accuracy)
        if accuracy == "draft":
            references.tell_age("jar", summary["state_fingerprint"])
        wall, heat = bars.profile_errors(summary, reference), bars.heat_error(summary, reference)
        for (key, what), value, target in zip((("wall_mean", "wall thickness, mean"), ("wall_largest", "wall thickness, largest"),
                                               ("heat", "heat into tools")), (*wall, heat), wanted):
            yield Figure(f"errors.{accuracy}.{key}", f"jar at {accuracy} against fine: {what}", 100 * value, target, unit="%")


def study(options):
    if not STUDY.exists():
        raise Skipped("no study has run; `build/parison tradeoff cases/jar --output results/tradeoff` runs it in some minutes.")
    variants = [variant for variant in json.loads(STUDY.read_text())["variants"] if variant["preset"] and variant["completed"]]
    for variant in variants:
        if variant["cpu_over_best_line"] is not None:
            yield Figure(f"study.{variant['name']}", f"{variant['name']}: CPU time over the best line of the last study",
                         variant["cpu_over_best_line"], 1.2)


@lru_cache
def solver_share(accuracy, threads):
    """Seconds of the jar's run: on the clock, factorising, solving; of CPU in all threads and in the first."""
    build("solver_share")
    log = new_path("solver_share.log")
    done = run([BUILD / "tools/benchmarks/programs/solver_share", CASE, accuracy, new_path("run"), threads], log)
    spent = re.search(r"whole (\S+) factorising (\S+) solving (\S+) cpu (\S+) first (\S+)", log.read_text())
    if done.code or not spent:
        raise RuntimeError(f"solver_share ended with {done.code}:\n" + log.read_text()[-800:])
    return [float(seconds) for seconds in spent.groups()]


def solver(options):
    whole, factorising, solving, _, _ = solver_share("standard", 1)
    yield Figure("solver.outside", "jar at standard: share outside factorisation and back-substitution",
                 100 * (whole - factorising - solving) / whole, 35, unit="%")
    yield Figure("solver.factorising", "  share of numeric factorisation", 100 * factorising / whole, unit="%")
    yield Figure("solver.solving", "  share of back-substitution", 100 * solving / whole, unit="%")


def checks(options):
    for accuracy in accuracies(options):
        build("check_share")
        log = new_path("check_share.log")
        done = run([BUILD / "tools/benchmarks/programs/check_share", CASE, accuracy, new_path("run")], log)
        last = log.read_text().split("\n")[-2].split()
        if done.code or last[:1] != ["whole"]:
            raise RuntimeError(f"check_share ended with {done.code}:\n" + log.read_text()[-800:])
        spent = dict(zip(last[::2], map(float, last[1::2])))
        whole = spent.pop("whole")
        yield Figure(f"checks.{accuracy}", f"share of all checks in the jar's run at {accuracy}", 100 * sum(spent.values()) / whole, 2, unit="%")
        for what, seconds in spent.items():
            yield Figure(f"checks.{accuracy}.{what}", f"  share of {what}", 100 * seconds / whole, unit="%")


def threads(options):
    if len(os.sched_getaffinity(0)) < 2:
        raise Skipped("one core only: OpenBLAS takes no second thread.")
    _, _, _, cpu, first = solver_share("standard", 2)
    # By CPU time, as the wall's depends on what else runs here.
    yield Figure("threads.two", "jar at standard: one BLAS thread over two, as if neither ever waited", cpu / first, 1.4, True)
