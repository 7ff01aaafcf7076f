// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_NUMBERED_FRAME_H
#define DRILL_RIG_SIM_TEST_NUMBERED_FRAME_H

#include <string>

#include "drill_rig_sim/realtime/frame_output.h"

/// A frame whose every number is another one, so that whatever takes the place of something else shows.
namespace drill_rig_sim
{
/// base + 1 .. base + 16, no flag set.
inline void number_signals(RigSignals& s, double base)
{
  s.time = base;
  s.hook_load = base + 1;
  s.dead_line_hook_load = base + 2;
  s.hook_load_string = base + 3;
  s.block_height = base + 4;
  s.block_velocity = base + 5;
  s.top_drive_angle = base + 6;
  s.top_drive_speed = base + 7;
  s.torque = base + 8;
  s.stand_pipe_pressure = base + 9;
  s.differential_pressure = base + 10;
  s.flow = base + 11;
  s.hole_depth = base + 12;
  s.bit_depth = base + 13;
  s.surface_wob = base + 14;
  s.rop = base + 15;
  s.ecd = base + 16;
  s.encoder_bit_depth = base + 21;
  s.flow_line_temperature = base + 22;
  s.stroke_rate = base + 17;
  s.pump_strokes = static_cast<unsigned>(base) + 18;
  s.floor_height = base + 19;
  s.floor_velocity = base + 20;
}

inline void number_bit(Truth& t)
{
  t.bit_position = {201.0, 202.0, 203.0};
  t.bit_orientation = Eigen::Quaterniond(2.0, 0.4, -0.6, 0.8);  // w, x, y, z: length sqrt(4 + 0.16 + 0.36 + 0.64) = sqrt(5.16)
  t.bit_velocity = {211.0, 212.0, 213.0};
  t.bit_angular_velocity = {221.0, 222.0, 223.0};
  t.bit_force = {231.0, 232.0, 233.0};
  t.bit_moment = {241.0, 242.0, 243.0};
  t.wob = 251.0;
  t.bit_torque = 252.0;
  t.bit_speed = 253.0;
}

inline FrameRecord numbered_record()
{
  FrameRecord f;
  f.stamp = 12'345'678'901;  // 12.345678901 s
  number_signals(f.truth, 100.0);
  number_bit(f.truth);
  number_signals(f.readings, 300.0);
  f.truth.setpoints.winch = {401.0, false};
  f.truth.setpoints.top_drive = {TopDriveMode::torque, 402.0, 403.0, 404.0, 405.0, false, 407.0, 408.0};
  f.truth.setpoints.pump.flow = 406.0;
  f.readings.setpoints = f.truth.setpoints;
  f.readings.mwd = {7, 298.5, 501.0, 502.0, 503.0};           // measured 1.5 s before the frame
  f.readings.toolface = {9, 299.25, 511.0, false};            // 0.75 s before it
  f.readings.inclination = {11, 300.0 - 1.25, 521.0, 522.0};  // 1.25 s before it
  f.readings.dynamics = {13,    300.0 - 2.25, 531.0, 532.0, 533.0, 534.0, 535.0,
                         536.0, 537.0,        538.0, 539.0, 540.0, 541.0};  // 2.25 s before it
  f.readings.lost_gauges = 5;
  f.commands.last = 9'000'000'009;
  f.commands.accepted = {7'000'000'007, 8'000'000'008, 9'000'000'009};
  return f;
}

/// One axis of hole with three string nodes; the second lies off the axis.
inline FrameOutput numbered_output()
{
  FrameOutput s;
  s.frame = numbered_record();
  s.profile.md = {601.0, 602.0, 603.0};
  s.profile.from_bit = {611.0, 612.0, 613.0};
  s.profile.position = {{1.0, 2.0, -100.0}, {4.5, 5.0, -90.0}, {7.0, 8.0, -80.0}};
  s.profile.tension = {621.0, 622.0, 623.0};
  s.profile.true_axial_force = {631.0, 632.0, 633.0};
  s.profile.torque = {641.0, 642.0, 643.0};
  s.profile.bending_moment = {651.0, 652.0, 653.0};
  s.profile.contact_force = {0.0, 2000.0, 0.0};
  s.profile.contact_vector = {{0.0, 0.0, 0.0}, {-2000.0, 100.0, 300.0}, {0.0, 0.0, 0.0}};
  s.profile.contact_side = {671.0, 672.0, 673.0};
  s.profile.spin_speed = {681.0, 682.0, 683.0};
  s.profile.radius = {0.1, 0.06, 0.07};
  s.profile.bending_stress = {691.0, 692.0, 693.0};
  s.profile.buckling = {0.701, 0.702, 0.703};
  s.profile.guided = {0, 0, 1};
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  s.axis = {{601.0, {1.0, 2.0, -100.0}, down, 0.11, 0.2},
            {602.0, {4.0, 5.0, -90.0}, down, 0.12, 0.2},
            {603.0, {7.0, 8.0, -80.0}, down, 0.13, 0.2}};
  return s;
}

}  // namespace drill_rig_sim

#endif
