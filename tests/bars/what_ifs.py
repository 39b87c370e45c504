# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes of four scenes whose effect is known from fine runs, and the runs that show it."""
import json
from pathlib import Path

from .runs import HERE, QUIET, SCENES, rounded, run

CASES = HERE.parents[1] / "cases"
REFERENCES, MEASURED = HERE / "what_ifs.json", HERE / "what_ifs_measured.json"
SHOULDER = ('tool.blow_mould.boundary.inner.path=["(31, 14) (37.5, 26) (37, 122) mm", '
            '"arc centre (30, 122) mm radius 7 mm from 0 deg to 90 deg", "(12, 129) (0, 126) mm"]')
# Scene: its case, the temperatures of its tools in degC, and what is changed.
SCENE = {
    "cup": (SCENES / "cup.toml", {"mould": 480, "plunger": 500}, {
        "glass_5": "glass.temperature=1085 degC", "glass_20": "glass.temperature=1060 degC",
        "mould_10": "tool.mould.temperature=470 degC", "mould_40": "tool.mould.temperature=440 degC",
        "plunger_20": "tool.plunger.temperature=480 degC", "longer": "stage.press.duration=0.9 s",
        "friction": "tool.plunger.friction.coefficient=6e5 Pa.s/m", "h1": "interface.0.h1=16000 W/m2/K"}),
    "vial": (SCENES / "vial.toml", {"mould": 470}, {
        "glass_5": "glass.temperature=875 degC", "mould_20": "tool.mould.temperature=450 degC",
        "hang": "stage.hang.duration=0.5 s", "pressure_9": "stage.blow.pressure.inner=0.9 bar",
        "pressure_6": "stage.blow.pressure.inner=0.6 bar", "longer": "stage.blow.duration=1.2 s",
        "h0": "interface.0.h0=600 W/m2/K", "air": "air.temperature=80 degC"}),
    "tumbler": (CASES / "tumbler", {"mould": 450, "ring": 450, "plunger": 500}, {
        "force_9": "stage.press.motion.plunger.force=-9 kN", "mould_20": "tool.mould.temperature=430 degC",
        "plunger_20": "tool.plunger.temperature=480 degC", "glass_10": "glass.temperature=1090 degC",
        "dwell": "stage.dwell.duration=3.5 s", "settle": "stage.settle.duration=0.3 s",
        "friction": "tool.mould.friction.coefficient=2e6 Pa.s/m", "cool": "stage.cool.air.h=120 W/m2/K"}),
    "jar": (CASES / "jar", {"ring": 460, "plate": 460, "blank": 460, "plunger": 500, "blow_mould": 450}, {
        "blank_20": "tool.blank.temperature=440 degC", "reheat": "stage.reheat.duration=1.9 s", "shoulder": SHOULDER,
        "pressure": "stage.blow.pressure.inner=0.4 bar", "plunger_20": "tool.plunger.temperature=480 degC",
        "glass_5": "glass.temperature=1145 degC", "force_7": "stage.press.motion.plunger.force=7 kN",
        "mould_20": "tool.blow_mould.temperature=430 degC"}),
}
TWINS, WARMER = 3, 0.01  # K from one to the next


def make_references(parison, scene, folder):
    """The quantities at fine of the base of a scene and of each of its changes, by name; changes that did not complete are missing.

    Each change begins where it can first have an effect, so that what lies before is exactly that of the base.
    """
    made = what_if(parison, scene, "fine", {name: [change] for name, change in SCENE[scene][2].items()}, folder, 1)
    made = {name: one["quantities"] for name, one in made.items() if one.get("quantities")}
    found = {name: {quantity: rounded(row["other"], 9) for quantity, row in rows.items()} for name, rows in made.items()}
    base = {quantity: rounded(row["base"], 9) for rows in made.values() for quantity, row in rows.items()}
    return {"base": base, **found} if base else {}


def references():
    return json.loads(REFERENCES.read_text(encoding="utf-8")) if REFERENCES.is_file() else {}


def write_references(found):
    scenes = [f' "{scene}": {{\n' + ",\n".join(f'  "{name}": {json.dumps(values)}' for name, values in found[scene].items()) + "\n }"
              for scene in sorted(found)]
    REFERENCES.write_text("{\n" + ",\n".join(scenes) + "\n}\n", encoding="utf-8")


def what_if(parison, scene, accuracy, variants, folder, jobs, twice=False):
    """The runs of a comparison by their names; variants are lists of assignments by name."""
    arguments = []
    for name, assignments in variants.items():
        arguments += ["--variant", name]
        for assignment in assignments:
            arguments += ["--set", assignment]
    run([parison, "what-if", SCENE[scene][0], "--accuracy", accuracy, "--output", folder, "--jobs", jobs,
         "--base", QUIET[1], *["--twice"] * twice, *arguments], folder.with_suffix(".log"))
    made = folder / "comparison.json"
    return {one["run"]: one for one in json.loads(made.read_text(encoding="utf-8"))["runs"]} if made.is_file() else {}


def twins_of(scene):
    """Variants whose tools are some mK warmer: what they change is scatter."""
    tools = SCENE[scene][1]
    return {f"twin{k}": [f"tool.{tool}.temperature={value + WARMER * k:.3f} degC" for tool, value in tools.items()]
            for k in range(1, TWINS + 1)}


def rows(scene, accuracy, comparison, truth):
    """What was compared: difference, its bar, the bars of both runs added and its true value, as shares of the size."""
    found = []
    for name, one in comparison.items():
        for quantity, row in (one.get("quantities") or {}).items():
            known = [truth[run].get(quantity) for run in ("base", name) if truth.get(run)]
            if len(known) < 2 or None in known or row["error_bar"] is None:
                continue
            size = row["scale"]
            found.append({"scene": scene, "accuracy": accuracy, "change": name, "name": quantity,
                          "difference": row["difference"] / size, "bar": row["error_bar"] / size,
                          "added": (row["bars_added"] or float("nan")) / size, "true": (known[1] - known[0]) / size,
                          "real": row["verdict"] == "real"})
    return found
