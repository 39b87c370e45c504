# SPDX-License-Identifier: GPL-3.0-or-later
"""coverage.py REPORT: prints how many lines of each module ran, of a report of `llvm-cov export`.

The exit code is 1 where less than WANTED of a module ran. Called by tools/coverage."""
import json
import sys
from collections import defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from documents import store  # noqa: E402

MODULES = ("core", "thermal", "contact", "remesh", "forming")
WANTED = 0.9


def files(report):
    """Lines and those that ran, by the path of each file in the repository."""
    found = {}
    for file in json.loads(Path(report).read_text())["data"][0]["files"]:
        path, lines = Path(file["filename"]).resolve(), file["summary"]["lines"]
        if path.is_relative_to(store.ROOT):
            found[path.relative_to(store.ROOT)] = (lines["count"], lines["covered"])
    return found


def modules(found):
    """A row for each module; one of which no line is counted has run by none."""
    counts, ran = defaultdict(int), defaultdict(int)
    for path, (count, covered) in found.items():
        counts[path.parts[0]] += count
        ran[path.parts[0]] += covered
    return [{"module": module, "lines": counts[module], "ran": ran[module]} for module in MODULES]


def share(row):
    return row["ran"] / row["lines"] if row["lines"] else 0.0


def main():
    found = files(sys.argv[1])
    rows = modules(found)
    for row in rows:
        print(f"{row['module']:8s} {row['lines']:6d} lines, {100 * share(row):5.1f} % ran" + ("" if share(row) >= WANTED else ", below 90 %"))
    worst = sorted((path for path in found if path.parts[0] in MODULES), key=lambda path: found[path][1] - found[path][0])[:10]
    print("most lines that did not run: " + ", ".join(f"{path} {found[path][0] - found[path][1]}" for path in worst))
    return 1 if any(share(row) < WANTED for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
