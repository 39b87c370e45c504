# SPDX-License-Identifier: GPL-3.0-or-later
"""Names in the documents: every key of a case stands in cases/README.md, and the rows of CONTRIBUTING.md name what their files have."""
import re

from documents.store import ROOT, files

CASES, CONTRIBUTING = ROOT / "cases/README.md", ROOT / "CONTRIBUTING.md"
KEY_LISTS = re.compile(r"(?:CaseTable(?: \w+)?\(|_keys\(\) \{\s*return )[^;{]*\{((?:\s*\"[^\"]*\",?)+)\s*\}")
SETTINGS = re.compile(r"\{\"(\w+)\",\s*&A::")
LINK = re.compile(r"\[([^\]]+)\]\(([^)#]+)[^)]*\)")
FENCE = re.compile(r"^```.*?^```", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"`([^`]+)`")
IDENTIFIER, PLACE = re.compile(r"[A-Za-z_]\w*(?:::\w+)*"), re.compile(r"[\w/.-]*(?:/[\w.-]+|\.(?:[ch]pp|py|js|toml|json))")


def keys():
    """All keys that the reader of cases knows."""
    found = set()
    for path in (ROOT / "forming/scene").rglob("*.cpp"):
        text = path.read_text()
        found.update(key for match in KEY_LISTS.finditer(text) for key in re.findall(r"\"([^\"]*)\"", match[1]))
        found.update(SETTINGS.findall(text))
    return found


def absent_keys():
    """A sentence for each key that cases/README.md leaves out."""
    known = {word for code in CODE.findall(FENCE.sub("", CASES.read_text())) for word in re.findall(r"\w+", code)}
    for key in sorted(keys() - known):
        yield f"{CASES.relative_to(ROOT)}: \"{key}\", a key of a case, is missing"


def rows():
    return [line for line in CONTRIBUTING.read_text().splitlines() if line.startswith("| ")]


def misnamed_files():
    """A sentence for each link of CONTRIBUTING.md whose text names another file than it leads to."""
    for text, link in LINK.findall(CONTRIBUTING.read_text()):
        if PLACE.fullmatch(text) and not link.endswith(text) and f"{text}/" not in link:
            yield f"{CONTRIBUTING.name}: \"{text}\" leads to {link}"


def unknown_names():
    """A sentence for each name in a table of CONTRIBUTING.md that no file of its row has; a header stands for its folder."""
    paths = [str(path.relative_to(ROOT)) for path in files("*")]
    for row in rows():
        names = CODE.findall(LINK.sub("", row))
        named = [ROOT / place for place in [link for _, link in LINK.findall(row)] + names if (ROOT / place).is_file()]
        named += [sibling for path in named if path.suffix == ".hpp" for sibling in path.parent.glob("*.cpp")]
        texts = "\n".join(path.read_text(errors="replace") for path in named)
        for name in names:
            elsewhere = any(re.search(rf"(?:^|/){re.escape(name.strip('/'))}(?:\.\w+|/.*)?$", path) for path in paths)
            if named and (PLACE.fullmatch(name) or IDENTIFIER.fullmatch(name)) and not elsewhere and name.split("::")[-1] not in texts:
                yield f"{CONTRIBUTING.name}: \"{name}\" is neither a file nor in the files of its row: {row[:60]}"


def wrong():
    return [*absent_keys(), *misnamed_files(), *unknown_names()]
