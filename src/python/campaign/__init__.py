# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns: many runs of a scene over factors, by Dask's workers, into one SQLite file. `drill_campaign` is the command; config/campaigns/README.md says more."""
