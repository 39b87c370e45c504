# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes of a case that mean nothing: to equal questions the program should give equal answers."""
import re
import shutil
import tomllib

from benchmarks.common import warmer_tool

SIZES = (1, 2)  # of a change that has one: 0.001 K, 0.1 % of an edge, 1 % of a first step


def inline(value):
    """A value read from TOML as TOML on one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f'"{key}" = {inline(each)}' for key, each in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(inline(each) for each in value) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"' if isinstance(value, str) else repr(value)


def rewritten(case, folder, data):
    """The case file of a copy of a case's folder that says `data` instead."""
    shutil.copytree(case.parent, folder, ignore=shutil.ignore_patterns("results*", "reference*"))
    (folder / case.name).write_text("".join(f'"{key}" = {inline(value)}\n' for key, value in data.items()), encoding="utf-8")
    return folder / case.name


def divided(stages):
    """The stages with the longest one whose loads do not change in two of half the length; None where there is none."""
    steady = [s for s in stages if "duration" in s and not any(k in s for k in ("motion", "pressure", "name_boundary")) and
              not any(k.startswith("end") for k in s)]
    if not steady:
        return None
    whole = max(steady, key=lambda s: float(s["duration"].split()[0]))
    half = f'{0.5 * float(whole["duration"].split()[0]):.9g} {whole["duration"].split()[1]}'
    at = stages.index(whole)
    return [*stages[:at], {**whole, "duration": half}, {**whole, "name": whole["name"] + "_2", "duration": half}, *stages[at + 1:]]


def with_midpoint(path):
    """A path, or its parts, with a point in the middle of each straight line between two numbers."""
    if isinstance(path, list):
        return [with_midpoint(part) for part in path]
    if path.startswith("arc"):
        return path
    number = r"\(([-\d.]+), ([-\d.]+)\)"
    return re.sub(number + r" (?=" + number + ")", lambda m: f"{m[0]}({(float(m[1]) + float(m[3])) / 2:.9g}, "
                                                             f"{(float(m[2]) + float(m[4])) / 2:.9g}) ", path)


def pointed(data):
    """The tools with redundant points on their outlines."""
    return [{**tool, "boundary": [{**b, **({"path": with_midpoint(b["path"])} if "path" in b else {})} for b in tool["boundary"]]}
            if "boundary" in tool else tool for tool in data["tool"]]


def variants(case, numerics, new_folder):
    """Kind, case file and overrides of each variant; `numerics` are the settings of the unchanged run, SI."""
    data = tomllib.loads(case.read_text(encoding="utf-8"))
    for k in SIZES:
        warm = [part for tool in data["tool"] for part in ("--set", warmer_tool(tool, 0.001 * k))]
        yield "tools warmer by mK", case, warm
        yield "edges 0.1 % shorter", case, ["--set", f"numerics.surface_size={1e3 * numerics['surface_size'] * (1 - 1e-3 * k):.9g} mm"]
        yield "first steps 1 % longer", case, ["--set", f"numerics.initial_step={numerics['initial_step'] * (1 + 1e-2 * k):.9g} s"]
    yield "tools in another order", rewritten(case, new_folder(), {**data, "tool": data["tool"][::-1]}), []
    if stages := divided(data.get("stage", [])):
        yield "a stage in two", rewritten(case, new_folder(), {**data, "stage": stages}), []
    yield "redundant points", rewritten(case, new_folder(), {**data, "tool": pointed(data)}), []
    yield "more outputs", case, ["--set", "output.interval=0.013 s"]
