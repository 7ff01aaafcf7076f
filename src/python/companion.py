# SPDX-License-Identifier: BSD-3-Clause
"""What the companion of a run says of it: a second model of the same rig under the same commands (numerics.companion), by the columns of
drill run --errors or the topics companion/truth/* of a bag. How far the two are apart measures what the numerics make of the rig."""
import numpy
from drill_rig_sim.score_runs import Run

OUTPUTS = ("hook_load", "torque", "wob", "rop", "bit_speed", "stand_pipe_pressure")  # whose errors drill run measures
WINDOW = 3.0  # over which differences are averaged, as in the measured error [s]


def companion_run(run, left_out):
    """The companion as a run of its own. None without one, and where it ended before the run: `left_out` has the reason."""
    if not run.companion:
        return None
    ended = ~numpy.isfinite(numpy.stack(list(run.companion.values()))).all(axis=0)
    if ended.any():
        left_out.append("companion: it ended before the run, it is missing from %.6g s on" % run["time"][ended.argmax()])
        return None
    return Run({"time": run["time"], **run.companion}, run.source, run.name + ", its companion")


def difference(run, column):
    """Root mean square over the last WINDOW of the difference between run and companion, in each row. Before the start there was none, once the
    companion has ended it is nan. None where the run has no such column of a companion."""
    if column not in run or column not in run.companion:
        return None
    squares = numpy.cumsum((run[column] - run.companion[column])**2 * run.dt)
    before = numpy.interp(run["time"] - WINDOW, run["time"], squares)
    return numpy.sqrt(numpy.maximum(squares - before, 0.0) / WINDOW)


def differences(run):
    """Of all OUTPUTS that run and companion have, by their names."""
    found = {column: difference(run, column) for column in OUTPUTS}
    return {column: off for column, off in found.items() if off is not None}
