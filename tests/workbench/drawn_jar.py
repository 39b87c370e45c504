# SPDX-License-Identifier: GPL-3.0-or-later
"""A sheet with the tools of a 58 mm jar as a mould shop draws them: full sections, the blank side neck down, the mould upright, in mm."""
import math

BLANK_SIDE, MOULD_SIDE = (120, 60), (320, 200)  # where axis and plane of the finish are on the sheet
RING = [(29, 0), (29, 13)]
BLANK = [(29, 13), (28.4, 20), (26.8, 86, 13), (0, 86)]  # a third number rounds the corner
PLUNGER = [(25.2, -50), (25.2, 11), (22.9, 17), (20.2, 79.5, 11), (0, 79.5)]  # where it stops
MOULD = [(29, 13), (34, 22, 10), (34, 112, 7), (11, 112, 4), (0, 109)]


def rounded(points):
    """Lines and arcs (begin, end, centre or None) of corners of which some are rounded."""
    curves, at = [], points[0][:2]
    for i, (x, y, *radius) in enumerate(points[1:], 1):
        if not radius:
            curves.append((at, (x, y), None))
            at = (x, y)
            continue
        (ux, uy), (vx, vy) = (((a - x) / math.hypot(a - x, b - y), (b - y) / math.hypot(a - x, b - y)) for a, b in (points[i - 1][:2], points[i + 1][:2]))
        half = math.acos(ux * vx + uy * vy) / 2
        along, out = radius[0] / math.tan(half), radius[0] / math.sin(half) / math.hypot(ux + vx, uy + vy)
        begin, end = (x + along * ux, y + along * uy), (x + along * vx, y + along * vy)
        curves += [(at, begin, None), (begin, end, (x + out * (ux + vx), y + out * (uy + vy)))]
        at = end
    return curves


def entity(layer, begin, end, centre):
    pairs = [(8, layer)]
    if not centre:
        return [(0, "LINE"), *pairs, (10, begin[0]), (20, begin[1]), (11, end[0]), (21, end[1])]
    first, last = (math.degrees(math.atan2(y - centre[1], x - centre[0])) for x, y in (begin, end))
    if (last - first) % 360 > 180:
        first, last = last, first
    return [(0, "ARC"), *pairs, (10, centre[0]), (20, centre[1]), (40, math.dist(begin, centre)), (50, first), (51, last)]


def both_halves(layer, points, place, up):
    """The curves of one side and their mirror images; what ends square on the axis is one line, as it is drawn."""
    found = []
    for begin, end, centre in rounded(points):
        through = end[0] == 0 and begin[1] == end[1]
        for side in (1,) if through else (1, -1):
            at = [(place[0] + side * r, place[1] + up * z) for r, z in (begin, (-begin[0], begin[1]) if through else end)]
            found += entity(layer, *at, centre and (place[0] + side * centre[0], place[1] + up * centre[1]))
    return found


def drawing():
    pairs = [(0, "SECTION"), (2, "HEADER"), (9, "$INSUNITS"), (70, 4), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for layer, points in (("RING", RING), ("BLANK", BLANK), ("PLUNGER", PLUNGER)):
        pairs += both_halves(layer, points, BLANK_SIDE, 1)
    pairs += both_halves("MOULD", MOULD, MOULD_SIDE, -1)
    for x, low, high in ((BLANK_SIDE[0], 0, 160), (MOULD_SIDE[0], 80, 210)):
        pairs += entity("CENTRE", (x, low), (x, high), None)
    frame = [(0, 0), (420, 0), (420, 297), (0, 297), (0, 0)]
    for begin, end in zip(frame, frame[1:]):
        pairs += entity("FRAME", begin, end, None)
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code}\n{value}\n" for code, value in pairs)
