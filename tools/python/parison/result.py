# SPDX-License-Identifier: GPL-3.0-or-later
"""Results: of a run just made, or of a folder that `parison run` wrote."""
import json
import os
from pathlib import Path

import numpy as np

from .errors import Error


def _table(path):
    """Columns of a CSV file by their headings; those that hold text as lists."""
    with open(path, encoding="utf-8") as file:
        headings = file.readline().rstrip("\n").split(",")
        rows = [line.rstrip("\n").split(",") for line in file if line.strip()]
    columns = {}
    for place, heading in enumerate(headings):
        words = [row[place] for row in rows]
        try:
            columns[heading] = np.array([float(word) if word else np.nan for word in words])
        except ValueError:
            columns[heading] = words
    return columns


class Table(dict):
    """Columns by their headings, which carry the units: numpy arrays, lists where they hold text."""

    def frame(self):
        """The same as a pandas DataFrame; raises ImportError without pandas."""
        import pandas

        return pandas.DataFrame(self)


class Result:
    """Results of a run in a folder.

    `state` is the state at the end where the run was made in this process, else None.
    """

    def __init__(self, folder, state=None, kept=None):
        self.folder = Path(os.fspath(folder))
        self.state = state
        self._kept = kept  # a temporary folder, which goes with this object
        self._read = {}
        if not (self.folder / "summary.json").is_file():
            raise Error(f"{self.folder}: no summary.json was found, allowed is a result folder of a run that has ended")

    def __repr__(self):
        return f"Result('{self.folder}', {self.verdict})"

    @property
    def summary(self):
        """summary.json as a dictionary; tools/README.md says what each key means."""
        if "summary" not in self._read:
            self._read["summary"] = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        return self._read["summary"]

    @property
    def completed(self):
        """Whether the run came to its end."""
        return self.summary["completed"]

    @property
    def verdict(self):
        """What the checks of the run say together, a sentence."""
        return self.summary["verdict"]

    @property
    def quantities(self):
        """Numbers by the names of `parison compare`: {"thickness_min_mm": 1.44, ...}."""
        return {name: quantity["value"] for name, quantity in self.summary["quantities"].items()}

    def table(self, name):
        """A CSV file of the folder by its name without ending: "history", "thickness", "contour", "heights", "tools" or
        "interface". Returns a Table; raises Error where the run wrote none."""
        if name not in self._read:
            path = self.folder / f"{name}.csv"
            if not path.is_file():
                there = ", ".join(sorted(p.stem for p in self.folder.glob("*.csv")))
                raise Error(f"{path}: no such table, the folder has {there}")
            self._read[name] = Table(_table(path))
        return self._read[name]

    @property
    def history(self):
        """history.csv: time, stage, step, volume, heats, forces, positions at each step."""
        return self.table("history")

    @property
    def wall(self):
        """thickness.csv: the wall's thickness against height and arc."""
        return self.table("thickness")
