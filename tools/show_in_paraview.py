#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads a result folder into ParaView: all bodies, mirrored, active tools only, one colour scale over all times.

As a macro (Macros > Import new macro, or Tools > Python Shell > Run Script): open glass.pvd of the folder first.
From a shell: pvpython tools/show_in_paraview.py results/jar [--field NAME] [--range LOW HIGH] [--revolve] [--time T] [--picture FILE.png]
[--state FILE.pvsm]; the state is opened in ParaView by File > Load State."""
import argparse
import json
import math
import sys
from pathlib import Path

from paraview import simple as pv

COLOURS, REVOLVED_DEGREES = "Inferno (matplotlib)", 270


def folder_of_active_source():
    """Of the file that is open in ParaView."""
    source = pv.GetActiveSource()
    if source is None or not hasattr(source, "FileName"):
        sys.exit("Open glass.pvd of a result folder first and keep it selected in the Pipeline Browser.")
    return Path(str(source.FileName)).parent


def readers(folder):
    """Name and reader of each body, the glass first."""
    files = sorted(folder.glob("*.pvd"), key=lambda path: (path.stem != "glass", path.stem))
    if not files or files[0].stem != "glass":
        sys.exit(f"{folder}: no glass.pvd was found, allowed is a result folder of parison run")
    found = {}
    for path in files:
        found[path.stem] = pv.PVDReader(registrationName=path.stem, FileName=str(path))
        found[path.stem].UpdatePipeline()
    return found


def range_over_time(sources, field):
    """Least and greatest value of a field, or of a vector's length, on all bodies at all times."""
    low, high = math.inf, -math.inf
    for source in sources:
        for time in source.TimestepValues:
            source.UpdatePipeline(time)
            array = source.PointData.GetArray(field)
            if array is None:
                break
            span = array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)
            low, high = min(low, span[0]), max(high, span[1])
    return low, high


def active_part(name, source, kind="section"):
    """The cells of a tool while its stage names it; the glass is always there."""
    if name == "glass":
        return source
    return pv.Threshold(registrationName=f"{name}_{kind}", Input=source, Scalars=["CELLS", "active"], LowerThreshold=0.5,
                        UpperThreshold=1.5, ThresholdMethod="Between")


def is_planar(folder):
    """Whether a run that has ended was of a planar case, which has no axis."""
    summary = Path(folder) / "summary.json"
    return summary.exists() and json.loads(summary.read_text()).get("geometry") == "planar"


def mirrored(name, source):
    """The other half of the section."""
    image = pv.Transform(registrationName=f"{name}_mirrored", Input=source, Transform="Transform")
    image.Transform.Scale = [-1, 1, 1]
    return image


def revolved(name, source):
    """The outline of the section turned about the axis, open at a quarter."""
    surface = pv.ExtractSurface(registrationName=f"{name}_surface", Input=source, NonlinearSubdivisionLevel=2)
    outline = pv.FeatureEdges(registrationName=f"{name}_outline", Input=surface, BoundaryEdges=1, FeatureEdges=0,
                              NonManifoldEdges=0, ManifoldEdges=0, Coloring=0)
    return pv.RotationalExtrusion(registrationName=f"{name}_revolved", Input=outline, Resolution=96, Capping=0,
                                  Angle=REVOLVED_DEGREES, RotationAxis=[0, 1, 0])


def show(source, view, field, colours):
    """With the colours of a field, or plain where `field` is None."""
    display = pv.Show(source, view)
    display.ColorArrayName = ["POINTS", field or ""]
    if field:
        display.LookupTable = colours
        display.Ambient, display.Diffuse = 0.25, 0.75
    return display


def is_upright(folder, time):
    """Whether +z points up at a time, by the stages of the summary; gravity turns over where the machine turns the parison."""
    try:
        stages = json.loads((folder / "summary.json").read_text())["stages"]
    except FileNotFoundError:
        return True
    return next((stage for stage in stages if time <= stage["end_s"] + 1e-9), stages[-1]).get("upright", True)


def look_at(view, revolve):
    view.InteractionMode = "3D" if revolve else "2D"
    view.CameraParallelProjection = 0 if revolve else 1
    view.OrientationAxesVisibility = int(revolve)
    pv.ResetCamera(view)
    if revolve:
        centre, distance = list(view.CameraFocalPoint), view.GetActiveCamera().GetDistance()
        view.CameraPosition = [centre[0] + 0.75 * distance, centre[1] + 0.45 * distance, centre[2] + 0.75 * distance]
        view.CameraViewUp = [0, 1, 0]
        pv.ResetCamera(view)


def load(folder, field, revolve, span=None):
    """Shows all bodies of a result folder, with colours over a span or over all values; returns the view."""
    bodies = readers(Path(folder))
    planar = is_planar(folder)
    if planar and revolve:
        sys.exit(f"{folder}: a planar case was found, allowed with --revolve are axisymmetric ones")
    low, high = range_over_time(bodies.values(), field)
    if low > high:
        names = list(bodies["glass"].PointData.keys())
        sys.exit(f"--field: \"{field}\" was found, allowed is a field of the glass: {', '.join(names)}")
    low, high = span or (low, high)
    view = pv.GetActiveViewOrCreate("RenderView")
    colours = pv.GetColorTransferFunction(field)
    colours.ApplyPreset(COLOURS, True)
    colours.RescaleTransferFunction(low, high)
    colours.AutomaticRescaleRangeMode = "Never"
    for name, reader in bodies.items():
        part = active_part(name, reader)
        pv.Hide(reader, view)
        shown = [part]
        if not planar:
            shown.append(active_part(name, revolved(name, reader), "body") if revolve else mirrored(name, part))
        for source in shown:
            display = show(source, view, field if reader.PointData.GetArray(field) else None, colours)
            if revolve and name != "glass":
                display.Opacity = 0.15
    bar = pv.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle, bar.Visibility = field, "", 1
    bar.TitleFontSize = bar.LabelFontSize = 12
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-.4g", "%-.4g"
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    look_at(view, revolve)
    return view


def go_to(view, time, folder):
    """Shows the output nearest to a time, or the last one, as the container stands then."""
    times = pv.GetTimeKeeper().TimestepValues
    pv.GetAnimationScene().AnimationTime = min(times, key=lambda t: abs(t - time)) if time is not None else times[-1]
    if not is_upright(folder, pv.GetAnimationScene().AnimationTime):
        position, focus = list(view.CameraPosition), list(view.CameraFocalPoint)
        view.CameraPosition = [position[0], 2 * focus[1] - position[1], position[2]]
        view.CameraViewUp = [0, -1, 0]
    pv.Render(view)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", nargs="?", help="result folder; without it that of the file open in ParaView")
    parser.add_argument("--field", default="temperature_degC", help="what the colours show")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="of the colours [all values at all times]")
    parser.add_argument("--revolve", action="store_true", help="turned about the axis, with a quarter open")
    parser.add_argument("--time", type=float, help="s; the output nearest to it [the last]")
    parser.add_argument("--picture", help="PNG file")
    parser.add_argument("--state", help="ParaView state file (.pvsm)")
    options, _ = parser.parse_known_args()  # ParaView has arguments of its own
    folder = Path(options.results or folder_of_active_source())
    view = load(folder, options.field, options.revolve, options.range)
    go_to(view, options.time, folder)
    pv.ResetCamera(view)
    pv.Render(view)
    if options.picture:
        pv.SaveScreenshot(options.picture, view, ImageResolution=[1200, 900])
    if options.state:
        pv.SaveState(options.state)


main()
