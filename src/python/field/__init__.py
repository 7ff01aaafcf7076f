# SPDX-License-Identifier: BSD-3-Clause
"""Recorded wells: what a rig's data system wrote, played to the simulator, and what of the model can be fitted to it."""
