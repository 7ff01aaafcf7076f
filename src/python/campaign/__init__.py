"""Campaigns: many runs of a scene over factors, by Dask's workers, into one SQLite file. `drill_campaign` is the command; README.md of src/python/campaign says more."""
