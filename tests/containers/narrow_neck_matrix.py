# SPDX-License-Identifier: GPL-3.0-or-later
"""Narrow-neck bottles of one size: three shapes of the plunger's tip, five frictions on plunger and blank."""
from . import narrow_neck
from .draws import Tip

TIPS = {"round_3": (False, 3, 0), "round_8": (False, 8, 0), "pointed_1": (True, 1, 35)}  # pointed, radius mm, angle deg
FRICTIONS = {"slip": '"slip"', "1e4": None, "1e5": None, "1e6": None, "stick": '"stick"'}
CLEARANCE = 0.8  # mm: with less room in the blank the gob of the slim tip does not fit
CASES = [(tip, friction) for tip in TIPS for friction in FRICTIONS]


class Fixed:
    """In place of a random draw: the middle of each range."""

    def uniform(self, low, high):
        return 0.5 * (low + high)

    def random(self):
        return 0.5

    def choices(self, population, _):
        return [population[0]]


def tip_of(name):
    """The tip of that name."""
    tip = Tip(Fixed(), (3, 3), (1, 1))
    tip.pointed, tip.radius, tip.angle = TIPS[name]
    return tip


def matrix_case(index):
    """Name, text of the case file and facts of one of the cases, numbered from 1."""
    tip, kind = CASES[index - 1]
    friction = FRICTIONS[kind] or f'{{ law = "navier", coefficient = "{kind} Pa.s/m" }}'
    frictions = {"blank": friction, "plunger": friction, "mould": '"stick"'}
    name = f"{index:03d}_{tip}_{kind}"
    made = narrow_neck.draw_case(Fixed(), name, tip_of(tip), frictions, CLEARANCE)
    if made is None:
        raise RuntimeError(f"{name}: the shapes do not suit each other")
    return name, *made
