# SPDX-License-Identifier: GPL-3.0-or-later
"""The counterparts of the paper's figures 9 to 13: a PNG and a CSV file each."""
import csv

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.tri import Triangulation

import exact
import measure
import runs as runs_module
from render import SUB_TRIANGLES, bodies_at, save

SHOWN_TIMES = (1, 2, 5, 10)
MAPPED = (7, 20)  # the pair of figures 9 and 12, the glass its slave
SIDE_LIMITS = ((600, 960), (552, 612))  # degC, the same in figures 10 and 11


CAPTIONS = {
    "fig09_map": "Temperature of both bodies at 10 s, 7/20 with the glass as slave, without and with the interface element; "
                 "below, the isotherms within 1 mm of the contact, which have to be straight.",
    "fig10_classical": "Temperature along both sides of the contact with the classical coupling, all mesh pairs and both roles.",
    "fig11_interface_element": "The same with the interface element, on the same scales.",
    "fig12_history": "Both sides of the contact over time, 7/20 with the glass as slave, at the axis and at the rim, and how far "
                     "they are from the exact solution.",
    "fig13_self_weight": "The glass flows for 1 s under its own weight and slides on the steel; h follows contact pressure and "
                         "viscosity (assumed). Temperatures and contact pressure along the contact, all mesh pairs.",
}


def write_csv(path, header, rows):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows([f"{v:.8g}" if isinstance(v, float) else v for v in row] for row in rows)


def pick(runs, pair, slave, method):
    return next(r for r in runs if (r.pair, r.slave, r.method) == (pair, slave, method))


def triangulation(body):
    sub = np.concatenate([body.cells[:, corners] for corners in SUB_TRIANGLES])
    return Triangulation(body.points[:, 0], body.points[:, 1], sub)


def temperature_map(runs, folder):
    """Figure 9: both bodies at 10 s, and the isotherms next to the contact."""
    figure, axes = plt.subplots(2, 2, figsize=(9, 8.4), dpi=90, layout="constrained", height_ratios=(2.6, 1))
    rows = []
    for column, method in enumerate(("classical", "interface element")):
        run = pick(runs, MAPPED, "glass", method)
        bodies, _ = bodies_at(run.folder, 10)
        for name, body in bodies.items():
            tri = triangulation(body)
            image = axes[0, column].tripcolor(tri, body.temperature, shading="gouraud", cmap="inferno", vmin=485, vmax=1150)
            step, colour = (10, "C3") if name == "glass" else (1, "C0")
            levels = np.arange(480, 1151, step)
            axes[1, column].tricontour(tri, body.temperature, levels=levels, colors=colour, linewidths=0.8, linestyles="solid")
            rows += [(method, name, *map(float, (x, y, t))) for (x, y), t in zip(body.points, body.temperature)]
        axes[0, column].axhline(0, color="white", linewidth=0.8)
        axes[1, column].axhline(0, color="black", linewidth=1)
        axes[0, column].set(aspect="equal", title=f"{method}, {run.mesh}", ylabel="z, mm", xlim=(0, 20), ylim=(-30, 20))
        axes[1, column].set(xlim=(0, 20), ylim=(-1, 1), xlabel="r, mm", ylabel="z, mm")
    axes[1, 0].set_title("isotherms: glass each 10 K, steel each 1 K", fontsize=10)
    figure.colorbar(image, ax=axes[0, :], label="temperature at 10 s, °C")
    save(figure, folder / "fig09_map.png", 256)
    write_csv(folder / "fig09_map.csv", ("coupling", "body", "r_mm", "z_mm", "T_C"), rows)


def along_contact(runs, method, folder, name):
    """Figures 10 and 11: temperature along both sides of the contact at several times; one column for each pair of meshes."""
    chosen, rows = [run for run in runs if run.method == method], []
    meshes = list(dict.fromkeys(run.mesh for run in chosen))
    figure, axes = plt.subplots(2, len(meshes), figsize=(12, 6), dpi=90, layout="constrained", sharex=True, sharey="row")
    for run in chosen:
        for i, side in enumerate(("glass", "steel")):
            axis = axes[i, meshes.index(run.mesh)]
            for k, time in enumerate(SHOWN_TIMES):
                values, wanted = run.side[side][run.times.index(time)], measure.side_exact(side, time)
                axis.plot(run.radius[side], values, f"C{k}" + ("-" if run.slave == "glass" else "--"), linewidth=1)
                axis.axhline(wanted, color="black", linewidth=0.6, linestyle=":")
                rows += [(run.mesh, run.slave, side, float(time), float(r), float(t), float(t - wanted))
                         for r, t in zip(run.radius[side], values)]
    for axis, mesh in zip(axes[0], meshes):
        axis.set_title(mesh)
    for axis in axes[1]:
        axis.set_xlabel("r, mm")
    for axis, side, limits in zip(axes[:, 0], ("glass", "steel"), SIDE_LIMITS):
        axis.set(ylabel=f"{side} side, °C", ylim=limits)
    lines = [plt.Line2D([], [], color=f"C{k}", label=f"{time} s") for k, time in enumerate(SHOWN_TIMES)]
    lines += [plt.Line2D([], [], color="grey", linestyle=style, label=label)
              for style, label in (("-", "slave glass"), ("--", "slave steel"), (":", "exact"))]
    axes[0, 0].legend(loc="upper left", handles=lines, fontsize=8)
    figure.suptitle(f"{method}: temperature along the contact, divisions glass/steel")
    save(figure, folder / f"{name}.png", 256)
    write_csv(folder / f"{name}.csv", ("divisions", "slave", "side", "time_s", "r_mm", "T_C", "less_exact_K"), rows)


def histories(runs, folder):
    """Figure 12: both sides at the axis and at the rim against the exact solution, and the distance from it."""
    times = np.unique(np.concatenate([np.linspace(0.01, 1, 60), np.linspace(1, 10, 91)]))
    reference = np.array([exact.solution(t) for t in times])
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.4), dpi=90, layout="constrained")
    axes[0].plot(times, reference[:, 0], "k", linewidth=2.5, alpha=0.35, label="exact")
    axes[0].plot(times, reference[:, 1], "k", linewidth=2.5, alpha=0.35)
    rows = [("exact", "", side, float(t), float(v), 0.0) for column, side in enumerate(("glass", "steel"))
            for t, v in zip(times, reference[:, column])]
    for method, style in (("classical", "C3"), ("interface element", "C0")):
        run = pick(runs, MAPPED, "glass", method)
        for side in ("glass", "steel"):
            for place, line in (("axis", "-"), ("rim", "--")):
                t, T = run.history["time_s"], run.history[f"{side}_{place}_degC"]
                off = T - np.array([measure.side_exact(side, x) for x in t])
                axes[0].plot(t, T, style + line, linewidth=0.9, label=f"{method}, {place}" if side == "glass" else None)
                axes[1].plot(t, np.abs(off) + 1e-6, style + line, linewidth=0.9)
                rows += [(method, place, side, float(a), float(b), float(c)) for a, b, c in zip(t, T, off)]
    axes[0].set(xlabel="time, s", ylabel="temperature of both sides, °C", xlim=(0, 10), title="{}/{}".format(*MAPPED))
    axes[1].set(xlabel="time, s", ylabel="distance from the exact solution, K", yscale="log", xlim=(0, 10), ylim=(1e-4, 300))
    axes[1].axhline(0.1, color="black", linewidth=0.8, linestyle=":")
    axes[0].legend(fontsize=8)
    for axis in axes:
        axis.grid(alpha=0.3)
    save(figure, folder / "fig12_history.png", 256)
    write_csv(folder / "fig12_history.csv", ("coupling", "place", "side", "time_s", "T_C", "less_exact_K"), rows)


def self_weight(weight, folder):
    """Figure 13: with self-weight, along the contact at 0.2, 0.5 and 1 s: both temperatures and the contact pressure."""
    names = (("T_glass_degC", "glass side, °C"), ("T_tool_degC", "steel side, °C"), ("pressure_Pa", "contact pressure, Pa"))
    figure, axes = plt.subplots(1, 3, figsize=(11, 4), dpi=90, layout="constrained")
    rows = []
    for time in (0.2, 0.5, 1.0):
        for axis, (name, _) in zip(axes, names):
            data = next(iter(weight.values()))[0]
            axis.text(0.5, measure.along_contact(data, time, name, 0.5), f"{time:g} s", va="bottom", fontsize=8)
        for i, (mesh, (data, _)) in enumerate(weight.items()):
            at = np.abs(data["time_s"] - time) < 1e-9
            for axis, (name, title) in zip(axes, names):
                axis.plot(data["r_mm"][at], data[name][at], f"C{i}", linewidth=3.5 - 0.55 * i,
                          label=mesh if time == 0.2 else None)
                axis.set(xlabel="r, mm", title=title)
                axis.grid(alpha=0.3)
            rows += [(mesh, time, *map(float, row)) for row in zip(*(data[n][at] for n in (
                "r_mm", "T_glass_degC", "T_tool_degC", "pressure_Pa", "h_W_m2K", "flux_W_m2")))]
    axes[0].legend(fontsize=8, title="glass/steel", ncol=3, loc="center", bbox_to_anchor=(0.5, 0.72))
    figure.suptitle("self-weight: along the contact at 0.2, 0.5 and 1 s")
    save(figure, folder / "fig13_self_weight.png", 256)
    write_csv(folder / "fig13_self_weight.csv",
              ("divisions", "time_s", "r_mm", "T_glass_degC", "T_tool_degC", "pressure_Pa", "h_W_m2K", "flux_W_m2"), rows)


def draw(runs, weight, folder):
    temperature_map(runs, folder)
    along_contact(runs, runs_module.METHODS[1], folder, "fig10_classical")
    along_contact(runs, runs_module.METHODS[0], folder, "fig11_interface_element")
    histories(runs, folder)
    self_weight(weight, folder)
    with open(folder / "figures.md", "w") as file:
        for name, caption in CAPTIONS.items():
            file.write(f"![{name}]({name}.png)\n\n{caption} Numbers: {name}.csv.\n\n")
