# SPDX-License-Identifier: GPL-3.0-or-later
"""Narrow-neck bottles by blow and blow. Neck-down frame: z = 0 at the finish, the body grows along +z."""
import math

from . import case_text as text
from .case_text import CONTACT, INSULATED, SYMMETRY, WALL, Tool, cooled
from .draws import Parison, colour, friction, rounded, temperatures
from .outline import Path, area, gap_within, volume


def open_blank(finish, height, radius, length, temperature, wall_friction):
    """The blank, open at its upper end, and the baffle that closes it later."""
    inner = Path((finish, height), (radius - 0.5, height + 14), (radius, length))
    outer = radius + WALL
    blank = Tool("blank", [("inner", CONTACT, inner), ("top", INSULATED, Path((outer, length))),
                           ("outer", cooled(200), Path((outer, height))),
                           ("bottom", INSULATED, Path((finish, height)))], temperature, wall_friction)
    baffle = Tool("baffle", [("face", CONTACT, Path((outer, length), (0, length))),
                             ("axis", SYMMETRY, Path((0, length + 20))),
                             ("rest", INSULATED, Path((outer, length + 20), (outer, length)))],
                  temperature, wall_friction)
    return inner, blank, baffle


def pin_tool(radius, tip, temperature, wall_friction):
    """The pin, its round corner at the height `tip`."""
    corner = 0.75 * radius
    outer = Path((radius, -20), (radius, tip - corner)).arc((radius - corner, tip - corner), corner, 0, 90).to((0, tip))
    return Tool("pin", [("outer", CONTACT, outer), ("axis", SYMMETRY, Path((0, -20))),
                        ("bottom", INSULATED, Path((radius, -20)))], temperature, wall_friction)


def stages(draw, pin_radius, tip, counter_blow, parison):
    """From the gob to the take-out; None where the parison would sag too far."""
    reheat = parison.reheat(draw, 0.3, 0.8)
    if reheat is None:
        return None
    finish = ["ring", "plate"]
    blow, mould_side = [*finish, "blank", "baffle"], [*finish, "mould"]
    inner = text.named_boundary("inner", (0, tip), (pin_radius, 0))
    return [text.stage("load", rounded(draw, 0.2, 0.4), -1, [*finish, "pin", "blank"]),
            text.stage("settle_blow", rounded(draw, 0.2, 0.5), -1, [*finish, "pin", "blank"],
                       f'pressure.top = "{rounded(draw, 0.5, 2)} bar"'),
            text.stage("corkage", rounded(draw, 0.2, 0.5), -1, blow, inner),
            text.stage("counter_blow", counter_blow, -1, blow,
                       f'pressure.inner = "{rounded(draw, 0.5, 2)} bar"'),
            text.stage("reheat", reheat, 1, finish),
            text.stage("run", rounded(draw, 0.2, 0.4), 1, mould_side), *parison.blow(draw, mould_side)]


def draw_case(draw, name):
    """A case file and what it is; None where the drawn numbers make no container."""
    finish, height = rounded(draw, 12, 15, 1), rounded(draw, 14, 18, 1)
    radius = round(finish + draw.uniform(3.5, 5.5), 1)
    length = round(radius * draw.uniform(5.0, 6.2), 1)
    total, body = round(length * draw.uniform(1.10, 1.18), 1), round(radius * draw.uniform(1.38, 1.6), 1)
    heel = rounded(draw, 4, 6, 1)
    shoulder = height + round((body - finish) * draw.uniform(1.6, 2.2), 1)
    mould = Path((finish, height), (body, shoulder), (body, total - heel))
    mould.arc((body - heel, total - heel), heel, 0, 90).to((round(0.4 * body, 1), total), (0, total - 2))
    heat = temperatures(draw)
    frictions = {tool: friction(draw) for tool in ("blank", "pin", "mould")}
    inner, blank, baffle = open_blank(finish, height, radius, length, heat["blank"], frictions["blank"])
    cavity = math.pi * finish ** 2 * height + volume(inner.points())
    wanted = draw.uniform(0.55, 0.68) * cavity
    wall = wanted / (area(mould.points()) + 2 * math.pi * finish * height)
    pin_radius, tip = round(finish - draw.uniform(4.5, 5.5), 2), round(height - draw.uniform(2, 5), 1)
    gob_radius = round(radius - draw.uniform(2.5, 3.5), 2)
    straight = wanted / (math.pi * gob_radius ** 2) - 4 / 3 * gob_radius
    side = Path().arc((0, tip + gob_radius), gob_radius, -90, 0).to((gob_radius, tip + gob_radius + straight))
    top = Path().arc((0, tip + gob_radius + straight), gob_radius, 0, 90)
    funnel = [(finish, 0), *inner.points(), (radius, 2 * total)]
    if not 1.8 <= wall <= 5 or gap_within(side.points() + top.points(), funnel) < 0.4 \
            or gap_within(inner.points(), mould.points()) < 0:
        return None
    tools = [*text.ring(finish, height, heat["ring"]), pin_tool(pin_radius, tip, heat["plunger"], frictions["pin"]), blank,
             baffle, text.closed_mould("mould", mould, heat["mould"], frictions["mould"])]
    counter_blow, parison_wall = rounded(draw, 0.9, 1.5), wanted / area(inner.points())
    parison = Parison(heat["gob"], 0.5 + counter_blow, 1.8, parison_wall, radius - parison_wall / 2, length - height,
                      total - length)
    made = stages(draw, pin_radius, tip, counter_blow, parison)
    if made is None:
        return None
    head = [f"Random narrow-neck bottle, blow and blow: {2.4e-3 * wanted:.0f} g, height {total:g} mm,",
            f"mean wall {wall:.2f} mm. Neck-down frame: z = 0 at the finish."]
    glass = [("side", CONTACT, side), ("top", CONTACT, top), ("axis", SYMMETRY, Path((0, tip)))]
    return text.case_text(head, name, made, glass, heat["gob"], colour(draw), tools), {
        f"friction_{tool}": value for tool, value in frictions.items()}
