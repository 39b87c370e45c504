# SPDX-License-Identifier: GPL-3.0-or-later
"""Narrow-neck bottles by press and blow. Neck-down frame: z = 0 at the finish, the body grows along +z."""
import math

from .draws import Plunger, Tip, friction, holding_walls, plunger_force, rounded
from .outline import Path, area, gap_within, radius_at, solve, volume
from .press_and_blow import Shape, Times, full_cavity, pressed_case


def container(draw):
    """Finish and the cavity of the blow mould: neck, shoulder, body, heel, push-up."""
    finish, height = rounded(draw, 12, 15.5, 1), rounded(draw, 14, 20, 1)
    body = rounded(draw, 25, 36, 1)
    total = round(body * draw.uniform(5.0, 7.2), 1)
    heel = rounded(draw, 5, 9, 1)
    neck_end = round(total * draw.uniform(0.2, 0.34), 1)
    shoulder = round(neck_end + (body - finish) * draw.uniform(1.6, 3.0), 1)
    mould = Path((finish, height), (finish + 0.5, height + 14), (finish + rounded(draw, 1, 2, 1), max(neck_end, height + 20)),
                 (body, max(shoulder, height + 45)), (body, total - heel))
    mould.arc((body - heel, total - heel), heel, 0, 90)
    mould.to((round(0.4 * body, 1), total), (0, total - rounded(draw, 2, 5, 1)))
    return finish, height, total, mould


def blank_cavity(finish, height, length, body, corner_share):
    """The cavity of blank and baffle with a body of some radius."""
    corner = corner_share * body
    cavity = Path((finish, height), (finish - 1, height + 10), (finish, height + 0.25 * (length - height)),
                  (body, height + 0.7 * (length - height)), (body, length - corner))
    return cavity.arc((body - corner, length - corner), corner, 0, 90).to((0, length))


def long_plunger(draw, finish, height, length, tip):
    """A slender plunger, its tip given or drawn, and the height of its tip in the full cavity."""
    shank = round(finish - draw.uniform(3.6, 4.8), 2)
    tip = tip or Tip(draw, (3, 0.8 * shank), (25, 50))
    tip_side = round(draw.uniform(0.55, 0.8) * shank if tip.pointed else tip.radius, 2)
    full = round(length - draw.uniform(7, 11), 2)
    taper = round(height + draw.uniform(12, 25), 1)
    return Plunger(shank, taper - full, shank - 0.05, taper + 1 - full, tip_side, tip), full


def gob(wanted, start, clearance, blank, length):
    """A gob that has fallen into the blank, its lower pole at `start`, with some clearance to the blank; None where the
    blank cannot hold it."""
    points = blank.points()
    lower = radius_at(points, start + 11) - clearance
    heights = [z for _, z in points[1:4] if z > start + lower + 1]

    def made(end):
        """Up to the height `end`, where its upper cap starts."""
        cap = 0.55 * (radius_at(points, end) - clearance)
        path = Path().arc((0, start + lower), lower, -90, 0)
        path.to(*[(radius_at(points, z) - clearance, z) for z in heights if z < end - 1])
        path.to((radius_at(points, end) - clearance, end))
        return path.arc((radius_at(points, end) - clearance - cap, end), cap, 0, 90).to((0, end + cap))

    end = solve(lambda z: volume(made(z).points()), start + lower + 3, length - 12, wanted)
    return (made(end), end) if end else (None, 0)


def fits(inner, outer):
    """Whether one line of points lies inside another: neither its points nor the other's corners beyond it."""
    corners = [(r, z) for r, z in outer if inner[0][1] < z < inner[-1][1]]
    return gap_within(inner, outer) >= 0 and all(radius_at(inner, z) <= r for r, z in corners)


def draw_shape(draw, tip=None, clearance=None, container=container, walls=(1.8, 3.2), girth=1):
    """Shapes that suit each other; None where the drawn numbers make no container. `girth` as in press_and_blow."""
    finish, height, total, mould = container(draw)
    wall = rounded(draw, *walls)
    wanted = wall * girth * (area(mould.points()) + 2 * math.pi * finish * height)
    length = round(height + (total - height) * draw.uniform(0.58, 0.70), 1)
    plunger, full = long_plunger(draw, finish, height, length, tip)
    displaced, corner_share = volume(plunger.outer(-full).points()), draw.uniform(0.5, 0.8)
    body = solve(lambda radius: full_cavity(finish, height, blank_cavity(finish, height, length, radius, corner_share)),
                 finish + 1, finish + 9, wanted + displaced)
    if body is None or not plunger.is_sound():
        return None
    blank = blank_cavity(finish, height, length, round(body, 3), round(corner_share, 3))
    start = rounded(draw, 0.5 * height, height, 1)
    shape = Shape(finish, height, total, wall, mould, length, blank, plunger, full, start, Path())
    shape.glass, _ = gob(shape.cavity(), start, clearance or draw.uniform(0.6, 1.3), blank, length)
    if shape.glass is None or not fits(blank.points(), mould.points()):
        return None
    return shape if gap_within(shape.glass.points(), [(finish, 0), *blank.points()]) >= 0.4 else None


def loads(draw, plunger):
    """Force on the plunger, kN, and frictions: where walls hold the glass it takes more to fill the cavity."""
    frictions = {tool: friction(draw) for tool in ("blank", "plunger", "mould")}
    holding = holding_walls(frictions, ("blank", "plunger"))
    return plunger_force(draw, math.pi * plunger.shank ** 2, 0.8 + 0.6 * holding), frictions


def draw_case(draw, name, tip=None, frictions=None, clearance=None):
    """A case file and what it is, with a plunger tip, the frictions of each tool and the clearance of the gob, mm, given or
    drawn; None where the drawn numbers make no container."""
    def given_loads(draw, plunger):
        return loads(draw, plunger)[0], frictions

    return pressed_case(draw, name, "narrow-neck bottle", draw_shape(draw, tip, clearance), given_loads if frictions else loads,
                        Times((0.4, 1.5), (0.4, 1.6), (0.3, 0.8)))
