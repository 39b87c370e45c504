# SPDX-License-Identifier: GPL-3.0-or-later
"""How time and memory of a coupled step grow with the mesh: the wall of a cup pressed in a mould, on structured meshes."""
import math
import statistics

from benchmarks.common import BUILD, Figure, build, new_path, run, sampled, step_bench

# A wall of 5 by 80 mm stands on a plate and at a mould; a ring presses it from above.
CASE = """
case = "wall"
geometry = "axisymmetric"
air = {{ temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }}

[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
viscosity = {{ law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }}
surface_tension = "0.315 N/m"

[material.iron]
density = "7200 kg/m3"
heat_capacity = "490 J/kg/K"
conductivity = "46 W/m/K"

[glass]
material = "glass"
temperature = "1000 degC"
mesh = {{ mapped = [{across}, {along}] }}
boundary = [
  {{ name = "bottom", path = "(30, 0) (35, 0) mm", condition = "contact" }},
  {{ name = "outer", path = "(35, 80) mm", condition = "contact" }},
  {{ name = "top", path = "(30, 80) mm", condition = "contact" }},
  {{ name = "inner", path = "(30, 0) mm", condition = "contact" }},
]
{tools}
[[interface]]
tools = ["plate", "mould", "ring"]
law = "constant"
h = "2000 W/m2/K"

[[stage]]
name = "press"
duration = "{duration} ms"
gravity = "-9.81 m/s2"
tools = ["plate", "mould", "ring"]
motion.ring = {{ offset = [["0 s", "0 mm"], ["1 s", "-100 mm"]] }}

[numerics]
max_step = "1 ms"
"""
TOOL = """
[[tool]]
name = "{name}"
material = "iron"
temperature = "450 degC"
friction = "{friction}"
boundary = [
  {{ name = "contact", path = "{contact}", condition = "contact" }},
  {{ name = "rest", path = "{rest}", condition = "insulated" }},
]
"""
TOOLS = (
    ("plate", "stick", "(50, 0) (20, 0) mm", "(20, -20) (50, -20) (50, 0) mm"),
    ("mould", "slip", "(35.01, 90) (35.01, 0.01) mm", "(50, 0.01) (50, 90) (35.01, 90) mm"),
    ("ring", "stick", "(20, 80) (35, 80) mm", "(35, 100) (20, 100) (20, 80) mm"),
)
SIZES = ((9, 139), (12, 208), (18, 278), (24, 417), (36, 556))  # 2.5 k to 40 k triangles
MEMORY_SIZE = (18, 278)  # 10 k
STEPS = 6
EVERY = 2  # steps from one bare factorisation to the next


def case(across, along):
    tools = "".join(TOOL.format(name=n, friction=f, contact=c, rest=r) for n, f, c, r in TOOLS)
    path = new_path("case.toml")
    path.write_text(CASE.format(across=across, along=along, duration=STEPS, tools=tools))
    return path


def exponent(sizes, costs):
    """Slope of log cost over log size, least squares."""
    x, y = [math.log(s) for s in sizes], [math.log(c) for c in costs]
    mx, my = statistics.fmean(x), statistics.fmean(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def section(options):
    build("step_bench")
    sizes = [2 * across * along for across, along in SIZES]
    kinds = {"flow": "flow of a step", "step": "whole step", "bare": "bare factorisation and solve"}
    costs = {size: {} for size in sizes}
    for size, (across, along) in zip(sizes, SIZES):
        rows = [row for row in step_bench(case(across, along), "draft", EVERY) if row["converged"]]
        if any(row["triangles"] != size for row in rows):
            raise RuntimeError(f"the mesh of {size} triangles was replaced during the run")
        costs[size]["iterations"] = [row["iterations"] for row in rows[1:]]
        costs[size]["bare"] = [row["bare"] for row in sampled(rows)]
        for kind in ("flow", "step"):
            costs[size][kind] = [row[kind] for row in rows[1:]]  # the first one also analyses the pattern
    for size in sizes:
        times = ", ".join(f"{kind} {1e3 * statistics.median(costs[size][kind]):.0f} ms" for kind in kinds)
        print(f"    {size:6} triangles: {times}, {statistics.median(costs[size]['iterations']):.0f} contact iterations", flush=True)
    for kind, what in kinds.items():
        value = exponent(sizes, [statistics.median(costs[size][kind]) for size in sizes])
        yield Figure(f"growth.{kind}", f"{what}: exponent of its CPU time, {sizes[0]} to {sizes[-1]} triangles", value,
                     1.3 if kind == "flow" else None)


def memory(options):
    build("parison")
    out = new_path("run")
    done = run([BUILD / "parison", "run", case(*MEMORY_SIZE), "--accuracy", "draft", "--output", out], f"{out}.log")
    if done.code:
        raise RuntimeError(f"parison run ended with {done.code}:\n" + open(f"{out}.log").read()[-800:])
    empty = run([BUILD / "parison", "--help"], new_path("help.log"))
    triangles = 2 * MEMORY_SIZE[0] * MEMORY_SIZE[1]
    yield Figure("memory.peak", f"peak memory of a coupled run with {triangles} triangles of glass", done.peak, 300, unit="MB")
    yield Figure("memory.program", "  of which the program and its libraries", empty.peak, unit="MB")
