# SPDX-License-Identifier: MIT
"""Prints the table at the end of tools/test from the JUnit files and the list of parts in a folder.
Status 1 if a part or a test failed, or if tests were skipped although REQUIRE_CORPORA is yes."""

import os
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def count(path):
    """(passed, failed, names of the skipped) of a JUnit file."""
    passed = failed = 0
    skipped = []
    for case in ElementTree.parse(path).iter("testcase"):
        if case.find("skipped") is not None or case.get("status") == "notrun":
            skipped.append(case.get("name"))
        elif case.find("failure") is not None or case.find("error") is not None:
            failed += 1
        else:
            passed += 1
    return passed, failed, skipped


def main(folder):
    passed = failed = 0
    skipped = []
    print(f"\n{'part':<14}{'passed':>8}{'failed':>8}{'skipped':>9}{'seconds':>9}")
    for line in (folder / "parts").read_text().splitlines():
        name, status, seconds = line.split()
        results = folder / f"{name}.xml"
        counts = count(results) if results.exists() else (0, 0, [])
        broken = int(status) != 0 and counts[1] == 0  # ended before its tests could say why
        print(
            f"{name:<14}{counts[0]:>8}{counts[1] + broken:>8}{len(counts[2]):>9}{seconds:>9}"
            + ("  did not end well" if broken else "")
        )
        passed += counts[0]
        failed += counts[1] + broken
        skipped += counts[2]
    if skipped:
        print(f"skipped, as the corpora are not there: {', '.join(skipped[:8])}"
              + (f" and {len(skipped) - 8} more" if len(skipped) > 8 else ""))
        if os.environ.get("REQUIRE_CORPORA") == "yes":
            print("skipped tests count as failed here")
            failed += len(skipped)
    print(f"{passed} passed, {failed} failed" + (f", {len(skipped)} skipped" if skipped else ""))
    return 1 if failed or passed == 0 else 0


sys.exit(main(Path(sys.argv[1])))
