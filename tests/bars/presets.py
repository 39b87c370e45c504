# SPDX-License-Identifier: GPL-3.0-or-later
"""How the true errors of scenes without contact, and of all walls, fall from preset to preset."""
import math

FREE = {"ring": "planar ring", "sphere": "thick sphere", "filament": "filament", "drop": "drop", "plane_drop": "plane drop"}
PRESETS = ("draft", "standard", "fine")
REFINED = 1.6 / 0.6  # edges at draft over those at fine


def root_mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def table(compared):
    """Rows of scene, error at each preset (root mean square of all its lengths, shares) and order from draft to fine;
    `compared` holds every quantity, those below the resolution of the bars too."""
    result = []
    for scene, what in FREE.items():
        errors = [root_mean_square([row["error"] for row in compared if row["scene"] == scene and row["accuracy"] == preset
                                    and row["kind"] == "lengths"]) for preset in PRESETS]
        if all(math.isfinite(e) and e > 0 for e in errors):
            result.append({"scene": what, "errors": errors, "order": math.log(errors[0] / errors[2]) / math.log(REFINED)})
    return result


def walls(compared):
    """Rows of scene and, for each preset it was run at, true errors of the mean wall and of the wall at its places
    (mean), shares, and CPU seconds."""
    found = {}
    for row in compared:
        if row["name"] in ("thickness_mean", "profile, mean"):
            run = found.setdefault(row["scene"], {}).setdefault(
                row["accuracy"], {"mean": math.nan, "places": math.nan, "cpu_seconds": row["cpu_seconds"]})
            run["mean" if row["name"] == "thickness_mean" else "places"] = row["error"]
    return [{"scene": scene, **found[scene]} for scene in found]
