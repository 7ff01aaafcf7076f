// SPDX-License-Identifier: BSD-3-Clause
// THE list of a rig's signals: one row a signal. It has no include guard: it is included once for each thing that is made from
// it.
//
// Define macros for the rows that you need and include this file. It undefines them again; rows without a macro are left out.
//
//   BOTH(type, name, dimension, mnemonic, item, meaning, reading)     of the truth and of the readings
//   GAUGE(...)       the same, shown by a gauge: key `instruments.surface.<name>` of the scene, bit of lost_gauges
//   GAUGE_LIKE(...)  the same by a gauge that has the errors of hook_load's key
//   ZEROED(...)      BOTH that counts from a zero set by `tare`: until then an empty cell in files of readings
//   TRUTH(type, name, dimension, meaning)                             no rig can sense it: of the truth only
//   READING(type, name, dimension, meaning, reading)                  of the readings only
//   BIT(name, field, dimension, value, meaning)                       at the bit, of the truth only
//   BIT_FILE(name, dimension, value, meaning)                         the same in files only
//
// GAUGE, GAUGE_LIKE and ZEROED are BOTH where they are not defined.
//
// type             of C++; in messages bool, double, int and unsigned become bool, float64, int32 and uint32
// name             of the field in C++, Python, RigState and RigTruth, of the column in CSV files, of the key in JSON
// dimension        enumerator of Dimension (math/shown_units.h), which gives the SI unit
// mnemonic, item   in WITSML files, and in record 01 of WITS level 0; "" and 0: not sent there
// meaning, reading one line each, as the messages have them; `reading` of a GAUGE is the instrument
// value, field     by a Truth named `t`; of BitTruth.msg
//
// Made from it: RigSignals, Truth, Readings (instruments/signals.h), Gauge and InstrumentsSpec (scene/instruments_spec.h), the
// conversion to messages (ros/conversions.cpp), signal_rows() (instruments/signal_rows.h: CSV, JSON, WITSML), rviz's values
// (rviz/message_values.cpp). After a change write what other languages need, where DRILL is the built program:
// test/tool/test_tables.py DRILL --write writes msg/RigState.msg, msg/RigTruth.msg and src/python/tables.py,
// test/tool/test_readme.py DRILL --write the table of msg/README.md.
#if defined(BOTH) && !defined(GAUGE)
#define GAUGE BOTH
#endif
#if defined(BOTH) && !defined(GAUGE_LIKE)
#define GAUGE_LIKE BOTH
#endif
#if defined(BOTH) && !defined(ZEROED)
#define ZEROED BOTH
#endif
#ifndef BOTH
#define BOTH(...)
#endif
#ifndef GAUGE
#define GAUGE(...)
#endif
#ifndef GAUGE_LIKE
#define GAUGE_LIKE(...)
#endif
#ifndef ZEROED
#define ZEROED(...)
#endif
#ifndef TRUTH
#define TRUTH(...)
#endif
#ifndef READING
#define READING(...)
#endif
#ifndef BIT
#define BIT(...)
#endif
#ifndef BIT_FILE
#define BIT_FILE(...)
#endif

GAUGE(double, hook_load, force, "HKLD", 14,
      "load carried by the lines at the block; block, top drive and friction of their rail included", "load cell")
GAUGE_LIKE(double, dead_line_hook_load, force, "", 0,
           "load of the dead line times the number of lines, friction of the turning sheaves included",
           "load cell at the dead line's anchor")
BOTH(double, hook_load_string, force, "", 0, "hook load without block and top drive", "hook_load less their weight")
GAUGE(double, torque, torque, "TORQUE", 18, "in the torque meter's spring, + drives the string clockwise", "torque meter")
GAUGE(double, stand_pipe_pressure, pressure, "SPP", 21, "in the stand pipe", "pressure gauge")
ZEROED(double, differential_pressure, pressure, "DIFP", 0, "of the mud motor, zeroed by tare",
       "stand_pipe_pressure less its tare, 0 until tared")
GAUGE(double, flow, flow, "FLOWIN", 30, "delivered by the pump", "flow meter")
BOTH(double, stroke_rate, strokes, "", 23, "of the mud pump", "exact: strokes are counted")
BOTH(unsigned, pump_strokes, number, "", 0, "whole strokes of the mud pump since the start", "exact")
BOTH(double, ecd, density, "", 0, "equivalent circulating density at the bit: mud weight with the losses of the annulus",
     "exact, without the delay of telemetry")
BOTH(double, flow_line_temperature, temperature, "", 0, "of the mud that returns; 0 without mud.temperature",
     "exact, by the flow line's thermometer")
GAUGE(double, block_height, length, "BLOCKCOMP", 12, "top-drive shaft above the rotary table",
      "drawworks encoder; bit depth, hole depth and rate of penetration are worked out from it")
GAUGE(double, encoder_bit_depth, length, "", 0, "measured depth of the bit by the length of its string, without the stretch",
      "depth encoder; held while the string is in the slips")
BOTH(double, block_velocity, speed, "", 0, "of the block, + up", "exact, by the drawworks' encoder")
BOTH(double, floor_height, length, "", 0,
     "of the rotary table above its mean place, where the frame rig_floor stays: heave; 0 on the ground",
     "exact, by the rig's motion reference unit")
BOTH(double, floor_velocity, speed, "", 0, "rate of floor_height, + up", "exact")
BOTH(double, top_drive_angle, angle, "", 0, "of the top drive's shaft, clockwise looking downhole, unbounded",
     "exact, by the drive's encoder")
BOTH(double, top_drive_speed, rotation, "SURF_RPM", 20, "of the top drive's shaft, clockwise looking downhole",
     "exact, by the drive's encoder")
BOTH(double, bit_depth, length, "BITDEP", 8, "measured depth of the bit's face",
     "length of the string less block_height; correct at the start; held while the string is in the slips")
BOTH(double, hole_depth, length, "DMEA", 10, "measured depth of the hole's bottom", "largest bit_depth so far")
BOTH(double, rop, penetration, "ROP", 13, "rate of penetration: rate of hole_depth over the frame", "rate over the last 10 s")
ZEROED(double, surface_wob, force, "WOB", 16, "surface weight on bit: tare less hook_load; 0 until tared, and in the slips",
       "by the reading of hook_load")
BOTH(bool, tared, number, "", 0, "surface_wob and differential_pressure have a zero", "exact")
TRUTH(bool, on_bottom, number, "the bit touches the bottom")
BOTH(bool, in_slips, number, "", 0, "the slips are set; they bear what the hook does not", "exact")
BOTH(int, stand_count, number, "", 0, "whole stands of the last part's pipe in the string", "exact")
BOTH(bool, brake_set, number, "", 0, "the drawworks brake is set; it slows the block at the winch's acceleration, then holds it",
     "exact")
TRUTH(bool, motor_stalled, number, "the mud motor's torque is at its stall torque")
BOTH(bool, winch_limited, number, "", 0, "a limit of speed, acceleration, load or height holds the winch back", "exact")
BOTH(bool, slack_line, number, "", 0, "the lines carry nothing", "exact")
BOTH(bool, stop_reached, number, "", 0,
     "the block is at its lowest or highest place: the winch stands there, or the block rests on the stop", "exact")
BOTH(bool, relief_valve_open, number, "", 0, "of the pump: part of its flow goes back to the tanks", "exact")
TRUTH(bool, over_stress, number, "pipe is stressed beyond its yield strength; yielding is not modelled")
TRUTH(bool, over_torque, number, "pipe is twisted beyond the make-up torque of its connections")
TRUTH(bool, buckled, number, "pipe is compressed beyond its buckling load in the hole")
TRUTH(double, cuttings_volume, volume, "of rock in the hole, in the flow and in beds; 0 without mud.cuttings")
TRUTH(double, bed_height, diameter, "largest height of a bed of cuttings along the hole; 0 without mud.cuttings")
TRUTH(double, bottom_hole_temperature, temperature, "of the mud around the bit; 0 without mud.temperature")
BOTH(bool, accuracy_warning, number, "", 0, "the simulation itself may be wrong; the diagnostics give the reason and the remedy",
     "the same")
BOTH(bool, top_drive_brake_set, number, "", 0, "the top drive's brake is on", "exact")
BOTH(bool, top_drive_limited, number, "", 0, "the drive is at a limit of torque, speed or power", "exact")
BOTH(bool, command_clamped, number, "", 0, "the last command was clamped to a limit, or another of the same frame", "exact")
BOTH(bool, commands_timed_out, number, "", 0,
     "the commands of winch or drive stopped: brake set, drive coasts until they come again", "exact")
BOTH(bool, over_pull, number, "", 0, "trip_hook_load was reached: the brake is set until a winch command that does not raise",
     "exact")
BOTH(bool, pump_tripped, number, "", 0, "no flow, by trip_pressure until a flow of 0 is commanded, or by a fault until that ends",
     "exact")
BOTH(bool, drive_tripped, number, "", 0, "the top drive coasts by a fault until that ends", "exact")
READING(unsigned, lost_gauges, number,
        "sum of the constants above of all gauges that have dropped out and repeat their last reading", "exact")
BIT(wob, wob, force, t.wob, "weight on bit: of the rock on its face, >= 0")
BIT(bit_torque, torque, torque, t.bit_torque,
    "of the rock on the bit's face, >= 0 when it resists clockwise turning; the gauge's friction on the wall is not in it")
BIT(bit_speed, speed, rotation, t.bit_speed, "of the bit, a mud motor's included, clockwise looking downhole")
BIT(inclination, inclination, angle, t.bit_inclination, "of the hole at its bottom, from vertical down")
BIT(azimuth, azimuth, angle, t.bit_azimuth, "of the hole at its bottom, clockwise from north, 0 to 2 pi")
BIT(toolface, toolface, angle, t.bend_toolface,
    "of the bend itself, clockwise looking downhole, from the high side or, near vertical, from north")
BIT(bit_east, position.x, length, t.bit_position.x(), "centre of the bit's face, east of the rotary table")
BIT(bit_north, position.y, length, t.bit_position.y(), "centre of the bit's face, north of the rotary table")
BIT(bit_up, position.z, length, t.bit_position.z(), "centre of the bit's face, above the rotary table")
BIT_FILE(bit_inclination, angle, inclination_of(t.bit_orientation* Eigen::Vector3d::UnitX()),
         "of the bit's axis, from vertical down")

#undef BOTH
#undef GAUGE
#undef GAUGE_LIKE
#undef ZEROED
#undef TRUTH
#undef READING
#undef BIT
#undef BIT_FILE
