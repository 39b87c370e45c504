# SPDX-License-Identifier: GPL-3.0-or-later
"""Scatter of the jar's wall when all tools are warmer by 0.001 to 0.02 K: what a discrete decision taken otherwise changes."""
import math
import re

from benchmarks.common import ROOT, Figure, build, parison, read_summary

RUNS, WARMER = 20, 0.001  # K, from one run to the next
TARGETS = {"draft": 0.2, "standard": 0.08}  # %


def warmer(text, change):
    """Overrides that set the temperature of every tool higher by `change`, K."""
    for tool in re.split(r"^\[\[tool\]\]", text, flags=re.M)[1:]:
        name = re.search(r'^name = "(\w+)"', tool, re.M).group(1)
        value = re.search(r'^temperature = "([\d.]+) degC"', tool, re.M).group(1)
        yield from ("--set", f'tool.{name}.temperature="{float(value) + change:.3f} degC"')


def deviations(profile):
    """Values of one place in all runs minus the straight line through them, as shares of their mean."""
    count, mean = len(profile), sum(profile) / len(profile)
    places = [i - (count - 1) / 2 for i in range(count)]
    slope = sum(i * v for i, v in zip(places, profile)) / sum(i * i for i in places)
    return [(v - mean - slope * i) / mean for i, v in zip(places, profile)]


def section(options):
    build("parison")
    text = (ROOT / "cases/jar/case.toml").read_text()
    for accuracy in [options.accuracy] if options.accuracy else ["draft"]:
        profiles = []
        for i in range(RUNS):
            _, folder = parison(ROOT / "cases/jar", accuracy, *warmer(text, i * WARMER))
            profiles.append(read_summary(folder)["thickness_profile_mm"])
        places = [place for place in zip(*profiles) if None not in place]
        squares = [d * d for place in places for d in deviations(place)]
        scatter = 100 * math.sqrt(sum(squares) / (len(places) * (RUNS - 2)))
        yield Figure(f"noise.{accuracy}", f"scatter of the jar's wall place by place, tools warmer by mK, {RUNS} runs, {accuracy}",
                     scatter, TARGETS.get(accuracy), unit="%")
