# SPDX-License-Identifier: GPL-3.0-or-later
"""Error bars of the bundled cases against the true errors, those against a finer run."""
import math

from benchmarks import references
from benchmarks.common import ROOT, Figure, Skipped, build, parison, read_summary

# Each case at the accuracies that differ in it: the first two bring meshes and steps of their own.
SCENES = {
    "shell_inflation": ("standard",),
    "contact_cylinders": ("standard",),
    "tumbler": ("draft", "standard"),
    "bottle": ("draft", "standard"),
    "jar": ("draft", "standard"),
}
RESOLUTION = 1e-4  # no bar is narrower: share of the scale, for a tool's heat of the mean of it and all, geometric; as forming/report/error_bars.cpp
MARGIN, POINTS = 0.02, 401  # of the arc beside an end of the wall, as forming/report/quantities.hpp


def resolution(name, quantities):
    """Least bar, in the quantity's unit; a place on the profile is one of 401."""
    if name == "thickness_min_at":
        return 1 / (POINTS - 1)
    if name.startswith("heat_"):
        whole = sum(abs(q["value"]) for n, q in quantities.items() if n.startswith("heat_"))
        return RESOLUTION * math.sqrt(abs(quantities[name]["value"]) * whole)
    return RESOLUTION * quantities[name]["scale"]


def profile_errors(run, reference):
    """Mean and largest difference of the walls as shares; None without a wall."""
    pairs = list(zip(run["thickness_profile_mm"], reference["thickness_profile_mm"]))
    shares = [abs(a - b) / b if a is not None and b is not None else math.nan for a, b in pairs]
    reach = round(MARGIN * (POINTS - 1))
    inner = [s for i, s in enumerate(shares) if all(math.isfinite(x) for x in shares[max(0, i - reach):i + reach + 1])]
    return (sum(inner) / len(inner), max(inner)) if inner else None


def heat_error(run, reference):
    """Heat wrongly given to tools over all heat; None without."""
    heats = {n: q["value"] for n, q in reference["quantities"].items() if n.startswith("heat_")}
    wrong = sum(abs(run["quantities"][n]["value"] - value) for n, value in heats.items())
    return wrong / sum(abs(v) for v in heats.values()) if heats else None


def compare(run, reference):
    """Rows of name, bar, true error, resolution, all as shares of the quantity's scale."""
    rows = []
    for name, quantity in run["quantities"].items():
        if name not in reference["quantities"] or "error" not in quantity:
            continue
        truth = reference["quantities"][name]["value"]
        shares = (quantity["error"], abs(quantity["value"] - truth), resolution(name, run["quantities"]))
        rows.append((name, *(value / abs(quantity["scale"]) for value in shares)))
    whole, walls, heat = run["error_bars"], profile_errors(run, reference), heat_error(run, reference)
    if walls:
        rows.append(("profile, mean", whole["thickness_profile_mean"], walls[0], RESOLUTION))
        rows.append(("profile, largest", whole["thickness_profile_max"], walls[1], RESOLUTION))
    if heat is not None:
        rows.append(("heat, all tools", whole["heat_into_tools"], heat, RESOLUTION))
    return rows


def kind(name):
    return name.split("_")[0]


def root_mean_square(values):
    values = list(values)
    return math.sqrt(sum(v * v for v in values) / len(values))


def section(options):
    build("parison")
    rows = []
    for case, reference in references.known(SCENES):
        for accuracy in SCENES[case]:
            _, folder = parison(ROOT / "cases" / case, accuracy, "--error-bars")
            if accuracy == "draft":
                references.tell_age(case, read_summary(folder)["state_fingerprint"])
            print(f"    {case} at {accuracy}: shares of the scale, %", flush=True)
            print(f"      {'':<22}{'bar':>10}{'true':>10}{'ratio':>8}", flush=True)
            for name, bar, true, least in compare(read_summary(folder), reference):
                ratio = f"{bar / true:8.1f}" if true > 1e-3 * bar else f"{'over 999':>8}"
                print(f"      {name:<22}{100 * bar:10.4f}{100 * true:10.4f}{ratio}  {'' if true <= bar else 'outside'}", flush=True)
                rows.append((name, bar, true, least))
    if not rows:
        raise Skipped("no case has a reference.")
    yield Figure("bars.inside", f"true error inside its bar, of {len(rows)} quantities of all scenes",
                 100 * sum(true <= bar for _, bar, true, _ in rows) / len(rows), 90, True, "%")
    yield Figure("bars.narrow", "bar at most 5 times the true error",
                 100 * sum(bar <= 5 * true for _, bar, true, _ in rows) / len(rows), 100, True, "%")
    yield Figure("bars.narrow_resolved", "  the same, a true error below the bars' stated resolution counted as that",
                 100 * sum(bar <= 5 * max(true, least) for _, bar, true, least in rows) / len(rows), unit="%")
    for of in sorted({kind(name) for name, *_ in rows} - {"peak"}):  # the peak is the limit the case sets
        alike = [row for row in rows if kind(row[0]) == of]
        ratio = root_mean_square(bar for _, bar, _, _ in alike) / root_mean_square(true for _, _, true, _ in alike)
        yield Figure(f"bars.{of.strip(',')}", f"  bars over true errors of {of.strip(',')}, root mean square of {len(alike)}", ratio, 5)
