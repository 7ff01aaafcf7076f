# SPDX-License-Identifier: BSD-3-Clause
"""The C++ module whose rules of units, names and depths records share with surveys."""
from drill_rig_sim.refusal import Refusal


def of_module():
    try:
        from drill_rig_sim import _sim  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise Refusal("records are read by the Python module sim, which is not built (it needs pybind11-dev): %s" % error)
    return _sim
