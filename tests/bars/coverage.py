# SPDX-License-Identifier: GPL-3.0-or-later
"""How many true errors lie inside their bars, also of scenes that were left out where the bars' factor was chosen."""
import math

from .errors import KINDS

WANTED = 0.9


def inside(row, factor=1.0):
    return row["error"] <= factor * row["bar"]


def share(found, factor=1.0):
    return sum(inside(row, factor) for row in found) / len(found) if found else math.nan


def of_kind(found, kind):
    return [row for row in found if row["kind"] == kind]


def least_factor(found):
    """The least factor on all bars with which, in each kind, nine of ten true errors lie inside and would of one more: the
    n of them and the new one count n + 1 (split conformal prediction: V. Vovk, A. Gammerman, G. Shafer, Algorithmic Learning
    in a Random World, 2005)."""
    least = 0.0
    for kind in KINDS:
        ratios = sorted(row["error"] / row["bar"] for row in of_kind(found, kind))
        if ratios:
            least = max(least, ratios[min(len(ratios), math.ceil(WANTED * (len(ratios) + 1))) - 1])
    return least


def left_out(found):
    """Per row, the factor chosen on all scenes but its own."""
    scenes = {row["scene"] for row in found}
    chosen = {scene: least_factor([row for row in found if row["scene"] != scene]) for scene in scenes}
    return [chosen[row["scene"]] for row in found]


def median(values):
    values = sorted(values)
    return 0.5 * (values[(len(values) - 1) // 2] + values[len(values) // 2]) if values else math.nan


def width(found):
    """The median of the bars over the true errors, those below the bars' resolution counted as that."""
    return median([row["bar"] / max(row["error"], row["resolution"]) for row in found])


def table(found):
    """Rows of kind, number of scenes, number of quantities, share inside, the same left out, median width."""
    factors = left_out(found)
    result = []
    for kind in (*KINDS, "all"):
        chosen = [(row, factor) for row, factor in zip(found, factors) if kind in ("all", row["kind"])]
        if not chosen:
            continue
        own = [row for row, _ in chosen]
        result.append({"kind": kind, "scenes": len({row["scene"] for row in own}), "count": len(own), "inside": share(own),
                       "left_out": sum(inside(row, factor) for row, factor in chosen) / len(chosen), "width": width(own)})
    return result
