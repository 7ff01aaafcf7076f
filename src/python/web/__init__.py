# SPDX-License-Identifier: BSD-3-Clause
"""What `drill web` serves: a page that shows a rig, live or from a bag. Needs Debian's python3-aiohttp and libjs-chart.js."""
