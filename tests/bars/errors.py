# SPDX-License-Identifier: GPL-3.0-or-later
"""True errors and bars of runs, by kind of quantity."""
import math

RESOLUTION = 1e-4  # no bar is narrower: share of the size of a quantity, as in forming/report/error_bars.cpp
MARGIN, POINTS = 0.02, 401  # of the arc beside an end of the wall, as in forming/report/quantities.hpp
KINDS = ("lengths", "wall, mean of places", "wall, worst place", "thinnest place", "temperatures", "heats", "forces", "times")
BY_WORD = {"thickness": "lengths", "extent": "lengths", "glass": "temperatures", "heat": "heats", "peak": "forces",
           "time": "times"}


def kind_of(name):
    return "thinnest place" if name == "thickness_min_at" else BY_WORD[name.split("_")[0]]


def size_of(name, quantities):
    """A heat counts between its own size and that of all heats, geometrically."""
    own = abs(quantities[name]["scale"])
    if not name.startswith("heat_"):
        return own
    return math.sqrt(own * sum(abs(q["scale"]) for n, q in quantities.items() if n.startswith("heat_")))


def profile_errors(run, reference):
    """Mean and largest difference of two walls as shares; None without a wall."""
    if not run or not reference:
        return None
    shares = [abs(a - b) / b if a is not None and b is not None else math.nan for a, b in zip(run, reference)]
    reach = round(MARGIN * (POINTS - 1))
    inner = [s for i, s in enumerate(shares) if all(math.isfinite(x) for x in shares[max(0, i - reach):i + reach + 1])]
    return (sum(inner) / len(inner), max(inner)) if inner else None


def heat_error(quantities, truth):
    """Heat wrongly given to tools over all heat; None without."""
    names = [name for name in quantities if name.startswith("heat_")]
    whole = sum(abs(truth[name]) for name in names)
    return sum(abs(quantities[name]["value"] - truth[name]) for name in names) / whole if whole else None


def counts(row):
    """Whether the bar or the true error exceeds the resolution; a size that a tool holds does not."""
    return max(row["bar"], row["error"]) > 1.0001 * row["resolution"]


def rows(scene, accuracy, summary, reference):
    """Dictionaries of what was compared: bar and true error as shares; what has no bar is left out."""
    found = []

    def add(name, kind, bar, error, resolution=RESOLUTION):
        if bar is not None and math.isfinite(bar):
            found.append({"scene": scene, "accuracy": accuracy, "name": name, "kind": kind, "bar": bar, "error": error,
                          "resolution": resolution, "cpu_seconds": summary["cpu_seconds"]})

    truth, quantities = reference["quantities"], summary["quantities"]
    for name, quantity in quantities.items():
        if name in truth and truth[name] is not None:
            size = size_of(name, quantities)
            least = 1 / (POINTS - 1) if name == "thickness_min_at" else RESOLUTION
            add(name, kind_of(name), quantity.get("error", math.nan) / size, abs(quantity["value"] - truth[name]) / size, least)
    whole = summary["error_bars"]
    walls = profile_errors(summary["thickness_profile_mm"], reference["thickness_profile_mm"])
    if walls:
        add("profile, mean", "wall, mean of places", whole["thickness_profile_mean"], walls[0])
        add("profile, largest", "wall, worst place", whole["thickness_profile_max"], walls[1])
    heat = heat_error(quantities, truth) if all(n in truth for n in quantities if n.startswith("heat_")) else None
    if heat is not None:
        add("heat, all tools", "heats", whole["heat_into_tools"], heat)
    return found
