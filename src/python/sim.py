"""A rig in this process, without ROS: what drill_rig_sim.rig is to a node, under the same names.

    from drill_rig_sim.sim import Simulator

    rig = Simulator("quick.yaml")
    rig.rotate(rpm=90)
    rig.winch(-0.01)
    rig.step_until(lambda s: s.truth.on_bottom, timeout=300)
    run = rig.record(60.0)                  # numpy: run.t, run.readings["hook_load"], run.truth["winch.brake"], run.bit["wob"]

Readings, truth and bit are bit for bit those of a node that runs the same scene at the same rate. Beside a rig's: record(), toolface and survey.
"""
import os
import typing

import numpy
from drill_rig_sim import _sim
from drill_rig_sim.lockstep import RPM, UNSENSED, Lockstep, Refused, State, TimedOut, series  # pylint: disable=unused-import

COMMANDS = {"winch": _sim.Winch, "top_drive": _sim.TopDrive, "mud_pump": _sim.MudPump, "steering": _sim.Steering}


class Record(typing.NamedTuple):
    """Of many frames, a row each: fields of RigState and BitTruth by their names, those of a set point as "winch.brake". As drill score takes a run
    (drill_rig_sim.score_runs.run_of_record)."""
    t: numpy.ndarray  # [s]
    readings: numpy.ndarray
    truth: numpy.ndarray
    bit: numpy.ndarray


class Simulator(Lockstep):
    """The rig of a scene's file: a path, package://PACKAGE/FILE, or a name in the package's config/scenes. `rate`: frames a second. `play_program`: the scene's program
    and operations give the set points until somebody else does. Time begins at 0 with every reset; snapshots bring back theirs."""

    def __init__(self, scene, rate=100.0, seed=0, play_program=False):
        self._rig = _sim.Rig(found(scene, "config/scenes"), rate, seed, play_program)
        self.rate = rate
        self._saved = {}
        self._telemetry = {"toolface": None, "survey": None}
        self._begin()

    # --- what downhole tools sent up, for drill_rig_sim.control.drive(rig, law, timeout, telemetry=rig)

    @property
    def toolface(self):
        """The last that came up, fields of MwdToolface and the time `t` of measurement [s]; None before."""
        return self._last("toolface", self._rig.toolface())

    @property
    def survey(self):
        """The last that came up, fields of MwdSurvey and the time `t` of measurement [s]; None before."""
        return self._last("survey", self._rig.survey())

    def listen(self, now, period):
        """Nothing is on its way here: see Telemetry of drill_rig_sim.topics."""

    # --- time

    def record(self, seconds, every=1):
        """Steps through `seconds`, at most 100000 frames, and keeps the frame after every so many and the last: a Record."""
        frames = self._frames_in(seconds)
        self._hand_over()
        readings, truth, bit = self._rig.record(frames, every)
        self._look()
        return Record(numpy.round(truth["time"], 9), readings, truth, bit)

    # --- services

    def reset(self, scene="", bit_depth=0.0):
        """Back to the start of a scene file, by default of the present one; the state there. Set points are forgotten."""
        self._rig.reset(found(scene, "config/scenes") if scene else "", bit_depth)
        return self._begin()

    def load_survey(self, file="", md=(), inclination=(), azimuth=(), tie_in_north=0.0, tie_in_east=0.0, tie_in_tvd=0.0, hole_depth=0.0, bit_depth=0.0):
        """A new well, from a file or by the fields of LoadSurvey; the state at its start. Set points are forgotten."""
        path = found(file, "config/surveys") if file else ""
        self._rig.load_survey(path, list(md), list(inclination), list(azimuth), (tie_in_north, tie_in_east, tie_in_tvd), hole_depth, bit_depth)
        return self._begin()

    def tare(self):
        """Zeroes surface WOB and differential pressure, off bottom; the state then."""
        self._rig.tare()
        return self._look()

    def save(self, name):
        """A snapshot in memory. (Files are the node's to write.)"""
        self._saved[name] = self._rig.save()

    def restore(self, name):
        """Back to a snapshot; the state there."""
        if name not in self._saved:
            raise Refused("there is no state %s; saved are: %s" % (name, ", ".join(self._saved) or "none"))
        self._rig.restore(self._saved[name])
        return self._begin()

    def fault(self, fault, clear=False, target="", depth=0.0, magnitude=0.0):
        """Begins a fault, named as in InjectFault: rig.fault("STUCK_PIPE", depth=900.0)."""
        self._rig.fault(fault, clear, target, depth, magnitude)

    def slips(self, are_set):
        """Hangs the string in the slips or takes it from there."""
        self._rig.slips(are_set)

    def connection(self, joints=0, remove=False):
        """Adds joints of drill pipe, or removes them; 0: a stand."""
        self._rig.connection(joints, remove)

    # --- the connection

    def _set(self, kind, **fields):
        self._set_points[kind] = COMMANDS[kind](**fields)

    def _hand_over(self):
        if self._set_points:
            set_points, self._set_points = self._set_points, {}
            self._rig.command(*(set_points.get(kind) for kind in COMMANDS))

    def _advance(self, frames):
        self._hand_over()
        self._rig.advance(frames)
        return self._look()

    def _look(self):
        frame = self._rig.frame()
        self.state = State(round(frame.t, 9), frame.readings, frame.truth, frame.bit)
        return self.state

    def _begin(self):
        self._set_points = {}
        return self._look()

    def _last(self, kind, reading):
        """The same object until another has come."""
        last = self._telemetry[kind]
        if reading is None or last is None or (reading.sequence, reading.t) != (last.sequence, last.t):
            self._telemetry[kind] = reading
        return self._telemetry[kind]


def found(name, folder):
    """The file of this name: a path as it is, else looked for as the node does."""
    if os.path.exists(name):
        return name
    import rospkg  # of no use to whoever gives paths
    package, file = name[len("package://"):].split("/", 1) if name.startswith("package://") else ("drill_rig_sim", os.path.join(folder, name))
    try:
        return os.path.join(rospkg.RosPack().get_path(package), file)
    except rospkg.ResourceNotFound:
        raise Refused("%s: there is neither such a file nor the package %s, needed: a path, package://PACKAGE/FILE, or a name in %s" % (name, package, folder))
