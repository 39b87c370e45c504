# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases that were measured: published points, the stored figures of tests/measured_cases, their tables and pictures."""
import csv
import json

from documents import store as stored
from documents.tables import digits, table

FOLDER = stored.ROOT / "cases" / "measured"


def points(name):
    """Rows of a case's measured.csv."""
    with open(FOLDER / name / "measured.csv", newline="") as file:
        return list(csv.DictReader(file))


def key(row):
    return row["quantity"] + (f", {row['at']}" if row["at"] else "")


def published(row):
    """The value, or the range where no value was published."""
    return row["value"] or (f"{row['low']} to {row['high']}" if row["low"] else "")


def store(name, found):
    (FOLDER / name / "figures.json").write_text(json.dumps(stored.rounded(found), indent=1) + "\n")
    if found["curves"]:
        picture(name, found)


def figures(name):
    return stored.read(FOLDER / name / "figures.json", f"tests/measured_cases --only {name} --store")


def laws():
    return stored.read(FOLDER / "contact_law" / "figures.json", "tests/measured_laws --store")


def store_laws(found):
    (FOLDER / "contact_law" / "figures.json").write_text(json.dumps(stored.rounded(found), indent=1) + "\n")


def rows(name):
    """The points of a case that it computes; a value outside what is allowed says so."""
    computed = figures(name)["computed"]
    for row in points(name):
        if key(row) in computed:
            value, unit = computed[key(row)], f" {row['unit']}" if row["unit"] else ""
            allowed = f"{row['low']} to {row['high']}{unit}" if row["low"] else ""
            outside = allowed and not float(row["low"]) <= value <= float(row["high"])
            yield [key(row) + (" s" if row["at"] else ""), published(row) + unit if published(row) else "", row["grade"], allowed,
                   digits(value, 4 if value >= 100 else 3) + unit + (" **outside**" if outside else "")]


HEADER = ["what", "published", "grade", "allowed", "computed"]


def measured(name):
    """Published points of a case, and what is computed."""
    return table(HEADER, list(rows(name)))


def measured_cases(*names):
    """Of all cases the values that have a range."""
    of = {name: [row for row in rows(name) if row[3]] for name in names}
    return table(["case", *HEADER], [["" if i else f"[{name}]({name}/README.md)", *row] for name, found in of.items() for i, row in enumerate(found)])


RANGES = {"exponent in the time of contact": (0.42, 0.54), "exponent in (gob - tool), end of the settling": (None, 1.5),
          "exponent in (gob - tool), with the counter-blow": (None, 1.5)}


def within(value, low, high):
    return f"{digits(value, 3)}" + ("" if (low is None or value >= low) and (high is None or value <= high) else " **out**")


def contact_laws():
    """The candidates of the default law against published points, and whether the bundled parisons bear them."""
    found = laws()["laws"]
    rows = [["mean loss in the jar's blank, K", "", *(digits(law["jar"]["loss"], 3) for law in found.values())]]
    rows.append(["heat into the jar's blank over that of perfect contact, %", "50 to 70", *(within(law["jar"]["share"], 50, 70) for law in found.values())])
    for name, (low, high) in RANGES.items():
        wanted = f"{low} to {high}" if low else f"at most {high}"
        rows.append([name, wanted, *(within(law[name], low, high) for law in found.values())])
    rows.append(["h of the laboratory's contact after a second, W/m2/K", "470 to 1750",
                 *(within(law["opened"], 470, 1750) if law["opened"] else "500 (`h0`)" for law in found.values())])
    ending = lambda law, case: {"completes": "completes", None: "not run"}.get(law["containers"].get(case), "**stops**")
    for case in next(iter(found.values()))["containers"]:
        rows.append([f"{case} on its tools", "completes", *(ending(law, case) for law in found.values())])
    return table(["", "published or wanted", *found], rows)


def contact_fits():
    """Constants of the gap by `calibrate`, for each reading of the published ranges."""
    return table(["reading of the published h over time", "`open_gap`, um, 95 % interval", "`opening_time`, s, 95 % interval"],
                 [[name, *(f"{digits(one['value'], 3)} ({digits(one['low'], 3)} to {digits(one['high'], 3)})" for one in of.values())]
                  for name, of in laws()["fits"].items()])


def picture(name, found):
    """Computed curves over the published points."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(5.6, 3.4), constrained_layout=True)
    colours = dict(zip(found["curves"], ("#2060a0", "#b03030", "#808080")))
    for label, curve in found["curves"].items():
        axes.plot(*zip(*curve), color=colours[label], label=label, linewidth=1.4, marker="x" if len(curve) < 9 else None)
    shown, unit = {}, found["axes"][1].rpartition(", ")[2]
    for row in points(name):
        if row["unit"] != unit or not published(row) or row["grade"] == "formula":
            continue
        if not row["value"]:
            axes.axhspan(float(row["low"]), float(row["high"]), color="#e8e8e8", zorder=0)
            continue
        if row["at"]:
            shown.setdefault(row["quantity"], []).append(row)
        else:
            axes.axhline(float(row["value"]), color="black", linestyle=":", linewidth=1)
            axes.annotate(f"published: {row['value']}", (1, float(row["value"])), xycoords=("axes fraction", "data"), xytext=(-3, 2),
                          textcoords="offset points", ha="right", va="bottom", fontsize=7)
    for (quantity, of), mark, colour in zip(shown.items(), "os", colours.values()):
        spread = [[float(r["value"]) - float(r["low"] or r["value"]) for r in of], [float(r["high"] or r["value"]) - float(r["value"]) for r in of]]
        axes.errorbar([float(r["at"]) for r in of], [float(r["value"]) for r in of], yerr=spread if of[0]["low"] else None, fmt=mark,
                      color=colour if len(shown) > 1 else "black", markersize=4, capsize=3, label=f"published, {quantity}")
    axes.set(xlabel=found["axes"][0], ylabel=found["axes"][1])
    axes.legend(fontsize=7, frameon=False)
    figure.savefig(FOLDER / name / "picture.png", dpi=110)
    pyplot.close(figure)


BLOCKS = {function.__name__: function for function in (measured, measured_cases, contact_laws, contact_fits)}
