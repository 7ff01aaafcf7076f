# SPDX-License-Identifier: BSD-3-Clause
"""A rig in this process, without ROS: what drill_rig_sim.rig is to a node, under the same names.

    from drill_rig_sim.sim import Simulator

    rig = Simulator("quick.yaml")
    rig.rotate(rpm=90)
    rig.winch(-0.01)
    rig.step_until(lambda s: s.truth.on_bottom, timeout=300)
    run = rig.record(60.0)                  # numpy: run.t, run.readings["hook_load"], run.truth["winch.brake"], run.bit["wob"]

Readings, truth and bit are bit for bit those of a node that runs the same scene at the same rate. Beside a rig's: record().
"""
import os
import typing

import numpy
from drill_rig_sim import _sim
from drill_rig_sim.lockstep import RPM, UNSENSED, Failed, Lockstep, Refused, State, TimedOut, series, yaml_of, zero_of  # pylint: disable=unused-import
from drill_rig_sim.text_file import report

COMMANDS = {"winch": _sim.Winch, "top_drive": _sim.TopDrive, "mud_pump": _sim.MudPump, "steering": _sim.Steering}
MOST_FRAMES = 100000  # of one call into the simulator


def build():
    """The linker's hash of the library, in hexadecimal digits."""
    return _sim.build()


def units():
    """Units that numbers of scenes, surveys and records may have, by quantity and spelling: how many SI units one of each is. units()["pressure"]["psi"]: 6894.757..."""
    return _sim.units()


def static(scene, motion="none", speed=0.0, rotation=0.0, flow=0.0):
    """Loads of the string as it hangs at a scene's start, by name, as drill static prints them [N], [N m]; `hook_load_gauge` as the scene's gauge
    shows it while the block moves; after a way up or down of a block that stands again `hook_load_gauge_after_up`, `hook_load_gauge_after_down`. motion: none (without friction), up, down or rotate;
    or `speed`, + up [m/s], and `rotation` [rad/s], with the drag of the mud at these. flow: of the pump [m3/s]. `annulus_pressure`: at the bit, above the mud's at rest [Pa]."""
    return _sim.static_loads(found(scene, "config/scenes"), motion, speed, rotation, flow)


def empty_block(scene, direction=0):
    """What the scene's gauge of the hook load shows with the string in the slips, without the gauge's errors and the friction of the block's rail [N].
    direction: of the block, 1 up, -1 down, 0: it stands, without that of the sheaves too."""
    return _sim.empty_block(found(scene, "config/scenes"), direction)


def plain_scene(scene):
    """Text of a scene that needs no other file: numbers only in SI units, the survey's stations in it, keys that have their defaults left out."""
    return _sim.plain_scene(found(scene, "config/scenes"))


class Record(typing.NamedTuple):
    """Of many frames, a row each: fields of RigState, RigTruth and BitTruth by their names, those of a set point as "winch.brake". As drill score takes a run
    (drill_rig_sim.score_runs.run_of_record)."""
    t: numpy.ndarray  # [s]
    readings: numpy.ndarray
    truth: numpy.ndarray
    bit: numpy.ndarray


class Simulator(Lockstep):
    """The rig of a scene's file: a name in the package's config/scenes, package://PACKAGE/FILE, or a path. `rate`: frames a second. `play_program`: the scene's program
    and operations give the set points until a caller does. Time begins at 0 with every reset; snapshots bring back theirs. One thread at a time."""

    def __init__(self, scene, rate=100.0, seed=0, play_program=False):
        require_whole("seed", seed, 0, 9000000000000000)  # as ~seed of a node
        self._rig = _sim.Rig(found(scene, "config/scenes"), rate, seed, play_program)
        self.rate = rate
        self._saved = {}
        self._telemetry = {"toolface": None, "survey": None, "inclination": None, "dynamics": None}
        report(self._rig.remarks())
        self._begin()

    @property
    def kernel(self):
        """Of the batch kernels. The same scene gives the same bits only by the same build() and kernel."""
        return self._rig.kernel()

    @property
    def joint_length(self):
        """Of a joint of the pipe that connection() adds and takes away [m]."""
        return self._rig.joint_length()

    @property
    def crew_connects(self):
        """Whether the scene's crew makes connections of its own (connections: auto)."""
        return self._rig.crew_connects()

    @property
    def drum_height(self):
        """Where the block would hang on lines without load [m]: what the drum has done, without what the load stretches."""
        return self._rig.drum_height()

    def drum_heights(self, heights, hook_loads):
        """The same of other times, by heights of the block without noise [m] and by what a gauge like the scene's showed of the hook load [N]; arrays."""
        return numpy.array(self._rig.drum_heights(list(map(float, heights)), list(map(float, hook_loads))))

    @property
    def wave_impedance(self):
        """Force over speed of a wave along the pipe at the string's top [N s/m]."""
        return self._rig.wave_impedance()

    @property
    def block_mass(self):
        """Of travelling block, hook and top drive [kg]."""
        return self._rig.block_mass()

    @property
    def crown_height(self):
        """Of the crown block above the rotary table [m]."""
        return self._rig.crown_height()

    @property
    def block_acceleration(self):
        """The largest of the block [m/s2]."""
        return self._rig.block_acceleration()

    @property
    def limits(self):
        """By signal, the largest that the rig can do: top_drive_speed [rad/s] and flow [m3/s]."""
        return {"top_drive_speed": self._rig.max_rotation(), "flow": self._rig.max_flow()}

    @property
    def accuracy_warning(self):
        """Why the last frame's numbers may be wrong, in one line; "" without a reason."""
        return self._rig.accuracy_warning()

    @property
    def accuracy_code(self):
        """Its short identifier, which stays the same in later versions (msg/README.md lists them); "" without a reason."""
        return self._rig.accuracy_code()

    @property
    def active_faults(self):
        """The faults under way, by their words in scenes, those of gauges as "sensor_bias of hook_load"."""
        return self._rig.active_faults()

    @property
    def measured_errors(self):
        """By output, named as drill run's columns, the error over the last 3 s that the companion measures (numerics.companion), as a share of the output's range;
        empty while nothing is measured."""
        return self._rig.measured_errors()

    @property
    def not_measured(self):
        """Why the error is not measured, in one line; "" while it is."""
        return self._rig.not_measured()

    # --- beside finer models

    def verify(self, times=2.0):
        """Before the first frame: two finer models go along from now on, with elements and steps `times` and `times` squared as short. A frame then costs some ten times
        as much; what it shows stays the same. Until another scene, well or start; nothing is restored meanwhile."""
        self._rig.verify(times)

    def verified(self):
        """How far the run is off by these so far, a dictionary as `drill verify --json` writes it: `verdict` (right, warned, unknown, or missed: wrong without a warning)
        and `outputs`, by the names of drill run's columns; errors as shares of an output's range."""
        return self._rig.verified()

    # --- what downhole tools sent up, for drill_rig_sim.control.drive(rig, law, timeout, telemetry=rig)

    @property
    def toolface(self):
        """The last that came up, fields of MwdToolface and the time `t` of measurement [s]; None before."""
        return self._last("toolface", self._rig.toolface())

    @property
    def survey(self):
        """The last that came up, fields of MwdSurvey and the time `t` of measurement [s]; None before."""
        return self._last("survey", self._rig.survey())

    @property
    def inclination(self):
        """The last between surveys that came up (instruments.mwd.inclination_period), fields of MwdInclination and the time `t` of measurement [s]; None before."""
        return self._last("inclination", self._rig.inclination())

    @property
    def dynamics(self):
        """The last of the tool of dynamics that came up (instruments.dynamics), fields of DownholeDynamics and the time `t` of its interval's end [s]; None before."""
        return self._last("dynamics", self._rig.dynamics())

    # --- time

    def record(self, seconds, every=1):
        """Steps through `seconds` and keeps each `every`-th frame and the last: a Record."""
        require_whole("every", every, 1, MOST_FRAMES)
        frames, recorder = self._frames_in(seconds), _sim.Recorder()
        self._hand_over()
        try:
            while frames > 0:
                part = min(frames, MOST_FRAMES - MOST_FRAMES % max(every, 1))
                recorder.record(self._rig, part, every)
                frames -= part
        except Failed as failure:
            failure.record = record_of(*recorder.arrays())
            raise
        finally:
            self._look()
        return record_of(*recorder.arrays())

    # --- services

    def reset(self, scene="", bit_depth=0.0):
        """Back to the start of a scene file, by default of the present one; the state there. Set points are forgotten."""
        self._rig.reset(found(scene, "config/scenes") if scene else "", bit_depth)
        report(self._rig.remarks())
        return self._begin()

    def load_survey(self, file="", md=(), inclination=(), azimuth=(), tie_in_north=0.0, tie_in_east=0.0, tie_in_tvd=0.0, hole_depth=0.0, bit_depth=0.0,
                    columns="", pass_over=False):
        """A new well, from a file or by the fields of LoadSurvey; the state at its start. Set points are forgotten."""
        path, columns = (found(name, "config/surveys") if name else "" for name in (file, columns))
        self._rig.load_survey(path, list(md), list(inclination), list(azimuth), (tie_in_north, tie_in_east, tie_in_tvd), hole_depth, bit_depth, columns,
                              pass_over)
        report(self._rig.remarks())
        return self._begin()

    def tare(self):
        """Zeroes surface WOB and differential pressure, off bottom; the state then."""
        self._rig.tare()
        return self._look()

    def tare_over(self, duration):
        """The same at their means over the last `duration` seconds, 0.5 to 60; what was zeroed, a Zero."""
        zero = zero_of(self._rig.tare_over(duration))
        self._look()
        return zero

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

    def slips(self, are_set=True, connection=None):
        """Hangs the string in the slips, by the joint that is nearest to the rotary table, or takes it from there. `connection`: fields of connection(), for which
        the slips hold the joint that it needs."""
        if are_set and connection is not None:
            self._rig.slips_for(connection.get("joints", 0), connection.get("remove", False))
        else:
            self._rig.slips(are_set)

    def connection(self, joints=0, remove=False):
        """Adds joints of drill pipe, or removes them; 0: a stand."""
        self._rig.connection(joints, remove)

    def operate(self, operations):
        """The driller begins operations, one after the other, as a scene has them: {"do": "trip", "to_depth": 1200}, a list of such, or their YAML. The reading
        operation_number is 0 once all are finished. A set point takes over the rig from them."""
        self._hand_over()
        self._rig.operate(yaml_of(operations))
        return self._look()

    @property
    def given_up(self):
        """Why the operation under way was given up, the block braked; "": it was not."""
        return self._rig.given_up()

    # --- the connection

    def _set(self, kind, **fields):
        try:
            self._set_points[kind] = COMMANDS[kind](**fields)
        except TypeError:
            raise TypeError(why_no_set_point(kind, fields)) from None

    def _hand_over(self):
        if self._set_points:
            set_points, self._set_points = self._set_points, {}
            self._rig.command(*(set_points.get(kind) for kind in COMMANDS))

    def _advance(self, frames):
        self._hand_over()
        try:
            self._rig.advance(frames)
        finally:
            self._look()
        return self.state

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


def record_of(readings, truth, bit):
    return Record(numpy.round(truth["time"], 9), readings, truth, bit)


def require_whole(name, value, least, most):
    if not isinstance(value, (int, numpy.integer)) or not least <= value <= most:
        raise Refused("%s is %s; allowed is %d to %d" % (name, value, least, most))


def why_no_set_point(kind, fields):
    """In one line; the module's own text has several."""
    known = {name: getattr(COMMANDS[kind](), name) for name in dir(COMMANDS[kind]) if not name.startswith("_")}
    for name, value in fields.items():
        if name not in known:
            return "%s: %s is not known; allowed: %s" % (kind, name, ", ".join(known))
        try:
            COMMANDS[kind](**{name: value})
        except TypeError:
            return "%s: %s is %r; allowed is %s" % (kind, name, value, "true or false" if isinstance(known[name], bool) else "a number")
    return "%s: needed is a set point" % kind


def found(name, folder):
    """The file of this name: looked for as the node does, else a path as it is."""
    name = os.fspath(name)
    if os.path.isabs(name):
        return name
    package, file = "drill_rig_sim", os.path.join(folder, name)
    if name.startswith("package://"):
        package, _, file = name[len("package://"):].partition("/")
    elif not file_of(package, file) and os.path.exists(name):
        return name
    path = file_of(package, file)
    if not path:
        raise Refused("%s: there is no such file, allowed: a name in %s, package://PACKAGE/FILE, or a path" % (name, folder))
    return path


def file_of(package, file):
    """A file of a package; "" where there is none."""
    try:
        import rospkg  # not needed for paths
    except ImportError:
        return ""
    try:
        path = os.path.join(rospkg.RosPack().get_path(package), file)
    except rospkg.ResourceNotFound:
        return ""
    return path if os.path.isfile(path) else ""
