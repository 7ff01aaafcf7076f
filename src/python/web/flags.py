# SPDX-License-Identifier: BSD-3-Clause
"""What a flag means to a driller, and its rank: red is latched until it is acknowledged. Written by test/tool/test_tables.py from the table of
src/rviz/console/flags.cpp."""
FLAGS = {
    "over_pull": ("red", "Over-pull: brake set until a command that does not raise"),
    "slack_line": ("red", "Slack line: the lines carry nothing"),
    "over_stress": ("red", "Over-stress: pipe beyond its yield strength"),
    "over_torque": ("red", "Over-torque: beyond a connection's make-up torque"),
    "buckled": ("red", "Buckling: pipe compressed beyond its critical buckling load"),
    "motor_stalled": ("red", "Mud motor stalled"),
    "relief_valve_open": ("red", "Relief valve open: part of the flow goes back"),
    "pump_tripped": ("red", "Pump tripped: no flow until a flow of 0 is commanded"),
    "drive_tripped": ("red", "Top drive tripped: it coasts"),
    "commands_timed_out": ("red", "Commands stopped: brake set, drive coasts"),
    "command_clamped": ("amber", "Command clamped to a limit"),
    "stop_reached": ("amber", "Block at its lowest or highest position"),
    "winch_limited": ("amber", "Winch held back by a limit"),
    "top_drive_limited": ("amber", "Top drive at a limit of torque, speed or power"),
}
