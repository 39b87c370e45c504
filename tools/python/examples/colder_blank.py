#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What does a colder blank change? A key of a case at several values, as a table.

    python3 tools/python/examples/colder_blank.py
    python3 tools/python/examples/colder_blank.py jar tool.plunger.temperature "480 degC" "500 degC" "520 degC"
"""
import sys

import numpy as np

import parison


def main(name="jar", key="tool.blank.temperature", *values):
    print(f"{name}, {key}")
    for value in values or ("440 degC", "460 degC", "480 degC"):
        case = parison.Case(name, accuracy="draft", changes={key: value})
        hottest = []  # of the glass after each step, degC

        def follow(state):
            hottest.append(state.glass.fields["temperature"].max() - 273.15)

        result = case.run(callback=follow)
        numbers = ", ".join(f"{quantity} {number:.5g}" for quantity, number in list(result.quantities.items())[:4])
        print(f"  {value}: {numbers}; hottest glass from {np.max(hottest):.0f} to {hottest[-1]:.0f} degC in {len(hottest)} steps; "
              f"{result.verdict}")


if __name__ == "__main__":
    main(*sys.argv[1:])
