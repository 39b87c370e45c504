# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in which several parts of the model work at once: exact where the bodies have one temperature each, else held against balances
and bounds."""
import math

from . import scenes as s

A, B, T0 = -2.309, 3922.0, 564.15  # of the VFT law, K
CAP = 3e10  # Pa.s, of the flow


def viscosity(kelvin):
    return min(CAP, 10 ** min(300.0, A + B / (kelvin - T0))) if kelvin > T0 else CAP


def part_covered(share=0.37, along=1, cycles=0, h=2e4, time=1.0, k=1e6, width=0.01, height=(0.01, 0.02)):
    """Two slabs of one temperature each, the tool under a share of the glass, which may be on a single edge; with cycles the tool leaves
    and comes back. Heat by the time of contact."""
    text = f'case = "covered"\ngeometry = "planar"\n[[stage]]\nname = "rest"\nduration = "{time:.9g} s"\ntools = ["tool"]\n'
    closed = time
    if cycles:
        part, moves = time / cycles, ['["0 s", "0 m"]']
        for i in range(cycles):
            moves += [f'["{(i + at) * part:.12g} s", "{z:g} m"]' for at, z in ((0.49, 0), (0.5, -1e-3), (0.99, -1e-3), (1, 0))]
        text += f'motion.tool = {{ offset = [{", ".join(moves)}] }}\n'
        closed = 0.49 * time
    text += f'[[interface]]\ntools = ["tool"]\nlaw = "constant"\nh = "{h:.9g} W/m2/K"\ntransition_gap = "{1e-4 * width:.9g} m"\n'
    text += s.material("hot", 2400, 1300, k) + s.material("cold", 7200, 490, k)
    text += f'[glass]\nmaterial = "hot"\ntemperature = "1273.15 K"\nmesh = {{ mapped = [{along}, 4] }}\n'
    text += s.box(width, 0, height[0], (s.CONTACT, s.INSULATED, s.INSULATED, s.INSULATED))
    text += '[[tool]]\nname = "tool"\nmaterial = "cold"\ntemperature = "673.15 K"\nmesh = { mapped = [3, 4] }\n'
    text += s.box(share * width, -height[1], 0, (s.INSULATED, s.INSULATED, s.CONTACT, s.INSULATED)) + s.output(time)
    contents = 2400 * 1300 * width * height[0], 7200 * 490 * share * width * height[1]
    softness = 1 / contents[0] + 1 / contents[1]
    return s.Scene(text, {"tools.tool.heat_received_J": 600 / softness * -math.expm1(-h * share * width * softness * closed)})


def pressed_temperature(start, tool, h, volume, height, speed, share, steps=4000):
    """Temperature, heat and work of a slipping disc of one temperature between plates of a constant one (Runge-Kutta, in the height)."""
    content, end = 2400 * 1300 * volume, (1 - share) * height

    def rates(z, kelvin):  # over the height: of temperature, heat to the plates, work
        power = 3 * viscosity(kelvin) * volume * speed ** 2 / z ** 2
        flux = h * 2 * volume / z * (kelvin - tool)
        return -(power - flux) / content / speed, -flux / speed, -power / speed
    state, dz = (start, 0.0, 0.0), (end - height) / steps
    for i in range(steps):
        z = height + i * dz
        k1 = rates(z, state[0])
        k2 = rates(z + dz / 2, state[0] + dz / 2 * k1[0])
        k3 = rates(z + dz / 2, state[0] + dz / 2 * k2[0])
        k4 = rates(z + dz, state[0] + dz * k3[0])
        state = tuple(x + dz / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(state, k1, k2, k3, k4))
    return state


def pressed_glass(start=1300.0, tool=800.0, h=1000.0, k=1e5, height=0.01, radius=0.02, speed=0.01, share=0.5, radiation=True,
                  friction='"slip"'):
    """A disc of VFT glass pressed between cold plates: flow, heat, contact, radiation inside the glass and new meshes. Where the glass
    conducts well it has one temperature, and work and heat are exact; else the balance of heat, and work above that of the hottest glass."""
    volume, duration = math.pi * radius ** 2 * height, share * height / speed
    extra = f'heat_capacity = "1300 J/kg/K"\nconductivity = "{k:.9g} W/m/K"\n'
    if radiation:
        extra += 'radiation = { refractive_index = 1.5, absorption = "200 1/m", thin_wall = false }\n'
    text = 'case = "pressed_glass"\ngeometry = "axisymmetric"\n'
    text += s.flow_material(f'{{ law = "vft", A = {A}, B = "{B} K", T0 = "{T0} K" }}', heat=extra)
    # Plates that stay at their temperature; of finite ones the skin would be another resistance.
    text += s.material("heavy", 7200, 1e9, 1e6) + s.disc(radius, height, f'temperature = "{start:.9g} K"\n')
    plates = s.plates(radius, height, [(duration, f'{{ offset = [["0 s", "0 m"], ["{duration:.12g} s", "{-share * height:.15g} m"]] }}')], friction)
    text += plates.replace(f"friction = {friction}\n", f'friction = {friction}\nmaterial = "heavy"\ntemperature = "{tool:.9g} K"\n')
    text += f'[[interface]]\ntools = ["base", "ram"]\nlaw = "constant"\nh = "{h:.9g} W/m2/K"\n'
    text += s.output(duration) + s.numerics(s.sizes(height) | s.time_settings(duration))
    end, heat, work = pressed_temperature(start, tool, h, volume, height, speed, share)
    content = 2400 * 1300 * volume
    if friction == '"slip"' and h * height / k < 2e-3:
        def exact_error(summary):
            tools = summary["tools"]
            found = tools["base"]["heat_received_J"] + tools["ram"]["heat_received_J"]
            return max(abs(summary["work"]["tools_J"] / work - 1), abs(found - heat) / max(heat, work),
                       abs(summary["glass"]["temperature_mean_degC"] + 273.15 - end) / (start - tool))
        return s.Scene(text, error=exact_error)

    def balance_error(summary):
        tools, lost = summary["tools"], content * (start - 273.15 - summary["glass"]["temperature_mean_degC"])
        received = tools["base"]["heat_received_J"] + tools["ram"]["heat_received_J"]
        gained = summary["dissipation_J"]
        hottest = start + gained / content * 10
        least = 3 * viscosity(hottest) * volume * speed * (1 / ((1 - share) * height) - 1 / height)
        # Of a millikelvin of a kelvin nothing can be told from the mean temperature.
        return max(abs(lost + gained - received) / max(received, gained, 1e-3 * content * (start - tool)), least / summary["work"]["tools_J"] - 1,
                   (tool - 273.15 - summary["glass"]["temperature_min_degC"]) / (start - tool))
    return s.Scene(text, error=balance_error)
