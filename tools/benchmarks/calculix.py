# SPDX-License-Identifier: GPL-3.0-or-later
"""CPU time to get within 0.1 K of the exact solution of two cylinders in contact, 1 to 10 s: Parison against CalculiX."""
import csv
import os
import shutil
import statistics
import subprocess

from benchmarks.common import BUILD, ROOT, Figure, Skipped, build, new_path, parison, read_summary, run
from benchmarks.contact_deck import deck, read_contact

# s: glass, steel in degC
EXACT = {1: (742.0877, 575.8608), 2: (706.4829, 583.7917), 5: (671.5318, 591.5769), 10: (652.8883, 595.7298)}
WITHIN = 0.1  # K
# Twice the case's 24 divisions, as many nodes in depth as its quadratic elements have: the cheapest of what was tried.
# The size of linear elements alone costs 0.089, 0.039, 0.022 K at 1 s with 24, 36, 48 divisions; quadratic elements take
# twice the time in all.
ROWS, QUADRATIC = 48, False
STEPS = (0.01, 0.005, 0.004, 0.0025, 0.002, 0.001, 0.0005)  # s
OWN_CONTROL = "DELTMX=0.55"  # K in an increment, the largest found within 0.1 K: 0.6 is 0.103 K off
TOLERANCES = ("1 K", "0.5 K", "0.2 K", "0.1 K", "0.05 K", "0.02 K")
REPEATS = 5


def worst(contact):
    """Largest deviation from the exact solution at its times, K; all of them have to be there."""
    return max(abs(value - exact) for time, sides in EXACT.items() if time in contact
               for values, exact in zip(contact[time], sides) for value in values)


def install():
    if shutil.which("ccx"):
        return
    as_root = [] if os.geteuid() == 0 else ["sudo", "-n"]
    if not shutil.which("apt-get") or (as_root and not shutil.which("sudo")):
        raise Skipped("CalculiX (package calculix-ccx) is missing; it can be installed here neither as root nor by sudo.")
    command = [*as_root, "apt-get", "install", "-y", "-qq", "--no-install-recommends", "calculix-ccx"]
    if subprocess.run(command, capture_output=True).returncode or not shutil.which("ccx"):
        raise Skipped("CalculiX (package calculix-ccx) is missing and apt-get could not install it.")


def calculix(control, duration):
    """CPU time and worst deviation up to `duration`."""
    path = new_path("cylinders")
    path.with_suffix(".inp").write_text(deck(control, duration, ROWS, QUADRATIC))
    done = run(["ccx", path.name], f"{path}.log", cwd=path.parent)
    contact = read_contact(path.with_suffix(".dat"))
    missing = [t for t in EXACT if t <= duration and t not in contact]
    if done.code or missing:
        raise RuntimeError(f"CalculiX gave no temperatures at {missing} s with {control}")
    return done.cpu, worst(contact)


def max_step():
    """The largest fixed step that is within 0.1 K at 1 s, where the deviation is largest."""
    for step in STEPS:
        _, deviation = calculix(step, 1.0)
        print(f"    CalculiX, steps of {step:g} s: {deviation:.3f} K off at 1 s", flush=True)
        if deviation <= WITHIN:
            return step
    raise Skipped(f"CalculiX does not get within {WITHIN} K with steps down to {STEPS[-1]} s.")


def case_with(tolerance):
    """The bundled case with another tolerance of the heat, steps only where something is asked."""
    text = (ROOT / "cases/contact_cylinders/case.toml").read_text()
    numerics = f'[numerics]\ntemperature_tolerance = "{tolerance}"\nmax_step = "1 s"\n'
    text += "\n" + numerics
    path = new_path("case.toml")
    path.write_text(text)
    return path


def parison_contact(case):
    """CPU time, worst deviation and the parts' shares of one run's wall time."""
    done, folder = parison(case, "draft")
    contact = {}
    with open(folder / "history.csv") as table:
        for row in csv.DictReader(table):
            contact[round(float(row["time_s"]), 6)] = [[float(row[f"{body}_{place}_degC"]) for place in ("axis", "rim")]
                                                       for body in ("glass", "steel")]
    if any(t not in contact for t in EXACT):
        raise RuntimeError("the run of contact_cylinders wrote no row at one of 1, 2, 5, 10 s")
    shares = {part: seconds / done.wall for part, seconds in read_summary(folder)["timing"].items()}
    return done.cpu, worst(contact), shares


def section(options):
    install()
    build("parison")
    fitting = []
    for tolerance in TOLERANCES:
        case = case_with(tolerance)
        cpu, deviation, _ = parison_contact(case)
        print(f"    Parison, tolerance {tolerance}: {deviation:.3f} K off at the most, {cpu:.2f} CPU s", flush=True)
        if deviation <= WITHIN:
            fitting.append((cpu, case))
    if not fitting:
        raise RuntimeError(f"Parison does not get within {WITHIN} K with any tolerance tried")
    case = min(fitting)[1]
    step = max_step()
    ours = [parison_contact(case) for _ in range(REPEATS)]
    theirs, deviation = calculix(step, 10.0)
    own, own_deviation = calculix(OWN_CONTROL, 10.0)
    if max(deviation, own_deviation) > WITHIN:
        raise RuntimeError(f"CalculiX is {deviation:.3f} K off, with its own step control {own_deviation:.3f} K")
    ours += [parison_contact(case) for _ in range(REPEATS)]
    cpu = statistics.median(c for c, _, _ in ours)
    start = statistics.median(run([BUILD / "parison", "--help"], new_path("help.log")).cpu for _ in range(REPEATS))
    print(f"    CalculiX: {theirs:.1f} CPU s at {step:g} s, {deviation:.3f} K off at the most; Parison: {cpu:.2f} CPU s",
          flush=True)
    what = f"whole process, CalculiX (steps of {step:g} s) over Parison, CPU to within {WITHIN} K"
    yield Figure("calculix.ratio", what, theirs / cpu, 100, True)
    heat = statistics.median(t["heat"] + t["contact"] for _, _, t in ours)
    what = f"  the same with CalculiX's own step control, {own:.1f} CPU s, {own_deviation:.3f} K off"
    yield Figure("calculix.own_control", what, own / cpu)
    yield Figure("calculix.start_share", "  Parison: share of start-up (--help)", 100 * start / cpu, unit="%")
    for part in ("heat", "contact", "output"):
        share = statistics.median(shares[part] for _, _, shares in ours)
        yield Figure(f"calculix.{part}_share", f"  Parison: share of {part}, wall time", 100 * share, unit="%")
