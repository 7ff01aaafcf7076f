# SPDX-License-Identifier: BSD-3-Clause
"""Runs within bounds: each worker has one process of its own for them, which is ended when it hangs and made anew when it has died."""
import contextlib
import os
import pickle
import resource
import select
import signal
import subprocess
import sys
import threading
import time

from drill_rig_sim.campaign.blueprint import USER_ERRORS, error_line

GOOD, REFUSED, FAILED, CONTROLLER, JUDGE, CPU, WALL, MEMORY, DIED = (
    "good", "refused", "failed", "controller", "judge", "cpu", "wall", "memory", "died")  # of a run


ENDS = 5.0  # so long a process that has closed its answers may take to be gone [s]
AUDIT_COST = 50.0  # how many times the CPU and wall time of a run its audit may take


class OverTime(BaseException):
    """A run has had its share of the processor. No error that a controller would catch."""


def over_time(*_):
    raise OverTime


def memory():
    """What this process holds for itself [bytes]."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmData"))


def run(blueprint, row, identity, begin, verified=False):
    """Status, reason, outputs, and CPU time [s] of a row of values, or of its audit. `begin`: the memory before the first [bytes]."""
    began, cpu = time.process_time(), bound(blueprint.cpu, verified)
    resource.setrlimit(resource.RLIMIT_DATA, (int(begin + blueprint.memory), resource.RLIM_INFINITY))
    signal.setitimer(signal.ITIMER_PROF, cpu)
    outputs = {}
    try:
        status, reason, outputs, _ = outcome(blueprint, row, identity, verified)
    except OverTime:
        status, reason = CPU, "took more than %g s of processor time" % cpu
    except MemoryError:
        status, reason = MEMORY, "needed more than %g MB of memory" % (blueprint.memory / 1e6)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        resource.setrlimit(resource.RLIMIT_DATA, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    return status, reason, outputs, time.process_time() - began


def bound(seconds, verified):
    """Of the time that a run may take, or its audit [s]."""
    return AUDIT_COST * seconds if verified else seconds


def outcome(blueprint, row, identity=None, verified=False):
    """Of a run without bounds: status, reason, outputs, and it as a Played where it went to its end. Without an identity any build will do. `verified`: two finer
    models go along; the status is then their verdict and the outputs what they found (sim.Simulator.verified())."""
    from drill_rig_sim.campaign import played  # pylint: disable=import-outside-toplevel
    from drill_rig_sim.campaign.scene_text import SceneTextError  # pylint: disable=import-outside-toplevel
    from drill_rig_sim.lockstep import Failed, Refused  # pylint: disable=import-outside-toplevel
    from drill_rig_sim.sim import build  # pylint: disable=import-outside-toplevel
    over = None
    try:
        rig = played.simulator(blueprint, row)
        if identity is not None and [build(), rig.kernel] != identity:
            raise Refused("build and kernel here are %s %s, the campaign's are %s %s: the same build on all machines, and numerics.kernel in the scene" %
                          (build()[:8], rig.kernel, identity[0][:8], identity[1]))
        if verified:
            rig.verify()
        over = played.play(blueprint, row, rig)
        if verified:
            found = rig.verified()
            return found["verdict"], "", found, over
        return GOOD, "", played.outputs_of(blueprint, over), over
    except (Refused, SceneTextError) as refusal:
        return FAILED if isinstance(refusal, Failed) else REFUSED, one_line(refusal, blueprint), {}, over
    except played.Unjudged as problem:
        return JUDGE, str(problem), {}, over
    except MemoryError:
        raise
    except USER_ERRORS as error:
        return CONTROLLER, error_line(error, "" if blueprint.controller is None else blueprint.controller.module), {}, over


def one_line(refusal, blueprint):
    """The same wherever the run was."""
    return "; ".join(str(refusal).replace("%s/" % blueprint.folder, "").splitlines())


def end_with(parent):
    """A worker that was killed leaves no run behind, not even one that hangs."""
    while os.getppid() == parent:
        time.sleep(1.0)
    os._exit(1)  # pylint: disable=protected-access


def serve():
    """The runner's process: a blueprint, then rows, identities and whether they are verified, by standard input; answers by standard output. Ends with its input."""
    from drill_rig_sim.campaign import played  # noqa: F401  pylint: disable=unused-import,import-outside-toplevel
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the campaign
    signal.signal(signal.SIGPROF, over_time)
    threading.Thread(target=end_with, args=(os.getppid(),), daemon=True).start()
    asked, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a controller prints is no answer
    try:
        blueprint, begin = pickle.load(asked), memory()
        while True:
            row, identity, verified = pickle.load(asked)
            pickle.dump(run(blueprint, row, identity, begin, verified), answers)
            answers.flush()
    except EOFError:
        pass


class Runner:
    """The process beside a worker."""

    def __init__(self, blueprint):
        self.blueprint, self.process = blueprint, None

    def run(self, row, identity, verified=False):
        """As run()."""
        began, wall = time.monotonic(), bound(self.blueprint.wall, verified)
        try:
            if self.process is None:
                self.process = subprocess.Popen([sys.executable, "-m", "drill_rig_sim.campaign.runner"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
                self.send(self.blueprint)
            self.send((row, identity, verified))
            if select.select([self.process.stdout], [], [], wall)[0]:
                return pickle.load(self.process.stdout)
            self.end()
            return WALL, "had not ended after %g s" % wall, {}, time.monotonic() - began
        except (EOFError, BrokenPipeError, pickle.UnpicklingError):
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.process.wait(ENDS)  # by itself: its own status, not that of kill()
            status = self.end()
            return DIED, "its process died%s" % (" of signal %d" % -status if status < 0 else ": status %d" % status), {}, time.monotonic() - began

    def send(self, what):
        pickle.dump(what, self.process.stdin)
        self.process.stdin.flush()

    def end(self):
        """Kills the process; its status."""
        if self.process is None:
            return 0
        status = self.process.poll()
        self.process.kill()
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout):
            with contextlib.suppress(OSError):  # what was not read yet
                pipe.close()
        ended, self.process = self.process, None
        return ended.returncode if status is None else status


if __name__ == "__main__":
    serve()
