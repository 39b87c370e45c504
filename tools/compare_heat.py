#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""compare_heat.py RESULT OTHER...: heat that each tool received, and RESULT's as a share of each other result's."""
import json
import sys
from pathlib import Path


def heats(folder):
    summary = json.loads((Path(folder) / "summary.json").read_text())
    if not summary["completed"]:
        sys.exit(f"compare_heat: the run in {folder} did not complete: {summary['reason']}")
    return {name: tool["heat_received_J"] for name, tool in summary["tools"].items()}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folders = sys.argv[1:]
    first, *others = [heats(folder) for folder in folders]
    names = [Path(folder).name for folder in folders]
    print("| tool | " + " | ".join(f"{name}, kJ" for name in names) + " | "
          + " | ".join(f"{names[0]} / {name}" for name in names[1:]) + " |")
    print("|---" * (2 * len(folders)) + "|")
    for tool, heat in first.items():
        received = [heat] + [other[tool] for other in others]
        shares = [f"{100 * heat / other[tool]:.0f} %" if other[tool] else "-" for other in others]
        print(f"| {tool} | " + " | ".join(f"{q / 1e3:.2f}" for q in received) + " | " + " | ".join(shares) + " |")


if __name__ == "__main__":
    main()
