# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases: read, changed, run."""
import copy
import numbers
import os
import tempfile
from pathlib import Path
from typing import Any, Callable, Mapping, Optional, Union

from . import _core
from .errors import CaseError, RunError
from .result import Result

StepCallback = Callable[[_core.State], Any]
PathLike = Union[str, "os.PathLike[str]"]
PACKAGE = Path(__file__).absolute().parent  # not where a link of a build folder leads


def bundled_cases() -> dict[str, Path]:
    """Folder of the cases that come with Parison, by name: {"jar": Path(...), ...}; empty where none is found."""
    for folder in PACKAGE.parents:
        cases = folder / "share/parison/cases"
        if cases.is_dir():
            return {path.parent.name: path.parent for path in sorted(cases.glob("*/case.toml"))}
    return {}


def _place_of(given: str) -> str:
    """A path as it is; a bare name that is no path is a bundled case."""
    if os.path.exists(given) or os.path.dirname(given) or str(given).endswith(".toml"):
        return str(given)
    known = bundled_cases()
    if given in known:
        return str(known[given])
    raise CaseError(f"{given}: no such case, allowed is a case file, a folder that holds a case.toml or the name of a bundled case"
                    f" ({', '.join(known) or 'none was found'})", file=str(given))


def _as_toml(value: Any) -> str:
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


def _position(entries: list[Any], word: str) -> Optional[int]:
    """Of the entry that a word picks: its number, its name, or without one a tool that it is for. None where there is none."""
    if word.isdecimal() and int(word) < len(entries):
        return int(word)
    for i, entry in enumerate(entries):
        if isinstance(entry, dict) and (entry["name"] == word if "name" in entry else word in entry.get("tools", [])):
            return i
    return None


def _step(found: Any, word: str) -> Optional[Union[int, str]]:
    """The key or number of what a word picks; None where it picks nothing."""
    if isinstance(found, list):
        return _position(found, word)
    return word if isinstance(found, dict) and word in found else None


def _path(tree: Any, key: str) -> Optional[list[Union[int, str]]]:
    """The keys and numbers that lead to a value, the same for each way to write its key; None where it has none."""
    path: list[Union[int, str]] = []
    for word in key.split("."):
        step = _step(tree, word.strip())
        if step is None:
            return None
        path.append(step)
        tree = tree[step]
    return path


def _own_step(tree: Any, word: str) -> Union[int, str]:
    """The same where a value is set: one of several tools that an entry is for gets an entry of its own, a table may be new."""
    step = _step(tree, word)
    if step is None:
        tree[word] = {}
        return word
    if not isinstance(tree, list) or word.isdecimal() or "name" in tree[step] or len(tree[step]["tools"]) == 1:
        return step
    tree.append({**copy.deepcopy(tree[step]), "tools": [word]})
    tree[step]["tools"].remove(word)
    return len(tree) - 1


def _assign(tree: Any, key: str, text: str) -> None:
    """Sets a value as `--set` does."""
    import tomllib

    *words, last = (word.strip() for word in key.split("."))
    for word in words:
        tree = tree[_own_step(tree, word)]
    try:
        value = tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        value = text
    tree[_own_step(tree, last)] = value


class Case:
    """A case file with changes.

    `source`: a case file, a folder that holds a case.toml, or the name of a bundled case. `accuracy`: "draft",
    "standard", "fine" or "draft coarser 1.5". `changes`: values by key, as `parison run --set KEY=VALUE` takes them. Reading
    checks everything: a mistake raises CaseError with `file`, `line` and `key`.
    """

    def __init__(self, source: PathLike, accuracy: str = "standard", changes: Optional[Mapping[str, Any]] = None) -> None:
        self._path = os.path.abspath(_place_of(os.fspath(source)))  # the same case also after os.chdir
        self._accuracy = accuracy
        self._changes: dict[str, str] = {}
        self._scene: Optional[_core.Scene] = None
        for key, value in (changes or {}).items():
            self._changes[key] = _as_toml(value)
        self._read()

    def _read(self) -> _core.Scene:
        if self._scene is None:
            self._scene = _core.read(self._path, self._accuracy, [f"{k}={v}" for k, v in self._changes.items()])
        return self._scene

    def __setitem__(self, key: str, value: Any) -> None:
        """Changes the value of a key or of a named dimension; one that the case refuses leaves it as it was."""
        before = dict(self._changes), self._scene
        self._changes.pop(key, None)  # the last assignment counts, also where it overlaps with others
        self._changes[key], self._scene = _as_toml(value), None
        try:
            self._read()
        except Exception:
            self._changes, self._scene = before
            raise

    def __getitem__(self, key: str) -> Any:
        """The value of a key, however it is written: the change made to it, as text, or what the case has with all changes.
        KeyError where neither says it."""
        import tomllib

        tree: Any = tomllib.loads(self._read().text)  # as it was read and runs, whatever the file is by now
        for changed, text in self._changes.items():
            _assign(tree, changed, text)
        path = _path(tree, key)
        if path is None:
            raise KeyError(key)
        for changed, text in reversed(self._changes.items()):
            other = _path(tree, changed)
            if other == path:
                return text
            if other is not None and other[: len(path)] == path[: len(other)]:
                break  # a value in it, or what it is in, was changed later
        for step in path:
            tree = tree[step]
        return tree

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._path, self._accuracy, dict(self._changes))

    @property
    def name(self) -> str:
        """Name of the case."""
        return self._read().name

    @property
    def accuracy(self) -> str:
        """The accuracy it is read at."""
        return self._accuracy

    @property
    def changes(self) -> dict[str, str]:
        """The changes made so far, by key, as text."""
        return dict(self._changes)

    def at(self, accuracy: str) -> "Case":
        """The same case with the same changes at another accuracy."""
        other = Case.__new__(Case)
        other._path, other._accuracy, other._changes, other._scene = self._path, accuracy, dict(self._changes), None
        other._read()
        return other

    def check(self) -> str:
        """What `parison check` says of the case, a text. Raises RunError where its first stage cannot begin."""
        reason = self._read().first_stage_failure()
        if reason:
            raise RunError(f"{self.name}: the first stage cannot begin: {reason}")
        return self._read().describe()

    def run(self, output: Optional[PathLike] = None, callback: Optional[StepCallback] = None) -> Result:
        """Runs the case and returns its Result.

        `output`: a new or empty folder for the results; None for one that is removed with the Result. `callback(state)` is
        called after each step with the State; where it returns a true value the run stops there. What it raises stops the run
        too and is raised here, and so is an interrupt from the keyboard; the results so far stay in `output`. A run that
        cannot continue raises RunError with the reason, with its Result as `result`.
        """
        return self._run(output, callback, resume=False)

    def resume(self, output: PathLike, callback: Optional[StepCallback] = None) -> Result:
        """Continues a run in its folder from the last checkpoint, as if it had never stopped."""
        return self._run(output, callback, resume=True)

    def _run(self, output: Optional[PathLike], callback: Optional[StepCallback], resume: bool) -> Result:
        if callback is not None and not callable(callback):
            raise TypeError(f"callback: a {type(callback).__name__} was found, allowed is a function of the State")
        if output is not None and not os.fspath(output):
            raise ValueError("output: an empty path was found, allowed is a folder")
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
