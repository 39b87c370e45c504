# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools that reach resting glass at some moment of the run and squeeze it, with the numerics of the presets: travel, work and heat of the
glass, which slips and so deforms evenly, by the closed form of the squeezed disc (planar: plate)."""
import math

from . import scenes as s

HEATED = 'heat_capacity = "1300 J/kg/K"\nconductivity = "1e5 W/m/K"\n'
HEAVY = s.material("heavy", 7200, 1e9, 1e6)  # stays at its temperature


def face(name, radius, low, high, side, heat):
    kinds = [s.INSULATED, s.INSULATED, s.INSULATED, s.SYMMETRY]
    kinds[side] = s.CONTACT
    tool = f'[[tool]]\nname = "{name}"\nfriction = "slip"\n'
    if heat:
        tool += 'material = "heavy"\ntemperature = "773.15 K"\n'
    return tool + s.box(3 * radius, low, high, kinds)


def ring(radius, wall, height):
    """A wall beside the glass, around base and ram."""
    tool = '[[tool]]\nname = "ring"\nfriction = "slip"\n'
    low, high, wide = -2 * height, 4 * height, 4 * radius
    points = [(wall, high), (wall, low), (wide, low), (wide, high)]
    names, kinds = ("inner", "bottom", "outer", "top"), (s.CONTACT, s.INSULATED, s.INSULATED, s.INSULATED)
    paths = [f"({wall:.12g}, {high:.12g}) ({wall:.12g}, {low:.12g}) m"] + [f"({r:.12g}, {z:.12g}) m" for r, z in points[2:] + points[:1]]
    return tool + "boundary = [" + ", ".join(f'{{ name = "{n}", path = "{p}", condition = {k} }}' for n, p, k in zip(names, paths, kinds)) + "]\n"


def squeezed(height, factor, force, time):
    """Height of a slipping disc under a force after a time, with factor = 3 eta V (planar: 4 eta V), Pa.s m3."""
    return 1 / (1 / height + force * time / factor)


def lumped(start, cold, h, capacity, volume, before, flight, height_at, power_at, after, faces, steps=4000):
    """Heat given to the tools, J, by glass of one temperature: `before` seconds on one face of `flight` m2, then `after` on two."""
    loss = h * flight / capacity
    kelvin = cold + (start - cold) * math.exp(-loss * before)
    heat, dt = capacity * (start - kelvin), after / steps
    for i in range(steps):
        t = (i + 0.5) * dt
        flux = faces * h * volume / height_at(t)
        gain = power_at(t)
        middle = kelvin + 0.5 * dt * (gain - flux * (kelvin - cold)) / capacity
        heat += dt * flux * (middle - cold)
        kelvin += dt * (gain - flux * (middle - cold)) / capacity
    return heat


def landing(kind="force", planar=False, viscosity=1e4, height=0.01, radius=0.02, share=0.15, gap=3e-3, speed=0.1, delay=0.0, squeeze_time=0.07,
            ring_share=0.0, rise=0.0, conductance=0.0, start_stage=False):
    """A ram above glass that rests on a base reaches it after delay + gap/speed: driven by a force that takes `share` of the height in
    `squeeze_time`, or by a motion at that speed. `rise`: the base carries the glass up at this share of the speed. `ring_share`: a wall
    that the glass reaches at this share of the squeeze. `start_stage`: the ram waits a stage of its own."""
    volume = radius * height if planar else math.pi * radius ** 2 * height
    factor = (4 if planar else 3) * viscosity * volume
    heat, up = conductance > 0, rise * speed
    touch = delay + gap / (speed + up) if rise else delay + gap / speed
    if kind == "motion":
        squeeze_time = share * height / (speed + up)
    duration, force = touch + squeeze_time, factor * (share / (1 - share)) / (height * squeeze_time)
    least = (height * (1 - ring_share * share)) if ring_share else 0.0
    wall = (radius * height / least if planar else radius * math.sqrt(height / least)) if ring_share else 0.0
    tools = '"base", "ram"' + (', "ring"' if ring_share else "")
    text = f'case = "landing"\ngeometry = "{"planar" if planar else "axisymmetric"}"\n'
    text += s.flow_material(viscosity, heat=HEATED if heat else "") + (HEAVY if heat else "")
    text += s.disc(radius, height, 'temperature = "1273.15 K"\n' if heat else "")
    waits = start_stage and delay > 0 and not rise
    if waits:
        text += f'[[stage]]\nname = "wait"\nduration = "{delay:.12g} s"\ntools = [{tools}]\n'
    begin, length = (0.0, duration - delay) if waits else (delay, duration)
    text += f'[[stage]]\nname = "land"\nduration = "{length:.12g} s"\ntools = [{tools}]\n'
    if kind == "motion":
        end = -(length - begin) * speed
        text += f'motion.ram = {{ offset = [["0 s", "0 m"], ["{begin:.12g} s", "0 m"], ["{length:.12g} s", "{end:.15g} m"]] }}\n'.replace(
            '["0 s", "0 m"], ["0 s", "0 m"]', '["0 s", "0 m"]')
    else:
        limit = f'"{speed:.9g} m/s"'
        if begin:
            limit = f'[["0 s", "1e-9 m/s"], ["{begin:.12g} s", "1e-9 m/s"], ["{begin * (1 + 1e-7):.12g} s", {limit}]]'
        text += f'motion.ram = {{ force = "{-force:.12g} N", speed_limit = {limit} }}\n'
    if rise:
        text += f'motion.base = {{ offset = [["0 s", "0 m"], ["{begin:.12g} s", "0 m"], ["{length:.12g} s", "{(length - begin) * up:.15g} m"]] }}\n'.replace(
            '["0 s", "0 m"], ["0 s", "0 m"]', '["0 s", "0 m"]')
    text += face("base", radius, -0.5 * radius, 0, 2, heat) + face("ram", radius, height + gap, height + gap + 0.5 * radius, 0, heat)
    if ring_share:
        text += ring(radius, wall, height)
    if heat:
        text += f'[[interface]]\ntools = [{tools}]\nlaw = "constant"\nh = "{conductance:.9g} W/m2/K"\ntransition_gap = "1e-7 m"\n'
    text += s.output(duration)

    def height_at(t):
        free = squeezed(height, factor, force, t) if kind == "force" else height - (speed + up) * t
        return max(free, least)
    exact_height = height_at(squeeze_time)
    if kind == "force":
        work = force * (height - exact_height)
        power_at = lambda t: factor * (force * height_at(t) / factor) ** 2 if height_at(t) > least else 0.0
    else:
        work = factor * (speed + up) * (1 / exact_height - 1 / height)
        power_at = lambda t: factor * ((speed + up) / height_at(t)) ** 2
    wanted_heat = lumped(1273.15, 773.15, conductance, 2400 * 1300 * volume, volume, touch, volume / height, height_at, power_at, squeeze_time,
                         2) if heat else 0.0

    def error(summary):
        found = summary["tools"]
        end = 1e-3 * (summary["quantities"]["extent_z_max"]["value"] - summary["quantities"]["extent_z_min"]["value"])
        errors = [abs(end - exact_height) / (height - exact_height), abs(summary["work"]["tools_J"] - work) / work,
                  abs(summary["work"]["impact_loss_J"]) / work]
        if heat:
            received = sum(found[name]["heat_received_J"] for name in ("base", "ram"))
            errors.append(abs(received - wanted_heat) / wanted_heat)
        return max(errors)
    return s.Scene(text, error=error)
