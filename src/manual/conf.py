# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's configuration of the manual; src/manual/run calls it."""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from pages import PACKAGE  # noqa: E402

with open(os.path.join(PACKAGE, 'package.xml'), encoding='utf-8') as manifest:
    version = release = re.search(r'<version>([\d.]+)</version>', manifest.read()).group(1)

project = 'drill_rig_sim'
copyright = 'the drill_rig_sim maintainers, BSD-3-Clause'  # pylint: disable=redefined-builtin
language = 'en'
extensions = ['myst_parser', 'sphinx.ext.mathjax', 'breathe', 'directives']
myst_enable_extensions = ['dollarmath', 'colon_fence']
myst_heading_anchors = 3
html_theme = 'furo'
html_title = 'drill_rig_sim %s' % version
html_static_path = [os.environ.get('MANUAL_STATIC', '_static')]
html_css_files = ['manual.css']
html_copy_source = False
html_show_sphinx = False
highlight_language = 'text'
# the copy of libjs-mathjax that src/manual/run puts there afterwards: the manual reads without a network
exclude_patterns = ['_static']
mathjax_path = 'mathjax/MathJax.js?config=TeX-AMS_HTML'
# MyST keeps MathJax off the text beside formulas; by default it marks them only for MathJax 3, which Debian does not have
mathjax2_config = {'tex2jax': {'processClass': 'tex2jax_process|mathjax_process|math|output_area'}}
math_number_all = False
breathe_projects = {'laws': os.environ.get('MANUAL_DOXYGEN', '')}
breathe_default_project = 'laws'
breathe_show_include = False
