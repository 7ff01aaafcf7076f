# SPDX-License-Identifier: BSD-3-Clause
"""Runs a file's unittests so that a skipped one shows: unittest alone ends with 0, as if it had passed. Reasons to skip."""
import glob
import os
import sys
import unittest

SKIPPED = 77  # what ctest takes for skipped (SKIP_RETURN_CODE in CMakeLists.txt)


def main(**options):
    """Ends the program: 0 all passed, 1 one failed, 77 none failed but one was skipped."""
    result = unittest.main(exit=False, **options).result
    for test, why in result.skipped:
        print('skipped %s: %s' % (test, why))
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(SKIPPED if result.skipped else 0)


def without_module(test, drill):
    """Skips the test where the Python module is not beside the program `drill`: left out of builds with sanitizers and without pybind11."""
    if not glob.glob(os.path.join(os.path.dirname(drill), '../python*/*-packages/drill_rig_sim/_sim*.so')):
        test.skipTest('the Python module is not built')
