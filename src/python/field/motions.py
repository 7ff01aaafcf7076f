# SPDX-License-Identifier: BSD-3-Clause
"""What the scene's gauges show of a string in one of the motions of a table of weights, by statics."""
import math

from drill_rig_sim.lockstep import Refused

# columns of a table: the signal, what drill static calls the motion, and which of the static loads; of the empty block, while the string is in the slips, its way
MOTIONS = {"pick_up": ("hook_load", "up", "hook_load_gauge"), "slack_off": ("hook_load", "down", "hook_load_gauge"), "rotating": ("hook_load", "rotate", "hook_load_gauge"),
           "rotating_up": ("hook_load", "up", "hook_load_gauge"), "rotating_down": ("hook_load", "down", "hook_load_gauge"),
           "rotating_after_up": ("hook_load", "rotate", "hook_load_gauge_after_up"), "rotating_after_down": ("hook_load", "rotate", "hook_load_gauge_after_down"),
           "torque": ("torque", "rotate", "torque"), "slips_up": ("hook_load", None, 1), "slips_down": ("hook_load", None, -1)}
# columns that say how the string and the mud move and how much pipe hangs above the table, and signals of a record that are like them
WAYS = {"speed": "block_velocity", "rotation": "top_drive_speed", "flow": "flow", "block_height": "block_height"}
ALONG = {"up": 1.0, "down": -1.0}
TURNED = ("rotating_up", "rotating_down")  # by the ratio of speed and rotation, along the hole or about it
STANDS = 1e-3   # speed of a block that counts as standing while the string turns [m/s]
USUAL = 0.2     # of a block, by which the drag of the mud is estimated where no speed is known [m/s]
MATTERS = 0.1   # of the friction that a string has, from which on that drag is reported


def shown(scene, column, speed=math.nan, rotation=math.nan, flow=math.nan):
    """What the gauge of hook load or torque shows in a motion; Refused where there is no equilibrium. Of the block's `speed` [m/s], `rotation` [rad/s] and `flow` [m3/s]
    any may be unknown, nan: without a speed, or of what turns without a rotation, the mud has no drag on the string. TURNED need both."""
    from drill_rig_sim.sim import empty_block, static
    _, motion, which = MOTIONS[column]
    if motion is None:
        return empty_block(scene, which)
    if column in TURNED and not (abs(speed) > 0.0 and abs(rotation) > 0.0):
        raise Refused("%s: the friction depends on speed and rotation, and one of them is not known" % column)
    speed, rotation, flow = (0.0 if math.isnan(number) else number for number in (speed, abs(rotation), flow))
    if motion == "rotate":
        way = {"speed": speed if abs(speed) > STANDS else 0.0, "rotation": rotation} if rotation else {"motion": motion}
    else:
        way = {"speed": ALONG[motion] * abs(speed), "rotation": rotation} if speed else {"motion": motion}
    return static(scene, **way, flow=max(flow, 0.0))[which]


def drag_of_unknown_speeds(scene):
    """A line on pick-up and slack-off weights without a speed, where the drag of the scene's mud would matter at a usual one; none else, and none where there is no equilibrium."""
    from drill_rig_sim.sim import static
    try:
        up, down, in_mud = (static(scene, **way)["hook_load_string"] for way in ({"motion": "up"}, {"motion": "down"}, {"speed": USUAL}))
    except Refused:
        return []
    drag, friction = in_mud - up, 0.5 * (up - down)
    return ["pick_up, slack_off: the speed of the block is not known, and the drag of the mud counts as friction: at %g m/s it is %.3g kN, beside %.3g kN of friction; "
            "needed: a column speed, as in speed (m/s)" % (USUAL, 1e-3 * drag, 1e-3 * friction)] if drag > MATTERS * friction else []
