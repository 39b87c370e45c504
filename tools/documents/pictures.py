# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of READMEs that are drawn from stored figures."""
from documents import store, tables

COLOURS = {"rosseland": "#b03030", "none": "#808080", "transfer": "#2060a0", "enclosure": "#000000"}


def radiation(case):
    """Wall and skin of a case by transfer with and without enclosure, without radiation inside the glass, and by Rosseland's conduction."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (wall, skin) = pyplot.subplots(1, 2, figsize=(9.5, 3.6), constrained_layout=True)
    for model, colour in COLOURS.items():
        run = store.run(case, f"light_{model}")
        label = tables.MODELS[model]
        known = [(i, t) for i, t in enumerate(run["thickness_profile_mm"]) if t is not None]
        last = len(run["thickness_profile_mm"]) - 1
        wall.plot([i / last for i, _ in known], [t for _, t in known], color=colour, label=label, linewidth=1.2)
        over_time = run["skin"] + [[end["end_s"], end["skin_mean_degC"]] for end in run["stages"][-1:] if "skin_mean_degC" in end]
        skin.plot([t for t, _ in over_time], [T for _, T in over_time], color=colour, label=label, linewidth=1.2)
    for stage in store.run(case, "light_enclosure")["stages"]:
        skin.axvline(stage["end_s"], color="#d0d0d0", linewidth=0.6, zorder=0)
        skin.annotate(stage["name"], (stage["end_s"], 0), xycoords=("data", "axes fraction"), xytext=(-1, 3), rotation=90,
                      textcoords="offset points", ha="right", va="bottom", fontsize=6, color="#606060")
    wall.set(xlabel="outer side, from the rim (0) to the middle of the bottom (1)", ylabel="wall, mm")
    skin.set(xlabel="time, s", ylabel="mean skin of the glass, degC")
    wall.legend(fontsize=7, frameon=False)
    path = store.ROOT / "cases" / case / "pictures" / "radiation.png"
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
    return path
