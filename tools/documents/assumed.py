# SPDX-License-Identifier: GPL-3.0-or-later
"""What remains assumed: studies by `parison uncertainty` of all assumed constants of a container, their table and picture."""
import json
import os
import re
import subprocess
import tempfile
import tomllib
from pathlib import Path

from documents.store import ROOT, Missing, read, rounded
from documents.tables import digits, table

FOLDER = ROOT / "cases/measured"
GIVEN = FOLDER / "assumed.toml"
CONTAINERS = ("jar", "bottle")
# What a constant does: a quantity, in % of it or in K. The force of the jar's plunger is given, so that resistance shows in the time of its press.
EFFECTS = {"wall": ("thickness_min", "%"), "heat": ("heat_blank", "%"), "glass": ("glass_mean", "K"), "press": ("time_press", "%")}
TITLES = {"wall": "thinnest wall", "heat": "heat into the blank", "glass": "mean of the glass", "press": "time that the given force presses"}
ACCURACY, RUNS = "draft coarser 2", "48"
SCATTER = "0 +- 1 uniform"

def given():
    return tomllib.loads(GIVEN.read_text())

def stored(case):
    return read(FOLDER / f"assumed_{case}.json", f"tools/readme_figures --assumed {case}")

def bands(glass, factor, x):
    radiation = tomllib.loads((ROOT / "cases/materials.toml").read_text())[glass]["radiation"]
    absorption = lambda band: f"{band['absorption'].split()[0]}*exp({factor}*{x})/(1 m)"
    inner = ", ".join(f'{{ up_to = "{band["up_to"]}", absorption = "{absorption(band)}" }}' for band in radiation["bands"])
    return f'material.{glass}.radiation={{ refractive_index = {radiation["refractive_index"]}, thin_wall = true, bands = [{inner}] }}'

def start_sets(case, container, spread, x):
    tools = {tool["name"]: tool for tool in tomllib.loads((ROOT / "cases" / case / "case.toml").read_text())["tool"]}
    if container["start"] == "plus":
        return [f"tool.{tool}.temperature.plus={spread} K*{x}" for tool in container["warmed"]]
    return [f"tool.{tool}.temperature={tools[tool]['temperature']} + {spread} K*{x}" for tool in container["warmed"]]

def sets_of(case, constant):
    """--set of one constant of a container, with its scatter in place of x."""
    container, x = given()["containers"][case], f"x_{constant['name']}"
    sets = list(constant.get("sets", []))
    sets += [constant["formed"].replace("TOOL", tool) for tool in container["formed"] if "formed" in constant]
    sets += [constant["cooled"].replace("TOOL", tool).replace("H W", f"{h} W") for tool, h in container["cooled"].items() if "cooled" in constant]
    if "warmed" in constant:
        sets += start_sets(case, container, constant["warmed"], x)
    if "light" in constant:
        sets.append(bands("flint", 0.693, x))
    return [re.sub(r"\bx\b", x, one) for one in sets]

def dimensions(case, constants):
    own = tomllib.loads((ROOT / "cases" / case / "case.toml").read_text()).get("dimension", {})
    own.update({f"x_{one['name']}": SCATTER for one in constants})
    return "dimension={ " + ", ".join(f"{key} = {json.dumps(value)}" for key, value in own.items()) + " }"

def words(case):
    constants = given()["constant"]
    sets = [dimensions(case, constants), *(one for constant in constants for one in sets_of(case, constant))]
    return ["uncertainty", ROOT / "cases" / case, "--accuracy", ACCURACY, "--runs", RUNS, *(word for one in sets for word in ("--set", one))]

def measure(case, parison=ROOT / "build/parison"):
    """Runs the study of a container and stores the effect of each constant over its range."""
    with tempfile.TemporaryDirectory(prefix="parison_assumed_") as scratch:
        one_thread = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        done = subprocess.run([parison, *words(case), "--jobs", "1", "--output", f"{scratch}/study"], env=one_thread, check=False,
                              stdout=subprocess.PIPE, text=True)
        path = Path(scratch) / "study/uncertainty.json"
        if not path.exists():
            raise RuntimeError(done.stdout[-800:])
        store(case, json.loads(path.read_text()))

def store(case, study):
    """Keeps of a study, by quantity, its value, its bars and each constant's effect: the change over half its range."""
    kept = {key: study[key] for key in ("accuracy", "runs_done", "runs_failed")}
    kept["quantities"] = {}
    for name, _ in EFFECTS.values():
        if name not in study["quantities"]:
            continue
        one = study["quantities"][name]
        kept["quantities"][name] = {**{key: one[key] for key in ("unit", "mean", "numerical_bar", "tolerance_bar", "q2")}, "effects": {
            key.removeprefix("dimension.x_"): found["main_effect"] for key, found in one["tolerances"].items()}}
    (FOLDER / f"assumed_{case}.json").write_text(json.dumps(rounded(kept), indent=1) + "\n")
    picture()

def effect(study, kind, constant):
    """What half the range of a constant moves, in % of the quantity or K, and whether that is above the scatter of the runs; None where the container has
    no such quantity. The main effect is that over one standard deviation of an even scatter, 1/sqrt(3) of half its width."""
    name, unit = EFFECTS[kind]
    quantity = study["quantities"].get(name)
    if not quantity:
        return None
    found, scale = quantity["effects"][constant], 3**0.5 * (1 if unit == "K" else 100 / quantity["mean"])
    return scale * (found["value"] or 0), found["low"] * found["high"] > 0, 0.5 * scale * (found["high"] - found["low"])

def shown(found):
    if not found or not found[1]:
        return "–"
    return f"{found[0]:+.0f}" if abs(found[0]) >= 9.95 else f"{found[0]:+.2g}"

def least(study, kind):
    """What the widest scatter of the constants that are not seen would hide."""
    unseen = [found[2] for one in given()["constant"] if (found := effect(study, kind, one["name"])) and not found[1]]
    return digits(max(unseen)) if unseen else "–"

def whole(study, kind):
    name, unit = EFFECTS[kind]
    quantity = study["quantities"].get(name)
    return f"±{digits(quantity['tolerance_bar'] * (1 if unit == 'K' else 100 / quantity['mean']))}" if quantity else "–"

def assumed():
    """Every assumed constant with its range, its source and what half of the range moves, in all containers."""
    studies = [stored(case) for case in CONTAINERS]
    cells = lambda of: [", ".join(dict.fromkeys(texts) if set(texts) == {"–"} else texts) for kind in EFFECTS if (texts := [of(study, kind) for study in studies])]
    strength = lambda one: max(abs(found[0]) * found[1] for study in studies for kind in EFFECTS if (found := effect(study, kind, one["name"])))
    seen = [one for one in sorted(given()["constant"], key=strength, reverse=True) if strength(one)]
    rows = [[one["what"], one["range"], one["source"], *cells(lambda study, kind: shown(effect(study, kind, one["name"])))] for one in seen]
    rows += [["least that these runs show", "", "", *cells(least)], ["all together, two standard deviations", "", "", *cells(whole)]]
    unseen = [f"{one['what']} ({one['range']})" for one in given()["constant"] if one not in seen]
    heads = [f"{kind}, {unit}: {', '.join(CONTAINERS)}" for kind, (_, unit) in EFFECTS.items()]
    return table(["assumed", "range (bundled)", "source", *heads], rows) + "\n\nNothing above the scatter: " + "; ".join(unseen) + "."

def hanging():
    """How many of the runs ended early."""
    return ", ".join(f"{stored(case)['runs_failed']} of {stored(case)['runs_done'] + stored(case)['runs_failed']} of the {case}" for case in CONTAINERS)

def picture():
    """Bars of what half the range of each constant moves, the strongest first, for each container."""
    known = [case for case in CONTAINERS if (FOLDER / f"assumed_{case}.json").exists()]
    if len(known) < len(CONTAINERS):
        return
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    studies, names = {case: stored(case) for case in CONTAINERS}, {one["name"]: one["what"] for one in given()["constant"]}
    bars = {kind: {case: {one: abs(found[0]) for one in names if (found := effect(study, kind, one)) and found[1]} for case, study in studies.items()}
            for kind in EFFECTS}
    seen = {kind: sorted({one for of in sizes.values() for one in of}, key=lambda one: max(of.get(one, 0) for of in sizes.values()))
            for kind, sizes in bars.items()}
    kinds = [kind for kind in EFFECTS if seen[kind]]
    figure, axes = pyplot.subplots(1, len(kinds), figsize=(4.0 * len(kinds), 2.4), constrained_layout=True)
    for panel, kind in zip(axes, kinds):
        for offset, (case, colour) in enumerate(zip(CONTAINERS, ("#2060a0", "#b03030"))):
            places = [place + 0.2 - 0.4 * offset for place in range(len(seen[kind]))]
            panel.barh(places, [bars[kind][case].get(one, 0) for one in seen[kind]], height=0.36, color=colour, label=case)
        panel.set_yticks(range(len(seen[kind])), [names[one].replace("`", "") for one in seen[kind]], fontsize=7)
        panel.set_title(f"{TITLES[kind]}, {EFFECTS[kind][1]}", fontsize=9)
        panel.tick_params(axis="x", labelsize=7)
    axes[0].legend(fontsize=7, frameon=False, loc="lower right")
    figure.savefig(FOLDER / "assumed.png", dpi=110)
    pyplot.close(figure)

BLOCKS = {"assumed": assumed, "hanging": lambda: f"Without a result ended {hanging()}: their parisons hang longer than their moulds."}
