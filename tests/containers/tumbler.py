# SPDX-License-Identifier: GPL-3.0-or-later
"""Wide-mouth tumblers, pressed only. z = 0 under the foot, the plunger comes down from above."""
import math

from . import case_text as text
from .case_text import CONTACT, INSULATED, SYMMETRY, WALL, Tool, cooled
from .draws import Tip, colour, enough_force, friction, holding_walls, plunger_force, pressing, rounded, temperatures
from .outline import Path, gap_within, radius_at, volume
from .press_and_blow import facts, gob


def mould_tool(inner, top, temperature, wall_friction):
    outer = inner.points()[-1][0] + WALL
    return Tool("mould", [("inner", CONTACT, inner), ("top", INSULATED, Path((outer, top))),
                          ("outer", cooled(200), Path((outer, -WALL), (0, -WALL))), ("axis", SYMMETRY, Path((0, 0)))],
                temperature, wall_friction)


def ring_tool(hole, rim, plug, height, temperature, wall_friction):
    """The ring that forms the rim: a plug in the mould."""
    outer = plug + WALL
    return Tool("ring", [("under", CONTACT, Path((hole, height), (plug, height))),
                         ("joint", INSULATED, Path((plug, rim), (outer, rim))),
                         ("outer", cooled(200), Path((outer, rim + 20))), ("top", INSULATED, Path((hole, rim + 20))),
                         ("hole", INSULATED, Path((hole, height)))], temperature, wall_friction)


def outer_path(tip, tip_radius, shank, side_end, top):
    """Outline of a plunger from above with its tip at z = 0, from the tip outwards."""
    upward = tip.end(Path((tip_radius, -2 * top)), tip_radius)  # of a tip that points up
    path = Path()
    for part in reversed(upward.parts[1:]):
        if isinstance(part, list):
            path.to(*[(r, -z) for r, z in reversed(part)])
        else:
            (r, z), radius, start, end = part
            path.arc((r, -z), radius, -end, -start)
    return path.to((shank, side_end), (shank, top))


def plunger_tool(outer, tip, tip_radius, shank, side_end, top, temperature, wall_friction, position):
    end = -tip.side(tip_radius) + 0.6 * tip_radius
    bore = Path((0.55 * shank, side_end), (0.55 * tip_radius, end), (0, end))
    return Tool("plunger", [("outer", CONTACT, outer), ("top", INSULATED, Path((0.55 * shank, top))),
                            ("bore", cooled(1000), bore), ("axis", SYMMETRY, Path((0, 0)))],
                temperature, wall_friction, "H13", position)


def stages(draw, press, rim, foot, side):
    tools = ["mould", "ring", "plunger"]
    hold = f'motion.plunger = {{ force = "-{rounded(draw, 0.1, 0.4)} kN", speed_limit = "150 mm/s" }}'
    air = f'air = {{ temperature = "50 degC", h = "{round(draw.uniform(40, 150))} W/m2/K", ambient = "50 degC" }}'
    return [text.stage("settle", rounded(draw, 0.1, 0.3), -1, tools),
            *[text.stage(name, time, -1, tools, *keys) for name, time, keys in press],
            text.stage("dwell", rounded(draw, 1.5, 4), -1, tools, hold),
            text.stage("cool", rounded(draw, 1, 4), -1, ["mould"], 'pressure.inner = "0 bar"',
                       text.named_boundary("inner", (side, rim), (0, foot)), air)]


def draw_case(draw, name):
    """A case file and what it is; None where the drawn numbers make no container."""
    rim = rounded(draw, 60, 110, 1)
    base = rounded(draw, 26, 38, 1)
    slope = math.tan(math.radians(draw.uniform(0.8, 4)))  # draft
    corner, foot, wall = rounded(draw, 3, 6, 1), rounded(draw, 5, 9, 1), rounded(draw, 3.5, 5.8)
    top = rim + 5
    inner = Path((0, 0), (base - corner, 0)).arc((base - corner, corner), corner, -90, 0)
    inner.to((base + slope * (top - corner), top))
    at_rim = base + slope * (rim - corner)
    tip = Tip(draw, (4, 12), (65, 78))
    shank = round(at_rim - wall, 2)
    tip_radius = round(base - wall - draw.uniform(0, 1.5), 2)
    side_end, length = round(rim - foot - 3, 2), rim + 80
    outer = outer_path(tip, tip_radius, shank, side_end, length)
    in_place = [(r, z + foot) for r, z in outer.points() if z + foot < rim] + [(shank, rim)]
    wanted = volume([p for p in inner.points() if p[1] < rim] + [(at_rim, rim)]) - volume(in_place)
    glass, gob_top = gob(draw, wanted, 0, base - corner - 1)
    if glass is None or gob_top > rim - 3 or not tip_radius < shank - 0.5 or -tip.side(tip_radius) > side_end - 10:
        return None
    heat, section = temperatures(draw), math.pi * shank ** 2
    force = plunger_force(draw, section)
    frictions = {tool: friction(draw) for tool in ("mould", "plunger")}
    force = enough_force(force, section, holding_walls(frictions, ("mould", "plunger")))
    start = round(gob_top + draw.uniform(1, 8), 2)
    hole = round(shank - 1, 2)
    tools = [mould_tool(inner, top, heat["mould"], frictions["mould"]),
             ring_tool(hole, top, at_rim + slope * 5 + 3, rim, heat["ring"], '"stick"'),
             plunger_tool(outer, tip, tip_radius, shank, side_end, length, heat["plunger"], frictions["plunger"], start)]
    press = pressing(draw, start, foot, -force, section, wanted)
    head = [f"Random tumbler, pressed: {2.4e-3 * wanted:.0f} g, height {rim:g} mm, wall {wall} mm,",
            f"plunger tip {tip}, cavity full at {foot:.3f} mm. z = 0 under the foot."]
    glass = [("surface", CONTACT, glass), ("axis", SYMMETRY, Path((0, 0)))]
    return text.case_text(head, name, stages(draw, press, rim, foot, shank), glass, heat["gob"], colour(draw),
                          tools), facts(tip, force, frictions, foot)
