# SPDX-License-Identifier: GPL-3.0-or-later
"""CalculiX deck of cases/contact_cylinders: z-mesh graded alike, a ring with a 2 mm bore, surface to surface contact."""
import re

BORE, RADIUS, GLASS_HEIGHT, STEEL_HEIGHT = 2e-3, 20e-3, 20e-3, 30e-3
COLUMNS, RATIO = 20, 40
WATCHED = (0, COLUMNS, 2 * COLUMNS)  # contact nodes from the bore out, in half divisions


def heights(height, rows):
    """Graded from the contact at 0: the last of `rows` divisions is RATIO times the first."""
    growth = RATIO ** (1 / (rows - 1))
    sizes = [growth**i for i in range(rows)]
    result = [0.0]
    for size in sizes:
        result.append(result[-1] + height * size / sum(sizes))
    return result


def body(name, first, levels, quadratic):
    """Nodes and axisymmetric elements; `levels` of z from the contact away, mid-side levels and columns in between."""
    steps = 2 * COLUMNS + 1

    def node(i, j):  # in half divisions
        return first + j * steps + i

    halves = [levels[0]]
    for a, b in zip(levels, levels[1:]):
        halves += [(a + b) / 2, b]
    lines = [f"*NODE, NSET=N{name}"]
    for j, z in enumerate(halves):
        for i in range(steps):
            if (i % 2 == 0 and j % 2 == 0) or (quadratic and (i % 2 == 0 or j % 2 == 0)):
                lines.append(f"{node(i, j)}, {BORE + (RADIUS - BORE) * i / (2 * COLUMNS):.12g}, {z:.12g}, 0.")
    lines.append(f"*ELEMENT, TYPE={'CAX8' if quadratic else 'CAX4'}, ELSET=E{name}")
    upward = levels[-1] > 0
    for j in range(len(levels) - 1):
        below, above = (2 * j, 2 * j + 2) if upward else (2 * j + 2, 2 * j)
        for i in range(0, 2 * COLUMNS, 2):
            nodes = [node(i, below), node(i + 2, below), node(i + 2, above), node(i, above)]
            if quadratic:
                nodes += [node(i + 1, below), node(i + 2, 2 * j + 1), node(i + 1, above), node(i, 2 * j + 1)]
            lines.append(f"{first + j * COLUMNS + i // 2}, " + ", ".join(map(str, nodes)))
    lines.append(f"*SURFACE, NAME=S{name}, TYPE=ELEMENT")
    return lines + [f"{first + i}, {'S1' if upward else 'S3'}" for i in range(COLUMNS)]


def deck(control, duration, rows, quadratic):
    """Text of the input file, backward Euler: fixed steps of `control` seconds, or its own step control where that is a text
    such as "DELTMX=0.5". The contact temperatures are printed each second."""
    glass, steel = 1, 10001
    lines = body("GLASS", glass, heights(GLASS_HEIGHT, rows), quadratic)
    lines += body("STEEL", steel, [-z for z in heights(STEEL_HEIGHT, rows)], quadratic)
    lines += ["*NSET, NSET=WATCH", ", ".join(str(first + i) for first in (glass, steel) for i in WATCHED)]
    for name, (conductivity, capacity, density) in {"GLASS": (2.77, 1282, 2500), "STEEL": (37, 620, 7800)}.items():
        lines += [f"*MATERIAL, NAME=M{name}", "*CONDUCTIVITY", f"{conductivity}", "*SPECIFIC HEAT", f"{capacity}",
                  "*DENSITY", f"{density}", "*ELASTIC", "1e9, 0.3", f"*SOLID SECTION, ELSET=E{name}, MATERIAL=M{name}"]
    lines += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", "1e9, 1.",
              "*GAP CONDUCTANCE", "5000., 0., 300.", "5000., 1e9, 300.",
              "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "SGLASS, SSTEEL"]
    seconds = ", ".join(f"{t}." for t in range(1, round(duration) + 1))
    own = isinstance(control, str)
    lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", "NGLASS, 1150.", "NSTEEL, 485.",
              "*TIME POINTS, NAME=SECONDS", seconds,
              f"*STEP, INC={1000000 if own else round(2 * duration / control)}",
              f"*HEAT TRANSFER, {control if own else 'DIRECT'}",
              f"1e-6, {duration!r}, 1e-10, 1." if own else f"{control!r}, {duration!r}",
              "*NODE PRINT, NSET=WATCH, " + ("TIME POINTS=SECONDS" if own else f"FREQUENCY={round(1 / control)}"),
              "NT", "*END STEP"]
    return "\n".join(lines) + "\n"


def read_contact(path):
    """{time: ([glass temperatures], [steel temperatures])} of a .dat file."""
    result, now = {}, None
    for line in open(path):
        if "temperatures for set WATCH" in line:
            now = round(float(re.search(r"time\s+(\S+)", line)[1]), 6)
            result[now] = ([], [])
        elif now is not None and len(line.split()) == 2:
            node, value = line.split()
            result[now][int(node) >= 10001].append(float(value))
    return result
