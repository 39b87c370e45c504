# SPDX-License-Identifier: GPL-3.0-or-later
"""Order in time of the staggered coupling, one pass a step, from steps halved and halved again."""
import json

from benchmarks.common import BUILD, Figure, build, new_path, run

ORDER = 1.9  # of three lengths of step, wanted for a scheme of order 2


def section(_):
    build("test_verification")
    report = new_path("coupling.json")
    log = new_path("coupling.log")
    done = run([BUILD / "tests/test_verification", "--gtest_filter=Coupling.*", f"--gtest_output=json:{report}"], log)
    if done.code:
        raise RuntimeError(f"the test of the coupling ended with {done.code}:\n" + log.read_text()[-800:])
    (test,) = json.loads(report.read_text())["testsuites"][0]["testsuite"]
    for key, what in (("radius", "radius"), ("force", "force"), ("mean_temperature", "mean temperature")):
        yield Figure(f"coupling.{key}", f"order in time of the coupling, disc pressed between cold plates: {what}",
                     float(test[key]), ORDER, True)
