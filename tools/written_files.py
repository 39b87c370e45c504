# SPDX-License-Identifier: GPL-3.0-or-later
"""The manifest of what Parison has written into a folder, as core/io/manifest.cpp keeps it, for the scripts."""
import os
import sys
from pathlib import Path

MANIFEST = ".parison_written"


def fingerprint(content):
    """FNV-1a, 64 bits."""
    value = 0xCBF29CE484222325
    for byte in content:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return value


def is_own(path):
    """Whether a file has one of the contents that were noted for it."""
    path, manifest = Path(path), Path(path).parent / MANIFEST
    if path.is_symlink() or not path.is_file() or not manifest.is_file():
        return False
    content = path.read_bytes()
    for line in manifest.read_text(encoding="utf-8").splitlines():
        words = line.split(" ", 3)
        if len(words) == 4 and words[0] == "has" and words[3] == path.name and int(words[1]) == len(content):
            if int(words[2].split(",")[-1], 16) == fingerprint(content):
                return True
    return False


def require_own(path):
    """Ends the script with exit code 2 where a file is there that Parison has not written, or that has changed since."""
    if os.path.lexists(path) and not is_own(path):
        print(f"{path}: this was not written by parison, or has changed since; allowed is another output, or this one once it"
              " is moved away", file=sys.stderr)
        sys.exit(2)


def note_written(path):
    """Notes the content of a file that was just written."""
    content = Path(path).read_bytes()
    with open(Path(path).parent / MANIFEST, "a", encoding="utf-8") as manifest:
        manifest.write(f"\nhas {len(content)} {fingerprint(content):016x} {Path(path).name}\n")
