# SPDX-License-Identifier: GPL-3.0-or-later
"""Scatter of a wall over changes that mean nothing: what a discrete decision taken otherwise changes."""
import math
import sys

from benchmarks.common import ROOT, Figure, build, new_path, parison, read_summary
from benchmarks.harmless import variants

TARGETS = {"draft": 0.2, "standard": 0.08}  # %


def shares(profile, base):
    """Differences of a wall from the unchanged one place by place, as shares."""
    return [v / b - 1 for v, b in zip(profile, base) if v is not None and b is not None]


def root_mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def within_bars(summary, changed):
    """Of each quantity that has an error bar whether a run of the changed case lies within it."""
    return [abs(changed["quantities"][name]["value"] - quantity["value"]) <= quantity["error"]
            for name, quantity in summary["quantities"].items()
            if quantity.get("error") is not None and name in changed["quantities"]]


def scatter(case, accuracy):
    """Root mean square over places and variants, %, by kind of change and of all, that of the worst place, and the share of the quantities within the
    error bars of the unchanged run, %."""
    _, folder = parison(case, accuracy, "--error-bars")
    summary = read_summary(folder)
    base = summary["thickness_profile_mm"]
    by_kind, within = {}, []
    for kind, changed, overrides in variants(case, summary["numerics"], lambda: new_path("case")):
        _, folder = parison(changed, accuracy, *overrides)
        by_kind.setdefault(kind, []).append(shares(read_summary(folder)["thickness_profile_mm"], base))
        within += within_bars(summary, read_summary(folder))
    # The unchanged run is one draw among them: two draws differ by the root of two scatters.
    every = [profile for profiles in by_kind.values() for profile in profiles]
    kinds = {kind: 100 * root_mean_square([v for p in profiles for v in p]) / math.sqrt(2) for kind, profiles in by_kind.items()}
    return kinds, 100 * root_mean_square([v for p in every for v in p]) / math.sqrt(2), \
        100 * max(root_mean_square(place) for place in zip(*every)) / math.sqrt(2), 100 * sum(within) / len(within)


def figures(case, accuracy, key, what, target=None):
    kinds, everywhere, worst, within = scatter(case, accuracy)
    yield Figure(key, f"scatter of the wall of {what}, place by place, {accuracy}", everywhere, target, unit="%")
    yield Figure(f"{key}.worst", f"  at the worst place of {what}", worst, unit="%")
    yield Figure(f"{key}.within_bars", f"  quantities of {what} within the error bars of the unchanged run", within, 95, unit="%", least=True)
    for kind, found in kinds.items():
        yield Figure(f"{key}/{kind}", f"  {kind}", found, unit="%")


def section(options):
    build("parison")
    for accuracy in [options.accuracy] if options.accuracy else ["draft"]:
        yield from figures(ROOT / "cases/jar/case.toml", accuracy, f"noise.{accuracy}.jar", "the jar", TARGETS.get(accuracy))


def containers(options):
    """The same of the bottle and of the random containers with a reference."""
    sys.path.insert(0, str(ROOT / "tests"))
    from containers import references  # pylint: disable=import-outside-toplevel
    build("parison")
    accuracy = options.accuracy or "draft"
    yield from figures(ROOT / "cases/bottle/case.toml", accuracy, f"noise.{accuracy}.bottle", "the bottle")
    for name in references.references():
        seed, number = name.split("/")
        _, case = references.write_case(seed, int(number[:3]), new_path("container"))
        yield from figures(case, accuracy, f"noise.{accuracy}.container_{number}", f"container {number} of seed {seed}")
