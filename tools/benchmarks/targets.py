# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of containers run with `--accuracy 1%` and `0.5%` over what was asked for."""
from benchmarks import bars, references
from benchmarks.common import ROOT, Figure, build, parison, read_summary

CASES = ("jar", "bottle", "tumbler")
TARGETS = (1, 0.5)  # %


def section(_):
    build("parison")
    for case, reference in references.known(CASES):
        for target in TARGETS:
            _, folder = parison(ROOT / "cases" / case, f"{target:g}%")
            summary = read_summary(folder)
            for key, what, error in (("wall", "wall thickness, mean", bars.profile_errors(summary, reference)[0]),
                                     ("heat", "heat into tools", bars.heat_error(summary, reference))):
                yield Figure(f"targets.{case}.{target:g}.{key}", f"{case} with --accuracy {target:g}%: error of the {what}",
                             100 * error, target, unit="%")
