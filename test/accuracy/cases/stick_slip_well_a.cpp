// SPDX-License-Identifier: BSD-3-Clause
// Off-bottom stick-slip of a published well: friction along the wall alone stops and frees the string.
//
// Aarsnes and Shor 2018, their synthetic case, as their program computes it (figures by rerunning it):
// - Torque per metre mu w sin(inclination) r: static 0.30 below 1 rad/s, 0.65 of that above; viscous drag 1/6 per second of the
//   momentum (a term of second order in their step of 0.83 ms).
// - The collars' waves run at the pipe's speed although their shear modulus is 67 GPa against 61. So their rotary inertia is
//   67/61 of steel's, and friction on them too: 10228 N m hold the string, of which 9639.5 are mu w sin(inclination) r.
// First, a wave model of our own with that law against the published figures. It shows what they are worth: the cycle is not
// quite periodic, its limits move by some per cent with cell and scheme. Then the simulator against that wave model, with the
// simulator's law, and against the figures.
//
// The fastest bit of single cycles lies within 2 % of their mean, and which of them is the fastest goes by rounding: two kernels
// of the simulator differ by 0.4 % in it. So simulator and wave model are compared by the mean of the cycles. Theirs is the
// fastest of all, and the wave model with their own law is 3 % below it.
//
// The simulator's law is smooth, mu_k (1 + (ratio - 1) exp(-(v/v_s)^2)), and falls most steeply at v_s/sqrt(2): v_s is chosen
// such that this is where theirs jumps, at 1 rad/s on the collars' surface. Its side force has tension times curvature: in the
// build section the friction coefficient is scaled to their torque. A turning string climbs the wall, N = S/sqrt(1 + mu^2):
// mu/sqrt(1 + mu^2) is their mu.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "groups.h"
#include "report.h"
#include "test_scenes.h"
#include "torsional_wave.h"
#include "well_a.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kStatic = 0.30, kKineticRatio = 0.65, kThreshold = 1.0;  // [-], [-], [rad/s]
constexpr double kCollarFactor = WellA::collar_shear / WellA::pipe_shear;
constexpr double kRotor = 2900.0, kProportional = 38e3, kIntegral = 100e3;
constexpr double kFrom = 60.0, kUntil = 100.0;  // the cycle is looked at [s]
constexpr double kBuildRate = WellA::inclination / (WellA::build_end - WellA::kick_off);
const double kStribeckSpeed = std::sqrt(2.0) * kThreshold * WellA::collar_radius;
/// Viscous torque: theirs, and what a uniform coefficient gives the same torque when all turns at one speed.
constexpr double kViscousRate = 1.0 / 6.0, kUniformDamping = 0.0386;  // [1/s], [N m s/rad per m]

/// The set point starts up as theirs, over a second, `above` the speed for the first 20 s.
struct SetPoint
{
  double speed = 0.0, above = 0.0;
  double at(double time) const { return (speed + (time < 20.0 ? above : 0.0)) * (1.0 - std::exp(-time)); }
};

/// Limits and period of a cycle, sample by sample.
struct Cycle
{
  double torque_low = 1e9, torque_high = -1e9, bit_low = 1e9, bit_high = -1e9, mean_torque = 0.0, period = 0.0;
  double mean_bit_high = 0.0;  ///< of the cycles' highest

  void add(double time, double motor_torque, double bit_speed, double level)
  {
    const bool risen = before_ < level && bit_speed >= level;
    before_ = bit_speed;
    if (time < kFrom) return;
    torque_low = std::min(torque_low, motor_torque);
    torque_high = std::max(torque_high, motor_torque);
    bit_low = std::min(bit_low, bit_speed);
    bit_high = std::max(bit_high, bit_speed);
    mean_torque += (motor_torque - mean_torque) / ++samples_;
    highest_ = std::max(highest_, bit_speed);
    if (!risen || time - last_ < 2.0) return;  // the front of a slip crosses the level more than once
    if (cycles_++ == 0)
      first_ = time;
    else
      mean_bit_high += (highest_ - mean_bit_high) / (cycles_ - 1);
    last_ = time;
    highest_ = 0.0;
    if (cycles_ > 1) period = (last_ - first_) / (cycles_ - 1);
  }

private:
  double before_ = 0.0, first_ = 0.0, last_ = -10.0, highest_ = 0.0;
  int cycles_ = 0;
  long samples_ = 0;
};

double inclination_at(double md)
{
  return std::min(std::max(0.0, md - WellA::kick_off) * kBuildRate, WellA::inclination);
}

/// Whose friction the wave model has.
enum class Law
{
  published,
  simulator
};

/// Break-off torque per metre of cell `i`, all of length `dx`.
std::vector<double> break_off(Law law, double dx)
{
  const double pipe = standard_gravity * well_a_pipe().linear_mass,
               collars = standard_gravity * WellA::density * WellA::collar_area;
  const int cells = static_cast<int>(std::lround(WellA::depth / dx));
  std::vector<double> out(cells), curved(cells, 0.0);
  double tension = 0.0, theirs = 0.0, ours = 0.0;
  for (int i = cells - 1; i >= 0; --i)
  {
    const double md = (i + 0.5) * dx, inclination = inclination_at(md);
    const bool collar = md > WellA::depth - WellA::collar_length;
    const double weight = collar ? collars : pipe;
    out[i] = kStatic * weight * std::sin(inclination) * (collar ? kCollarFactor * WellA::collar_radius : 0.5 * WellA::pipe_outer);
    if (md > WellA::kick_off && md < WellA::build_end)
    {
      curved[i] = std::abs(weight * std::sin(inclination) - tension * kBuildRate);
      theirs += out[i];
      ours += curved[i];
    }
    tension += weight * std::cos(inclination) * dx;
  }
  if (law == Law::simulator)
    for (int i = 0; i < cells; ++i)
      if (curved[i] > 0.0) out[i] = curved[i] * theirs / ours;
  return out;
}

Cycle wave_model(Law law, const SetPoint& set_point)
{
  const double c = std::sqrt(WellA::pipe_shear / WellA::density), dx = 2.5;
  const int collars = static_cast<int>(WellA::collar_length / dx), pipe = static_cast<int>(WellA::depth / dx) - collars;
  const WaveSection upper{pipe, WellA::pipe_shear * WellA::pipe_moment() / c},
      lower{collars, WellA::collar_shear * WellA::collar_moment / c};
  std::vector<double> damping(pipe + collars, kUniformDamping);
  if (law == Law::published)
    for (int i = 0; i < pipe + collars; ++i) damping[i] = kViscousRate * (i < pipe ? upper : lower).impedance / c;
  const std::vector<double> limit = break_off(law, dx);
  const TorsionalWave::Friction friction = [&](double w, int i)
  {
    if (law == Law::published) return (w < kThreshold ? 1.0 : kKineticRatio) * limit[i];
    const double x = w * (i < pipe ? 0.5 * WellA::pipe_outer : WellA::collar_radius) / kStribeckSpeed;
    return (kKineticRatio + (1.0 - kKineticRatio) * std::exp(-x * x)) * limit[i];
  };
  TorsionalWave string(c, dx, upper, lower, damping);
  Cycle cycle;
  double rotor = 0.0, integral = 0.0;
  for (double time = 0.0; time < kUntil; time += string.step())
  {
    const double error = set_point.at(time) - rotor;
    integral += string.step() * error;
    const double motor = kProportional * error + kIntegral * integral;
    string.advance(rotor, friction);
    rotor += string.step() / kRotor * (motor - string.top_torque());
    cycle.add(time, motor, string.bit_speed(), 0.5 * set_point.speed);
  }
  return cycle;
}

/// mu of which the climbing string feels `felt`.
double friction_felt_as(double felt)
{
  return felt / std::sqrt(1.0 - felt * felt);
}

/// `build_factor` scales friction in the build section.
Scene scene_of(double build_factor)
{
  const double kinetic = kKineticRatio * kStatic, hole = 0.2159, end = WellA::depth + 10.0;
  Scene scene = scene_in(build_and_hold(WellA::kick_off, kBuildRate, WellA::inclination, 0.0, end), end, WellA::depth, 0.0);
  scene.well.sections = {{WellA::build_end, hole, friction_felt_as(build_factor * kinetic)},
                         {WellA::depth - WellA::collar_length, hole, friction_felt_as(kinetic)},
                         {end, hole, friction_felt_as(kCollarFactor * kinetic)}};
  scene.contact.static_ratio = friction_felt_as(kStatic) / friction_felt_as(kinetic);
  scene.contact.stribeck_speed = kStribeckSpeed;
  scene.mud.density = 0.0;
  scene.mud.torsional_damping = kUniformDamping;
  PartSpec bit = bit_part(2.0 * WellA::collar_radius, 0.01);
  bit.length = bit.joint_length = WellA::collar_radius;
  scene.string = {bit, well_a_collars(kCollarFactor), well_a_pipe()};
  scene.start.block_height = 1.0;
  TopDriveSpec& drive = scene.rig.top_drive;
  drive.inertia = kRotor;
  drive.proportional_gain = kProportional;
  drive.integral_gain = kIntegral;
  drive.gearbox_friction = 0.0;  // theirs has none
  drive.max_torque = 1e6;
  drive.max_power = 1e9;
  drive.meter_stiffness = 1e8;
  scene.numerics.element_length = 15.0;
  scene.numerics.structural_damping = 6e-5;  // as their upwind scheme spreads a front: c dx/2 (1 - 0.93) at dx 2.5 m
  scene.numerics.step = 0.002;
  return scene;
}

/// Torque in steady turning of the string above `md`, and of all of it.
std::pair<double, double> turning_torque(const RigAtRest& rig, double md)
{
  State state = rig.state;
  const RigForces forces = solve_static(*rig.model, state, sliding_around).forces;
  double above = 0.0, all = 0.0;
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
  {
    const ClosestPoint closest = state.well.locate(state.nodes[i].position, state.nodes[i].segment);
    const double torque = closest.friction *
                          (forces.contact[i] * rig.model->mesh().nodes[i].contact_radius +
                           forces.span_contact[i] * 0.5 * rig.model->mesh().elements[static_cast<std::size_t>(i)].outer_diameter);
    all += torque;
    if (closest.md < md) above += torque;
  }
  return {above, all};
}

Scene calibrated_scene()
{
  const double wanted = kKineticRatio * kStatic * standard_gravity * well_a_pipe().linear_mass * 0.5 * WellA::pipe_outer *
                        (1.0 - std::cos(WellA::inclination)) / kBuildRate;
  return scene_of(wanted / turning_torque(build_at_rest(scene_of(1.0)), WellA::build_end).first);
}

Cycle simulated(const Scene& scene, const SetPoint& set_point)
{
  RigAtRest rig = build_at_rest(scene);
  Stepper stepper(rig.model, find_method(IntegratorKind::bdf2));
  Cycle cycle;
  Setpoints turn;
  while (rig.state.time < kUntil)
  {
    turn.top_drive.speed = set_point.at(rig.state.time);
    if (!stepper.advance(rig.state, scene.numerics.step, turn)) return {};
    const DriveState& drive = rig.state.drive;
    const double motor = kProportional * (turn.top_drive.speed - drive.speed) + kIntegral * drive.integral;
    cycle.add(rig.state.time, motor, rig.state.nodes[0].rate.spin, 0.5 * set_point.speed);
  }
  return cycle;
}

/// The bound is relative to theirs, the lowest torque's to the swing of theirs: it is the small difference of large numbers.
void compare(Report& report, const std::string& name, const Cycle& ours, const Cycle& theirs, double bound,
             const std::string& source)
{
  const double swing = theirs.torque_high - theirs.torque_low;
  report.add({name + ": lowest motor torque [N m]", ours.torque_low, theirs.torque_low, bound * swing, source, true});
  report.add({name + ": highest motor torque [N m]", ours.torque_high, theirs.torque_high, bound, source});
  report.add({name + ": fastest bit [rpm]", ours.bit_high / rpm, theirs.bit_high / rpm, bound, source});
  report.add({name + ": period [s]", ours.period, theirs.period, 0.03, source});
}
}  // namespace

void stick_slip_well_a_cases(Report& report)
{
  const SetPoint slow{60.0 * rpm, 0.0};
  // at 100 rpm turning evenly is stable, and so is a cycle that a start from rest may fall into: it comes down from 140 rpm
  const SetPoint fast{100.0 * rpm, 40.0 * rpm};
  Cycle published;
  published.torque_low = 1555.0;
  published.torque_high = 14280.0;
  published.bit_high = 156.0 * rpm;
  published.period = 4.88;
  const double torque_at_100 = 7653.0;
  const std::string paper = "Aarsnes and Shor 2018", wave = "wave model with the simulator's friction law and side force";

  compare(report, "Well A stick-slip at 60 rpm wave model", wave_model(Law::published, slow), published, 0.05, paper);
  report.add(
      {"Well A at 100 rpm wave model: torque [N m]", wave_model(Law::published, fast).mean_torque, torque_at_100, 0.01, paper});

  const Scene scene = calibrated_scene();
  const double break_off_torque = turning_torque(build_at_rest(scene), 0.0).second / kKineticRatio;
  report.add({"Well A break-off torque [N m]", break_off_torque, 10228.0, 0.01, "9639.5 with 67/61 of it on the collars"});
  const Cycle ours = simulated(scene, slow);
  const Cycle waves = wave_model(Law::simulator, slow);
  compare(report, "Well A stick-slip at 60 rpm", ours, waves, 0.05, wave);
  report.add({"Well A stick-slip at 60 rpm: fastest bit, mean of the cycles [rpm]", ours.mean_bit_high / rpm,
              waves.mean_bit_high / rpm, 0.02, wave});
  compare(report, "Well A stick-slip at 60 rpm as published", ours, published, 0.08,
          paper + ": friction law and side force differ");
  const Cycle steady = simulated(scene, fast);
  report.add({"Well A at 100 rpm: torque [N m]", steady.mean_torque, torque_at_100, 0.01, paper});
  report.add({"Well A at 100 rpm: slowest bit [rpm]", steady.bit_low / rpm, 100.0, 0.05, paper + ": no stick-slip"});
}

}  // namespace drill_rig_sim
