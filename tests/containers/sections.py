# SPDX-License-Identifier: GPL-3.0-or-later
"""Containers that are not round from round parisons. Neck-down frame: z = 0 at the finish, the body grows along +z."""
import random
from dataclasses import dataclass

from . import case_text as text
from . import narrow_neck, press_and_blow
from .draws import colour, friction, log_uniform, rounded, temperatures
from .outline import Path, number

MAX_DRAWS = 10000
SHAPES = ("circle", "ellipse", "rectangle", "superellipse")
PER_ROUND = {"circle": 1, "ellipse": 1, "rectangle": 1.15, "superellipse": 1.12}  # girth over that of an ellipse, about
WIDEST = 2.6  # half the width of a container over the radius of its parison
SAG = 0.4  # share of what is free that a parison may use which was not pressed, and is hotter than one that was


@dataclass
class Body:
    """A body from the last of the points of finish and neck on: lengths in mm."""
    points: list
    shoulder: float  # height where it has its full width
    total: float
    heel: float
    base: float  # radius of the foot over half the width
    push_up: float

    def cavity(self, half_width):
        wide = Path(*self.points, (half_width, self.shoulder), (half_width, self.total - self.heel))
        wide.arc((half_width - self.heel, self.total - self.heel), self.heel, 0, 90)
        return wide.to((round(self.base * half_width, 2), self.total), (0, round(self.total - self.push_up, 2)))


def jar(draw, total):
    """A jar or pot with a wide mouth of some height, and half its depth."""
    finish = round(min(34, max(11, total * draw.uniform(0.2, 0.4))), 1)
    height = round(min(16, max(6, 0.14 * total)), 1)
    depth = round(finish * draw.uniform(1.04, 1.4), 1)
    shoulder = round(height + 2 + (depth - finish) * draw.uniform(1, 2.5), 1)
    return Body([(finish, height)], shoulder, total, *foot(draw, depth)), depth


def bottle(draw, total):
    """A bottle of some height with a narrow neck, and half its depth."""
    finish, height = rounded(draw, 12, 15.5, 1), rounded(draw, 14, 20, 1)
    depth = rounded(draw, 18, 34, 1)
    neck_end = round(max(height + 20, total * draw.uniform(0.2, 0.34)), 1)
    shoulder = round(neck_end + (depth - finish) * draw.uniform(1.2, 3), 1)
    neck = [(finish, height), (finish + 0.5, height + 14), (finish + rounded(draw, 1, 2, 1), neck_end)]
    return Body(neck, shoulder, total, *foot(draw, depth)), depth


def foot(draw, depth):
    return round(depth * draw.uniform(0.12, 0.35), 1), draw.uniform(0.3, 0.6), round(depth * draw.uniform(0.02, 0.15), 1)


# With heights and mean walls, mm, and the most width over depth.
FAMILIES = {"jar": (press_and_blow, jar, (70, 200), (1.5, 4), 2.2), "pot": (press_and_blow, jar, (40, 85), (1.5, 4), 1.5),
            "bottle": (narrow_neck, bottle, (100, 250), (1.8, 3.2), 2.2)}


def section(draw, shape, body, depth):
    """The value of `section` in a case file; None for a circle. Round where the shoulder begins."""
    radius, start = body.points[-1]

    def over_height(values, unit=""):
        """From where the shoulder begins to where it ends."""
        heights = [start + (body.shoulder - start) * i / (len(values) - 1) for i in range(len(values))]
        quote = '"' if unit else ""
        return "[" + ", ".join(f'["{number(z)} mm", {quote}{number(value)}{unit}{quote}]'
                               for z, value in zip(heights, values)) + "]"

    if shape == "circle":
        return None
    keys = {"half_depth": over_height([radius, 0.5 * (radius + depth), depth], " mm")}
    if shape == "rectangle":
        keys["corner_radius"] = over_height([radius, depth * draw.uniform(0.15, 0.95)], " mm")
    if shape == "superellipse":
        keys["exponent"] = over_height([2, rounded(draw, 2.2, 6)])
    return "{ " + ", ".join(f"{key} = {value}" for key, value in keys.items()) + " }"


def parison_glass(shape):
    """The outline of the glass in the full cavity of blank and plunger, from the plunger's tip to the baffle."""
    path = shape.plunger.outer(-shape.full).shifted(shape.full).reversed()
    path.to((shape.finish, 0), (shape.finish, shape.height))
    path.parts += shape.blank.parts
    return path


def stages(draw, shape, dwell, reheat, parison):
    """From the closed blank to the take-out, in space from the reheat on."""
    inner = text.named_boundary("inner", (0, shape.full), (shape.plunger.shank, 0))
    finish, mould_side = ["ring", "plate"], ["ring", "plate", "mould"]
    return [text.stage("dwell", dwell, -1, [*finish, "blank", "plunger"]),
            text.stage("reheat", reheat, 1, finish, inner, 'solid = { sector = "90 deg" }'),
            text.stage("run", rounded(draw, 0.2, 0.8), 1, mould_side), *parison.blow(draw, mould_side)]


def draw_case(draw, name, title, shape, aspect):
    """A case file and what it is; None where the drawn numbers make no container."""
    family, draw_body, heights, walls, _ = FAMILIES[title]
    total = log_uniform(draw, *heights, 3)
    body, depth = draw_body(draw, total)
    if depth <= body.points[-1][0] or total - body.heel < body.shoulder + 3:
        return None

    def container(_):
        return *body.points[0], total, body.cavity(depth)

    drawn = family.draw_shape(draw, container=container, walls=walls, girth=PER_ROUND[shape] * (1 + aspect) / 2)
    if drawn is None or aspect * depth > WIDEST * max(r for r, _ in drawn.blank.points()):
        return None
    drawn.start = drawn.full
    heat, dwell = temperatures(draw), rounded(draw, 0.6, 2)
    parison = drawn.parison(heat["gob"], dwell)
    parison.free *= SAG
    reheat = parison.reheat(draw, 0.3, 1.8)
    if reheat is None:
        return None
    frictions = {tool: friction(draw) for tool in ("blank", "plunger", "mould")}
    mould = text.closed_mould("mould", body.cavity(round(aspect * depth, 1)), heat["mould"], frictions["mould"],
                              section(draw, shape, body, depth))
    head = [f"Random {shape} {title}: {2.4e-3 * drawn.cavity():.0f} g, height {total:g} mm, mean wall {drawn.wall} mm, half depth",
            f"{depth:g} mm, {aspect:g} times as wide. The glass starts as it fills the blank. Neck-down frame: z = 0 at the finish."]
    glass = [("surface", text.CONTACT, parison_glass(drawn)), ("axis", text.SYMMETRY, Path((0, drawn.full)))]
    return text.case_text(head, name, stages(draw, drawn, dwell, reheat, parison), glass, heat["gob"], colour(draw),
                          [*drawn.tools(heat, frictions)[:-1], mould])


def random_section(seed, index):
    """Name and text of the case file of one container; the same for the same seed and index."""
    draw = random.Random(f"{seed}/{index}")
    title = draw.choice(("jar", "bottle"))
    if title == "jar" and index % 4 == 0:
        title = "pot"
    shape = draw.choices(SHAPES, (10, 30, 35, 25))[0]
    aspect = rounded(draw, 1, FAMILIES[title][-1])
    if shape == "circle" or shape != "ellipse" and draw.random() < 0.5:
        aspect = 1
    name = f"{index:03d}_{shape}_{title}"
    for _ in range(MAX_DRAWS):
        made = draw_case(draw, name, title, shape, aspect)
        if made:
            return name, made
    raise RuntimeError(f"{name}: no container in {MAX_DRAWS} draws")
