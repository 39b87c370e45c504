# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of a case file from outlines, temperatures, frictions and stages: keys as in the bundled cases."""
from .outline import Path, number, point_text

AIR = 'air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }'
LAW = """law = "pressure-viscosity"
h0 = "500 W/m2/K"
h1 = "20000 W/m2/K"
p_ref = "0.2 MPa"
eta_ref = "1e3 Pa.s"
a = 1
b = 0.25
"""
INSULATED = 'condition = "insulated"'
CONTACT = 'condition = "contact"'
SYMMETRY = 'condition = "symmetry"'
WALL = 25.0  # of the tools, mm


def cooled(h):
    return f'condition.cooled = {{ h = "{h} W/m2/K", temperature = "50 degC" }}'


def quoted(names):
    return "[" + ", ".join(f'"{name}"' for name in names) + "]"


def boundary(name, condition, path):
    return f'  {{ name = "{name}", {condition}, path = {path.text()} }},'


class Tool:
    """A tool: `boundaries` of (name, condition, path), friction as TOML, temperature in degC."""

    def __init__(self, name, boundaries, temperature, friction, material="grey_iron", position=None,
                 section=None):
        self.name, self.boundaries, self.temperature = name, boundaries, temperature
        self.friction, self.material, self.position, self.section = friction, material, position, section

    def text(self):
        lines = ["[[tool]]", f'name = "{self.name}"', f'material = "{self.material}"',
                 f'temperature = "{self.temperature} degC"', f"friction = {self.friction}"]
        if self.position is not None:
            lines.append(f'position = "{number(self.position)} mm"')
        if self.section is not None:
            lines.append(f"section = {self.section}")
        return "\n".join(lines + ["boundary = ["] + [boundary(*b) for b in self.boundaries] + ["]", ""])


def stage(name, duration, gravity, tools, *more):
    """A stage; gravity of +1 or -1 along the axis, `more` its other keys as TOML."""
    parts = [f'name = "{name}"', f'duration = "{duration} s"', f'gravity = "{9.81 * gravity:g} m/s2"',
             f"tools = {quoted(tools)}", *more]
    return "  { " + ", ".join(parts) + " },"


def named_boundary(name, start, end):
    return f'name_boundary = [{{ name = "{name}", from = "{point_text([start])}", to = "{point_text([end])}" }}]'


def case_text(head, name, stages, glass, temperature, colour, tools):
    """A whole case file; `glass` holds the glass boundaries, like a tool's, `colour` names one of the bundled glasses."""
    lines = [f"# {line}" for line in head] + [f'case = "{name}"', 'geometry = "axisymmetric"', AIR,
                                             'output.interval = "0.1 s"', "", "stage = [", *stages, "]", "",
                                             "[[interface]]",
                                             f"tools = {quoted(tool.name for tool in tools)}", LAW, "[glass]",
                                             f'material = "{colour}"', f'temperature = "{temperature} degC"',
                                             "boundary = [", *[boundary(*b) for b in glass], "]", ""]
    return "\n".join(lines + [tool.text() for tool in tools])


def ring(radius, height, temperature):
    """The neck ring with the guide plate under it; they hold the finish from the press to the end."""
    outer = radius + WALL
    neck = Tool("ring", [("inner", CONTACT, Path((radius, 0), (radius, height))),
                         ("top", INSULATED, Path((outer, height))), ("outer", cooled(200), Path((outer, 0))),
                         ("bottom", INSULATED, Path((radius, 0)))], temperature, '"grip"')
    plate = Tool("plate", [("top", CONTACT, Path((0, 0), (outer, 0))), ("outer", cooled(200), Path((outer, -WALL))),
                           ("bottom", INSULATED, Path((0, -WALL))), ("axis", SYMMETRY, Path((0, 0)))],
                 temperature, '"grip"')
    return [neck, plate]


def closed_mould(name, inner, temperature, friction, section=None):
    """A mould around a cavity that opens at its lower end and is closed on the axis at its upper end; `section` as TOML."""
    points = inner.points()
    start, end = points[0], points[-1]
    outer, top = max(r for r, _ in points) + WALL, max(z for _, z in points) + WALL
    return Tool(name, [("inner", CONTACT, inner), ("axis", SYMMETRY, Path((0, top))),
                       ("outer", cooled(200), Path((outer, top), (outer, start[1]))),
                       ("bottom", INSULATED, Path(start))], temperature, friction, section=section)
