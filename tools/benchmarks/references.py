# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that runs are held against: stored ones where a fine run takes minutes, made anew where it takes seconds."""
import hashlib
import json
from functools import lru_cache
from pathlib import Path

from benchmarks.common import ROOT, Skipped, build, parison, read_summary

STORED = Path(__file__).resolve().parent / "references.json"
SECONDS = {"shell_inflation": "fine coarser 0.667", "contact_cylinders": "fine coarser 0.667"}
MINUTES = {"jar": "fine", "tumbler": "fine", "bottle": "fine coarser 0.8"}  # the bottle at fine is still 0.27 % off in the mean of its wall


def fingerprint(case):
    """Of the case file: a reference serves only the case that it was made of."""
    return hashlib.sha256((ROOT / "cases" / case / "case.toml").read_bytes()).hexdigest()[:16]


def kept(summary):
    profile = [None if t is None else float(f"{t:.6g}") for t in summary["thickness_profile_mm"]]
    return {"quantities": summary["quantities"], "thickness_profile_mm": profile, "cpu_seconds": round(summary["cpu_seconds"], 1)}


@lru_cache
def of_case(case):
    if case in SECONDS:
        build("parison")
        return kept(read_summary(parison(ROOT / "cases" / case, SECONDS[case])[1]))
    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    if stored.get(case, {}).get("case_file") != fingerprint(case):
        raise Skipped(f"no fine reference is stored for this state of cases/{case}; `tools/bench --update-references` makes it in some minutes.")
    return stored[case]


def known(cases):
    """Cases and their references; prints which are skipped."""
    for case in cases:
        try:
            yield case, of_case(case)
        except Skipped as reason:
            print(f"    {case} skipped: {reason}", flush=True)


def store(case, summary, draft):
    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    stored[case] = {"case_file": fingerprint(case), "accuracy": summary["accuracy"],
                    "draft_state": draft["state_fingerprint"], **kept(summary)}
    STORED.write_text(json.dumps(stored) + "\n")


@lru_cache
def tell_age(case, draft_state):
    """Says so when the draft run ends otherwise than it did with the reference."""
    if case in MINUTES and of_case(case).get("draft_state") != draft_state:
        print(f"    note: the reference of {case} was made by another state of the program or on another machine; "
              "`tools/bench --update-references` makes it anew", flush=True)


def update():
    """Runs every case whose reference is stored once more at fine accuracy."""
    build("parison")
    for case, accuracy in MINUTES.items():
        print(f"reference of {case}, at {accuracy}", flush=True)
        run, draft = (read_summary(parison(ROOT / "cases" / case, at)[1]) for at in (accuracy, "draft"))
        store(case, run, draft)
