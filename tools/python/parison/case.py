# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases: read, changed, run."""
import numbers
import os
import tempfile
from pathlib import Path

from . import _core
from .errors import CaseError, RunError
from .result import Result

PACKAGE = Path(__file__).absolute().parent  # not where a link of a build folder leads


def bundled_cases():
    """Folder of the cases that come with Parison, by name: {"jar": Path(...), ...}; empty where none is found."""
    for folder in PACKAGE.parents:
        cases = folder / "share/parison/cases"
        if cases.is_dir():
            return {path.parent.name: path.parent for path in sorted(cases.glob("*/case.toml"))}
    return {}


def _place_of(given):
    """A path as it is; a bare name that is no path is a bundled case."""
    if os.path.exists(given) or os.path.dirname(given) or str(given).endswith(".toml"):
        return str(given)
    known = bundled_cases()
    if given in known:
        return str(known[given])
    raise CaseError(f"{given}: no such case, allowed is a case file, a folder that holds a case.toml or the name of a bundled case"
                    f" ({', '.join(known) or 'none was found'})", file=str(given))


def _as_toml(value):
    """A value as `--set` takes it after the sign of equality."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (numbers.Number, str)):
        return str(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(f'"{v}"' if isinstance(v, str) else _as_toml(v) for v in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = " + (f'"{v}"' if isinstance(v, str) else _as_toml(v)) for k, v in value.items()) + " }"
    raise TypeError(f"a {type(value).__name__} was found, allowed are numbers, texts, lists and dictionaries of these")


class Case:
    """A case file with changes.

    `source`: a case file, a folder that holds a case.toml, or the name of a bundled case. `accuracy`: "draft",
    "standard", "fine" or "draft coarser 1.5". `changes`: values by key, as `parison run --set KEY=VALUE` takes them. Reading
    checks everything: a mistake raises CaseError with `file`, `line` and `key`.
    """

    def __init__(self, source, accuracy="standard", changes=None):
        self._path = _place_of(os.fspath(source))
        self._accuracy = accuracy
        self._changes = {}
        self._scene = None
        for key, value in (changes or {}).items():
            self._changes[key] = _as_toml(value)
        self._read()

    def _read(self):
        if self._scene is None:
            self._scene = _core.read(self._path, self._accuracy, [f"{k}={v}" for k, v in self._changes.items()])
        return self._scene

    def __setitem__(self, key, value):
        """Changes the value of a key or of a named dimension; one that the case refuses leaves it as it was."""
        before = dict(self._changes), self._scene
        self._changes[key], self._scene = _as_toml(value), None
        try:
            self._read()
        except Exception:
            self._changes, self._scene = before
            raise

    @property
    def name(self):
        """Name of the case."""
        return self._read().name

    @property
    def accuracy(self):
        """The accuracy it is read at."""
        return self._accuracy

    @property
    def changes(self):
        """The changes made so far, by key, as text."""
        return dict(self._changes)

    def at(self, accuracy):
        """The same case with the same changes at another accuracy."""
        other = Case.__new__(Case)
        other._path, other._accuracy, other._changes, other._scene = self._path, accuracy, dict(self._changes), None
        other._read()
        return other

    def check(self):
        """What `parison check` says of the case, a text. Raises RunError where its first stage cannot begin."""
        reason = self._read().first_stage_failure()
        if reason:
            raise RunError(f"{self.name}: the first stage cannot begin: {reason}")
        return self._read().describe()

    def run(self, output=None, callback=None):
        """Runs the case and returns its Result.

        `output`: a new or empty folder for the results; None for one that is removed with the Result. `callback(state)` is
        called after each step with the State; where it returns True the run stops there. What it raises stops the run
        too and is raised here, and so is an interrupt from the keyboard; the results so far stay in `output`. A run that
        cannot continue raises RunError with the reason, with its Result as `result`.
        """
        return self._run(output, callback, resume=False)

    def resume(self, output, callback=None):
        """Continues a run in its folder from the last checkpoint, as if it had never stopped."""
        return self._run(output, callback, resume=True)

    def _run(self, output, callback, resume):
        scene = self._read()
        kept = tempfile.TemporaryDirectory(prefix="parison-") if output is None else None
        folder = os.path.join(kept.name, "run") if kept else os.fspath(output)
        state, facts = _core.run(scene, folder, callback, resume)
        result = Result(folder, state=state, kept=kept)
        if facts["completed"] or facts["stopped"]:
            return result
        error = RunError(f"the run stopped in {facts['reason']}")
        error.result = result
        raise error
