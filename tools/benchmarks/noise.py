# SPDX-License-Identifier: GPL-3.0-or-later
"""Scatter of a wall when all tools are warmer by 0.001 to 0.02 K: what a discrete decision taken otherwise changes."""
import math
import sys
import tomllib

from benchmarks.common import ROOT, Figure, build, new_path, parison, read_summary, warmer_tool

RUNS, RUNS_OF_CONTAINER, WARMER = 20, 10, 0.001  # K, from one run to the next
TARGETS = {"draft": 0.2, "standard": 0.08}  # %


def warmer(text, change):
    """Overrides that set the temperature of every tool higher by `change`, K."""
    for tool in tomllib.loads(text)["tool"]:
        yield from ("--set", warmer_tool(tool, change))


def deviations(profile):
    """Values of one place in all runs minus the straight line through them, as shares of their mean."""
    count, mean = len(profile), sum(profile) / len(profile)
    places = [i - (count - 1) / 2 for i in range(count)]
    slope = sum(i * v for i, v in zip(places, profile)) / sum(i * i for i in places)
    return [(v - mean - slope * i) / mean for i, v in zip(places, profile)]


def scatter(case, accuracy, runs):
    """Root mean square over all places and runs, %, and that of the place where it is largest."""
    text = case.read_text(encoding="utf-8")
    profiles = []
    for i in range(runs):
        _, folder = parison(case, accuracy, *warmer(text, i * WARMER))
        profiles.append(read_summary(folder)["thickness_profile_mm"])
    places = [sum(d * d for d in deviations(place)) / (runs - 2) for place in zip(*profiles) if None not in place]
    return 100 * math.sqrt(sum(places) / len(places)), 100 * math.sqrt(max(places))


def section(options):
    build("parison")
    for accuracy in [options.accuracy] if options.accuracy else ["draft"]:
        yield Figure(f"noise.{accuracy}", f"scatter of the jar's wall place by place, tools warmer by mK, {RUNS} runs, {accuracy}",
                     scatter(ROOT / "cases/jar/case.toml", accuracy, RUNS)[0], TARGETS.get(accuracy), unit="%")


def containers(options):
    """The same of the random containers with a reference."""
    sys.path.insert(0, str(ROOT / "tests"))
    from containers import references  # pylint: disable=import-outside-toplevel
    build("parison")
    accuracy = options.accuracy or "draft"
    for name in references.references():
        seed, number = name.split("/")
        _, case = references.write_case(seed, int(number[:3]), new_path("container"))
        everywhere, worst = scatter(case, accuracy, RUNS_OF_CONTAINER)
        what = f"container {number} of seed {seed}, {RUNS_OF_CONTAINER} runs, {accuracy}"
        yield Figure(f"noise.{accuracy}.{number}", f"scatter of the wall of {what}, place by place", everywhere, unit="%")
        yield Figure(f"noise.{accuracy}.{number}.worst", f"scatter at the worst place of {what}", worst, unit="%")
