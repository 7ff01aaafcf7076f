// SPDX-License-Identifier: BSD-3-Clause
// THE list of the top drive's modes: one row a mode. It has no include guard: it is included once for each thing that is made
// from it.
//
//   MODE(name, goal, brakes, loop, label, meaning)
//
// name     enumerator of TopDriveMode, word of the scene file; in capitals the constant of TopDriveCommand.msg, numbered in this
// order goal     of DriveGoal: what the mode makes for, which says its set points brakes   whether the brake sets itself once the
// drive is there: at a speed of 0, at the angle loop     function of rig/top_drive.cpp that gives the gains of its speed loop
// label    in rviz's panel
// meaning  one line, as msg/README.md has it
//
// Made from it: TopDriveMode and top_drive_modes (rig/setpoints.h), the drive's loops (rig/top_drive.cpp), the words of a
// program, rviz's controls, the table of msg/README.md and the modes of Python (src/python/tables.py). A new mode goes to the
// end, with its loop's function and its constant in msg/TopDriveCommand.msg.
#ifndef MODE
#define MODE(...)
#endif

// NOLINTBEGIN(bugprone-branch-clone): modes may have the same loop
MODE(speed, speed, true, loop_of_speed, "speed", "keeps `speed`; at 0 the brake holds once the shaft stands")
MODE(torque, torque, false, loop_of_speed, "torque", "gives `torque`, as long as the speed stays within the rig's")
MODE(angle, angle, true, loop_of_angle, "angle",
     "turns to `angle` (of `top_drive_angle` in `rig_state`) no faster than `speed` (0 = 10 rpm) and holds it within 0.5 deg by "
     "the "
     "brake: toolfaces in slide drilling")
MODE(soft_torque, speed, false, loop_of_soft_torque, "soft torque",
     "keeps `speed`, but gives way to waves of torque about one frequency, the string's slowest torsion unless the scene says "
     "another: "
     "less stick-slip")
MODE(z_torque, speed, false, loop_of_z_torque, "Z torque",
     "the same over a band of frequencies: the drive hides most of its inertia by the reading of its torque meter")
MODE(oscillate, swing, false, loop_of_angle, "oscillate",
     "rocks from `angle` + `amplitude_right` to `angle` - `amplitude_left` at `speed`, and turns back where the torque limit has "
     "stopped "
     "it: friction falls in slide drilling. Refused with both amplitudes 0")
MODE(droop, speed, false, loop_of_droop, "droop",
     "keeps `speed` less torque / `proportional_gain`: the loop without its integral, so that the drive slows down under load")

// NOLINTEND(bugprone-branch-clone)
#undef MODE
