from typing import Any, Callable, Optional

import numpy as np
import numpy.typing as npt

class Body:
    """A body at one moment. Arrays share the memory of the state, keep it alive and are read-only."""

    @property
    def name(self) -> str:
        """ "glass", or the name of the tool."""
    @property
    def nodes(self) -> npt.NDArray[np.float64]:
        """(nodes, 2): r and z, m; of a tool in its own frame."""
    @property
    def cells(self) -> npt.NDArray[np.int32]:
        """(cells, 6): three vertices counterclockwise, then the middle nodes of the sides 01, 12, 20."""
    @property
    def boundary(self) -> list[tuple[int, int, int, str]]:
        """Edges: first, last and middle node, and the name of the boundary."""
    @property
    def fields(self) -> dict[str, npt.NDArray[Any]]:
        """(nodes,) or (nodes, 2) by name; `units` has their units."""
    @property
    def units(self) -> dict[str, str]: ...
    @property
    def offset(self) -> float:
        """Position of a tool along the axis, m."""
    @property
    def volume(self) -> float:
        """m3, of the full revolution or of 1 m of depth."""

class State:
    """Everything at one moment of a run; it does not change, also while the run goes on."""

    @property
    def time(self) -> float:
        """s since the start of the run."""
    @property
    def step(self) -> int: ...
    @property
    def stage(self) -> str: ...
    @property
    def remeshes(self) -> int:
        """New meshes of the glass since the start."""
    @property
    def glass(self) -> Body: ...
    @property
    def tools(self) -> dict[str, Body]: ...

class Scene:
    @property
    def name(self) -> str: ...
    @property
    def accuracy(self) -> str: ...
    @property
    def text(self) -> str:
        """The case file as it was read."""
    def describe(self) -> str: ...
    def first_stage_failure(self) -> str: ...

def read(path: str, accuracy: str, overrides: list[str]) -> Scene: ...
def run(scene: Scene, directory: str, callback: Optional[Callable[[State], Any]], resume: bool) -> tuple[State, dict[str, Any]]: ...
