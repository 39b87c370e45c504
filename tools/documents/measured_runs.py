# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs behind the measured cases: laboratory contact, loss of a gob in the blank side, share of perfect contact."""
import csv
import json
import math
import os
import subprocess
import sys
import tomllib
from functools import lru_cache

from documents.store import ROOT

TOOLS = 404  # degC of the blank side
GOBS, CONTACTS = (1100, 1150), (3.12, 4.72)  # degC, s
# Where exponents are fitted: of two gobs alone, how each lies in the blank decides a tenth of the exponent.
FITTED_GOBS = (1100, 1112, 1125, 1138, 1150)
TIME, SETTLING, WHOLE = "exponent in the time of contact", "exponent in (gob - tool), end of the settling", "exponent in (gob - tool), with the counter-blow"


class Runs:
    """Runs of cases at draft in a folder of their own."""

    def __init__(self, parison, folder):
        self.parison, self.folder, self.count = parison.resolve(), folder, 0

    def command(self, name, case, *options):
        self.count += 1
        out = self.folder / f"{self.count}"
        done = subprocess.run([self.parison, name, case, *options, "--accuracy", "draft", "--output", out], stdout=subprocess.PIPE,
                              env={**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            sys.exit(f"parison {name} {case} ended with {done.returncode}:\n{done.stdout[-1500:]}")
        return out

    def run(self, case, *sets, keep_going=False):
        return self.command("run", case, *(word for each in sets for word in ("--set", each)), *["--keep-going"] * keep_going)


def table(path):
    """Columns of numbers of a CSV file; what is no number is left as text."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {key: [row[key] for row in rows] for key in rows[0]}


def curve(out, column):
    rows = table(out / "history.csv")
    return [[float(t), float(y)] for t, y in zip(rows["time_s"], rows[column])]


def inline(value):
    """A value as TOML in one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f'"{key}" = {inline(item)}' for key, item in value.items()) + " }"
    return f"[{', '.join(map(inline, value))}]" if isinstance(value, list) else json.dumps(value)


def stages_to(case, last, **durations):
    """--set of the stages of a bundled case up to one of them, some with other durations."""
    stages = tomllib.loads((case / "case.toml").read_text())["stage"]
    kept = stages[:[stage["name"] for stage in stages].index(last) + 1]
    return "stage=" + inline([{**stage, **({"duration": durations[stage["name"]]} if stage["name"] in durations else {})} for stage in kept])


def conductance(out):
    rows = table(out / "interface.csv")
    return sorted({float(t): float(h) for t, h in zip(rows["time_s"], rows["h_W_m2K"])}.items())


def exponent(along, values):
    """Slope of a power law by least squares."""
    x, y = [math.log(a) for a in along], [math.log(value) for value in values]
    middle = sum(x) / len(x)
    return sum((a - middle) * b for a, b in zip(x, y)) / sum((a - middle) ** 2 for a in x)


def blank_losses(runs, *sets, contacts=CONTACTS):
    """Of the bottle, by gob a pair for each contact: the mean loss, K, at the end of the settling and of the contact. The gob settles, its loading of
    0.3 s included, for the contact less the 1.6 s of corkage and counter-blow. The density is one, as the other simulator's."""
    case = ROOT / "cases" / "bottle"
    tools = [f"tool.{tool}.temperature={TOOLS} degC" for tool in ("ring", "plate", "pin", "blank", "baffle")]

    def losses(gob, contact):
        stages = stages_to(case, "counter_blow", settle_blow=f"{contact - 1.6 - 0.3:.2f} s", counter_blow="1.3 s")
        mean = curve(runs.run(case, f"glass.temperature={gob} degC", "material.flint.density=2400 kg/m3", *tools, stages, *sets),
                     "glass_mean_degC")
        return [gob - min(mean, key=lambda point: abs(point[0] - time))[1] for time in (contact - 1.6, contact)]

    return {gob: [losses(gob, time) for time in contacts] for gob in FITTED_GOBS}


def loss_exponents(found):
    """Of losses by `blank_losses`: in (gob - tool) the means over the contacts, and in the time, where there are two, over the gobs."""
    above = [gob - TOOLS for gob in found]
    contacts = len(next(iter(found.values())))
    exponents = {name: sum(exponent(above, [losses[i][end] for losses in found.values()]) for i in range(contacts)) / contacts
                 for end, name in enumerate((SETTLING, WHOLE))}
    if contacts == 1:
        return exponents
    return {TIME: sum(exponent(CONTACTS, [loss for _, loss in losses]) for losses in found.values()) / len(found), **exponents}


def blank_heat(out):
    return json.loads((out / "summary.json").read_text())["tools"]["blank"]["heat_received_J"]


@lru_cache
def perfect_heat(runs):
    """Heat into the jar's blank until the end of its dwell by perfect contact, 50 kW/m2/K, J. It chills the skin until its flow is not resolved at draft;
    heat alone is taken from it."""
    case = ROOT / "cases" / "jar"
    return blank_heat(runs.run(case, stages_to(case, "dwell"), with_law(case, law="constant", h="50000 W/m2/K"), keep_going=True))


def blank_dwell(runs, *sets):
    """The jar to the end of its dwell: `loss` of the mean, K, and `share`, %, of the heat into the blank over that of perfect contact."""
    case = ROOT / "cases" / "jar"
    out = runs.run(case, stages_to(case, "dwell"), *sets)
    mean = curve(out, "glass_mean_degC")
    return {"loss": mean[0][1] - mean[-1][1], "share": 100 * blank_heat(out) / perfect_heat(runs)}


def with_law(case, **law):
    """--set of the interfaces of a bundled case, those whose h follows pressure and viscosity by another law."""
    interfaces = tomllib.loads((case / "case.toml").read_text())["interface"]
    return "interface=" + inline([{"tools": one["tools"], **law} if one["law"] == "pressure-viscosity" else one for one in interfaces])
