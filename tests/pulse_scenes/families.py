# SPDX-License-Identifier: GPL-3.0-or-later
"""Random plane scenes in which the exchange of heat comes in pulses, ramps and short stages, and their heat in one dimension."""
from extreme_scenes import runs
from extreme_scenes.scenes import AIR, CONTACT, INSULATED, SYMMETRY, Scene, box, material

from .column import Interval, Layer, integrate

WIDTH = 0.005
STIFF = '\nviscosity = { law = "constant", value = "1e9 Pa.s" }\n'
GLASS, IRON = (1.3, 2400.0, 1300.0), (46.0, 7200.0, 490.0)


def curve(points, unit):
    return "[" + ", ".join(f'["{time:.12g} s", "{value:.12g} {unit}"]' for time, value in points) + "]"


def pulses(draw, log, low, high):
    """A curve of pulses between two values, [(time, value)], with edges of a tenth or a thousandth of a pulse."""
    width, count = log(0.01, 0.5), draw.choice([1, 1, 2, 5, 10])
    rest, edge = width * log(1, 50), width * draw.choice([0.1, 1e-3])
    points, time = [(0.0, low)], draw.choice([0.2, 1]) * rest
    for _ in range(count):
        points += [(time, low), (time + edge, high), (time + width, high), (time + width + edge, low)]
        time += width + edge + rest
    return points, time


def ramp(draw, log, low, high):
    """A curve that goes from one value to another in a short time."""
    start, width, after = log(0.02, 3), log(0.01, 0.5), log(0.05, 5)
    return [(0.0, low), (start, low), (start + width, high)], start + width + after


def some_curve(draw, log, low, high):
    kind = draw.choice([pulses, pulses, ramp])
    return kind(draw, log, low, high)


def value_at(points, time):
    for (t, a), (u, b) in zip(points, points[1:]):
        if t <= time <= u:
            return a if a == b or u == t else a + (b - a) * (time - t) / (u - t)
    return points[0][1] if time < points[0][0] else points[-1][1]


def intervals(points, end, h=None, around=None, law=None):
    """Intervals between the points of a curve up to an end; what is not the curve is a constant. `law`: h by the curve's value."""
    times = sorted({t for t, _ in points if t < end} | {0.0, end})
    result = []
    for start, stop in zip(times, times[1:]):
        pair = (value_at(points, start + 1e-9 * (stop - start)), value_at(points, stop - 1e-9 * (stop - start)))
        result.append(Interval(stop - start, pair if h is None else (h, h), pair if around is None else (around, around), law))
    return result


def slab(draw, log, is_iron=None):
    """A material's name, its lines and a layer of it at the start."""
    k, density, c = IRON if (draw.random() < 0.3 if is_iron is None else is_iron) else GLASS
    return Layer(k, density * c, log(3e-3, 3e-2), draw.uniform(600, 1500)), material("hot", density, c, k)


def glass(layer, kinds):
    return f'[glass]\nmaterial = "hot"\ntemperature = "{layer.temperature:.12g} K"\n' + box(WIDTH, 0, layer.thickness, kinds)


def case(name, end, middle, body):
    return f'case = "{name}"\ngeometry = "planar"\n{middle}[output]\ninterval = "{end:.9g} s"\n{body}'


def one_stage(end):
    return f'stage = [{{ name = "rest", duration = "{end:.12g} s" }}]\n'


def ended(text, layers, history, key):
    """The error is that of the heat, as a share of all that passes without sign."""
    heat, _ = integrate(layers, history)
    exchanged = sum(abs(b - a) for a, b in zip([0.0] + heat, heat))

    def error(summary):
        return abs(runs.value(summary, key) / WIDTH - heat[-1]) / exchanged
    return Scene(text, error=error)


def perhaps_flowing(draw, body):
    """In half of the cases stiff glass that flows, held between planes of symmetry; with the condition of its sides."""
    if draw.random() < 0.5:
        return body, INSULATED
    return body.rstrip() + STIFF, SYMMETRY


def cooling(draw, log):
    """Pulses or ramps of h, by air or by a coolant."""
    layer, body = slab(draw, log)
    high, around = log(100, 2e4), layer.temperature - log(50, 600)
    points, end = some_curve(draw, log, draw.choice([0.0, high / 100, high / 10]), high)
    h, kind, air, sides = curve(points, "W/m2/K"), AIR, "", INSULATED
    if draw.random() < 0.5:
        kind = f'{{ cooled = {{ h = {h}, temperature = "{around:.12g} K" }} }}'
    else:
        air = f'air = {{ temperature = "{around:.12g} K", h = {h}, ambient = "{around:.12g} K" }}\n'
        body, sides = perhaps_flowing(draw, body)
    text = case("cooling", end, air + one_stage(end), body + glass(layer, (sides, sides, kind, sides)))
    return ended(text, [layer], intervals(points, end, around=around), "heat_to_air_J")


def temperature(draw, log):
    """Pulses or ramps of the temperature of air, coolant or the surface itself."""
    layer, body = slab(draw, log)
    jump = log(20, 500) * draw.choice([-1, 1])
    points, end = some_curve(draw, log, layer.temperature, layer.temperature + jump)
    values = curve(points, "K")
    h = log(100, 2e4)
    kind = draw.choice([f'{{ cooled = {{ h = "{h:.12g} W/m2/K", temperature = {values} }} }}', f'{{ temperature = {values} }}'])
    text = case("temperature", end, one_stage(end), body + glass(layer, (INSULATED, INSULATED, kind, INSULATED)))
    given = float("inf") if kind.startswith("{ temp") else h
    return ended(text, [layer], intervals(points, end, h=given), "heat_to_air_J")


def stages(draw, log):
    """Stages of 10 ms to 5 s, each with its own air."""
    layer, body = slab(draw, log)
    body, sides = perhaps_flowing(draw, body)
    history, text = [], ""
    for number in range(draw.randint(2, 6)):
        duration, h, around = log(0.01, 5), draw.choice([0.0, log(10, 1e4)]), layer.temperature - log(50, 500)
        history.append(Interval(duration, (h, h), (around, around)))
        text += (f'{{ name = "s{number}", duration = "{duration:.12g} s", air = {{ temperature = "{around:.12g} K", h = "{h:.12g} W/m2/K", '
                 f'ambient = "{around:.12g} K" }} }}, ')
    end = sum(i.duration for i in history)
    if all(i.h[0] == 0 for i in history):
        return stages(draw, log)
    text = case("stages", end, f"stage = [{text}]\n", body + glass(layer, (sides, sides, AIR, sides)))
    return ended(text, [layer], history, "heat_to_air_J")


def touches(draw, log):
    """A tool that is there in some of the stages."""
    layer, body = slab(draw, log, False)
    tool = Layer(IRON[0], IRON[1] * IRON[2], log(5e-3, 3e-2), layer.temperature - log(50, 600))
    h, history, text = log(200, 2e4), [], ""
    for number in range(draw.randint(1, 3)):
        for tools, conductance, duration in (('"tool"', h, log(0.01, 2)), ("", 0.0, log(0.01, 3))):
            history.append(Interval(duration, (conductance, conductance)))
            text += f'{{ name = "s{number}{"a" if tools else "b"}", duration = "{duration:.12g} s", tools = [{tools}] }}, '
    end = sum(i.duration for i in history)
    stage = f'stage = [{text}]\ninterface = [{{ tools = ["tool"], law = "constant", h = "{h:.12g} W/m2/K", transition_gap = "5e-6 m" }}]\n'
    text = case("touches", end, stage, body + glass(layer, (CONTACT, INSULATED, INSULATED, INSULATED)) + cold_tool(tool))
    return ended(text, [layer, tool], history, "tools.tool.heat_received_J")


def cold_tool(tool, friction=""):
    return (material("cold", IRON[1], IRON[2], IRON[0]) + f'[[tool]]\nname = "tool"\nmaterial = "cold"\ntemperature = "{tool.temperature:.12g} K"\n{friction}'
            + box(WIDTH, -tool.thickness, 0, (INSULATED, INSULATED, CONTACT, INSULATED)))


def pressed(draw, log):
    """Stiff glass on a tool under a pressure in pulses or ramps, on which the conductance depends."""
    layer, body = slab(draw, log, False)
    tool = Layer(IRON[0], IRON[1] * IRON[2], log(5e-3, 3e-2), layer.temperature - log(50, 600))
    high = log(0.1e5, 3e5)
    values = [draw.choice([0.01, 0.1]) * high, high]
    if draw.random() < 0.4:
        values.reverse()
    points, end = some_curve(draw, log, *values)
    h0, h1, reference = 500.0, log(1e3, 2e4), log(0.1e5, 3e5)
    air = f'air = {{ temperature = "{layer.temperature:.12g} K", h = "0 W/m2/K", ambient = "{layer.temperature:.12g} K" }}\n'
    stage = (f'{air}stage = [{{ name = "rest", duration = "{end:.12g} s", tools = ["tool"], pressure.top = {curve(points, "Pa")} }}]\n'
             f'interface = [{{ tools = ["tool"], law = "pressure-viscosity", h0 = "{h0} W/m2/K", h1 = "{h1:.12g} W/m2/K", '
             f'p_ref = "{reference:.12g} Pa", eta_ref = "1e9 Pa.s", a = 1, b = 0 }}]\n')
    text = case("pressed", end, stage, body.rstrip() + STIFF + glass(layer, (CONTACT, SYMMETRY, AIR, SYMMETRY))
                + cold_tool(tool, 'friction = "slip"\n'))

    def law(pressure):
        return h0 + (h1 - h0) * pressure / (pressure + reference)
    history = intervals(points, end, law=law, around=0.0)
    return ended(text, [layer, tool], history, "tools.tool.heat_received_J")


FAMILIES = {cooling: 3, temperature: 2, stages: 2, touches: 2, pressed: 2}
