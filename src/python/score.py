# SPDX-License-Identifier: BSD-3-Clause
"""Judges a controller's run: `drill score` as a function. What each score is stands at the function that works it out; SI units but where a
name says otherwise. Needs ROS only for bags.

    from drill_rig_sim.score import score
    scores = score("run.csv", plan="plan.csv", bit_diameter=0.3112, wob=10e3)
    scores["drilling"]["rop_on_bottom_m_h"], scores["left_out"]
"""
import math

import numpy
from drill_rig_sim.companion import companion_run
from drill_rig_sim.score_runs import FLAGS, Run, read_run
from drill_rig_sim.spans import spans
from drill_rig_sim.survey import Survey, angle_between, direction, read_survey

ON_BOTTOM = 0.01        # so near to the hole's bottom the bit counts as on it [m]
WINDOW = 10.0           # of the stick-slip index, and of the mean that distinguishes sliding from turning [s]
LEAST_ROP = 5e-5       # mean on bottom from which on something is drilled, 0.18 m/h [m/s]
SLIDING = 0.105         # slower than this mean of the top drive the string slides, 1 rpm [rad/s]
TURNING = 0.5           # windows whose mean bit speed is below this have no stick-slip index [rad/s]
STATIONS = 10.0         # between the stations whose doglegs are added up [m]
LEAST = 1.0             # hole that doglegs need [m]
RESET = 1e-3            # shallower by that in a row: another hole [m]
PATH_SPACING = 0.5      # between the points of the hole that are held against the plan [m]


def score(run, plan=None, bit_diameter=None, wob=None, wob_band=None, toolface=None, toolface_band=None, namespace=None):
    """Judges a run: a file of drill run --csv, a bag, or a Run. `plan`: a survey's file, or a Survey. `bit_diameter` [m]: for the specific
    energy. `wob` +- `wob_band` [N] (a tenth of it) and `toolface` +- `toolface_band` [rad] (15 deg): set points, for the share of time near them.
    Returns a dictionary of dictionaries; what cannot be determined is None, and `left_out` says why. `companion`: the same of the run's companion, None
    without one: how far the two are apart says how much a score depends on the numerics."""
    run = run if isinstance(run, Run) else read_run(run, namespace)
    plan = read_survey(plan, plan=True) if isinstance(plan, str) else plan
    asked = (plan, bit_diameter, wob, 0.1 * wob if wob is not None and wob_band is None else wob_band, toolface,
             math.radians(15.0) if toolface_band is None else toolface_band)
    scores = scores_of(run, *asked)
    companion = companion_run(run, scores["left_out"])
    scores["companion"] = None if companion is None else scores_of(companion, *asked)
    return scores


def scores_of(run, plan, bit_diameter, wob, wob_band, toolface, toolface_band):
    """As score(), of the run alone."""
    left_out = [run.earlier] if run.earlier else []
    bottom = on_bottom(run)
    drilled = new_hole(run, bottom)
    return {
        "run": run.name, "source": run.source,
        "drilling": drilling(run, bottom, drilled),
        "wob": weight(run, bottom, wob, wob_band, left_out),
        "toolface": tool_direction(run, bottom, toolface, toolface_band, left_out),
        "stick_slip": stick_slip(run, bottom, left_out),
        "connections": connections(run, bottom, left_out),
        "stalls": stalls(run, left_out),
        "limits": {flag: times_of(run, run[flag] > 0.0) for flag in FLAGS if flag in run},
        "energy": specific_energy(run, bottom, drilled, bit_diameter, left_out),
        "path": path(run, drilled, plan, left_out),
        "left_out": left_out}


def on_bottom(run):
    """Rows whose bit is within ON_BOTTOM of the hole's bottom."""
    return run["bit_depth"] >= run["hole_depth"] - ON_BOTTOM


def new_hole(run, bottom):
    """Drilled between a row and the one before [m]; what a reset does to the depth is no drilling."""
    return numpy.where(bottom, numpy.maximum(numpy.diff(run["hole_depth"], prepend=run["hole_depth"][0]), 0.0), 0.0)


def mean_and_deviation(values, weights):
    """Weighted by time."""
    mean = numpy.average(values, weights=weights)
    return float(mean), float(math.sqrt(numpy.average((values - mean)**2, weights=weights)))


def share(rows, weights):
    return float(weights[rows].sum() / weights.sum())


def periods(rows):
    """First and last index of each stretch of rows that are true."""
    return [(begin, end - 1) for begin, end in spans(rows)]


def times_of(run, rows):
    """How often, and how long in all [s]."""
    return {"number": len(periods(rows)), "s": float(run.dt[rows].sum())}


def drilling(run, bottom, drilled):
    """Metres drilled; rates of penetration: metres over the time on bottom, and over all of the run."""
    metres, time, all_time = float(drilled.sum()), float(run.dt[bottom].sum()), float(run.dt.sum())
    return {"duration_s": all_time, "on_bottom_s": time, "drilled_m": metres, "rop_on_bottom_m_h": 3600.0 * metres / time if time > 0.0 else None,
            "rop_m_h": 3600.0 * metres / all_time}


def weight(run, bottom, wanted, band, left_out):
    """Weight on bit [N] on bottom, by time: of the bit in the truth, of the surface in readings. share_in_band: of the time on bottom."""
    if not run.dt[bottom].sum() > 0.0:
        left_out.append("wob: the bit was never on bottom")
        return None
    known = bottom & numpy.isfinite(run["wob"])
    values, weights = run["wob"][known], run.dt[known]
    if not weights.sum() > 0.0:
        left_out.append("wob: surface WOB was never zeroed")
        return None
    if weights.sum() < run.dt[bottom].sum():
        left_out.append("wob: %.1f s on bottom before surface WOB was zeroed" % (run.dt[bottom].sum() - weights.sum()))
    mean, deviation = mean_and_deviation(values, weights)
    scores = {"mean": mean, "deviation": deviation, "least": float(values.min()), "largest": float(values.max())}
    if wanted is not None:
        scores.update(set_point=wanted, band=band, share_in_band=share(numpy.abs(values - wanted) <= band, weights))
    return scores


def sliding_rows(run, bottom):
    """On bottom, with the top drive's mean over 10 s below 1 rpm: rocking is sliding too."""
    angle = numpy.cumsum(run["top_drive_speed"] * run.dt)
    time = run["time"]
    begin = numpy.maximum(numpy.minimum(time - 0.5 * WINDOW, time[-1] - WINDOW), time[0])  # a window about each row, within the run
    end = numpy.minimum(begin + WINDOW, time[-1])
    turned = numpy.interp(end, time, angle) - numpy.interp(begin, time, angle)
    return bottom & (numpy.abs(turned) < SLIDING * (end - begin))


def tool_direction(run, bottom, wanted, band, left_out):
    """The bend's toolface [deg] while sliding. Mean and deviation of directions (Mardia & Jupp, Directional Statistics, 2000): of the resultant
    R of the unit vectors, deviation sqrt(-2 ln R)."""
    if "toolface" not in run:
        left_out.append("toolface: not in this run")
        return None
    sliding = sliding_rows(run, bottom)
    weights, values = run.dt[sliding], run["toolface"][sliding]
    if not weights.sum() > 0.0:
        left_out.append("toolface: the run never slides (on bottom, top drive below 1 rpm)")
        return None
    resultant = numpy.average(numpy.exp(1j * values), weights=weights)
    length = min(abs(resultant), 1.0)
    scores = {"sliding_s": float(weights.sum()), "mean_deg": float(numpy.degrees(numpy.angle(resultant))),
              "deviation_deg": math.degrees(math.sqrt(-2.0 * math.log(length))) if length > 0.0 else None}
    if wanted is not None:
        off = numpy.abs(numpy.angle(numpy.exp(1j * (values - wanted))))
        scores.update(set_point_deg=math.degrees(wanted), band_deg=math.degrees(band), share_in_band=share(off <= band, weights))
    return scores


def stick_slip_windows(run, bottom):
    """Of each 10 s wholly on bottom with a turning bit: when it begins [s], and (largest - least) / (2 mean) of the bit's speed, as tools
    downhole report it: 1 where the bit comes to a stop and turns at twice its mean in between."""
    time, found = run["time"], []
    for begin in numpy.arange(time[0], time[-1] - WINDOW + 1e-9, WINDOW):
        rows = (time > begin + 1e-9) & (time <= begin + WINDOW + 1e-9)
        if not rows.any() or not bottom[rows].all():
            continue
        speed = run["bit_speed"][rows]
        mean = numpy.average(speed, weights=run.dt[rows])
        if mean > TURNING:
            found.append((float(begin), float((speed.max() - speed.min()) / (2.0 * mean))))
    return found


def stick_slip(run, bottom, left_out):
    """Mean and largest of the index over the windows, and the share of windows at 1 or more: full stick-slip."""
    if "bit_speed" not in run:
        left_out.append("stick_slip: the bit's speed is not in this run")
        return None
    if numpy.median(run.dt[1:]) > 0.5:
        left_out.append("stick_slip: rows are %.3g s apart, needed: 0.5 s at most" % numpy.median(run.dt[1:]))
        return None
    indices = numpy.array([index for _, index in stick_slip_windows(run, bottom)])
    if not len(indices):
        left_out.append("stick_slip: no window of 10 s on bottom with a turning bit")
        return None
    return {"windows": len(indices), "mean": float(indices.mean()), "largest": float(indices.max()), "share_at_1": float((indices >= 1.0).mean())}


def connections(run, bottom, left_out):
    """Connections: how many times in slips, mean time there, and from weight to weight: from the last row on bottom to the first again [s]."""
    if "in_slips" not in run:
        left_out.append("connections: in_slips is not in this run")
        return None
    stretches = periods(run["in_slips"] > 0.0)
    in_slips = [float(run.dt[first:last + 1].sum()) for first, last in stretches]
    weights = []
    for first, last in stretches:
        before, after = numpy.flatnonzero(bottom[:first]), numpy.flatnonzero(bottom[last + 1:])
        if len(before) and len(after):
            weights.append(float(run["time"][last + 1 + after[0]] - run["time"][before[-1]]))
    return {"number": len(stretches), "in_slips_s": float(numpy.mean(in_slips)) if in_slips else None,
            "weight_to_weight_s": float(numpy.mean(weights)) if weights else None}


def stalls(run, left_out):
    """Of the mud motor: how often, and how long in all."""
    if "motor_stalled" not in run:
        left_out.append("stalls: motor_stalled is not in this run: it is truth, not a reading")
        return None
    return times_of(run, run["motor_stalled"] > 0.0)


def specific_energy(run, bottom, drilled, bit_diameter, left_out):
    """Mechanical specific energy (Teale 1965), E = F/A + 2 pi N T / (A ROP), as work over volume: (sum of F dh + sum of T w dt) / (A h). F, T, w:
    of the bit, mud motor included, in the truth; surface WOB, torque and top drive in readings."""
    if bit_diameter is None:
        left_out.append("energy: needs the bit's diameter")
        return None
    metres = float(drilled.sum())
    if not metres > 0.0:
        left_out.append("energy: nothing was drilled")
        return None
    if metres < LEAST_ROP * float(run.dt[bottom].sum()):
        left_out.append("energy: less than 0.18 m/h was drilled on bottom")
        return None
    if numpy.isnan(run["wob"][drilled > 0.0]).any():
        left_out.append("energy: surface WOB was not zeroed in all of the drilling")
        return None
    at_bit = "bit_torque" in run and "bit_speed" in run
    torque, speed = (run["bit_torque"], run["bit_speed"]) if at_bit else (run["torque"], run["top_drive_speed"])
    area = 0.25 * math.pi * bit_diameter**2
    push, turn = float((run["wob"] * drilled)[drilled > 0.0].sum()), float((torque * speed * run.dt)[bottom].sum())
    return {"at": "bit" if at_bit else "surface", "mse_mpa": 1e-6 * (push + turn) / (area * metres), "thrust_share": push / (push + turn)}


def stations(run, drilled):
    """Measured depths [m] and tangents of the hole every STATIONS of what was drilled, its end included; of the surveys where the run has
    no hole. None where that is less than LEAST."""
    if "inclination" in run and "azimuth" in run:
        rows = numpy.flatnonzero(drilled > 0.0)
        depth = run["hole_depth"][rows]
        if not len(rows) or depth[-1] - depth[0] <= LEAST:  # between two stations
            return None
        wanted = numpy.append(numpy.arange(depth[0], depth[-1] - LEAST, STATIONS), depth[-1])
        picked = rows[numpy.minimum(numpy.searchsorted(depth, wanted), len(rows) - 1)]
        return run["hole_depth"][picked], direction(run["inclination"][picked], run["azimuth"][picked])
    surveys = []
    for row in run.surveys:
        if not surveys or row[0] >= surveys[-1][0] + LEAST:
            surveys.append(row)
    if len(surveys) < 2:
        return None
    md, inclination, azimuth = numpy.array(surveys).T
    return md, direction(inclination, azimuth)


def path(run, drilled, plan, left_out):
    """Doglegs of the hole [deg/30 m] between stations 10 m apart (or its surveys): mean and largest. tortuosity: the sum of the hole's doglegs
    beyond the plan's between the same depths, per 30 m. Distances [m] of the bottom to the nearest place of the plan, every half metre."""
    scores = {"dogleg_mean_deg_30m": None, "dogleg_largest_deg_30m": None, "tortuosity_deg_30m": None, "distance_mean_m": None,
              "distance_largest_m": None, "distance_end_m": None}
    if is_reset(run):
        left_out.append("path: the hole became shallower by a reset, so it is not one hole")
        return scores
    found = stations(run, drilled)
    if found is None:
        left_out.append("path: needs %g m of new hole, or two surveys" % LEAST)
        return scores
    md, tangents = found
    doglegs, lengths = numpy.degrees(angle_between(tangents[:-1], tangents[1:])), numpy.diff(md)
    scores["dogleg_mean_deg_30m"] = float(30.0 * doglegs.sum() / lengths.sum())
    scores["dogleg_largest_deg_30m"] = float((30.0 * doglegs / lengths).max())
    if plan is None:
        left_out.append("path: tortuosity and distance need a plan")
        return scores
    if md[0] < plan.md[0] or md[-1] > plan.md[-1]:
        left_out.append("path: tortuosity and distance: the hole from %.1f to %.1f m is not all within the plan's %g to %g m" %
                        (md[0], md[-1], plan.md[0], plan.md[-1]))
        return scores
    planned = numpy.array([plan.at(depth)[1] for depth in md])
    planned_doglegs = numpy.degrees(angle_between(planned[:-1], planned[1:]))
    scores["tortuosity_deg_30m"] = float(30.0 * (doglegs.sum() - planned_doglegs.sum()) / lengths.sum())
    scores.update(distances(run, drilled, plan, left_out))
    return scores


def is_reset(run):
    """Whether the hole ever became shallower, by more than a correction of its path could take off."""
    return bool((numpy.diff(run["hole_depth"]) < -RESET).any())


def distances(run, drilled, plan, left_out):
    points = bottom_points(run, drilled)
    if points is None:
        left_out.append("path: distance: the position of the bit is not in this run")
        return {}
    off = plan.distances(points)
    return {"distance_mean_m": float(off.mean()), "distance_largest_m": float(off.max()), "distance_end_m": float(off[-1])}


def bottom_points(run, drilled):
    """Where the bit was, every PATH_SPACING of new hole and at its end; None where the run does not say, and for no single hole."""
    rows = numpy.flatnonzero(drilled > 0.0)
    if "bit_east" not in run or not len(rows) or is_reset(run):
        return None
    depth = run["hole_depth"][rows]
    picked = rows[numpy.searchsorted(depth, numpy.arange(depth[0], depth[-1], PATH_SPACING))]
    picked = numpy.append(picked, rows[-1])
    return numpy.stack([run["bit_east"][picked], run["bit_north"][picked], run["bit_up"][picked]], axis=-1)


__all__ = ["Run", "Survey", "read_run", "read_survey", "score"]
