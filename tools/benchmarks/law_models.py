# SPDX-License-Identifier: GPL-3.0-or-later
"""What poorer models of contact, density and light between surfaces are off by against the best: the figures of the model column."""
import json
import math
import tomllib

from benchmarks.calibration import FILE, measured_by, save
from benchmarks.common import ROOT, Figure, build, parison, read_summary
from benchmarks.radiation_models import differences, expected, skin_difference, skins
from documents.measured_runs import with_law

CASES = ("jar", "bottle")
FIRST_H = (3000.0, 1700.0)  # W/m2/K, of the search for the constant that passes as much heat
SAME_HEAT = 0.02  # share


def run(case, accuracy, *sets):
    """Summary of a case, None where it does not come to its end."""
    try:
        _, folder = parison(ROOT / "cases" / case, accuracy, *(word for one in sets for word in ("--set", one)))
    except RuntimeError as reason:
        print(f"    {case} with {', '.join(sets)}: {str(reason).splitlines()[-1]}", flush=True)
        return None
    return {**read_summary(folder), "skins": skins(folder)}


def heat(summary):
    return sum(quantity["value"] for name, quantity in summary["quantities"].items() if name.startswith("heat_"))


def drawn_density(case):
    """kg/m3 of the gob at its temperature."""
    glass = tomllib.loads((ROOT / "cases" / case / "case.toml").read_text())["glass"]
    law = {key: float(value.split()[0]) for key, value in
           tomllib.loads((ROOT / "cases/materials.toml").read_text())[glass["material"]]["expansion"].items()}
    above = float(glass["temperature"].split()[0]) - law["transformation"]
    return law["cold_density"] * math.exp(-3 * (law["solid"] * (law["transformation"] - 20) + law["liquid"] * above))


def constant(case, accuracy, reference):
    """The case by the constant h with which its tools take as much heat as by the best law, or the nearest that completes: secants of the logarithms."""
    wanted, known = math.log(heat(reference)), []
    for _ in range(5):
        if len(known) < 2:
            log_h = math.log(FIRST_H[len(known)])
        else:
            (h1, q1, _), (h2, q2, _) = known[-2:]
            log_h = h2 + (wanted - q2) * (h2 - h1) / (q2 - q1)
        summary = run(case, accuracy, with_law(ROOT / "cases" / case, law="constant", h=f"{math.exp(log_h):.4g} W/m2/K"))
        if summary is None:  # the parison hangs longer than its mould: the nearest of those that fit
            break
        known.append((log_h, math.log(heat(summary)), summary))
        if abs(known[-1][1] - wanted) < SAME_HEAT:
            break
    if not known:
        return None
    log_h, _, summary = min(known, key=lambda one: abs(one[1] - wanted))
    print(f"    {case}: constant h of {math.exp(log_h):.0f} W/m2/K", flush=True)
    return summary


# Of each part the poorer models: what makes a run of a case by it, whose reference is the case itself.
PARTS = {
    "contact": {"constant": constant, "gap": lambda case, accuracy, _: run(case, accuracy, with_law(ROOT / "cases" / case, law="gap"))},
    "density": {"constant": lambda case, accuracy, _: run(case, accuracy, f"material.flint.density={drawn_density(case):.0f} kg/m3")},
    "enclosure": {"false": lambda case, accuracy, _: run(case, accuracy, "enclosure=false")},
}


def measure(case, accuracy):
    """By part the models that came to their end, with their differences from the case itself."""
    reference, found = run(case, accuracy), {part: {} for part in PARTS}
    for part, models in PARTS.items():
        for model, run_by in models.items():
            summary = run_by(case, accuracy, reference)
            if summary is None:
                continue
            off = {key: float(f"{value:.3g}") for key, value in differences(summary, reference).items()}
            found[part][model] = {**off, "skin_K": float(f"{skin_difference(summary, reference):.3g}")}
            print(f"    {case}, {part} {model}: {found[part][model]}", flush=True)
    return found


def section(options):
    build("parison")
    accuracy = options.accuracy or "draft"
    measured = {case: measure(case, accuracy) for case in CASES}
    scenes = {part: [{"case": case, "models": found[part]} for case, found in measured.items()] for part in PARTS}
    for part, models in PARTS.items():
        for model in models:
            completed = [scene for scene in scenes[part] if model in scene["models"]]
            yield Figure(f"laws.{part}.{model}", f"{part} by {model}, wall in the mean or heat into tools off at most, of {len(completed)} scenes",
                         100 * expected(completed, model), unit="%")
    if options.save:
        by = measured_by(f"bundled cases at {accuracy}, against the cases as they are")
        save({**json.loads(FILE.read_text()), **{f"{part}_models": {**by, "scenes": scenes[part]} for part in PARTS}})
