#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the temperature and the mesh of glass and active tools from a result folder, one PNG for each time or a strip; glass in space as it is
seen."""
import argparse
import json
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import written_files
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.tri import Triangulation
from PIL import Image
from solid_view import SolidGlass
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

GLASS_MAP, TOOL_MAP = "inferno", "cividis"
SUB_TRIANGLES = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))


class Body:
    """A body at an output time, in mm and degC."""

    def __init__(self, path):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        self.points = vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
        self.cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 6)
        temperature = grid.GetPointData().GetArray("temperature_degC")
        self.temperature = None if temperature is None else vtk_to_numpy(temperature)
        place = grid.GetCellData().GetArray("active")
        self.active = place is None or place.GetTuple1(0) > 0

    def edges(self):
        """Quadratic cell edges once each, as (first, last, mid), and how many cells share them."""
        edges = np.concatenate([self.cells[:, [i, (i + 1) % 3, 3 + i]] for i in range(3)])
        _, index, count = np.unique(edges[:, 2], return_index=True, return_counts=True)
        return edges[index], count

    def curves(self, edges, sign, pieces=6):
        s = np.linspace(0, 1, pieces + 1)[:, None]
        shape = np.stack([(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)])
        lines = np.einsum("ksx,ekd->esd", shape, self.points[edges])
        return lines * [sign, 1]


def collection(results, name):
    """Times and files of a .pvd."""
    root = xml.parse(results / f"{name}.pvd").getroot()
    return [(float(d.get("timestep")), results / d.get("file")) for d in root.iter("DataSet")]


def bodies_at(results, time):
    """The glass and the active tools at the output nearest to a time."""
    found, actual = {}, None
    for pvd in sorted(results.glob("*.pvd"), key=lambda p: p.stem != "glass"):
        entries = collection(results, pvd.stem)
        at, path = min(entries, key=lambda entry: abs(entry[0] - time))
        if not entries[0][0] - 1e-9 <= time <= entries[-1][0] + 1e-9:
            sys.exit(f"{results}: {time:g} s was asked for, allowed are times from {entries[0][0]:g} to {entries[-1][0]:g} s")
        body = Body(path)
        actual = at if pvd.stem == "glass" else actual
        if body.active:
            found[pvd.stem] = body
    return found, actual


def solid_at(results, time):
    """The glass in space at the output nearest to a time; nothing before it is in space."""
    if not (results / "solid/glass.pvd").exists():
        return None, None
    entries = collection(results / "solid", "glass")
    if not entries or time <= entries[0][0] + 1e-9:
        return None, None
    actual, path = min(entries, key=lambda entry: abs(entry[0] - time))
    return SolidGlass(path), actual


def limits(bodies):
    values = [body.temperature for body in bodies if body.temperature is not None]
    if not values:
        return None
    low, high = min(v.min() for v in values), max(v.max() for v in values)
    return (low, high) if high - low > 1 else (low - 5, high + 5)


def draw_body(axes, body, colours, span, mirrored, lines):
    sub = np.concatenate([body.cells[:, corners] for corners in SUB_TRIANGLES])
    edges, shared = body.edges()
    outline = edges[shared == 1]
    if mirrored:
        outline = outline[body.points[outline, 0].max(axis=1) > 1e-6]
    image = None
    for sign in (1, -1) if mirrored else (1,):
        x, y = sign * body.points[:, 0], body.points[:, 1]
        if span is None or body.temperature is None:
            axes.add_collection(PolyCollection(np.stack([x[sub], y[sub]], -1), facecolor="#c9d6df", edgecolor="face"))
        else:
            image = axes.tripcolor(Triangulation(x, y, sub), body.temperature, shading="gouraud", cmap=colours,
                                   vmin=span[0], vmax=span[1])
        if sign > 0 or not mirrored:
            axes.add_collection(LineCollection(body.curves(edges, sign), **lines))
        axes.add_collection(LineCollection(body.curves(outline, sign), colors="black", linewidths=0.5))
    return image


def window(bodies, mirrored):
    """The glass with a margin: tools may reach far beyond it."""
    points = bodies["glass"].points
    low, high = points.min(0), points.max(0)
    margin = 0.35 * (high - low).max()
    return ((-high[0] if mirrored else low[0]) - margin, high[0] + margin), (low[1] - margin, high[1] + margin)


def is_upright(results, time):
    """Whether +z points up at a time, by the stages of the summary; gravity turns over where the machine turns the parison."""
    try:
        stages = json.loads((results / "summary.json").read_text())["stages"]
    except FileNotFoundError:
        return True
    return next((stage for stage in stages if time <= stage["end_s"] + 1e-9), stages[-1]).get("upright", True)


def draw_solid(solid, time, title, path):
    """The container as it is seen, with the colours of its surface."""
    figure, axes = plt.subplots(figsize=(7, 7.5), dpi=100, layout="constrained")
    image = solid.draw(axes, GLASS_MAP, limits([solid]))
    axes.autoscale_view()
    without_axes(axes)
    axes.set_title(f"{title}   t = {time:.4g} s")
    figure.colorbar(image, ax=axes, label="glass, °C", fraction=0.04, pad=0.02)
    save(figure, path, 256)


def draw(results, time, title, mirrored, path):
    solid, actual = solid_at(results, time)
    if solid:
        draw_solid(solid, actual, title, path)
        return
    bodies, actual = bodies_at(results, time)
    tools = {name: body for name, body in bodies.items() if name != "glass"}
    (left, right), (bottom, top) = window(bodies, mirrored)
    height = 7.5
    figure, axes = plt.subplots(figsize=(height * (right - left) / (top - bottom) + 2.6, height), dpi=100, layout="constrained")
    glass_span, tool_span = limits([bodies["glass"]]), limits(tools.values())
    tool_image = None
    for body in tools.values():
        image = draw_body(axes, body, TOOL_MAP, tool_span, mirrored, {"colors": (1, 1, 1, 0.22), "linewidths": 0.2})
        tool_image = tool_image or image
    glass_image = draw_body(axes, bodies["glass"], GLASS_MAP, glass_span, mirrored,
                            {"colors": (0, 0, 0, 0.35), "linewidths": 0.2})
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal", xlabel="r, mm" if mirrored else "x, mm",
             ylabel="z, mm" if mirrored else "y, mm", title=f"{title}   t = {actual:.4g} s")
    if not is_upright(results, actual):
        axes.invert_yaxis()
    axes.set_facecolor("#f4f4f2")
    for image, label in ((tool_image, "tools, °C"), (glass_image, "glass, °C")):
        if image is not None:
            figure.colorbar(image, ax=axes, label=label, fraction=0.04, pad=0.02)
    save(figure, path, 256)


def save(figure, path, colours=None):
    """A PNG; with a number of colours it is a third as large."""
    written_files.require_own(path)
    figure.savefig(path, pil_kwargs={"optimize": True})
    plt.close(figure)
    if colours:
        with Image.open(path) as image:
            small = image.convert("RGB").quantize(colours)
        small.save(path, optimize=True)
    written_files.note_written(path)
    print(path)


def strip_panel(axes, bodies, spans, turned):
    """One stage end without axes; turned over, +z points down."""
    thin = {"colors": (0, 0, 0, 0.3), "linewidths": 0.12}
    images = [None, None]
    for name, body in bodies.items():
        glass = name == "glass"
        image = draw_body(axes, body, GLASS_MAP if glass else TOOL_MAP, spans[not glass], True,
                          thin if glass else {"colors": "none", "linewidths": 0})
        images[not glass] = image or images[not glass]
    if turned:
        axes.invert_yaxis()
    without_axes(axes)
    return images


def solid_panel(axes, solid, span):
    """The container in space, its mouth up."""
    image = solid.draw(axes, GLASS_MAP, span)
    without_axes(axes)
    return [image, None]


def without_axes(axes):
    axes.set(aspect="equal", xticks=[], yticks=[])
    for side in axes.spines.values():
        side.set_visible(False)


def draw_strip(results, stages, path):
    """The ends of all stages side by side on one scale, as the glass stands, the right half of each with its mesh."""
    shown = [solid_at(results, stage["end_s"])[0] or bodies_at(results, stage["end_s"])[0] for stage in stages]
    solids, sections = ([one for one in shown if isinstance(one, SolidGlass) is wanted] for wanted in (True, False))
    spans = [limits([b["glass"] for b in sections] + solids), limits([t for b in sections for n, t in b.items() if n != "glass"])]
    right = 1.02 * max([t.points[:, 0].max() for b in sections for t in b.values()] + [1.2 * solid.radius for solid in solids])
    heights = [(b["glass"].points[:, 1].min(), b["glass"].points[:, 1].max()) for b in sections] + [solid.range for solid in solids]
    bottom, top = min(low for low, _ in heights) - 0.25 * right, max(high for _, high in heights) + 0.45 * right
    width = 1.75
    figure, row = plt.subplots(1, len(stages), figsize=(width * len(stages) + 1.6, width * (top - bottom) / (2 * right) + 0.5),
                               dpi=90, layout="constrained", squeeze=False)
    images = [None, None]
    for axes, bodies, stage in zip(row[0], shown, stages):
        if isinstance(bodies, SolidGlass):
            axes.set(xlim=(-right, right), ylim=(bottom, top) if bodies.up > 0 else (-top, -bottom))
            found = solid_panel(axes, bodies, spans[0])
        else:
            axes.set(xlim=(-right, right), ylim=(bottom, top))
            found = strip_panel(axes, bodies, spans, not stage.get("upright", True))
        images = [one or other for one, other in zip(found, images)]
        axes.set_title(f"{stage['name']}  {stage['end_s']:.2f} s", fontsize=10)
    for image, label in zip(images[::-1], ("tools, °C", "glass, °C")):
        if image is not None:
            figure.colorbar(image, ax=list(row[0]), label=label, fraction=0.012, pad=0.006, aspect=28)
    save(figure, path)


def is_planar(results):
    """Whether a run that has ended was of a planar case."""
    summary = results / "summary.json"
    return summary.exists() and json.loads(summary.read_text()).get("geometry") == "planar"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=Path, help="result folder of a run")
    parser.add_argument("--time", type=float, help="seconds; the nearest output is drawn")
    parser.add_argument("--stage-ends", action="store_true", help="one picture for the end of each stage (the default)")
    parser.add_argument("--strip", action="store_true", help="the ends of all stages side by side in one picture")
    parser.add_argument("--planar", action="store_true", help="do not mirror at the axis, as of planar cases whose run has ended")
    parser.add_argument("--out", type=Path, help="PNG file of a single time or strip, else the folder of the pictures")
    options = parser.parse_args()
    results = options.results
    mirrored = not (options.planar or is_planar(results))
    if options.time is not None:
        draw(results, options.time, results.resolve().name, mirrored, options.out or results / f"t_{options.time:g}.png")
        return
    try:
        stages = json.loads((results / "summary.json").read_text())["stages"]
    except FileNotFoundError:
        sys.exit(f"{results}/summary.json: was not found; give --time, or wait for the end of the run")
    if options.strip:
        draw_strip(results, stages, options.out or results / "strip.png")
        return
    folder = options.out or results
    folder.mkdir(parents=True, exist_ok=True)
    for number, stage in enumerate(stages, 1):
        draw(results, stage["end_s"], stage["name"], mirrored, folder / f"{number}_{stage['name'].replace('/', '_')}.png")


if __name__ == "__main__":
    main()
