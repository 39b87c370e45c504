# SPDX-License-Identifier: GPL-3.0-or-later
"""Wide-mouth jars by press and blow. Neck-down frame: z = 0 at the finish, the body grows along +z."""
import math
from dataclasses import dataclass

from . import case_text as text
from .draws import (Parison, Plunger, Tip, colour, enough_force, friction, holding_walls, plunger_force, pressing,
                    rounded, temperatures)
from .outline import Path, area, gap_within, solve, volume


def container(draw):
    """Finish, body and the cavity of the blow mould."""
    finish, height = rounded(draw, 20, 34, 1), rounded(draw, 10, 16, 1)
    body = round(finish * draw.uniform(1.1, 1.4), 1)
    total = round(body * draw.uniform(2.6, 3.9), 1)
    heel = rounded(draw, 4, 9, 1)
    shoulder = round(height + 3 + (body - finish) * draw.uniform(1.0, 2.0), 1)
    mould = Path((finish, height), (body, shoulder), (body, total - heel)).arc((body - heel, total - heel), heel, 0, 90)
    mould.to((round(0.35 * body, 1), total), (0, total - rounded(draw, 1.5, 4, 1)))
    return finish, height, total, mould


def blank_cavity(draw, finish, height, length):
    """The cavity of blank and baffle, and its radii under the neck and at the baffle's corner."""
    neck = round(finish - draw.uniform(0.8, 2.0), 1)
    end = round(neck - draw.uniform(1.0, 3.5), 1)
    corner = round(end * draw.uniform(0.4, 0.6), 1)
    cavity = Path((finish, height), (neck, height + rounded(draw, 4, 8, 1)), (end, length - corner))
    cavity.arc((end - corner, length - corner), corner, 0, 90).to((0, length))
    return cavity, neck, end


def plunger_in(draw, blank, height, neck, end, length, wanted):
    """A plunger that leaves the wanted volume of the cavity when it is fully in, and the height of its tip then."""
    finish_wall, thicker, bottom = draw.uniform(3.2, 5), draw.uniform(0.95, 1.1), draw.uniform(1.0, 1.5)
    tip = Tip(draw, (6, 12), (60, 75))
    shank = round(neck + 1.4 - finish_wall, 1)
    cavity = math.pi * blank.points()[0][0] ** 2 * height + volume(blank.points())

    def made(wall):
        at = length - bottom * wall
        return Plunger(shank, height - at, neck - wall, height + 6 - at, end - thicker * wall, tip), at

    def left(wall):
        plunger, at = made(wall)
        return cavity - volume(plunger.outer(-at).points())

    wall = solve(left, 2.5, min(10, 0.7 * end), wanted)
    return made(wall) if wall and wall > 3.0 else (None, None)


def gob(draw, wanted, start, widest):
    """A gob with half spheres at its ends, its lower pole at `start`; None where it would be too wide or too flat."""
    stretch = draw.uniform(1.05, 1.6)
    radius = round(min((wanted / math.pi / (4 / 3 + 2 * (stretch - 1))) ** (1 / 3), widest), 2)
    straight = wanted / (math.pi * radius ** 2) - 4 / 3 * radius
    if straight < 0.1:
        return None, 0
    path = Path().arc((0, start + radius), radius, -90, 0).arc((0, start + radius + straight), radius, 0, 90)
    return path, start + 2 * radius + straight


@dataclass
class Shape:
    """The shapes of a press-and-blow container: lengths in mm, volume of the glass in mm3."""
    finish: float  # radius of the neck ring
    height: float  # of the neck ring
    total: float  # height of the container
    wall: float  # of the container, mean
    mould: Path
    length: float  # of the parison
    blank: Path
    plunger: Plunger
    full: float  # height of the plunger's tip in the full cavity
    start: float  # height of its tip when it is loaded
    glass: Path  # the gob

    def cavity(self):
        """Volume of the glass with the plunger in."""
        return full_cavity(self.finish, self.height, self.blank) - volume(self.plunger.outer(-self.full).points())

    def parison(self, gob_temperature, dwell):
        """The parison after some time in the blank."""
        wanted = self.cavity()
        wall = wanted / (0.5 * area(self.blank.points()) + 0.5 * area(self.plunger.outer(-self.full).points()))
        radius = (self.plunger.shank + self.plunger.tip_side) / 2 + wall / 2
        return Parison(gob_temperature, 0.3 + dwell, 2, wall, radius, self.length - self.height, self.total - self.length)

    def tools(self, heat, frictions):
        return [*text.ring(self.finish, self.height, heat["ring"]),
                text.closed_mould("blank", self.blank, heat["blank"], frictions["blank"]),
                self.plunger.tool(self.full + 48, heat["plunger"], frictions["plunger"], self.start),
                text.closed_mould("mould", self.mould, heat["mould"], frictions["mould"])]


def full_cavity(finish, height, blank):
    """Volume of neck ring and blank, mm3."""
    return math.pi * finish ** 2 * height + volume(blank.points())


@dataclass
class Times:
    """Ranges of the stages, s."""
    dwell: tuple
    reheat: tuple
    run: tuple


def draw_shape(draw, container=container, walls=(2.2, 4.2), girth=1):
    """Shapes that suit each other; None where the drawn numbers make no container. `girth`: of the container, over that of
    the cavity that is drawn."""
    finish, height, total, mould = container(draw)
    wall = rounded(draw, *walls)
    wanted = wall * girth * (area(mould.points()) + 2 * math.pi * finish * height)
    length = round(height + (total - height) * draw.uniform(0.66, 0.78), 1)
    blank, neck, end = blank_cavity(draw, finish, height, length)
    plunger, full = plunger_in(draw, blank, height, neck, end, length, wanted)
    if plunger is None or not plunger.is_sound() or gap_within(blank.points(), mould.points()) < 0:
        return None
    start = rounded(draw, height, height + 10, 1)
    shape = Shape(finish, height, total, wall, mould, length, blank, plunger, full, start, Path())
    shape.glass, top = gob(draw, shape.cavity(), start, end - draw.uniform(1, 3))
    if shape.glass is None or top > length - 2 or gap_within(shape.glass.points(), [(finish, 0), *blank.points()]) < 0.8:
        return None
    return shape


def loads(draw, plunger):
    """Force on the plunger, kN, and frictions."""
    section = math.pi * plunger.shank ** 2
    force = plunger_force(draw, section)
    frictions = {tool: friction(draw) for tool in ("blank", "plunger", "mould")}
    return enough_force(force, section, holding_walls(frictions, ("blank", "plunger"))), frictions


def draw_case(draw, name):
    """A case file and what it is; None where the drawn numbers make no container."""
    return pressed_case(draw, name, "wide-mouth jar", draw_shape(draw), loads, Times((0.8, 2.0), (0.5, 1.8), (0.2, 0.6)))


def pressed_case(draw, name, title, shape, loads_of, times):
    """A case file of press and blow and what it is; None without a shape, or where the parison would sag too far."""
    if shape is None:
        return None
    plunger, wanted = shape.plunger, shape.cavity()
    heat = temperatures(draw)
    force, frictions = loads_of(draw, plunger)
    press = pressing(draw, shape.start, shape.full, force, math.pi * plunger.shank ** 2, wanted)
    dwell = rounded(draw, *times.dwell)
    made = stages(draw, press, shape, dwell, shape.parison(heat["gob"], dwell), times)
    if made is None:
        return None
    head = [f"Random {title}, press and blow: {2.4e-3 * wanted:.0f} g, height {shape.total:g} mm, mean wall {shape.wall} mm,",
            f"plunger tip {plunger.tip}, cavity full at {shape.full:.3f} mm. Neck-down frame: z = 0 at the finish."]
    glass = [("surface", text.CONTACT, shape.glass), ("axis", text.SYMMETRY, Path((0, shape.start)))]
    return text.case_text(head, name, made, glass, heat["gob"], colour(draw), shape.tools(heat, frictions)), \
        facts(plunger.tip, force, frictions, shape.full)


def facts(tip, force, frictions, full):
    """What is noted beside a result."""
    return {"tip": str(tip), "force_kN": force, "full_mm": round(full, 3),
            **{f"friction_{tool}": value for tool, value in frictions.items()}}


def stages(draw, press, shape, dwell, parison, times):
    """From the loaded gob to the take-out; `press` from `pressing`. None where the parison would sag too far."""
    blank_side, mould_side = ["ring", "plate", "blank", "plunger"], ["ring", "plate", "mould"]
    hold = f'motion.plunger = {{ force = "{rounded(draw, 0.08, 0.25)} kN", speed_limit = "150 mm/s" }}'
    inner = text.named_boundary("inner", (0, shape.full), (shape.plunger.shank, 0))
    reheat = parison.reheat(draw, *times.reheat)
    if reheat is None:
        return None
    return [text.stage("settle", rounded(draw, 0.1, 0.4), -1, blank_side),
            *[text.stage(name, time, -1, blank_side, *keys) for name, time, keys in press],
            text.stage("dwell", dwell, -1, blank_side, hold),
            text.stage("reheat", reheat, 1, ["ring", "plate"], inner),
            text.stage("run", rounded(draw, *times.run), 1, mould_side), *parison.blow(draw, mould_side)]
