# SPDX-License-Identifier: GPL-3.0-or-later
"""Results: of a run just made, or of a folder that `parison run` wrote."""
import json
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _core
from .errors import Error

if TYPE_CHECKING:
    from tempfile import TemporaryDirectory

    import pandas


def _table(path: Path) -> dict[str, Any]:
    """Columns of a CSV file by their headings; those that hold text as lists."""
    import numpy as np  # here, since not every script reads a table

    with open(path, encoding="utf-8") as file:
        headings = file.readline().rstrip("\n").split(",")
        rows = [line.rstrip("\n").split(",") for line in file if line.strip()]
    columns: dict[str, Any] = {}
    for place, heading in enumerate(headings):
        words = [row[place] for row in rows]
        try:
            columns[heading] = np.array([float(word) if word else np.nan for word in words])
        except ValueError:
            columns[heading] = words
    return columns


class Table(dict[str, Any]):
    """Columns by their headings, which carry the units: numpy arrays, lists where they hold text."""

    def frame(self) -> "pandas.DataFrame":
        """The same as a pandas DataFrame; raises ImportError without pandas."""
        import pandas

        return pandas.DataFrame(self)


class Quantity(float):
    """A number of a run with its three bars, all in `unit`.

    `numerical`: of mesh and steps, nan without error bars. `model`: what the best models were found to move such a
    quantity at most, 0 where the run has them, nan where it was not measured. `tolerance`: two standard deviations by
    `parison uncertainty`, nan where the run is not the mean of such a study.
    """

    unit: str
    numerical: float
    model: float
    tolerance: float

    def __new__(cls, value: float, unit: str = "", numerical: float = math.nan, model: float = math.nan,
                tolerance: float = math.nan) -> "Quantity":
        made = super().__new__(cls, value)
        made.unit, made.numerical, made.model, made.tolerance = unit, numerical, model, tolerance
        return made

    def __getnewargs__(self) -> tuple[float, str, float, float, float]:  # type: ignore[override]
        return float(self), self.unit, self.numerical, self.model, self.tolerance


def _number(of: dict[str, Any], key: str) -> float:
    """Of a JSON object; nan where it has none."""
    found = of.get(key)
    return math.nan if found is None else float(found)


class Result:
    """Results of a run in a folder.

    `state` is the state at the end where the run was made in this process, else None. To other processes a Result goes as
    its folder.
    """

    def __init__(self, folder: "Union[str, os.PathLike[str]]", state: Optional[_core.State] = None,
                 kept: "Optional[TemporaryDirectory[str]]" = None) -> None:
        self.folder = Path(os.fspath(folder))
        self.state = state
        self._kept = kept  # a temporary folder, which goes with this object
        self._read: dict[str, Any] = {}
        if not (self.folder / "summary.json").is_file():
            raise Error(f"{self.folder}: no summary.json was found, allowed is a result folder of a run that has ended")

    def __repr__(self) -> str:
        return f"Result('{self.folder}', {self.verdict})"

    def __reduce__(self) -> tuple[Any, ...]:
        if self.is_temporary:
            raise Error("results in a temporary folder cannot go to another process; allowed are those of a run with `output`")
        return type(self), (str(self.folder.resolve()),)

    @property
    def is_temporary(self) -> bool:
        """Whether the folder goes with this object."""
        return self._kept is not None

    @property
    def summary(self) -> dict[str, Any]:
        """summary.json as a dictionary; tools/README.md says what each key means."""
        if "summary" not in self._read:
            self._read["summary"] = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        found: dict[str, Any] = self._read["summary"]
        return found

    @property
    def completed(self) -> bool:
        """Whether the run came to its end."""
        return bool(self.summary["completed"])

    @property
    def verdict(self) -> str:
        """What the checks of the run say together, a sentence."""
        return str(self.summary["verdict"])

    @property
    def quantities(self) -> dict[str, Quantity]:
        """Numbers by the names of `parison compare`: {"thickness_min": 1.44, ...}, each a float with its bars."""
        tolerances = self._tolerances()
        return {name: Quantity(_number(one, "value"), str(one["unit"]), _number(one, "error"), _number(one, "model"),
                               tolerances.get(name, math.nan))
                for name, one in self.summary["quantities"].items()}

    @property
    def models(self) -> dict[str, dict[str, str]]:
        """The models of the run and the best ones: {"radiation": {"used": "rosseland", "best": "transfer"}}."""
        found: dict[str, dict[str, str]] = self.summary.get("models", {})
        return found

    def _tolerances(self) -> dict[str, float]:
        """Bars of the tolerances by quantity, where the folder is the run at the means of `parison uncertainty`."""
        runs = self.folder.resolve().parent
        study = runs.parent / "uncertainty.csv"
        if runs.name != "mean" or not study.is_file():
            return {}
        table = _table(study)
        return dict(zip(table["quantity"], (float(bar) for bar in table["tolerance_bar"])))

    def table(self, name: str) -> Table:
        """A CSV file of the folder by its name without ending: "history", "thickness", "contour", "heights", "tools" or
        "interface". Returns a Table; raises Error where the run wrote none."""
        if name not in self._read:
            path = self.folder / f"{name}.csv"
            if not path.is_file():
                there = ", ".join(sorted(p.stem for p in self.folder.glob("*.csv")))
                raise Error(f"{path}: no such table, the folder has {there}")
            self._read[name] = Table(_table(path))
        found: Table = self._read[name]
        return found

    @property
    def history(self) -> Table:
        """history.csv: time, stage, step, volume, heats, forces, positions at each step."""
        return self.table("history")

    @property
    def wall(self) -> Table:
        """thickness.csv: the wall's thickness against height and arc."""
        return self.table("thickness")
