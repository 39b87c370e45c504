# SPDX-License-Identifier: GPL-3.0-or-later
"""The axes of the table of extremes: a name, the claim that decides, and scenes in the order of the axis."""
from dataclasses import dataclass

from . import coupled
from . import scenes as s

VFT = '{ law = "vft", A = -2.309, B = "3922 K", T0 = "564.15 K" }'
SLABS, SERIES = "heat of two slabs by Laplace transform", "heat of a slab by Laplace transform"
SLIP, SHELL = "work 3 eta V W/h2 integrated", "radial balance integrated"


@dataclass
class Axis:
    name: str
    claim: str
    points: list  # of (label, function that gives the scene)


def over(function, key, values, show="{:g}", **others):
    return [(show.format(value), lambda value=value: function(**{key: value}, **others)) for value in values]


def factors(function, key, base, which, values):
    """Values of one of a pair times factors."""
    def scene(factor):
        pair = list(base)
        pair[which] *= factor
        return function(**{key: tuple(pair)})
    return [(f"{factor:g}", lambda factor=factor: scene(factor)) for factor in values]


def mapped(along, across, ratio=1):
    return f"mesh = {{ mapped = [{along}, {across}], ratio = [1, {ratio:g}] }}\n"


def tool_mapped(along, across):
    return f"mesh = {{ mapped = [{along}, {across}] }}\n"


def vft(kelvin):
    exponent = -2.309 + 3922 / (kelvin - 564.15)
    return s.squeeze(viscosity=10 ** min(exponent, 300), law=VFT, kelvin=kelvin)


def units():
    """The same case in other units."""
    scene = s.squeeze()
    scene.text = (scene.text.replace('"10000 Pa.s"', '"100 kP"').replace('"2400 kg/m3"', '"2.4 g/cm3"')
                  .replace("(0.02, 0) m", "(20, 0) mm").replace("(0, 0) (20, 0) mm", "(0, 0) (20, 0) mm"))
    return scene


def open_and_close(cycles):
    """A tool that leaves and comes back: the heat cannot be less than without contact, nor more than in one long one."""
    scene = s.contact(time=1.0)
    limit = next(iter(scene.exact.values()))
    moves = ", ".join(f'["{(i + 0.5) / cycles:.6g} s", "{0 if i % 2 else -1e-3:g} m"]' for i in range(cycles))
    scene.text = scene.text.replace('tools = ["tool"] }]', f'tools = ["tool"], motion.tool = {{ offset = [["0 s", "0 m"], {moves}] }} }}]', 1)
    scene.exact = {}
    scene.error = lambda summary: max(0.0, summary["tools"]["tool"]["heat_received_J"] / limit - 1)
    return scene


def steps(viscosity):
    """A shell whose inflation lasts as long as the viscosity makes it."""
    return s.shell(viscosity=viscosity)


HEAT = [
    Axis("conductance of a contact, W/m2/K", SLABS, over(s.contact, "h", (1e-6, 1, 1e3, 1e6, 1e9, 1e12, 1e15, 1e18, 1e21, 1e30))),
    Axis("cooling by air, h in W/m2/K", SERIES, over(s.in_air, "h", (1e-6, 1, 1e3, 1e6, 1e12, 1e18, 1e30))),
    Axis("cooling by a coolant, h in W/m2/K", SERIES, over(s.in_air, "h", (1, 1e3, 1e6, 1e12, 1e18), kind="cooled")),
    Axis("conductivity of the glass, times", SLABS, factors(s.contact, "k", (1.3, 46.0), 0, (1e-6, 1e-5, 1e-3, 1, 1e3, 1e6))),
    Axis("conductivity of the tool, times", SLABS, factors(s.contact, "k", (1.3, 46.0), 1, (1e-6, 1e-5, 1e-3, 1, 1e3, 1e6))),
    Axis("heat capacity of the glass, times", SLABS, factors(s.contact, "c", (1300.0, 490.0), 0, (1e-6, 1e-3, 1, 1e3, 1e6))),
    Axis("heat capacity of the tool, times", SLABS, factors(s.contact, "c", (1300.0, 490.0), 1, (1e-6, 1e-3, 1, 1e3, 1e6))),
    Axis("jump between glass and tool, K", SLABS, [(f"{j:g}", lambda j=j: s.contact(temperature=(673.15 + j, 673.15)))
                                                  for j in (1e-3, 1e-1, 10, 1e3, 1e4, 1e5, 1e6)]),
    Axis("jump between glass and air, K", SERIES, [(f"{j:g}", lambda j=j: s.in_air(temperature=(323.15 + j, 323.15)))
                                                  for j in (1e-3, 1, 1e3, 1e4, 1e6)]),
    Axis("time of contact, s", SLABS, over(s.contact, "time", (1e-6, 1e-5, 1e-3, 1e-1, 10, 1e3))),
    Axis("time in air at h = 1e4 W/m2/K, s", SERIES, over(s.in_air, "time", (1e-6, 1e-3, 1, 100), h=1e4)),
    Axis("time beside a wall of given temperature, s", SERIES, over(s.in_air, "time", (1e-6, 1e-3, 1, 100), kind="wall")),
    Axis("sphere in air, h in W/m2/K", "heat of a sphere by Laplace transform", over(s.sphere_in_air, "h", (1, 200, 1e4, 1e6))),
    Axis("radiating sphere, start in K", "T^4 law integrated", [(f"{T:g}", lambda T=T: s.sphere_in_air(
        h=0, emissivity=1, k=1e4, temperature=(T, 300))) for T in (310, 1000, 1500, 3000)]),
    Axis("cells along the contact, glass to tool", SLABS, [(f"{a}:{b}", lambda a=a, b=b: s.contact(
        mesh=(mapped(a, 20, 10), tool_mapped(b, 40)))) for a, b in ((1, 300), (3, 30), (30, 3), (300, 1))]),
    Axis("start mesh of slivers, aspect of the cells", SLABS, [(f"{a}", lambda a=a: s.contact(
        mesh=(mapped(2, a, 1), tool_mapped(2, a)))) for a in (10, 100, 400)]),
    Axis("first cells of a given mesh, number across", SLABS, [(f"{n}", lambda n=n: s.contact(
        h=1e4, mesh=(mapped(8, n), tool_mapped(8, n)))) for n in (1, 2, 3, 5, 10, 20)]),
    Axis("size of the scene, m (time with its square)", SLABS, [(f"{0.01 * f:g}", lambda f=f: s.contact(
        time=f * f, h=2000 / f, width=0.01 * f, height=(0.01 * f, 0.02 * f), more=s.sizes(0.01 * f)
        | {"max_step": f'"{f * f / 5:g} s"', "initial_step": f'"{f * f / 1e3:g} s"', "min_step": f'"{max(1e-12, f * f * 1e-6):g} s"'}))
        for f in (1e-3, 1e-2, 1, 100, 1e3)]),
    Axis("contact that opens and closes, times", "not more heat than of one long contact", over(lambda n: open_and_close(n), "n", (2, 20, 100))),
]
LUMPED = "heat of two bodies of one temperature each, by the area and time of contact"
COUPLED = [
    Axis("share of a single edge that a tool covers", LUMPED, over(coupled.part_covered, "share", (0.001, 0.01, 0.1, 0.37, 0.5, 0.9, 0.999))),
    Axis("single partly covered edge, opened and closed in each step, times", LUMPED, over(coupled.part_covered, "cycles", (1, 10, 100, 1000))),
    Axis("glass pressed and cooled, conductance of the plates, W/m2/K", "work and heat of a disc of one temperature, integrated",
         over(coupled.pressed_glass, "h", (1, 100, 1e3, 1e4, 1e5), k=1e8)),
]
FLOW = [
    Axis("viscosity, Pa.s", SLIP, over(s.squeeze, "viscosity", (1e-3, 1, 1e4, 1e8, 1e12, 1e16))),
    Axis("VFT glass, degC", SLIP, [(f"{T:g}", lambda T=T: vft(T + 273.15)) for T in (1400, 1100, 800, 600, 577, 560, 400)]),
    Axis("speed of the plunger, m/s", SLIP, over(s.squeeze, "speed", (1e-6, 1e-3, 0.1, 2, 20))),
    Axis("pressed by a share of the height", SLIP, over(s.squeeze, "share", (1e-3, 0.1, 0.5, 0.8, 0.95))),
    Axis("radius over height of the disc", SLIP, [(f"{r / h:g}", lambda r=r, h=h: s.squeeze(radius=r, height=h, speed=0.1 * h))
                                                 for r, h in ((0.002, 0.02), (0.01, 0.01), (0.05, 0.002))]),
    Axis("size of the scene, m", SLIP, [(f"{0.01 * f:g}", lambda f=f: s.squeeze(height=0.01 * f, radius=0.02 * f, speed=1e-3 * f))
                                       for f in (1e-4, 1e-3, 1, 10, 30)]),
    Axis("friction, Pa.s/m (Navier)", SLIP, [("1e-6", lambda: s.squeeze(friction='{ law = "navier", coefficient = "1e-6 Pa.s/m" }')),
                                            ("1", lambda: s.squeeze(friction='{ law = "navier", coefficient = "1 Pa.s/m" }'))]),
    Axis("friction without slip", "work between that with slip and that of admissible velocities",
         [("stick", lambda: s.squeeze(friction='"stick"')), ("grip", lambda: s.squeeze(friction='"grip"'))]),
    Axis("stages", SLIP, over(s.squeeze, "stages", (1, 10, 100), show="{}")),
    Axis("reversal of the plunger", SLIP, over(s.squeeze, "back", (True,), show="there and back")),
    Axis("force of the plunger, N", "work force times way", over(s.press, "force", (1e-2, 1, 1e3, 1e6, 1e9))),
    Axis("blowing pressure, bar", SHELL, [(f"{p / 1e5:g}", lambda p=p: s.shell(pressure=p)) for p in (1, 1e3, 1e5, 1e7, 1e9)]),
    Axis("wall of a shell of 10 mm, mm", SHELL, [(f"{1e3 * w:g}", lambda w=w: s.shell(outer=0.01 + w)) for w in (3e-5, 3e-4, 3e-3, 3e-2, 1e-1)]),
    Axis("growth of a shell, times its radius", SHELL, over(s.shell, "growth", (1.01, 1.3, 2, 4))),
    Axis("shell against surface tension, N/m", SHELL, over(s.shell, "tension", (1e-6, 0.3, 100, 290))),
    Axis("steps of 1e-9 to 10 s, viscosity in Pa.s", SHELL, over(steps, "viscosity", (1e-1, 1e1, 1e4, 1e7))),
    Axis("size of a shell, m", SHELL, [(f"{0.01 * f:g}", lambda f=f: s.shell(inner=0.01 * f, outer=0.015 * f)) for f in (1e-4, 1e-2, 1, 30)]),
    Axis("drop at rest, surface tension in N/m", "nothing moves, nothing is dissipated", over(s.drop, "tension", (1e-6, 0.3, 1e3))),
    Axis("radius of a drop at rest, m", "nothing moves, nothing is dissipated", over(s.drop, "radius", (1e-6, 1e-4, 1e-2, 0.5))),
    Axis("gravity on glass at rest, g", "nothing moves, nothing is dissipated", [(f"{g:g}", lambda g=g: s.at_rest(gravity=9.81 * g))
                                                                               for g in (1e-3, 1, 100)]),
    Axis("pressure on glass at rest, bar", "nothing moves, nothing is dissipated", [(f"{p:g}", lambda p=p: s.at_rest(
        gravity=0, pressure=1e5 * p)) for p in (1e-5, 1, 100)]),
    Axis("density of glass at rest, kg/m3", "nothing moves, nothing is dissipated", over(s.at_rest, "density", (1, 2400, 2e4))),
    Axis("glass warmed by its own work, m/s", "heat equals work", over(s.warmed, "speed", (1e-3, 0.1, 2, 10))),
    Axis("units", SLIP, [("mm, P, g/cm3", units)]),
]
AXES = HEAT + COUPLED + FLOW
