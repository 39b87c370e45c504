# SPDX-License-Identifier: GPL-3.0-or-later
"""The measured figures from which Parison estimates errors and the effects of model parts: forming/scene/calibration.json."""
import datetime
import json
import math
import re
import subprocess

from benchmarks import bars, parts, references
from benchmarks.common import ROOT, Figure, Skipped, build, parison, read_summary

FILE = ROOT / "forming/scene/calibration.json"
LINE = 120  # characters
WORST, ORDER = "bottle", "jar"  # the container that errs most gives the error at draft, the other the order


def measured_by(case):
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    return {"commit": commit or "unknown", "date": datetime.date.today().isoformat(), "case": case}


def save(figures):
    """Writes the figures; an object of numbers alone stands on a line where it has room."""
    text = json.dumps(figures, indent=2)
    one_line = lambda found: "{ " + " ".join(line.strip() for line in found[1].splitlines()).strip() + " }"
    FILE.write_text(re.sub(r"\{([^{}\[\]]*)\}", lambda found: one_line(found) if len(one_line(found)) <= LINE else found[0], text) + "\n")


def errors(case, accuracy, reference):
    """Errors of the wall in the mean and of the heat, as fractions."""
    _, folder = parison(ROOT / "cases" / case, accuracy)
    summary = read_summary(folder)
    return {"thickness": bars.profile_errors(summary, reference)[0], "heat": bars.heat_error(summary, reference)}


def error_law():
    known = dict(references.known((WORST, ORDER)))
    if len(known) < 2:
        raise Skipped(f"{WORST} and {ORDER} need references (tools/bench --update-references)")
    worst = errors(WORST, "draft", known[WORST])
    draft, standard = errors(ORDER, "draft", known[ORDER]), errors(ORDER, "standard", known[ORDER])
    law = measured_by(f"the {WORST}, which errs most of the bundled containers; the order is the {ORDER}'s")
    for key in ("thickness", "heat"):
        law[key] = {"at_draft": float(f"{worst[key]:.2g}"), "order": float(f"{math.log2(draft[key] / standard[key]):.3g}")}
    return law


def model_parts(report, duration):
    """What each part changed in the jar, from a study of its variants, with the number that the part had there."""
    estimates = {part["part"]: part for part in report["estimates"]}
    found = {}
    for variant in report["variants"]:
        name = parts.PARTS.get(variant["name"])
        if not name or name not in estimates or not estimates[name]["in_scene"] or not variant["completed"]:
            continue
        found[name] = {"number": float(f"{estimates[name]['number']:.2g}"), "thickness": float(f"{variant['thickness_mean']:.3g}"),
                       "heat": float(f"{variant['heat']:.3g}")}
    return {**measured_by("the jar at draft"), "duration_s": duration, "parts": found}


def section(options):
    build("parison")
    stored = json.loads(FILE.read_text())
    law = error_law()
    study = parts.study("jar")
    summary = read_summary(parison(ROOT / "cases/jar", "draft")[1])
    new_parts = model_parts(study, float(f"{summary['time_s']:.2g}"))
    new_parts["parts"] = {**stored["model_parts"]["parts"], **new_parts["parts"]}
    for key in ("thickness", "heat"):
        yield Figure(f"calibration.{key}.at_draft", f"error law, {key}: at draft over the stored one",
                     law[key]["at_draft"] / stored["error_law"][key]["at_draft"])
        yield Figure(f"calibration.{key}.order", f"error law, {key}: order", law[key]["order"])
    for name, now in new_parts["parts"].items():
        before = stored["model_parts"]["parts"].get(name)
        if before and before["thickness"]:
            yield Figure(f"calibration.{name}", f"{name}: change of the wall over the stored one", now["thickness"] / before["thickness"])
    if options.save:
        save({**stored, "error_law": law, "model_parts": new_parts})
