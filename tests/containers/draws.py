# SPDX-License-Identifier: GPL-3.0-or-later
"""Random temperatures, frictions, plunger tips and motions within published ranges, drawn from one `random.Random`."""
import math

from .case_text import CONTACT, INSULATED, SYMMETRY, Tool, cooled, stage
from .outline import Path, number

DENSITY = 2400  # of the glass, kg/m3


def whole(draw, low, high):
    """A whole number of a range."""
    return round(draw.uniform(low, high))


def rounded(draw, low, high, digits=2):
    return round(draw.uniform(low, high), digits)


def log_uniform(draw, low, high, digits=2):
    """A number whose logarithm is uniform, with a few significant digits."""
    return float(f"{math.exp(draw.uniform(math.log(low), math.log(high))):.{digits}g}")


def friction(draw):
    """Friction of a mould or plunger as TOML: none, Navier's from 1e4 to 1e6 Pa.s/m, with Coulomb's cap, stick, grip."""
    kind = draw.choices(("slip", "navier", "capped", "stick", "grip"), (15, 50, 10, 15, 10))[0]
    if kind not in ("navier", "capped"):
        return f'"{kind}"'
    cap = f", coulomb = {rounded(draw, 0.1, 0.5)}" if kind == "capped" else ""
    return f'{{ law = "navier", coefficient = "{log_uniform(draw, 1e4, 1e6):g} Pa.s/m"{cap} }}'


def temperatures(draw):
    """Start temperatures, degC: gob, blank side, blow mould, plunger or pin, neck ring."""
    return {"gob": whole(draw, 1080, 1180), "blank": whole(draw, 400, 520), "mould": whole(draw, 400, 520),
            "plunger": whole(draw, 450, 600), "ring": whole(draw, 450, 550)}


def colour(draw):
    """A bundled glass, from clear to dark; of one whole number, so that all draws after it are those of earlier versions."""
    return ("flint", "green", "amber")[(whole(draw, 50, 260) - 50) // 71]


def plunger_force(draw, area, least=0.5):
    """Force on the plunger, kN, from `least` to 3; on a wide one at least 5 bar of its section, mm2."""
    return log_uniform(draw, min(2.5, max(least, 5e-4 * area)), 3)


def holding_walls(frictions, tools):
    """How many of two tools hold the glass that touches them."""
    return sum("stick" in frictions[tool] or "grip" in frictions[tool] for tool in tools)


def enough_force(force, area, holding):
    """The force, kN, or what a plunger of some section, mm2, needs where walls hold the glass: 5 bar, and as much again for
    each such wall, or it stops short of the full cavity."""
    return max(force, round(5e-4 * area * (1 + holding), 2))


class Parison:
    """What the mean of a parison is like when it leaves the blank, for the times and pressures that suit it. Its glass,
    `wall` mm thick, has lost heat for some time, s, through one or two faces at 1250 W/m2/K to 480 degC."""

    def __init__(self, gob_temperature, contact, faces, wall, radius, length, free):
        cooling = faces * 1250 * contact / (DENSITY * 1300 * 1e-3 * wall)
        self.viscosity = 10 ** (-2.309 + 3922 / (480 + (gob_temperature - 480) * math.exp(-cooling) - 291))
        self.wall, self.radius, self.length, self.free = wall, radius, length, free

    def reheat(self, draw, low, high):
        """A time in air, s, in which it sags, as a rod, by no more than about half of what is free under it; None where it
        is too hot for any."""
        longest = 0.55 * self.free / self.length * 6 * self.viscosity / (DENSITY * 9.81 * 1e-3 * self.length)
        return None if longest < low else rounded(draw, low, min(high, longest))

    def blow(self, draw, tools):
        """Stages: a gentle blow that widens it at 5 to 20 1/s, as the valve opens, then the full pressure to the take-out."""
        gentle = 1e-5 * draw.uniform(5, 20) * 2 * self.viscosity * self.wall / self.radius
        full = rounded(draw, 0.5, 3)
        pressures = [round(min(max(gentle, 0.03), full), 2), full]
        times = [rounded(draw, 0.4, 0.9), rounded(draw, 1.0, 3.0)]
        return [stage(name, time, 1, tools, f'pressure.inner = "{number(pressure)} bar"')
                for name, time, pressure in zip(("blow", "hold"), times, pressures)]


class Tip:
    """The tip of a plunger: `round`, a corner of a radius round a flat face or a half sphere; `pointed`, a cone with a
    small sphere and a fillet at its foot."""

    def __init__(self, draw, round_radii, pointed_degrees):
        self.pointed = draw.random() < 0.35
        self.radius = rounded(draw, 1, 3) if self.pointed else rounded(draw, *round_radii)
        self.angle = rounded(draw, *pointed_degrees, digits=1) if self.pointed else 0

    def __str__(self):
        return f"{'pointed' if self.pointed else 'round'} {number(self.radius)} mm"

    def _fillet(self, radius):
        """Radius and centre height of the fillet where the cone meets a side of some radius."""
        fillet = 0.4 * radius
        a = math.radians(self.angle)
        r = radius - fillet + fillet * math.cos(a)
        cone = -self.radius + self.radius * math.sin(a) - (r - self.radius * math.cos(a)) * math.cos(a) / math.sin(a)
        return fillet, cone - fillet * math.sin(a)

    def side(self, radius):
        """Height below the tip at which the side of some radius ends, mm, below zero."""
        return self._fillet(radius)[1] if self.pointed else -min(self.radius, radius)

    def end(self, path, radius):
        """Adds the tip, at z = 0, to a path that comes up the side."""
        if self.pointed:
            fillet, z = self._fillet(radius)
            return path.arc((radius - fillet, z), fillet, 0, self.angle).arc((0, -self.radius), self.radius, self.angle, 90)
        if self.radius >= radius:
            return path.arc((0, -radius), radius, 0, 90)
        return path.arc((radius - self.radius, -self.radius), self.radius, 0, 90).to((0, 0))


class Plunger:
    """A plunger from below, drawn with its tip at z = 0: shank, taper between two heights under the tip, side, tip."""

    def __init__(self, shank, shank_end, side, side_start, tip_side, tip):
        self.shank, self.shank_end, self.side, self.side_start = shank, shank_end, side, side_start
        self.tip_side, self.tip = tip_side, tip

    def outer(self, bottom):
        path = Path((self.shank, bottom), (self.shank, self.shank_end), (self.side, self.side_start),
                    (self.tip_side, self.tip.side(self.tip_side)))
        return self.tip.end(path, self.tip_side)

    def is_sound(self):
        """Whether it only gets slimmer towards its tip, so that it can be withdrawn."""
        return (self.shank >= self.side >= self.tip_side > 0
                and self.shank_end < self.side_start < self.tip.side(self.tip_side))

    def tool(self, length, temperature, wall_friction, position):
        """The tool, with a bore of half its radius for the cooling."""
        end = self.tip.side(self.tip_side) - 0.6 * self.tip_side
        bore, shank_bore = 0.5 * self.tip_side, 0.5 * self.shank
        inner = Path((0, end), (bore, end), (shank_bore, self.shank_end), (shank_bore, -length))
        return Tool("plunger", [("outer", CONTACT, self.outer(-length)), ("axis", SYMMETRY, Path((0, end))),
                                ("bore", cooled(2000 if self.tip_side < 8 else 1000), inner),
                                ("bottom", INSULATED, Path((self.shank, -length)))],
                    temperature, wall_friction, "H13", position)


def pressing(draw, start, end, force, area, volume):
    """Stages of the press as (name, duration, keys as TOML): by a force, or by a position curve that leaves some of the
    volume free, and then by the force."""
    push = f'motion.plunger = {{ force = "{number(force)} kN", speed_limit = "{whole(draw, 120, 250)} mm/s" }}'
    rest = 'end_speed = "5 mm/s"'
    if draw.random() < 0.7:
        return [("press", rounded(draw, 1.5, 2.5), [push, rest])]
    near = end - math.copysign(rounded(draw, 0.01, 0.03, 3) * volume / area, end - start)
    time = rounded(draw, 0.4, 0.9)
    share = rounded(draw, 0.5, 0.75)
    curve = [(0, start), (round(0.5 * time, 3), start + share * (near - start)), (time, near)]
    text = ", ".join(f'["{number(t)} s", "{number(z)} mm"]' for t, z in curve)
    return [("press", time, [f"motion.plunger = {{ offset = [{text}] }}"]),
            ("fill", rounded(draw, 0.8, 1.5), [push, rest])]
