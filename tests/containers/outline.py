# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines of lines and arcs in (r, z), mm: their text for a case file, their points, the volume they enclose."""
import math

DIGITS = 5  # of a coordinate in mm


def number(x):
    """A number as it stands in a case file."""
    text = f"{x:.{DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def point_text(points):
    return " ".join(f"({number(r)}, {number(z)})" for r, z in points) + " mm"


class Path:
    """Points and arcs one after the other; what does not meet is joined by a line."""

    def __init__(self, *points):
        self.parts = []
        self.to(*points)

    def to(self, *points):
        if points:
            self.parts.append([(round(r, DIGITS), round(z, DIGITS)) for r, z in points])
        return self

    def arc(self, centre, radius, start, end):
        """An arc from `start` to `end`, degrees."""
        rounded = [round(x, DIGITS) for x in (*centre, radius, start, end)]
        self.parts.append(((rounded[0], rounded[1]), *rounded[2:]))
        return self

    def reversed(self):
        """The same from its end to its start."""
        turned = Path()
        turned.parts = [part[::-1] if isinstance(part, list) else (*part[:2], part[3], part[2]) for part in self.parts[::-1]]
        return turned

    def text(self):
        """The value of `path` in a case file."""
        texts = []
        for part in self.parts:
            if isinstance(part, list):
                texts.append(f'"{point_text(part)}"')
            else:
                (r, z), radius, start, end = part
                texts.append(f'"arc centre ({number(r)}, {number(z)}) mm radius {number(radius)} mm '
                             f'from {number(start)} deg to {number(end)} deg"')
        return texts[0] if len(texts) == 1 else "[" + ", ".join(texts) + "]"

    def points(self, per_degree=1):
        """Its points in order; arcs as chords."""
        result = []
        for part in self.parts:
            if isinstance(part, list):
                result += part
                continue
            (r, z), radius, start, end = part
            count = max(2, round(per_degree * abs(end - start)))
            angles = [math.radians(start + (end - start) * i / count) for i in range(count + 1)]
            result += [(r + radius * math.cos(a), z + radius * math.sin(a)) for a in angles]
        return result

    def shifted(self, dz):
        moved = Path()
        for part in self.parts:
            if isinstance(part, list):
                moved.to(*[(r, z + dz) for r, z in part])
            else:
                (r, z), radius, start, end = part
                moved.arc((r, z + dz), radius, start, end)
        return moved


def volume(points):
    """Volume between a line of points and the axis, mm3, positive where z grows."""
    return sum(math.pi / 3 * (a[0] ** 2 + a[0] * b[0] + b[0] ** 2) * (b[1] - a[1])
               for a, b in zip(points, points[1:]))


def area(points):
    """Area of the surface of revolution, mm2."""
    return sum(math.pi * (a[0] + b[0]) * math.dist(a, b) for a, b in zip(points, points[1:]))


def radius_at(points, z):
    """Radius at a height of a line of points whose z never falls; 0 beyond its ends."""
    for a, b in zip(points, points[1:]):
        if a[1] <= z <= b[1] and b[1] > a[1]:
            return a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1])
    return 0.0


def gap_within(inner, outer):
    """Least distance of the points of `inner` from the lines of `outer`, negative where a point lies beyond them in r."""
    least = math.inf
    for r, z in inner:
        away = min(distance((r, z), a, b) for a, b in zip(outer, outer[1:]))
        least = min(least, away if r <= radius_at(outer, z) else -away)
    return least


def distance(x, a, b):
    """Distance of a point from a line from a to b."""
    along = (b[0] - a[0], b[1] - a[1])
    square = along[0] ** 2 + along[1] ** 2
    t = 0 if square == 0 else max(0, min(1, ((x[0] - a[0]) * along[0] + (x[1] - a[1]) * along[1]) / square))
    return math.dist(x, (a[0] + t * along[0], a[1] + t * along[1]))


def solve(function, low, high, wanted):
    """Where a monotone function takes a value, by bisection; None where it does not within the bounds."""
    f_low, f_high = function(low) - wanted, function(high) - wanted
    if f_low * f_high > 0:
        return None
    for _ in range(60):
        middle = 0.5 * (low + high)
        if (function(middle) - wanted) * f_low > 0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
