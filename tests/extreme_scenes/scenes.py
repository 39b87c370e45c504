# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes with exact solutions: a function gives the text of a case and the exact values of keys of its summary."""
import math
from dataclasses import dataclass, field

from . import exact


@dataclass
class Scene:
    """A case and what its summary must show: exact values by key, or a function of the summary that gives the error."""
    text: str
    exact: dict = field(default_factory=dict)
    error: object = None


def material(name, density, capacity=None, conductivity=None, extra=""):
    heat = "" if capacity is None else f'heat_capacity = "{capacity:.9g} J/kg/K"\nconductivity = "{conductivity:.9g} W/m/K"\n'
    return f'[material.{name}]\ndensity = "{density:.9g} kg/m3"\n{heat}{extra}\n'


def box(width, bottom, top, kinds):
    """Boundaries of a rectangle from the axis to `width`, m: bottom, side, top, axis, with their conditions."""
    names = ("bottom", "side", "top", "axis")
    points = [f"({width:.12g}, {bottom:.12g})", f"({width:.12g}, {top:.12g})", f"(0, {top:.12g})", f"(0, {bottom:.12g})"]
    paths = [f"(0, {bottom:.12g}) {points[0]} m"] + [f"{point} m" for point in points[1:]]
    return "boundary = [" + ", ".join(f'{{ name = "{name}", path = "{path}", condition = {kind} }}'
                                      for name, path, kind in zip(names, paths, kinds)) + "]\n"


INSULATED, CONTACT, SYMMETRY, AIR = '"insulated"', '"contact"', '"symmetry"', '"air"'


def numerics(values):
    return "[numerics]\n" + "".join(f'{key} = {value}\n' for key, value in values.items()) if values else ""


def contact(h=2000.0, time=1.0, k=(1.3, 46.0), c=(1300.0, 490.0), density=(2400.0, 7200.0), temperature=(1273.15, 673.15),
            height=(0.01, 0.02), width=0.01, mesh=("", ""), more=None):
    """Two slabs brought together, plane: the heat that crosses."""
    text = f'case = "contact"\ngeometry = "planar"\nstage = [{{ name = "rest", duration = "{time:.9g} s", tools = ["tool"] }}]\n'
    text += f'interface = [{{ tools = ["tool"], law = "constant", h = "{h:.9g} W/m2/K", transition_gap = "{1e-3 * width:.9g} m" }}]\n'
    text += material("hot", density[0], c[0], k[0]) + material("cold", density[1], c[1], k[1])
    text += f'[glass]\nmaterial = "hot"\ntemperature = "{temperature[0]:.12g} K"\n{mesh[0]}'
    text += box(width, 0, height[0], (CONTACT, INSULATED, INSULATED, INSULATED))
    text += f'[[tool]]\nname = "tool"\nmaterial = "cold"\ntemperature = "{temperature[1]:.12g} K"\n{mesh[1]}'
    text += box(width, -height[1], 0, (INSULATED, INSULATED, CONTACT, INSULATED))
    text += f'[output]\ninterval = "{time:.9g} s"\n' + numerics(more)
    sides = [exact.slab_admittance(k[i], density[i] * c[i], height[i]) for i in (0, 1)]
    heat = width * exact.heat_through(sides, h, temperature[0] - temperature[1], time) if h > 0 else 0.0
    return Scene(text, {"tools.tool.heat_received_J": heat})


def in_air(h=200.0, time=1.0, k=1.3, c=1300.0, density=2400.0, temperature=(1273.15, 323.15), height=0.01, width=0.01, mesh="",
           kind="air", more=None):
    """A slab cooled on its top by air, by a coolant or by a wall of given temperature."""
    top = {"air": AIR, "cooled": f'{{ cooled = {{ h = "{h:.9g} W/m2/K", temperature = "{temperature[1]:.12g} K" }} }}',
           "wall": f'{{ temperature = "{temperature[1]:.12g} K" }}'}[kind]
    text = f'case = "air"\ngeometry = "planar"\nstage = [{{ name = "rest", duration = "{time:.9g} s" }}]\n'
    if kind == "air":
        text += f'air = {{ temperature = "{temperature[1]:.12g} K", h = "{h:.9g} W/m2/K", ambient = "{temperature[1]:.12g} K" }}\n'
    text += material("hot", density, c, k)
    text += f'[glass]\nmaterial = "hot"\ntemperature = "{temperature[0]:.12g} K"\n{mesh}'
    text += box(width, 0, height, (INSULATED, INSULATED, top, INSULATED))
    text += f'[output]\ninterval = "{time:.9g} s"\n' + numerics(more)
    side = exact.slab_admittance(k, density * c, height)
    conductance = math.inf if kind == "wall" else h
    heat = width * exact.heat_through([side], conductance, temperature[0] - temperature[1], time) if conductance > 0 else 0.0
    return Scene(text, {"heat_to_air_J": heat})


def quarter(inner, outer, kinds):
    """Boundaries of half a section of a sphere or a shell, m: equator, outer, axis, inner."""
    text = f'{{ name = "equator", path = "({inner:.12g}, 0) ({outer:.12g}, 0) m", condition = {kinds[0]} }}, '
    text += f'{{ name = "outer", path = "arc centre (0, 0) m radius {outer:.12g} m from 0 deg to 90 deg", condition = {kinds[1]} }}, '
    text += f'{{ name = "axis", path = "(0, {inner:.12g}) m", condition = {kinds[2]} }}'
    if inner > 0:
        text += f', {{ name = "inner", path = "arc centre (0, 0) m radius {inner:.12g} m from 90 deg to 0 deg", condition = {kinds[3]} }}'
    return f"boundary = [{text}]\n"


def sphere_in_air(h=200.0, time=10.0, k=1.3, c=1300.0, density=2400.0, temperature=(1273.15, 323.15), radius=0.01, emissivity=0.0,
                  more=None):
    """A sphere cooled by air; with an emissivity by radiation alone, when it must conduct well."""
    text = f'case = "sphere"\ngeometry = "axisymmetric"\nstage = [{{ name = "rest", duration = "{time:.9g} s" }}]\n'
    text += f'air = {{ temperature = "{temperature[1]:.12g} K", h = "{h:.9g} W/m2/K", ambient = "{temperature[1]:.12g} K" }}\n'
    text += material("hot", density, c, k, f"emissivity = {emissivity:g}\n" if emissivity else "")
    text += f'[glass]\nmaterial = "hot"\ntemperature = "{temperature[0]:.12g} K"\n' + quarter(0, radius, (SYMMETRY, AIR, SYMMETRY))
    text += f'[output]\ninterval = "{time:.9g} s"\n' + numerics(more)
    half, content = 2 * math.pi * radius ** 2, density * c * 2 / 3 * math.pi * radius ** 3
    if emissivity:
        end = exact.radiated_temperature(temperature[0], temperature[1], half, emissivity, content, time)
        return Scene(text, {"heat_to_air_J": content * (temperature[0] - end)})
    side = exact.sphere_admittance(k, density * c, radius)
    return Scene(text, {"heat_to_air_J": half * exact.heat_through([side], h, temperature[0] - temperature[1], time)})


def flow_material(viscosity, density=2400.0, tension=0.0, heat=""):
    law = viscosity if isinstance(viscosity, str) else f'{{ law = "constant", value = "{viscosity:.9g} Pa.s" }}'
    surface = f'surface_tension = "{tension:.9g} N/m"\n' if tension else ""
    return f'[material.liquid]\ndensity = "{density:.9g} kg/m3"\nviscosity = {law}\n{surface}{heat}'


def sizes(length):
    """Settings of the numerics for a scene of another size than a container."""
    return {"surface_size": f'"{length / 6:.9g} m"', "skin_size": f'"{length / 6:.9g} m"',
            "tool_contact_size": f'"{length / 3:.9g} m"', "motion_tolerance": f'"{length / 400:.9g} m"'}


def plates(radius, height, motions, friction='"slip"'):
    """Two plates around a disc; a stage for each (duration, motion of the upper one)."""
    text = ""
    for number, (duration, motion) in enumerate(motions):
        text += f'[[stage]]\nname = "press{number}"\nduration = "{duration:.12g} s"\ntools = ["base", "ram"]\nmotion.ram = {motion}\n'
    wide, thick = 20 * radius, 0.5 * radius
    for name, low, high, face in (("base", -thick, 0, 2), ("ram", height, height + thick, 0)):
        kinds = [INSULATED, INSULATED, INSULATED, SYMMETRY]
        kinds[face] = CONTACT
        text += f'[[tool]]\nname = "{name}"\nfriction = {friction}\n' + box(wide, low, high, kinds)
    return text


def time_settings(duration):
    return {"max_step": f'"{duration / 5:.9g} s"', "initial_step": f'"{max(duration / 200, 1e-9):.9g} s"',
            "min_step": f'"{max(duration * 1e-7, 1e-12):.9g} s"'}


def output(duration):
    return f'[output]\ninterval = "{max(duration, 1e-6):.9g} s"\n'


def disc(radius, height, extra=""):
    return (f'[glass]\nmaterial = "liquid"\n{extra}film = {{ min_thickness = "{0.01 * height:.9g} m" }}\n'
            + box(radius, 0, height, (CONTACT, CONTACT, CONTACT, SYMMETRY)))


def squeeze(viscosity=1e4, speed=1e-3, height=0.01, radius=0.02, share=0.1, law=None, kelvin=None, more=None, friction='"slip"', stages=1,
            back=False):
    """A disc pressed between plates at a constant speed by a share of its height: work of the ram. Without slip a lower and an upper
    bound of it (Stefan's film and the work of the extension in its velocities) stand for the exact value."""
    volume, duration = math.pi * radius ** 2 * height, share * height / speed
    text = 'case = "squeeze"\ngeometry = "axisymmetric"\n' + flow_material(law or viscosity)
    text += disc(radius, height, f'temperature = "{kelvin:.9g} K"\n' if kelvin else "")
    part, ends = duration / stages, [-share * height * i / stages for i in range(stages + 1)]
    motions = [(part, f'{{ offset = [["0 s", "{a:.15g} m"], ["{part:.12g} s", "{b:.15g} m"]] }}') for a, b in zip(ends, ends[1:])]
    if back:  # the same way back, off the glass
        motions.append((part, f'{{ offset = [["0 s", "{ends[-1]:.15g} m"], ["{part:.12g} s", "0 m"]] }}'))
    text += plates(radius, height, motions, friction=friction)
    text += output(duration) + numerics(sizes(height) | time_settings(duration) | (more or {}))
    end = (1 - share) * height
    slipping = 3 * viscosity * volume * speed * (1 / end - 1 / height)
    if friction == '"slip"' or "navier" in friction:
        return Scene(text, {"work.tools_J": slipping})
    # Power of the parabolic velocities: pi eta V^2 (3.6 R^2/h + 1.5 R^4/h^3), R^2 h constant, integrated over h.
    film = math.pi * viscosity * speed * (1.8 * radius ** 2 * height * (1 / end ** 2 - 1 / height ** 2)
                                          + 0.375 * (radius ** 2 * height) ** 2 * (1 / end ** 4 - 1 / height ** 4))

    def outside(summary):
        work = summary["work"]["tools_J"]
        return max(0.0, slipping / work - 1, work / film - 1)
    return Scene(text, error=outside)


def press(viscosity=1e4, force=100.0, height=0.01, radius=0.02, share=0.2, more=None):
    """The same under a force, for the time in which it loses a share of its height."""
    volume = math.pi * radius ** 2 * height
    duration = 3 * viscosity * volume / (force * height) * (1 / (1 - share) - 1)
    text = 'case = "press"\ngeometry = "axisymmetric"\n' + flow_material(viscosity) + disc(radius, height)
    limit = 100 * height / duration
    text += plates(radius, height, [(duration, f'{{ force = "{-force:.9g} N", speed_limit = "{limit:.9g} m/s" }}')])
    text += output(duration) + numerics(sizes(height) | time_settings(duration) | (more or {}))
    return Scene(text, {"work.tools_J": force * share * height})


def shell(viscosity=1e4, pressure=1e5, inner=0.01, outer=0.015, growth=1.3, tension=0.0, more=None, mesh="mesh = { mapped = [4, 16] }\n"):
    """A spherical shell blown up: its wall at the time when the exact inner radius has grown by a factor."""
    duration = exact.shell_time(viscosity, pressure, inner, outer, growth * inner, tension)
    wall = (outer ** 3 - inner ** 3 + (growth * inner) ** 3) ** (1 / 3) - growth * inner
    settings = sizes(max(outer - inner, outer / 20)) | {"strain_per_step": 0.04} | time_settings(duration) | (more or {})
    text = 'case = "shell"\ngeometry = "axisymmetric"\n' + flow_material(viscosity, tension=tension)
    text += f'[glass]\nmaterial = "liquid"\n{mesh}' + quarter(inner, outer, (SYMMETRY, AIR, SYMMETRY, AIR))
    text += f'[[stage]]\nname = "blow"\nduration = "{duration:.12g} s"\npressure.inner = "{pressure:.9g} Pa"\n'
    text += output(duration) + numerics(settings)
    return Scene(text, {"thickness.mean_mm": 1e3 * wall})


def drop(radius=0.01, viscosity=1e4, tension=0.3, time=None):
    """A sphere with surface tension at rest: it stays, and its volume and radius with it."""
    time = time or 10 * viscosity * radius / tension
    text = 'case = "drop"\ngeometry = "axisymmetric"\n' + flow_material(viscosity, tension=tension)
    text += '[glass]\nmaterial = "liquid"\n' + quarter(0, radius, (SYMMETRY, AIR, SYMMETRY))
    text += f'[[stage]]\nname = "rest"\nduration = "{time:.12g} s"\n'
    text += output(time) + numerics(sizes(radius) | time_settings(time))
    # What moves dissipates: a sphere that keeps its form does not.
    energy = tension * 2 * math.pi * radius ** 2
    return Scene(text, error=lambda summary: abs(summary["work"]["dissipation_J"]) / energy)


def at_rest(gravity=9.81, density=2400.0, viscosity=1e2, radius=0.02, height=0.02, time=1.0, friction='"slip"', pressure=0.0):
    """Glass that fills a cup, under gravity and pressure: it stays at rest and loses no work."""
    text = 'case = "rest"\ngeometry = "axisymmetric"\n' + flow_material(viscosity, density)
    text += '[glass]\nmaterial = "liquid"\n' + box(radius, 0, height, (CONTACT, CONTACT, AIR, SYMMETRY))
    wall = 0.5 * radius
    path = (f'(0, {-wall:.12g}) ({radius + wall:.12g}, {-wall:.12g}) ({radius + wall:.12g}, {2 * height:.12g}) ({radius:.12g}, {2 * height:.12g}) m')
    text += f'[[tool]]\nname = "cup"\nfriction = {friction}\nboundary = [{{ name = "outside", path = "{path}", condition = {INSULATED} }}, '
    text += f'{{ name = "inside", path = "({radius:.12g}, 0) (0, 0) m", condition = {CONTACT} }}, '
    text += f'{{ name = "axis", path = "(0, {-wall:.12g}) m", condition = {SYMMETRY} }}]\n'
    text += f'[[stage]]\nname = "rest"\nduration = "{time:.9g} s"\ngravity = "{-gravity:.9g} m/s2"\ntools = ["cup"]\n'
    text += (f'pressure.top = "{pressure:.9g} Pa"\n' if pressure else "") + output(time) + numerics(sizes(height) | time_settings(time))
    weight = density * math.pi * radius ** 2 * height * gravity + pressure * math.pi * radius ** 2
    return Scene(text, error=lambda summary: abs(summary["work"]["dissipation_J"]) / (weight * height))


def warmed(speed=1.0, viscosity=1e4, height=0.01, radius=0.02, share=0.1, start=1273.15):
    """A disc of glass with heat pressed between plates without friction or heat: its work warms it."""
    volume, duration = math.pi * radius ** 2 * height, share * height / speed
    text = 'case = "warmed"\ngeometry = "axisymmetric"\n'
    text += flow_material(viscosity, heat='heat_capacity = "1300 J/kg/K"\nconductivity = "1.3 W/m/K"\n')
    text += material("iron", 7200, 490, 46)
    text += disc(radius, height, f'temperature = "{start:.9g} K"\n')
    text += plates(radius, height, [(duration, f'{{ offset = [["0 s", "0 m"], ["{duration:.12g} s", "{-share * height:.15g} m"]] }}')])
    text = text.replace('friction = "slip"\n', f'friction = "slip"\nmaterial = "iron"\ntemperature = "{start:.9g} K"\n')
    text += '[[interface]]\ntools = ["base", "ram"]\nlaw = "constant"\nh = "1e-3 W/m2/K"\n'
    text += output(duration) + numerics(sizes(height) | time_settings(duration))
    work = 3 * viscosity * volume * speed * (1 / ((1 - share) * height) - 1 / height)
    return Scene(text, {"dissipation_J": work})
