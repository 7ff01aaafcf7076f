# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of records share: a folder for files, rows that are right, and refusals of one line."""
import os

import numpy
from drill_rig_sim.field.record import RecordError, read_record
from in_folder import InFolder

CASES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "cases")
KLBF, FEET = 4448.2216152605, 0.3048
ROWS = ((0, 200.0, 30.0), (5, 201.0, 29.5), (10, 202.5, 29.0), (15, 203.0, 28.0))  # seconds, hook load [klbf], block [ft]
STAMPS = ["2024-05-01T10:00:%02dZ" % row[0] for row in ROWS]

MAP = "time: {column: T, unit: s}\nhook_load: {column: H, unit: klbf}\nblock_height: {column: B, unit: ft}\n"


class Folder(InFolder):
    def read(self, text, columns=None, name="r.csv", encoding="utf-8"):
        return read_record(self.file(name, text, encoding), self.file("map.yaml", columns) if columns else None)

    def right(self, record, remarks=()):
        """ROWS, as they were written."""
        self.assertEqual([row[0] for row in ROWS], list(record.time))
        numpy.testing.assert_allclose(record.signals["hook_load"], [KLBF * row[1] for row in ROWS], rtol=1e-6)
        numpy.testing.assert_allclose(record.signals["block_height"], [FEET * row[2] for row in ROWS], rtol=1e-6)
        for line in remarks:
            self.assertIn(line, "\n".join(record.remarks))

    def all_right(self, texts, *args, **options):
        """Texts by what is special in them, each read as ROWS."""
        for what, text in dict(texts).items():
            with self.subTest(what):
                self.right(self.read(text, *args, **options))

    def all_refused(self, cases):
        """Texts and what their refusals say, by what is special in them."""
        for what, (text, said) in cases.items():
            with self.subTest(what):
                self.refused(said, text)

    def refused(self, said, *args, **options):
        """In one line that holds these texts."""
        with self.assertRaises(RecordError, msg=said) as caught:
            self.read(*args, **options)
        for text in [said] if isinstance(said, str) else said:
            self.assertIn(text, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))
        self.assertLess(len(str(caught.exception)), 900)
