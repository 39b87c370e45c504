# SPDX-License-Identifier: GPL-3.0-or-later
"""Links between the documents: the files and headings that they name exist."""
import re

from documents.store import ROOT

LINK = re.compile(r"\]\(([^) ]+)\)|src=\"([^\"]+)\"")
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.DOTALL | re.MULTILINE)


def anchors(path):
    """Names of a document's headings as links give them."""
    headings = re.findall(r"^#+ (.*)$", path.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken(documents):
    """A sentence for each link that leads nowhere."""
    for document in documents:
        for match in LINK.finditer(CODE.sub("", document.read_text())):
            link = match[1] or match[2]
            name, _, anchor = link.partition("#")
            if "://" in link:
                continue
            path = (document.parent / name).resolve() if name else document
            if not path.exists():
                yield f"{document.relative_to(ROOT)}: \"{link}\" leads to no file"
            elif anchor and anchor not in anchors(path):
                yield f"{document.relative_to(ROOT)}: \"{link}\" leads to no heading"
