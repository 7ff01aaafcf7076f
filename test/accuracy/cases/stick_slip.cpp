// SPDX-License-Identifier: BSD-3-Clause
// Stick-slip: one degree of freedom against its closed form.
#include <algorithm>
#include <cmath>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "groups.h"
#include "report.h"
#include "test_scenes.h"

namespace drill_rig_sim
{
namespace
{
/// A string without mass, stiffness k, under a top drive that turns at w_0 whatever the torque; at its end a body of inertia J
/// whose friction falls by D at once when it slips. With w_n = sqrt(k/J) and y = w_n D/k:
///   peak = w_0 + sqrt(w_0^2 + y^2), slip = 2 (pi - atan(y/w_0))/w_n, stick = 2 D/(k w_0).
struct OneDegree
{
  double stiffness = 473.0;   ///< k [N m/rad]
  double inertia = 374.0;     ///< J [kg m2]
  double drop = 2000.0;       ///< D [N m]
  double speed = 50.0 * rpm;  ///< w_0 [rad/s]
  double frequency() const { return std::sqrt(stiffness / inertia); }
  double rise() const { return frequency() * drop / stiffness; }
  double peak() const { return speed + std::hypot(speed, rise()); }
  double slip_time() const { return 2.0 * (pi - std::atan(rise() / speed)) / frequency(); }
  double stick_time() const { return 2.0 * drop / (stiffness * speed); }
};

struct Cycle
{
  double peak = 0.0, slip_time = 0.0, stick_time = 0.0;
};

/// The bit is the body, a bulky one on hard bottom: its bristle is then so stiff (7e8 N m/rad) that BDF2 damps the ringing of the
/// stuck bit on it within a few steps. The string carries more of the bit than the bottom does, so it stays in tension.
Scene one_degree_scene(const OneDegree& c, double stribeck_speed, double step)
{
  const double radius = 1.5, weight = 800.0, length = 2000.0;
  Scene scene = without_damping(vertical_scene(length - 20.0, length - 20.0));
  scene.well.sections = {{length, 4.0, 0.0}};
  scene.formation[0].drillability = 0.0;
  PartSpec bit = bit_part(2.0 * radius, c.inertia / (0.4 * radius * radius));
  bit.bit->torque.kinetic_friction = 5.0;
  bit.bit->torque.static_friction = bit.bit->torque.kinetic_friction + c.drop * 3.0 / (weight * bit.bit->diameter);
  bit.bit->torque.speed = stribeck_speed;
  PartSpec pipe = pipe_part(0, 1e5, 0.01, pipe_outer);
  const double moment = pi / 32.0 * (std::pow(pipe_outer, 4) - std::pow(pipe_inner, 4));
  pipe.young_modulus = 2.6 * c.stiffness * (length - radius) / moment;
  scene.string = {bit, pipe};
  scene.start.weight_on_bit = weight;
  TopDriveSpec& drive = scene.rig.top_drive;
  drive.proportional_gain = drive.meter_stiffness = 1e9;
  drive.integral_gain = 0.0;
  drive.max_torque = drive.max_power = 1e15;
  scene.numerics.element_length = 250.0;  // a turn of the string of some 2 rev: less than half a turn in an element
  scene.numerics.step = step;
  return scene;
}

/// Times and peak of the last slip, and the stick before it, in 60 s. A slip begins and ends where its speed, seen as straight
/// between 0.05 and 0.1 rad/s, is zero: below, the stuck bit rings on its bristle.
Cycle measured(const OneDegree& c, double stribeck_speed, double step)
{
  RigAtRest rig = build_at_rest(one_degree_scene(c, stribeck_speed, step));
  Stepper stepper(rig.model, find_method(IntegratorKind::bdf2));
  stepper.limits().tolerance = 1e-11;
  Setpoints turn;
  turn.top_drive.speed = c.speed;

  Cycle cycle;
  const double low = 0.05, high = 0.1;
  double before = 0.0, start = 0.0, stop = 0.0, passed_low = 0.0, passed_high = 0.0, peak = 0.0;
  int slips = 0;
  while (rig.state.time < 60.0)
  {
    if (!stepper.advance(rig.state, step, turn)) return {};
    const double now = rig.state.nodes[0].rate.spin;
    auto time_of = [&](double speed) { return rig.state.time - step * (now - speed) / (now - before); };
    if (before < low && now >= low) passed_low = time_of(low);
    if (before < high && now >= high)
    {
      start = passed_low - (time_of(high) - passed_low);
      if (slips++ > 0) cycle.stick_time = start - stop;
      peak = 0.0;
    }
    peak = std::max(peak, now);
    if (before >= high && now < high) passed_high = time_of(high);
    if (before >= low && now < low)
    {
      stop = 2.0 * time_of(low) - passed_high;
      cycle.slip_time = stop - start;
      cycle.peak = peak;
    }
    before = now;
  }
  return cycle;
}

/// The simulator's friction falls from static to kinetic over a Stribeck speed N_s; the closed form's at once. As N_s falls to 0
/// the peak comes down to it: 1.1, 0.6, 0.3, 0.14, 0.05 % above at N_s = 0.04, 0.02, ... 0.0025 rad/s, the same at steps of 1, 2
/// and 4 ms. (It does so only while the bristle's own creep under the winding string, k w_0 / 7e8 = 4e-6 rad/s, is slow against
/// N_s.)
void one_degree(Report& report)
{
  const OneDegree c;
  const Cycle ours = measured(c, 0.0025, 0.002);
  const char* const source = "closed form: friction that drops at once; ours over 0.0025 rad/s";
  report.add({"stick-slip of one degree: peak [rpm]", ours.peak / rpm, c.peak() / rpm, 0.01, source});
  report.add({"stick-slip of one degree: slip [s]", ours.slip_time, c.slip_time(), 0.01, source});
  report.add({"stick-slip of one degree: stick [s]", ours.stick_time, c.stick_time(), 0.01, source});
}
}  // namespace

void stick_slip_cases(Report& report)
{
  one_degree(report);
}

}  // namespace drill_rig_sim
