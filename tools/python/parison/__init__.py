# SPDX-License-Identifier: GPL-3.0-or-later
"""Parison for Python: cases, runs with callbacks, fields as arrays, results as tables.

    import parison

    case = parison.Case("jar", accuracy="draft")
    case["tool.blank.temperature"] = "440 degC"
    result = case.run("results/colder_blank")
    print(result.summary["thickness"]["min_mm"], result.verdict)
"""
from .case import Case
from .errors import CaseError, Error, RunError
from .result import Result

__all__ = ["Case", "CaseError", "Error", "Result", "RunError"]
