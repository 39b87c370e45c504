# SPDX-License-Identifier: GPL-3.0-or-later
"""References of random containers: whole products that nobody looked at when a rule or a factor was chosen."""
import json
import sys
from pathlib import Path

from bars import runs

from . import random_case

REFERENCES = Path(__file__).resolve().parent / "references.json"
ACCURACY = "fine coarser 0.7"
SEED = 307


def add_options(parser):
    parser.add_argument("--containers", nargs="*", type=int, metavar="N",
                        help="random containers instead of scenes, by their numbers [those with a reference]")
    parser.add_argument("--seed", type=int, default=SEED, help="of the containers")


def write_case(seed, number, output):
    """Name of a container and its case file, which is written."""
    name, text, _ = random_case(seed, number)
    case = output / f"{seed}_{name}" / "case.toml"
    case.parent.mkdir(parents=True, exist_ok=True)
    case.write_text(text, encoding="utf-8")
    return f"{seed}/{name}", case


def references():
    return json.loads(REFERENCES.read_text(encoding="utf-8")) if REFERENCES.is_file() else {}


def make(asked):
    """Makes the references of the containers named and keeps each as soon as it is there; the exit code."""
    failed = 0
    for number in asked.containers or sys.exit(f"{Path(sys.argv[0]).name}: --references needs the numbers of containers"):
        name, case = write_case(asked.seed, number, asked.output)
        summary = runs.run_case(asked.parison.resolve(), case, ACCURACY, case.parent / "reference")
        print(f"{name}: " + (f"{summary['cpu_seconds']:.0f} s" if summary else "did not complete"), flush=True)
        if summary:
            runs.write_references({**references(), name: runs.reference_of(summary, ACCURACY)}, REFERENCES)
        failed += not summary
    return 1 if failed else 0


def with_reference(asked):
    """Case file and reference by the name of each container asked for."""
    known = references()
    numbers = asked.containers or [int(name.split("/")[1][:3]) for name in known if name.startswith(f"{asked.seed}/")]
    written = dict(write_case(asked.seed, number, asked.output) for number in numbers)
    missing = [name for name in written if name not in known]
    if missing or not written:
        sys.exit(f"{Path(sys.argv[0]).name}: no reference for {', '.join(missing) or f'seed {asked.seed}'}; --references makes them")
    return {name: (case, known[name]) for name, case in written.items()}
