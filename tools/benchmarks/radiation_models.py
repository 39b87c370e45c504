# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cheaper models of radiation are off by against `transfer`, and what they cost: the figures from which `radiation.model = "auto"` chooses."""
import csv
import json
import math
import tomllib

from benchmarks import bars
from benchmarks.calibration import FILE, measured_by, save
from benchmarks.common import ROOT, Figure, build, parison, read_summary, warmer_tool

MODELS = ("rosseland", "p1", "p1_cones")  # cheaper than the reference, or meant to be
REFERENCE = "transfer"
# Cases with the material of their glass.
CASES = {"jar": "flint", "bottle": "flint", "tumbler": "flint", "nnpb": "flint", "flute": "crystal", "sag": "float"}
SCENES = (("jar", "flint"), ("jar", "amber"), ("bottle", "flint"), ("bottle", "green"), ("tumbler", "flint"), ("tumbler", "amber"),
          ("nnpb", "flint"), ("flute", "flint"), ("sag", "flint"))
HARMLESS = 1e-3  # K warmer: what a change that means nothing does


def warmer(case):
    """Sets that warm the first tool of a case by next to nothing."""
    return warmer_tool(tomllib.loads((ROOT / "cases" / case / "case.toml").read_text())["tool"][0], HARMLESS)


def run(case, glass, model, accuracy, *more):
    """CPU seconds and summary of a case, its glass as light meets one of the bundled glasses, by a model."""
    radiation = f'{{ model = "{model}", refractive_index = 1.518, bands = "{glass}", thin_wall = true }}'
    sets = ("enclosure=false", f"material.{CASES[case]}.radiation={radiation}", *more)
    measured, folder = parison(ROOT / "cases" / case, accuracy, *(word for one in sets for word in ("--set", one)))
    return measured.cpu, {**read_summary(folder), "skins": skins(folder)}


def skins(folder):
    """Mean skin of the glass at the end of each stage, degC."""
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        return {row["stage"]: float(row["skin_mean_degC"]) for row in csv.DictReader(file)}


def skin_difference(summary, reference):
    """The largest difference of the mean skin at the end of any stage, K."""
    return max(abs(summary["skins"][stage] - skin) for stage, skin in reference["skins"].items())


def thinnest_difference(summary, reference):
    """Of the thinnest wall, as a share of the reference's; 0 where the scene has no wall."""
    found, true = (one["quantities"].get("thickness_min", {"value": 0.0})["value"] for one in (summary, reference))
    return abs(found / true - 1) if true else 0.0


def differences(summary, reference):
    """Of the wall in the mean, of its thinnest place and of the heat into the tools, as shares of the reference's; 0 for what the scene has not."""
    wall, heat = bars.profile_errors(summary, reference), bars.heat_error(summary, reference)
    if not wall and heat is None:
        raise RuntimeError(f"{reference['case']} has neither a wall nor heat of tools to compare")
    return {"thickness": wall[0] if wall else 0.0, "thinnest": thinnest_difference(summary, reference), "heat": heat or 0.0}


def worst(row):
    return max(row["thickness"], row["heat"])


def measure(case, glass, accuracy):
    """The entry of a scene: noise, and each model's differences from transfer with its CPU time over that of transfer."""
    seconds, reference = run(case, glass, REFERENCE, accuracy)
    noise = differences(run(case, glass, REFERENCE, accuracy, warmer(case))[1], reference)
    entry = {"case": case, "glass": glass, "noise": float(f"{worst(noise):.2g}"), "models": {}}
    for model in MODELS:
        cpu, summary = run(case, glass, model, accuracy)
        off = {key: float(f"{value:.3g}") for key, value in differences(summary, reference).items()}
        entry["models"][model] = {**off, "skin_K": float(f"{skin_difference(summary, reference):.3g}"), "cost": float(f"{cpu / seconds:.3g}")}
    shown = ", ".join(f"{model} wall {100 * m['thickness']:.2f} % heat {100 * m['heat']:.2f} % skin {m['skin_K']:.1f} K cost {m['cost']:.2f}"
                      for model, m in entry["models"].items())
    print(f"    {case} of {glass}: {shown}; noise {100 * entry['noise']:.2f} %", flush=True)
    return entry


def expected(scenes, model, without=None):
    """The largest difference of a model in all scenes but those of a case."""
    return max(worst(scene["models"][model]) for scene in scenes if scene["case"] != without)


def held_out(scenes):
    """Of each case and model: what its scenes are off by over what the other cases expect."""
    for case in dict.fromkeys(scene["case"] for scene in scenes):
        for model in MODELS:
            own = max(worst(scene["models"][model]) for scene in scenes if scene["case"] == case)
            yield case, model, own, expected(scenes, model, case)


def section(options):
    build("parison")
    accuracy = options.accuracy or "draft"
    scenes = [measure(case, glass, accuracy) for case, glass in SCENES]
    for model in MODELS:
        cost = math.exp(sum(math.log(scene["models"][model]["cost"]) for scene in scenes) / len(scenes))
        yield Figure(f"models.{model}.error", f"{model} against transfer, wall in the mean or heat into tools, the worst of {len(scenes)} scenes",
                     100 * expected(scenes, model), unit="%")
        yield Figure(f"models.{model}.cost", "  CPU time over that by transfer, geometric mean", cost)
    rows = list(held_out(scenes))
    for case, model, own, others in rows:
        print(f"    left out {case:<9}{model:<10} off by {100 * own:6.2f} %, expected by the other cases {100 * others:6.2f} %"
              f"{'' if own <= others else '  more than expected'}", flush=True)
    yield Figure("models.held_out", f"cases left out in turn whose error is at most what the others expect, of {len(rows)} pairs with a model",
                 100 * sum(own <= others for _, _, own, others in rows) / len(rows), unit="%")
    yield Figure("models.held_out.ratio", "  the largest error over what the others expect", max(own / others for _, _, own, others in rows))
    if options.save:
        stored = json.loads(FILE.read_text())
        by = measured_by(f"bundled cases at {accuracy}, against transfer")
        save({**stored, "radiation_models": {**by, "scenes": scenes}})
