# SPDX-License-Identifier: GPL-3.0-or-later
"""What `parison tradeoff` estimates of each part of the model, against runs without the part (or with it)."""
import json
import math

from benchmarks.common import BUILD, ROOT, Figure, build, new_path, run

CASES = ("tumbler", "bottle", "contact_cylinders")  # the estimates of the jar are its own study
PARTS = {"no_radiation": "internal radiation", "with_radiation": "internal radiation", "no_thin_wall": "thin-wall limit",
         "no_emission": "surface radiation", "no_air_cooling": "cooling by air", "fixed_tools": "warming of tools",
         "no_tension": "surface tension", "with_tension": "surface tension", "no_gravity": "gravity", "all_slip": "friction on tools"}
MATTERS = 0.005  # smaller changes than this, estimated and measured, are left aside
LEAST = MATTERS / 100  # for the ratio
FACTOR = 5


def study(case):
    out = new_path(f"parts_{case}")
    log = f"{out}.log"
    done = run([BUILD / "parison", "tradeoff", ROOT / "cases" / case, "--only", "model", "--base", "draft",
                "--reference", "draft coarser 0.9", "--timings", 1, "--jobs", 1, "--output", out], log)
    if done.code:
        raise RuntimeError(f"parison tradeoff {case} ended with {done.code}:\n" + open(log).read()[-800:])
    return json.loads((out / "tradeoff.json").read_text())


def section(_):
    build("parison")
    ratios = []
    for case in CASES:
        report = study(case)
        estimates = {part["part"]: part for part in report["estimates"]}
        for variant in report["variants"]:
            part = PARTS.get(variant["name"])
            if not part or not variant["completed"] or part not in estimates:
                continue
            for key, measured in (("thickness", variant["thickness_mean"]), ("heat", variant["heat"])):
                estimated = estimates[part][key]
                if measured is None or max(estimated, measured) < MATTERS:
                    continue
                ratios.append(max(estimated, LEAST) / max(measured, LEAST))
                print(f"    {case:<18}{part:<20}{key:<10} estimated {100 * estimated:6.2f} %, measured {100 * measured:6.2f} %", flush=True)
    off = [max(r, 1 / r) for r in ratios]
    yield Figure("parts.worst", f"estimates of model parts, the worst of {len(off)}: off by a factor of", max(off), FACTOR)
    yield Figure("parts.usual", "  in the geometric mean", math.exp(sum(map(math.log, off)) / len(off)))
