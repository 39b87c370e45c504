# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshers of the glass against each other, on the outlines and size fields of the bundled runs, and in whole runs."""
import csv
import statistics
from pathlib import Path

from benchmarks import bars, references
from benchmarks.common import BUILD, ROOT, Figure, build, new_path, read_summary, run

WORST, MEDIAN = 0.3, 0.9  # quality asked of a new mesh
REPEATS = 3
NOW = "gmsh"
MESHERS = {
    "gmsh": "gmsh frontal-Delaunay",
    "gmsh Delaunay": "gmsh Delaunay",
    "CGAL": "CGAL",
    "CGAL Lloyd": "CGAL, 5 Lloyd passes",
    "CGAL kept": "CGAL, outline kept",
    "CGAL kept Lloyd": "CGAL, outline kept, 5 Lloyd passes",
    "CGAL kept smoothed": "CGAL, outline kept, smoothed below 0.7",
    "CGAL kept smoothed more": "CGAL, outline kept, smoothed below 0.9",
}
IN_RUNS = ("gmsh", "CGAL kept smoothed", "CGAL kept smoothed more")
SETTINGS = ("max_step=0.1 s", "surface_size=1.5 mm", "surface_size=1.7 mm", "strain_per_step=0.29", "strain_per_step=0.27",
            "skin_size=0.66 mm", "skin_size=0.74 mm", "elements_across=2.2", "work_per_step=5.4e-05")
# A disc of 5 mm sticks to a plate and a ram that presses it to a film of 0.8 mm.
FILM = """
case = "film"
geometry = "axisymmetric"
air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }

[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
viscosity = { law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }

[material.iron]
density = "7200 kg/m3"
heat_capacity = "490 J/kg/K"
conductivity = "46 W/m/K"

[glass]
material = "glass"
temperature = "1100 degC"
boundary = [
  { name = "surface", path = "(0, 0) (20, 0) (20, 5) (0, 5) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]

[[tool]]
name = "plate"
material = "iron"
temperature = "600 degC"
friction = "stick"
boundary = [
  { name = "top", path = "(80, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -20) mm", condition = "symmetry" },
  { name = "rest", path = "(80, -20) (80, 0) mm", condition = "insulated" },
]

[[tool]]
name = "ram"
material = "iron"
temperature = "600 degC"
friction = "stick"
boundary = [
  { name = "face", path = "(0, 5) (80, 5) mm", condition = "contact" },
  { name = "rest", path = "(80, 25) (0, 25) mm", condition = "insulated" },
  { name = "axis", path = "(0, 5) mm", condition = "symmetry" },
]

[[interface]]
tools = ["plate", "ram"]
law = "constant"
h = "1000 W/m2/K"

[[stage]]
name = "press"
duration = "0.5 s"
gravity = "-9.81 m/s2"
tools = ["plate", "ram"]
motion.ram = { offset = [["0 s", "0 mm"], ["0.5 s", "-4.2 mm"]] }
"""


def film():
    path = new_path("film.toml")
    path.write_text(FILM)
    return path


def bench(case, accuracy, repeats, mesher, *settings):
    """Runs a case with a mesher; whether it completed, its result folder."""
    out = new_path("meshers")
    program = BUILD / "tools/benchmarks/programs/mesher_bench"
    done = run([program, case, accuracy, out, repeats, mesher, *settings], f"{out}.log")
    if not (out / "summary.json").exists():
        raise RuntimeError(f"mesher_bench {case} ended with {done.code}:\n" + Path(f"{out}.log").read_text()[-800:])
    return done.code == 0, out


def rows_by_mesher(folder):
    """Number of meshes that a mesher failed to make, rows of the others."""
    with open(f"{folder}.meshes.csv") as table:
        rows = list(csv.DictReader(table))
    made = [{k: v if k in ("mesher", "bits") else float(v) for k, v in row.items()} for row in rows if row["triangles"] != "nan"]
    return {name: [row for row in made if row["mesher"] == name] for name in MESHERS}, len(rows) - len(made)


def section(options):
    build("mesher_bench")
    accuracy = options.accuracy or "draft"
    for case, path in (("jar", ROOT / "cases/jar"), ("tumbler", ROOT / "cases/tumbler"), ("film", film())):
        rows, failed = rows_by_mesher(bench(path, accuracy, REPEATS, NOW)[1])
        again, _ = rows_by_mesher(bench(path, accuracy, 1, NOW)[1])
        if failed:
            print(f"    {failed} meshes could not be made")
        key = f"mesher.{case}.{accuracy}"
        print(f"    {case} at {accuracy}, {len(rows[NOW])} meshes: triangles, ms, minimum and lowest median quality, smallest angle, "
              "|log2(edge/size)| mean and largest,\n    ratio of neighbours' areas, points added, same bits")
        for name, what in MESHERS.items():
            print("    " + describe(what, rows[name], again[name]), flush=True)
        now = seconds(rows[NOW])
        for quality, what, least in (("min_quality", "worst quality", WORST), ("median", "lowest median quality", MEDIAN)):
            yield Figure(f"{key}.{quality}", f"{case}: {what} of a new mesh", min(row[quality] for row in rows[NOW]), least, True)
        for name in MESHERS:
            if name != NOW:
                yield Figure(f"{key}.{name}.time", f"  {MESHERS[name]} over {MESHERS[NOW]}, CPU time", seconds(rows[name]) / now)


def seconds(rows):
    return sum(row["seconds"] for row in rows)


def describe(what, rows, again):
    """A line of the table; bits are the same when they are within a process and in another one."""
    same = all(row["same"] == 1 for row in rows) and [r["bits"] for r in rows] == [r["bits"] for r in again]
    least, most = (lambda key: min(row[key] for row in rows)), (lambda key: max(row[key] for row in rows))
    total = sum(row["triangles"] for row in rows)
    fit = statistics.fmean(row["size_mean"] for row in rows)
    return (f"{what:<38} {total:7.0f} {1e3 * seconds(rows):6.0f}  {least('min_quality'):.2f} {least('median'):.3f}  {least('angle'):4.1f}  "
            f"{fit:.2f} {most('size_max'):.2f}  {most('jump'):.1f}  {sum(row['added'] for row in rows):3.0f}  {'yes' if same else 'no'}")


def runs(options):
    build("mesher_bench")
    reference = references.of_case("jar")
    for mesher in IN_RUNS:
        means, largest, shares, stopped = [], [], [], 0
        for setting in SETTINGS:
            completed, folder = bench(ROOT / "cases/jar", "draft", 0, mesher, f"numerics.{setting}")
            if not completed:
                stopped += 1
                continue
            summary = read_summary(folder)
            mean, worst = bars.profile_errors(summary, reference)
            means.append(100 * mean)
            largest.append(100 * worst)
            shares.append(100 * summary["timing"]["remesh"] / summary["wall_seconds"])
        key, what = f"mesher_runs.{mesher}", MESHERS[mesher]
        yield Figure(f"{key}.stopped", f"{what}: runs of the jar at draft, of {len(SETTINGS)}, that stop on inverted cells", stopped,
                     0 if mesher == NOW else None)
        yield Figure(f"{key}.wall_mean", "  wall thickness against fine, mean of all runs", statistics.fmean(means), unit="%")
        yield Figure(f"{key}.wall_largest", "  largest error of any run", max(largest), unit="%")
        yield Figure(f"{key}.share", "  share of remeshing, mean of the runs", statistics.fmean(shares), unit="%")
