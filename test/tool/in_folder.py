# SPDX-License-Identifier: BSD-3-Clause
"""A test with a folder of its own for the files that it writes."""
import os
import tempfile
import unittest


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name, text, encoding="utf-8"):
        """Path of a file of this text, as it stands."""
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding=encoding, newline="") as out:
            out.write(text)
        return path
