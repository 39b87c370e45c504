# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the verification: a row for each test; figures whose names differ in one place stand together."""
import re
from itertools import groupby

from documents import store

EXACT = 1e-8  # limits below this are those of balances and identities, which hold to round-off
LONGEST = 8  # words in which names of figures that stand together differ, at most
LEAST = 3  # words that these names share, and that "…" stands for, at least
SIGNS = {"at most": "≤", "at least": "≥"}

def named(figures):
    """Figures with the words of their names: without "off by" and "relative", "the same: " told in full."""
    subject = ""
    for figure in figures:
        what = re.sub(r",? relative$|[:,]? off by( at most)?$", "", figure["what"].strip()).replace(": off by, ", ", ").replace(" off by, ", ", ")
        if what.startswith("the same: ") and subject:
            what = subject + what.removeprefix("the same")
        elif not what.startswith("the same"):
            subject = what.rpartition(": ")[0] or what
        yield {**figure, "words": what.split()}

def same(words, others):
    """How many words both begin with."""
    return next((i for i, pair in enumerate(zip(words, others)) if pair[0] != pair[1]), min(len(words), len(others)))

def shared(figures):
    """How many words all names begin with, and how many they end with beyond these."""
    names = [figure["words"] for figure in figures]
    begin = min(same(names[0], name) for name in names)
    end = min(min(same(names[0][::-1], name[::-1]), len(name) - begin, len(names[0]) - begin) for name in names)
    return begin, end if end >= LEAST else 0

def stand_together(figures):
    """Whether the names share enough, and differ in few words of one part, which a colon may only end."""
    begin, end = shared(figures)
    parts = [figure["words"][begin:len(figure["words"]) - end] for figure in figures]
    return begin + end >= LEAST and all(0 < len(part) <= LONGEST and not any(word[-1] == ":" for word in part[:-1]) for part in parts)

def groups(lines, fit=lambda lines: True):
    found = []
    for line in lines:
        longer = found and [*found[-1], line]
        if longer and fit(longer) and stand_together(longer) and (len(longer) == 2 or shared(longer) == shared(longer[:-1])):
            found[-1].append(line)
        else:
            found.append([line])
    return found

def title(lines):
    """The words of lines that stand together: what differs is told in the place where it does."""
    first = lines[0]["words"]
    if len(lines) == 1:
        return first
    begin, end = shared(lines)
    parts = [" ".join(line["words"][begin:len(line["words"]) - end]) for line in lines]
    mark = parts[0][-1] if parts[0][-1] in ",:" and all(part[-1] == parts[0][-1] for part in parts) else ""
    parts = [part.rstrip(",:") for part in parts]
    return [*first[:begin], *(("; " if any("," in part for part in parts) else ", ").join(parts) + mark).split(), *first[len(first) - end:]]

def below(words, others):
    """The name of a line in which "…" stands for words that it begins with, up to a comma or colon, or ends with as the line above does."""
    alike = same(words, others)
    begin = next((i for i in range(min(alike, len(words) - 1), LEAST - 1, -1) if words[i - 1][-1] in ",:"), 0)
    end = min(same(words[::-1], others[::-1]), len(words) - alike - 1)
    end = end if end >= LEAST else 0
    return " ".join(["…"] * (begin > 0) + words[begin:len(words) - end] + ["…"] * (end > 0))

def limit(bound):
    return f"{bound:g}".replace("e-0", "e-")

def alike(texts):
    """One text where all are equal, else all of them."""
    return ", ".join(dict.fromkeys(texts) if len(set(texts)) == 1 else texts)

def line_of(figures, digits):
    """Figures that stand together as one line: words, measured values with their units, limits."""
    units = [figure["unit"] for figure in figures]
    values = [digits(figure["measured"]) for figure in figures]
    if len(set(units)) > 1:
        values, units = [f"{value} {unit}".strip() for value, unit in zip(values, units)], [""]
    limits = alike([SIGNS[figure["sense"]] + limit(figure["bound"]) for figure in figures])
    return {"words": title(figures), "values": ", ".join(values), "unit": units[0], "limits": limits}

def same_limits(lines):
    return all(line[key] == lines[0][key] for line in lines for key in ("unit", "limits"))

def lines_of(figures, digits):
    """The lines of a test, those with the same limits put together once more."""
    lines, above = [], []
    for group in groups([line_of(group, digits) for group in groups(figures)], same_limits):
        words, values = title(group), "; ".join(line["values"] for line in group)
        lines.append(f"{below(words, above)}: **{values}**" + f" {group[0]['unit']}".rstrip() + f" ({group[0]['limits']})")
        above = words
    return lines

def exact(figure):
    return figure["sense"] == "at most" and figure["bound"] is not None and figure["bound"] <= EXACT

def told(figure):
    return figure["bound"] is not None and not exact(figure)

def rows(digits):
    """Test and lines of each test that has a figure which is told."""
    figures = [figure for _, of_test in groupby(store.verification(), lambda figure: figure["test"]) for figure in named(of_test)]
    for test, of_test in groupby(filter(told, figures), lambda figure: figure["test"]):
        yield [f"`{test.removeprefix('test_').removesuffix('.*')}`", "<br>".join(lines_of(of_test, digits))]

def left_out():
    """What the table leaves out."""
    bounds = [figure["bound"] for figure in store.verification()]
    of_identities = [figure["bound"] for figure in store.verification() if exact(figure)]
    return f"[figures.json](figures.json) has {len(of_identities)} more of balances and identities, which hold to round-off, within {limit(max(of_identities))}; " \
        f"and {bounds.count(None)} without a limit, as of P1 or the classical coupling of nodes, for comparison."
