#!/usr/bin/env -S /usr/bin/python3 -B
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws error against CPU time from the tradeoff.json of `parison tradeoff` into tradeoff.png and tradeoff.svg beside it."""
import json
import sys
from pathlib import Path

import matplotlib

import written_files

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402

MARKS = {"accuracy": "o", "mesh": "s", "time": "^", "coupling": "D", "order": "v"}


def main():
    folder = Path(sys.argv[1])
    pictures = [folder / f"tradeoff.{kind}" for kind in ("png", "svg")]
    for picture in pictures:
        written_files.require_own(picture)
    variants = json.loads((folder / "tradeoff.json").read_text())["variants"]
    shown = [r for r in variants if r["completed"] and r["group"] not in ("reference", "model") and r["error"]]
    figure, axes = plt.subplots(figsize=(7, 4.6))
    for group in dict.fromkeys(r["group"] for r in shown):
        members = [r for r in shown if r["group"] == group]
        axes.plot([r["cpu_seconds"] for r in members], [100 * r["error"] for r in members], MARKS.get(group, "x"),
                  label={"accuracy": "accuracy levels"}.get(group, f"one thing changed: {group}"), markersize=6, alpha=0.8)
    front = sorted((r for r in shown if r["on_front"]), key=lambda r: r["cpu_seconds"])
    axes.plot([r["cpu_seconds"] for r in front], [100 * r["error"] for r in front], "k-", linewidth=1, label="best line")
    for r in shown:
        if r["preset"]:
            at = (r["cpu_seconds"], 100 * r["error"])
            axes.plot(*at, "o", markersize=13, markerfacecolor="none", markeredgecolor="crimson", markeredgewidth=1.8)
            axes.annotate(r["name"], at, xytext=(9, 7), textcoords="offset points", color="crimson")
    axes.set(xscale="log", yscale="log", xlabel="CPU time, s",
             ylabel="error, %: the larger of\nmean wall thickness and heat into tools")
    for r in variants:
        if r["group"] == "reference" and r["completed"]:
            axes.axvline(r["cpu_seconds"], color="crimson", linestyle=":", linewidth=1)
            axes.annotate(f"{r['accuracy']}, the reference", (r["cpu_seconds"], 0.97), xycoords=axes.get_xaxis_transform(),
                          xytext=(-4, 0), textcoords="offset points", rotation=90, ha="right", va="top", color="crimson")
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 1e4 * low else (1,)))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, which="both", alpha=0.3)
    axes.legend(frameon=False, loc="lower left")
    figure.tight_layout()
    for picture in pictures:
        figure.savefig(picture, dpi=150)
        written_files.note_written(picture)
    print(f"{folder}/tradeoff.png, tradeoff.svg")


main()
