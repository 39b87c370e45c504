# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong, as exceptions."""


class Error(Exception):
    """Any failure of Parison."""


class CaseError(Error):
    """A mistake in a case: `file`, `line` (0 where it is not known), `key`; the text says what was found and is allowed."""

    def __init__(self, message, file="", line=0, key=""):
        super().__init__(message)
        self.file, self.line, self.key = file, line, key


class RunError(Error):
    """A run that could not begin or go on; the text says why."""
