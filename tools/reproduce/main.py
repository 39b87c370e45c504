# SPDX-License-Identifier: GPL-3.0-or-later
"""The cylinder test of the paper: all mesh pairs and roles, with and without the interface element; pictures and a table."""
import argparse
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))  # render.py

import exact
import figures
import measure
import runs as runs_module

LIMIT_OF_TABLE = 1e-4  # K
LABELS = {"deviation": "against the exact solution, 1 to 10 s, all pairs and roles, triangles too",
          "spread": "spread along the contact at 10 s", "difference": "largest difference between any two runs at any output"}


def print_table(rows, path):
    figures.write_csv(path, rows[0], [row.values() for row in rows])
    print("\nboth sides of the contact: largest deviation from the exact solution from 1 to 10 s, spread along the contact, heat")
    print(f"{'coupling':<18}{'glass/steel':<12}{'slave':<7}{'deviation, K':>20}{'spread at 10 s, K':>22}{'heat, J':>11}{'off':>10}")
    print(f"{'':37}{'glass':>12}{'steel':>8}{'glass':>13}{'steel':>9}")
    for row in rows:
        print(f"{row['coupling']:<18}{row['divisions glass/steel']:<12}{row['slave']:<7}"
              f"{row['glass deviation K']:12.4f}{row['steel deviation K']:8.4f}{row['glass spread K']:13.5f}"
              f"{row['steel spread K']:9.5f}{row['heat J']:11.2f}{100 * row['heat error']:9.3f} %")


def judge(found):
    missed = 0
    print("\nwith the interface element")
    for key, limit in measure.REQUIRED.items():
        good = found[key] <= limit
        missed += not good
        print(f"{'ok  ' if good else 'FAIL'}  {LABELS[key]}: {found[key]:.4f} K, allowed {limit} K")
    return missed


def print_weight(weight):
    """All meshes, and those that share their glass mesh: these differ by the contact alone."""
    print("\nself-weight: largest difference between any two meshes, 0.1 to 1 s, over a share of the contact's radius")
    print(f"{'':24}{'share':>6}{'glass, K':>10}{'steel, K':>10}{'pressure, Pa':>14}{'heat':>12}{'contact radius, mm':>21}")
    same = {mesh: value for mesh, value in weight.items() if mesh.startswith("20/")}
    for label, group in (("all six", weight), ("20/20, 20/7, 20/13", same)):
        for share in (0.75, 0.9, 1.0):
            off = measure.weight_differences(group, share)
            print(f"{label:<24}{100 * share:4.0f} %{off['T_glass_degC']:10.4f}{off['T_tool_degC']:10.4f}{off['pressure_Pa']:14.3f}"
                  f"{100 * off['heat']:10.4f} %{off['rim_mm']:21.4f}")
    print(f"force on the steel against the weight of the glass: {measure.weight_differences(weight, 1.0)['weight']:.1e}")


def main():
    parser = argparse.ArgumentParser(prog="tools/reproduce_paper", description=__doc__)
    parser.add_argument("--build", type=Path, required=True, help="folder of the built programs")
    parser.add_argument("--output", type=Path, required=True, help="new folder for runs, pictures and tables")
    options = parser.parse_args()
    if options.output.exists() and any(options.output.iterdir()):
        sys.exit(f"reproduce_paper: \"{options.output}\" holds files already, allowed is a new folder")
    kelvin, heat = exact.check()
    print(f"exact solution against the published table: {kelvin:.1e} K, heat {heat:.1e}")
    if kelvin > LIMIT_OF_TABLE:
        sys.exit("reproduce_paper: the exact solution does not agree with the table")
    jobs = os.cpu_count()
    runs = runs_module.heat_runs(options.build, options.output, jobs)
    print_table(measure.table(runs), options.output / "table.csv")
    missed = judge(measure.verdict(runs))
    weight = runs_module.weight_runs(options.build, options.output, jobs)
    print_weight(weight)
    print()
    figures.draw(runs, weight, options.output)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
