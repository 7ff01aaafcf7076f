# SPDX-License-Identifier: BSD-3-Clause
"""Signals of a record that cannot be of one rig, as where one of them is in another unit than its map or its header says: what each contradicts is another signal."""
import numpy
from drill_rig_sim.field.idle_signals import idle

MOST_PUMPED = 5e6            # of three pumps of 2200 hp [W]
MOST_TURNED = 2e6            # of the largest top drives [W]
LEAST_SHARE = 0.5            # of the pressure that water loses in the widest drill pipe
WIDEST = 0.152               # inner diameter of 6 5/8 in pipe [m]
WATER, VISCOSITY = 1e3, 1e-3  # [kg/m3], [Pa s]
RUNS = 5e-3                  # of a flow [m3/s]
FULL, FAR_DOWN, LOW = 25e-3, 1500.0, 3e6  # flow of drilling [m3/s] with the bit so deep [m], and a pressure that bit, tools and pipe exceed then [Pa]
SHUT_IN, TRICKLE = 3e6, 1e-3  # pressure that needs a flow [Pa], and less than a pump delivers [m3/s]
SMALLEST = 1.5e-5            # of an opening, half of three nozzles of 4/32 in, that water goes through at the pressure of the stand pipe [m2]
TURNS, IDLE, DEEP = 3.0, 50.0, 300.0  # rotary speed [rad/s] of a string so long [m] that has a larger torque [N m]
LIGHTEST, HEAVIEST, HANGING = 30.0, 1200.0, 1.3e6  # weights of pipe in mud, of a horizontal well's and of 13 5/8 in casing [N/m], and of what hangs above it [N]
FAR = 10.0                   # of the bit above a bottom that gets deeper [m]
GROWS, FASTEST = 0.5, 0.3    # of a hole [m], and a rate at which none is drilled [m/s]
RISES, SLOWEST = 5.0, 2e-3   # of a block [m], and a speed at which none is lifted so far [m/s]


def contradictions(record):
    """Lines, one for each."""
    return pump(record) + (loss(record) or low(record)) + trickle(record) + turning(record) + load(record) + growth(record) + lifting(record) + idle(record)


def both(record, *names):
    """The signals in the rows that hold all of them; None where a signal is missing."""
    if not all(name in record for name in names):
        return None
    values = numpy.array([record.signals[name] for name in names])
    values = values[:, numpy.isfinite(values).all(axis=0)]
    return values if values.shape[1] else None


def pump(record):
    found = both(record, "stand_pipe_pressure", "flow")
    power = 0.0 if found is None else float((found[0] * found[1]).max())
    return ["stand_pipe_pressure and flow: together up to %.3g MW, more than the pumps of a rig have (%g MW); are both units right?" %
            (power / 1e6, MOST_PUMPED / 1e6)] if power > MOST_PUMPED else []


def loss(record):
    """Of water in the widest pipe, by Blasius (1913) for smooth pipes: f = 0.0791/Re^0.25, pressure 2 f rho v^2 L/D. Mud, tool joints, tools and the bit add to it."""
    found = both(record, "stand_pipe_pressure", "flow", "bit_depth")
    if found is None:
        return []
    pressure, flow, depth = found[:, (found[1] > RUNS) & (found[2] > DEEP)]
    if not len(flow):
        return []
    speed = flow / (0.25 * numpy.pi * WIDEST**2)
    least = 2.0 * 0.0791 * (WATER * speed * WIDEST / VISCOSITY)**-0.25 * WATER * speed**2 * depth / WIDEST
    k = int(flow.argmax())
    return ["stand_pipe_pressure: it is usually %.3g kPa at up to %.3g m3/s, less than water loses in the widest drill pipe (%.3g kPa); is its unit right?" %
            (numpy.median(pressure) / 1e3, flow[k], least[k] / 1e3)] if numpy.median(pressure / least) < LEAST_SHARE else []


def low(record):
    found = both(record, "stand_pipe_pressure", "flow", "bit_depth")
    pressure, flow, depth = found[:, (found[1] > FULL) & (found[2] > FAR_DOWN)] if found is not None else numpy.zeros((3, 0))
    return ["stand_pipe_pressure: its largest value is %.3g MPa at up to %.3g m3/s with the bit at %.5g m, less than bit and pipe need; is its unit right?" %
            (pressure.max() / 1e6, flow.max(), depth.max())] if len(pressure) and pressure.max() < LOW else []


def trickle(record):
    found = both(record, "stand_pipe_pressure", "flow")
    if found is None:
        return []
    return narrow(*found) or trickle_at(*found.max(axis=1))


def narrow(pressure, flow):
    """While the pump usually runs: by Bernoulli's equation, the whole pressure spent in the nozzles of a bit."""
    pressure, flow = (values[(flow > 0.5 * flow.max()) & (pressure > SHUT_IN)] for values in (pressure, flow))
    if not len(flow) or flow.max() < TRICKLE or numpy.median(flow * numpy.sqrt(0.5 * WATER / pressure)) > SMALLEST:
        return []
    return ["flow: it is usually %.3g m3/s at %.3g MPa, less than the smallest nozzles of a bit let through; is its unit right?" % (numpy.median(flow), numpy.median(pressure) / 1e6)]


def trickle_at(pressure, flow):
    return ["flow: its largest value is %.3g m3/s while the stand pipe has up to %.3g MPa; is its unit right?" % (flow, pressure / 1e6)] if pressure > SHUT_IN and 0.0 < flow < TRICKLE else []


def turning(record):
    found = both(record, "torque", "top_drive_speed")
    if found is None:
        return []
    torque, power = numpy.abs(found[0]), numpy.abs(found[0] * found[1])
    if power.max() > MOST_TURNED:
        return ["torque and top_drive_speed: together up to %.3g MW, more than top drives have (%g MW); are both units right?" % (power.max() / 1e6, MOST_TURNED / 1e6)]
    depth = largest(record, "bit_depth")
    turned = numpy.abs(found[1]) > TURNS
    return ["torque: its largest value is %.3g N.m while %.4g m of pipe turn; is its unit right?" % (torque.max(), depth)] if turned.any() and depth > DEEP and 0.0 < torque.max() < IDLE else []


def largest(record, name):
    """0 where a record has no such signal."""
    return float(numpy.nanmax(record.signals[name])) if name in record else 0.0


def load(record):
    found = both(record, "hook_load", "bit_depth")
    return [] if found is None else load_at("hook_load", found[0], found[1].max())


def load_at(name, loads, depth):
    """A line on hook loads [N] with the bit at up to a depth [m] that no string has."""
    heavy = loads[loads > 0.5 * loads.max()]
    usual = float(numpy.median(heavy)) if len(heavy) else 0.0
    if depth > DEEP and 0.0 < loads.max() < LIGHTEST * depth:
        return ["%s: its largest value is %.3g kN with the bit at %.5g m, less than so much pipe weighs; is its unit right?" % (name, loads.max() / 1e3, depth)]
    return ["%s: it is usually %.3g kN with the bit at up to %.5g m, more than block and pipe weigh; is its unit right?" % (name, usual / 1e3, depth)] if usual > HANGING + HEAVIEST * depth > HANGING + HEAVIEST * DEEP else []


def growth(record):
    """On a hole that gets deeper while the bit is far above its bottom, or faster than any."""
    if "hole_depth" not in record:
        return []
    good = numpy.isfinite(record.signals["hole_depth"])
    time, hole = record.time[good], record.signals["hole_depth"][good]
    steps, times = numpy.diff(numpy.maximum.accumulate(hole)), numpy.diff(time)  # a depth that varies from row to row does not grow
    grows = numpy.flatnonzero(steps > 0.0)
    if steps.sum() < GROWS:
        return []
    rate = float(numpy.median(steps[grows] / times[grows]))
    lines = ["hole_depth: it usually grows by %.3g m/s, faster than holes are drilled; is the unit of the time right?" % rate] if rate > FASTEST and len(grows) > 2 else []
    above = numpy.median((hole - record.at("bit_depth", time))[1:][grows]) if "bit_depth" in record else 0.0
    return lines + (["hole_depth: it grows while the bit is usually %.4g m above the bottom; are both units right?" % above] if above > FAR and len(grows) > 2 else [])


def lifting(record):
    if "block_height" not in record:
        return []
    good = numpy.isfinite(record.signals["block_height"])
    time, height = record.time[good], record.signals["block_height"][good]
    if len(time) < 2:
        return []
    rise, speed = float((height - numpy.minimum.accumulate(height)).max()), float((numpy.diff(height) / numpy.diff(time)).max())
    return ["block_height: it rises by %.3g m at %.2g m/s at most, slower than blocks are lifted; is the unit of the time right?" % (rise, speed)] if rise > RISES and speed < SLOWEST else []
