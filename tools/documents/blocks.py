# SPDX-License-Identifier: GPL-3.0-or-later
"""Marked blocks of the READMEs: `<!-- begin: NAME ARGUMENTS -->` to `<!-- end: NAME -->`, whose text a function makes."""
import re

from documents import assumed, measured, studies, tables
from documents.store import ROOT, Missing, files

BLOCK = re.compile(r"(^<!-- begin: (\w+)((?: [\w.]+)*) -->\n).*?^(<!-- end: \2 -->)", re.DOTALL | re.MULTILINE)
BLOCKS = {**tables.BLOCKS, **studies.BLOCKS, **measured.BLOCKS, **assumed.BLOCKS}
MARK = re.compile(r"^<!-- (?:begin|end): ", re.MULTILINE)


def documents():
    """All documents of the repository."""
    return files("*.md")


def make(path, name, arguments):
    """The text of a block; that of a case's README gets the case as first argument."""
    folder = path.parent.relative_to(ROOT).parts
    if folder[:1] == ("cases",) and len(folder) == 2 and name in tables.CASE_BLOCKS:
        return tables.CASE_BLOCKS[name](folder[1], *arguments)
    if name in BLOCKS:
        return BLOCKS[name](*arguments)
    raise Missing(f"{path.relative_to(ROOT)}: a block \"{name}\" was found, allowed are {', '.join(sorted(BLOCKS))}, in "
                  f"cases/*/README.md also {', '.join(sorted(tables.CASE_BLOCKS))}")


def written(path, missing):
    """The document with every block made anew; a block whose figures are not stored stays, and the reason goes to `missing`."""
    text = path.read_text()
    found = []

    def replace(match):
        found.append(match)
        try:
            return match[1] + make(path, match[2], match[3].split()) + "\n" + match[4]
        except Missing as reason:
            missing.append(str(reason))
            return match[0]

    result = BLOCK.sub(replace, text)
    if 2 * len(found) != len(MARK.findall(text)):
        raise Missing(f"{path.relative_to(ROOT)}: a block that begins has no end of its name")
    return result


def update(check):
    """Writes all documents with blocks, or says which are stale; the number of those. Ends with Missing where figures are not stored."""
    stale, missing = 0, []
    for path in documents():
        if not MARK.search(path.read_text()):
            continue
        text = written(path, missing)
        if text == path.read_text():
            continue
        stale += 1
        print(f"{path.relative_to(ROOT)}: " + ("its figures are not those stored; tools/readme_figures writes them" if check else "written"))
        if not check:
            path.write_text(text)
    if missing:
        raise Missing("\n".join(sorted(set(missing))))
    return stale
