#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Formulas of the manual that ./src/manual/run made, as Chromium shows them: each is typeset. Skipped without the manual or Chromium."""
import os
import shutil
import subprocess
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
HTML = os.path.join(SOURCE, 'build', 'manual', 'html')
CHROMIUM = shutil.which('chromium')
WAIT = 30000  # for MathJax, on the page's own clock [ms]


def shown(page, folder):
    """The page's elements after its scripts have run."""
    command = [CHROMIUM, '--headless', '--no-sandbox', '--disable-gpu', '--user-data-dir=' + folder, '--virtual-time-budget=%d' % WAIT, '--dump-dom', 'file://' + page]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True, timeout=300, universal_newlines=True).stdout


@unittest.skipUnless(CHROMIUM and os.path.isdir(HTML), 'needs Chromium and the manual (./src/manual/run)')
class Formulas(unittest.TestCase):
    def test_each_is_typeset(self):
        pages = 0
        for folder, _, files in os.walk(HTML):
            for page in [os.path.join(folder, name) for name in files if name.endswith('.html')]:
                with open(page, encoding='utf-8') as file:
                    written = file.read().count('class="math notranslate')
                if not written:
                    continue
                with self.subTest(page=os.path.relpath(page, HTML)), tempfile.TemporaryDirectory() as data:
                    dom = shown(page, data)
                    self.assertEqual(written, dom.count('class="MathJax"'))
                    self.assertNotIn('class="merror', dom)
                pages += 1
        self.assertGreater(pages, 0)


if __name__ == '__main__':
    unittest.main()
