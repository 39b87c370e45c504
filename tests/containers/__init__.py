# SPDX-License-Identifier: GPL-3.0-or-later
"""Random containers: case files by seed and number."""
import random

from . import blow_and_blow, narrow_neck, press_and_blow, tumbler

FAMILIES = {"jar": (press_and_blow, 35), "tumbler": (tumbler, 15), "narrow_neck": (narrow_neck, 35),
            "blow_and_blow": (blow_and_blow, 15)}  # with their weights
MAX_DRAWS = 10000


def random_case(seed, index):
    """Name, text of the case file and facts of one container; the same for the same seed and index."""
    draw = random.Random(f"{seed}/{index}")
    family = draw.choices(list(FAMILIES), [weight for _, weight in FAMILIES.values()])[0]
    name = f"{index:03d}_{family}"
    for _ in range(MAX_DRAWS):
        made = FAMILIES[family][0].draw_case(draw, name)
        if made:
            return name, *made
    raise RuntimeError(f"{name}: no container in {MAX_DRAWS} draws")
