# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the cases of the cylinder test and reads what they wrote."""
import csv
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np

import cases
from render import Body, collection

METHODS = ("interface element", "classical")


@dataclass
class Run:
    """One run of the cylinder test; sides by body name, temperatures in degC at the contact's nodes along r in mm."""
    pair: tuple
    slave: str
    method: str
    folder: object = None
    times: list = field(default_factory=list)
    radius: dict = field(default_factory=dict)
    side: dict = field(default_factory=dict)  # by body: array (time, node)
    heat: float = 0.0  # J, from glass to steel at the end
    history: dict = field(default_factory=dict)  # columns

    @property
    def mesh(self):
        return cases.TRIANGLES if self.pair == cases.TRIANGLES else "{}/{}".format(*self.pair)

    @property
    def label(self):
        return f"{self.mesh}, slave {self.slave}"


def call(command, log):
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    with open(log, "w") as out:
        if subprocess.run([str(part) for part in command], stdout=out, stderr=subprocess.STDOUT, env=environment).returncode:
            sys.exit(f"reproduce_paper: a run failed, see {log}")


def columns(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if name not in ("stage", "tool", "limited_by")}


def file_of(run, name):
    """The program calls the slave glass; its files are named so."""
    return "glass" if name == run.slave else cases.TOOL_NAME[name]


def read(run):
    for name in cases.ROLES:
        entries = collection(run.folder, file_of(run, name))
        run.times = [time for time, _ in entries]
        rows = []
        for _, path in entries:
            body = Body(path)
            nodes = np.flatnonzero(np.abs(body.points[:, 1]) < 1e-9)
            nodes = nodes[np.argsort(body.points[nodes, 0])]
            rows.append(body.temperature[nodes])
            run.radius[name] = body.points[nodes, 0]
        run.side[name] = np.array(rows)
    run.history = columns(run.folder / "history.csv")
    run.heat = abs(run.history["heat_to_tools_J"][-1])


def heat_runs(build, output, jobs):
    """All mesh pairs and roles with and without the interface element."""
    runs = []
    for method in METHODS:
        for pair in (*cases.PAIRS, cases.TRIANGLES):
            for slave in cases.ROLES:
                run = Run(pair, slave, method)
                name = run.mesh.replace("/", "_") + f"_slave_{slave}"
                (output / "cases").mkdir(parents=True, exist_ok=True)
                (output / "cases" / f"{name}.toml").write_text(cases.heat_case(pair, slave))
                run.folder = output / "runs" / f"{name}_{method.replace(' ', '_')}"
                runs.append(run)
    (output / "runs").mkdir()

    def execute(run):
        case = output / "cases" / (run.folder.name.removesuffix("_" + run.method.replace(" ", "_")) + ".toml")
        program = [build / "tests" / "classical_contact", case, run.folder] if run.method == "classical" else [
            build / "parison", "run", case, "--accuracy", "standard", "--output", run.folder]
        call(program, f"{run.folder}.log")
    with ThreadPoolExecutor(jobs) as pool:
        list(pool.map(execute, runs))
    for run in runs:
        read(run)
    return runs


def weight_runs(build, output, jobs):
    """Columns of interface.csv and history.csv of the variant with self-weight, by mesh."""
    (output / "runs").mkdir(exist_ok=True)
    (output / "cases").mkdir(exist_ok=True)

    def execute(pair):
        mesh = pair if pair == cases.TRIANGLES else "{}/{}".format(*pair)
        name = "self_weight_" + mesh.replace("/", "_")
        case, folder = output / "cases" / f"{name}.toml", output / "runs" / name
        case.write_text(cases.weight_case(pair))
        call([build / "parison", "run", case, "--accuracy", "standard", "--output", folder], f"{folder}.log")
        return mesh, (columns(folder / "interface.csv"), columns(folder / "history.csv"))
    with ThreadPoolExecutor(jobs) as pool:
        return dict(pool.map(execute, (*cases.PAIRS, cases.TRIANGLES)))
