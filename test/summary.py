#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the cases in the JUnit files of ctest, gtest and rostest under a folder: names those that failed, ends with
'N passed, N failed, N skipped'. What ctest and rostest say of programs that count their own cases is left out unless it failed."""
import pathlib
import sys
import xml.etree.ElementTree as xml



def why(case):
    """The lines in which a program that ctest took for skipped reports why."""
    said = [line for line in (case.findtext("system-out") or "").splitlines() if "skipped" in line.lower() or "not installed" in line]
    return ": " + "; ".join(said) if said else ""


passed = failed = skipped = 0
for file in sorted(pathlib.Path(sys.argv[1]).rglob("*.xml")):
    try:
        cases = list(xml.parse(file).iter("testcase"))
    except xml.ParseError as error:
        print("%s: not readable: %s" % (file, error))
        failed += 1
        continue
    for case in cases:
        told_elsewhere = file.name.startswith("rostest-") or case.get("name").startswith("_ctest_")
        if case.find("failure") is not None or case.find("error") is not None:
            failed += 1
            print("FAILED %s.%s (%s)" % (case.get("classname"), case.get("name"), file.name))
        elif case.find("skipped") is not None or case.get("result") == "skipped" or case.get("status") == "notrun":
            skipped += 1
            print("SKIPPED %s.%s%s" % (case.get("classname"), case.get("name"), why(case)))
        elif not told_elsewhere:
            passed += 1
print("%d passed, %d failed, %d skipped" % (passed, failed, skipped))
sys.exit(1 if failed or not passed else 0)
