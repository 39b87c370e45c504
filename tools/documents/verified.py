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
    """Figures with the words of their names: without "off by" at the end, "the same: " told in full."""
    subject = ""
    for figure in figures:
        what = re.sub(r"[:,]? off by( at most)?$", "", figure["what"].strip())
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


def groups(figures):
    found = []
    for figure in figures:
        longer = found and [*found[-1], figure]
        if longer and stand_together(longer) and (len(longer) == 2 or shared(longer) == shared(longer[:-1])):
            found[-1].append(figure)
        else:
            found.append([figure])
    return found


def title(figures):
    """The name of figures that stand together: what differs is told in the place where it does."""
    first = figures[0]["words"]
    if len(figures) == 1:
        return " ".join(first)
    begin, end = shared(figures)
    parts = [" ".join(figure["words"][begin:len(figure["words"]) - end]) for figure in figures]
    mark = parts[0][-1] if parts[0][-1] in ",:" and all(part[-1] == parts[0][-1] for part in parts) else ""
    parts = [part.rstrip(",:") for part in parts]
    return " ".join([*first[:begin], ("; " if any("," in part for part in parts) else ", ").join(parts) + mark, *first[len(first) - end:]])


def below(what, above):
    """The name of a line in which "…" stands for words that it begins with, up to a comma or colon, or ends with as the line above does."""
    words, others = what.split(), above.split()
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


def item(figures, above, digits):
    """A line of figures that stand together: name, measured values, limits."""
    units = [figure["unit"] for figure in figures]
    values = [digits(figure["measured"]) for figure in figures]
    if len(set(units)) > 1:
        values = [f"{value} {unit}".strip() for value, unit in zip(values, units)]
        units = [""]
    bounds = ["" if figure["bound"] is None else SIGNS[figure["sense"]] + limit(figure["bound"]) for figure in figures]
    required = f" ({alike([bound or 'none' for bound in bounds])})" if any(bounds) else ""
    return f"{below(title(figures), above)}: **{', '.join(values)}**" + f" {units[0]}".rstrip() + required


def exact(figure):
    return figure["sense"] == "at most" and figure["bound"] is not None and figure["bound"] <= EXACT


def rows(digits):
    """Test and figures of each test that has a figure which is no identity."""
    named_figures = [figure for _, of_test in groupby(store.verification(), lambda figure: figure["test"]) for figure in named(of_test)]
    for test, of_test in groupby((figure for figure in named_figures if not exact(figure)), lambda figure: figure["test"]):
        found = groups(of_test)
        lines = [item(group, title(above) if above else "", digits) for group, above in zip(found, [None, *found])]
        yield [f"`{test.removeprefix('test_').removesuffix('.*')}`", "<br>".join(lines)]


def identities():
    """How many figures are balances and identities, and the largest limit of these."""
    bounds = [figure["bound"] for figure in store.verification() if exact(figure)]
    return f"{len(bounds)} further figures of [figures.json](figures.json) are balances and identities that hold to round-off, within {limit(max(bounds))}."
