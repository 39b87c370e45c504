# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sections of tools/bench share: figures with targets, programs built and run with their CPU time."""
import csv
import json
import math
import os
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
ONE_THREAD = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


class Skipped(Exception):
    """A section that cannot be measured here; the text says why."""


@dataclass
class Figure:
    """A measured ratio; `target` is the bound, `least` tells that it is a lower one; None where nothing is asked."""
    key: str
    what: str
    value: float
    target: Optional[float] = None
    least: bool = False
    unit: str = ""

    def met(self):
        if self.target is None:
            return None
        return self.value >= self.target if self.least else self.value <= self.target


@dataclass
class Run:
    cpu: float  # user and system, s
    wall: float  # s
    peak: float  # MB
    code: int


def run(command, log, cwd=None):
    """Runs one process on one thread and measures it."""
    start = time.monotonic()
    with open(log, "w") as out:
        process = subprocess.Popen([str(c) for c in command], stdout=out, stderr=subprocess.STDOUT, env=ONE_THREAD, cwd=cwd)
        _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return Run(used.ru_utime + used.ru_stime, time.monotonic() - start, used.ru_maxrss / 1024, process.returncode)


def build(*targets):
    """Sets up and builds, saying nothing when all is there."""
    if not (BUILD / "build.ninja").exists():
        subprocess.run([ROOT / "tools/setup"], check=True)
        subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"], check=True)
    done = subprocess.run(["ninja", "-C", BUILD, *targets], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise RuntimeError("the build failed:\n" + done.stdout[-2000:])


_folder = tempfile.TemporaryDirectory(prefix="parison_bench_")
_count = 0


def new_path(name):
    """A path in a folder that lives as long as the benchmark."""
    global _count
    _count += 1
    return Path(_folder.name) / f"{_count}_{name}"


def parison(case, accuracy, *arguments):
    """Runs a case with the command; its measurements, its result folder."""
    out = new_path("run")
    done = run([BUILD / "parison", "run", case, "--accuracy", accuracy, "--output", out, *arguments], f"{out}.log")
    if done.code:
        raise RuntimeError(f"parison run {case} ended with {done.code}:\n" + Path(f"{out}.log").read_text()[-800:])
    return done, out


def step_bench(case, accuracy, every):
    """Rows of CPU seconds, one for each step tried; at every `every`-th the bare factorisation and the interface too."""
    out = new_path("steps")
    done = run([BUILD / "tools/benchmarks/programs/step_bench", case, accuracy, out, every], f"{out}.log")
    if done.code:
        raise RuntimeError(f"step_bench {case} ended with {done.code}:\n" + Path(f"{out}.log").read_text()[-800:])
    with open(f"{out}.steps.csv") as table:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(table)]


def read_summary(folder):
    return json.loads((folder / "summary.json").read_text())


def warmer_tool(tool, change):
    """The override by which a tool of a case, a table of its TOML, starts warmer by `change`, K."""
    given, key = tool["temperature"], f'tool.{tool["name"]}.temperature'
    if isinstance(given, dict):
        return f"{key}.plus={float(given.get('plus', '0 K').removesuffix(' K')) + change:.6g} K"
    return f"{key}={float(given.removesuffix(' degC')) + change:.3f} degC"


def sampled(rows):
    """The steps beside which the bare figures were taken."""
    return [row for row in rows if not math.isnan(row["bare"])]
