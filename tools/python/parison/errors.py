# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong, as exceptions."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

if TYPE_CHECKING:
    from .result import Result


class Error(Exception):
    """Any failure of Parison."""


class CaseError(Error):
    """A mistake in a case: `file`, `line` (0 where it is not known), `key`; the text says what was found and is allowed."""

    def __init__(self, message: str, file: str = "", line: int = 0, key: str = "") -> None:
        super().__init__(message)
        self.file, self.line, self.key = file, line, key


class RunError(Error):
    """A run that could not begin or go on; the text says why. `result`: what there is of it, or None."""

    result: Optional[Result] = None

    def __reduce__(self) -> tuple[Any, ...]:
        kept = {} if self.result is None or self.result.is_temporary else {"result": self.result}
        return type(self), self.args, kept
