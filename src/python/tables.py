# SPDX-License-Identifier: BSD-3-Clause
"""The lists of signals, top-drive modes, gauges and faults of include/drill_rig_sim, as `drill reference --of tables.py` prints them."""
import typing


class Signal(typing.NamedTuple):
    name: str      # of the column of drill run --csv
    of: str        # both, truth, reading or bit
    type: str      # in messages; "": in files only
    field: str     # of RigState, RigTruth or BitTruth
    quantity: str  # of drill_rig_sim.units
    mnemonic: str  # in WITSML files; "": none
    item: int      # in record 01 of WITS level 0; 0: none


SIGNALS = (
    Signal("hook_load", "both", "float64", "hook_load", "force", "HKLD", 14),
    Signal("dead_line_hook_load", "both", "float64", "dead_line_hook_load", "force", "", 0),
    Signal("hook_load_string", "both", "float64", "hook_load_string", "force", "", 0),
    Signal("torque", "both", "float64", "torque", "torque", "TORQUE", 18),
    Signal("stand_pipe_pressure", "both", "float64", "stand_pipe_pressure", "pressure", "SPP", 21),
    Signal("differential_pressure", "both", "float64", "differential_pressure", "pressure", "DIFP", 0),
    Signal("flow", "both", "float64", "flow", "flow", "FLOWIN", 30),
    Signal("stroke_rate", "both", "float64", "stroke_rate", "strokes", "", 23),
    Signal("pump_strokes", "both", "uint32", "pump_strokes", "number", "", 0),
    Signal("ecd", "both", "float64", "ecd", "density", "", 0),
    Signal("flow_line_temperature", "both", "float64", "flow_line_temperature", "temperature", "", 0),
    Signal("block_height", "both", "float64", "block_height", "length", "BLOCKCOMP", 12),
    Signal("encoder_bit_depth", "both", "float64", "encoder_bit_depth", "length", "", 0),
    Signal("block_velocity", "both", "float64", "block_velocity", "speed", "", 0),
    Signal("floor_height", "both", "float64", "floor_height", "length", "", 0),
    Signal("floor_velocity", "both", "float64", "floor_velocity", "speed", "", 0),
    Signal("top_drive_angle", "both", "float64", "top_drive_angle", "angle", "", 0),
    Signal("top_drive_speed", "both", "float64", "top_drive_speed", "rotation", "SURF_RPM", 20),
    Signal("bit_depth", "both", "float64", "bit_depth", "length", "BITDEP", 8),
    Signal("hole_depth", "both", "float64", "hole_depth", "length", "DMEA", 10),
    Signal("rop", "both", "float64", "rop", "penetration", "ROP", 13),
    Signal("surface_wob", "both", "float64", "surface_wob", "force", "WOB", 16),
    Signal("tared", "both", "bool", "tared", "number", "", 0),
    Signal("on_bottom", "truth", "bool", "on_bottom", "number", "", 0),
    Signal("in_slips", "both", "bool", "in_slips", "number", "", 0),
    Signal("stand_count", "both", "int32", "stand_count", "number", "", 0),
    Signal("brake_set", "both", "bool", "brake_set", "number", "", 0),
    Signal("motor_stalled", "truth", "bool", "motor_stalled", "number", "", 0),
    Signal("winch_limited", "both", "bool", "winch_limited", "number", "", 0),
    Signal("slack_line", "both", "bool", "slack_line", "number", "", 0),
    Signal("stop_reached", "both", "bool", "stop_reached", "number", "", 0),
    Signal("relief_valve_open", "both", "bool", "relief_valve_open", "number", "", 0),
    Signal("over_stress", "truth", "bool", "over_stress", "number", "", 0),
    Signal("over_torque", "truth", "bool", "over_torque", "number", "", 0),
    Signal("buckled", "truth", "bool", "buckled", "number", "", 0),
    Signal("cuttings_volume", "truth", "float64", "cuttings_volume", "volume", "", 0),
    Signal("bed_height", "truth", "float64", "bed_height", "diameter", "", 0),
    Signal("bottom_hole_temperature", "truth", "float64", "bottom_hole_temperature", "temperature", "", 0),
    Signal("accuracy_warning", "both", "bool", "accuracy_warning", "number", "", 0),
    Signal("top_drive_brake_set", "both", "bool", "top_drive_brake_set", "number", "", 0),
    Signal("top_drive_limited", "both", "bool", "top_drive_limited", "number", "", 0),
    Signal("command_clamped", "both", "bool", "command_clamped", "number", "", 0),
    Signal("commands_timed_out", "both", "bool", "commands_timed_out", "number", "", 0),
    Signal("over_pull", "both", "bool", "over_pull", "number", "", 0),
    Signal("pump_tripped", "both", "bool", "pump_tripped", "number", "", 0),
    Signal("drive_tripped", "both", "bool", "drive_tripped", "number", "", 0),
    Signal("lost_gauges", "reading", "uint32", "lost_gauges", "number", "", 0),
    Signal("wob", "bit", "float64", "wob", "force", "", 0),
    Signal("bit_torque", "bit", "float64", "torque", "torque", "", 0),
    Signal("bit_speed", "bit", "float64", "speed", "rotation", "", 0),
    Signal("inclination", "bit", "float64", "inclination", "angle", "", 0),
    Signal("azimuth", "bit", "float64", "azimuth", "angle", "", 0),
    Signal("toolface", "bit", "float64", "toolface", "angle", "", 0),
    Signal("bit_east", "bit", "float64", "position.x", "length", "", 0),
    Signal("bit_north", "bit", "float64", "position.y", "length", "", 0),
    Signal("bit_up", "bit", "float64", "position.z", "length", "", 0),
    Signal("bit_inclination", "bit", "", "", "angle", "", 0),
)
TOP_DRIVE_MODES = (
    "speed",
    "torque",
    "angle",
    "soft_torque",
    "z_torque",
    "oscillate",
    "droop",
)
GAUGES = (
    "hook_load",
    "dead_line_hook_load",
    "torque",
    "stand_pipe_pressure",
    "flow",
    "block_height",
    "encoder_bit_depth",
)
FAULTS = (
    "stuck_pipe",
    "sensor_freeze",
    "sensor_bias",
    "sensor_noise",
    "brake_slip",
    "drive_trip",
    "motor_stall",
    "washed_out_hole",
    "pump_trip",
    "sensor_dropout",
    "sensor_drift",
    "differential_sticking",
    "pack_off",
    "friction_change",
    "formation_change",
    "washed_out_pipe",
)
