// SPDX-License-Identifier: BSD-3-Clause
// Each account of what takes energy out, against the work of its force worked out by hand: a bit that moves in one way alone.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/stepper.h"
#include "lone_bit.h"

namespace test_solve_energy_losses
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double mass = 1000.0, mud_mass = 200.0, spin_inertia = 50.0;  // [kg], [kg], [kg m2]

Scene quiet()
{
  return weightless(lone_bit_scene());
}

/// A bit of the `mass`, the mud that goes along sideways and the inertia about its axis. `spring`: the pipe's stiffness in
/// stretch and twist is kept, and with `bending` [N m2] that of a slender beam; otherwise the bit is free.
RigAtRest heavy_bit(const Scene& scene, bool spring, double bending = 0.0, double about_axis = spin_inertia)
{
  return lone_bit(scene,
                  [spring, bending, about_axis](MeshNode& bit, BeamSection& pipe)
                  {
                    bit.mass = mass;
                    bit.mud_inside = mud_mass;
                    bit.mud_outside = 0.0;
                    bit.spin_inertia = about_axis;
                    if (bending > 0.0) bit.tilt_inertia = 1e-3;
                    pipe.bending_near = 4.0 * bending / pipe.length + 1e-9;
                    pipe.bending_far = 2.0 * bending / pipe.length + 1e-9;
                    if (!spring) pipe.axial = pipe.torsion = 1e-9;
                  });
}

/// `end`: the state then, unless null.
EnergyAccounts run(const RigAtRest& start, double step, double span, State* end = nullptr)
{
  State state = start.state;
  Stepper stepper(start.model, find_method(IntegratorKind::bdf2));
  stepper.limits().tolerance = 1e-12;
  EnergyBalance balance(start.model);
  stepper.keep_balance(&balance);
  for (long k = 0; k < std::lround(span / step); ++k) EXPECT_TRUE(stepper.advance(state, step, Setpoints()));
  if (end) *end = state;
  return balance.accounts();
}

/// What a damper takes of `energy` by the time t, the speed falling as exp(-rate t).
double taken(double energy, double rate, double t)
{
  return energy * (1.0 - std::exp(-2.0 * rate * t));
}

/// All losses but the one under test are nothing beside it, and the balance closes.
void expect_alone(const EnergyAccounts& e, double EnergyAccounts::*account, double expected)
{
  EXPECT_NEAR(e.*account, expected, 1e-3 * expected);
  EXPECT_NEAR(e.dissipated(), expected, 1e-3 * expected) << "no other account has any";
  EXPECT_NEAR(e.broken_rock() + e.correction, 0.0, 1e-6 * expected);
  EXPECT_LT(e.closure(), 1e-3);
}
}  // namespace

// m v' = -c v: the film takes the kinetic energy of the bit and of the mud that goes along.
TEST(Losses, squeezeFilmTakesForceTimesSpeed)
{
  Scene scene = quiet();
  scene.string[0].bit->squeeze_film_damping = 2400.0;
  RigAtRest rig = heavy_bit(scene, false);
  rig.state.nodes[0].rate.velocity = Vector3d(0.03, 0.04, 0.0);
  expect_alone(run(rig, 1e-3, 0.2), &EnergyAccounts::squeeze_film, taken(0.5 * (mass + mud_mass) * 0.05 * 0.05, 2.0, 0.2));
  // none of a motion along the hole
  rig.state.nodes[0].rate.velocity = Vector3d(0.0, 0.0, 0.05);
  EXPECT_LT(std::abs(run(rig, 1e-3, 0.2).squeeze_film), 1e-6);
}

// Across the string, along it and about it, each motion has its own damper.
TEST(Losses, mudTakesItsShareOfEachMotion)
{
  const double length = heavy_bit(quiet(), false).model->mesh().nodes[0].length;  // of the string that is the bit's node's
  Scene scene = quiet();
  scene.mud.lateral_damping = 1.5 * (mass + mud_mass) / length;
  scene.mud.axial_damping = 2.5 * mass / length;
  scene.mud.torsional_damping = 3.5 * spin_inertia / length;
  RigAtRest rig = heavy_bit(scene, false);
  NodeRate& rate = rig.state.nodes[0].rate;
  rate.velocity = Vector3d(0.03, 0.04, 0.0);
  expect_alone(run(rig, 1e-3, 0.2), &EnergyAccounts::mud, taken(0.5 * (mass + mud_mass) * 0.05 * 0.05, 1.5, 0.2));
  rate.velocity = Vector3d(0.0, 0.0, 0.05);
  expect_alone(run(rig, 1e-3, 0.2), &EnergyAccounts::mud, taken(0.5 * mass * 0.05 * 0.05, 2.5, 0.2));
  rate.velocity.setZero();
  rate.spin = 4.0;
  expect_alone(run(rig, 1e-3, 0.2), &EnergyAccounts::mud, taken(0.5 * spin_inertia * 16.0, 3.5, 0.2));
  // no mud above the rotary table
  rig.state.nodes[0].position.z() = 0.5;
  EXPECT_LT(std::abs(run(rig, 1e-3, 0.2).mud), 1e-6);
}

// m v' = -k v^2, k = half rho C_d D L: v = v_0/(1 + k v_0 t/m). Along the string there is none of it.
TEST(Losses, mudTakesTheCubeOfASidewaysSpeed)
{
  Scene scene = quiet();
  scene.mud.drag_coefficient = 1.3;
  RigAtRest rig = heavy_bit(scene, false);
  const double k = 0.5 * scene.mud.density * 1.3 * pipe_outer * rig.model->mesh().nodes[0].length;
  NodeRate& rate = rig.state.nodes[0].rate;
  rate.velocity = Vector3d(0.03, 0.04, 0.0);
  const double left = 0.05 / (1.0 + k * 0.05 * 0.2 / (mass + mud_mass));
  expect_alone(run(rig, 1e-3, 0.2), &EnergyAccounts::mud, 0.5 * (mass + mud_mass) * (0.05 * 0.05 - left * left));
  rate.velocity = Vector3d(0.0, 0.0, 0.05);
  EXPECT_LT(std::abs(run(rig, 1e-3, 0.2).mud), 1e-6);
}

// A swing at w with the damping ratio z = w t_d/2: what stretch, twist and bending have lost by the time t is what is missing of
// the closed form.
TEST(Losses, structuralDampingTakesWhatTheSwingLoses)
{
  constexpr double damping_time = 0.004, t = 0.05, speed = 0.02, spin = 0.3, bending = 1e9;
  Scene scene = quiet();
  scene.numerics.structural_damping = damping_time;
  RigAtRest rig = heavy_bit(scene, true);
  const BeamSection& pipe = rig.model->mesh().elements[0].section;
  const auto lost = [&](double inertia, double stiffness, double rate)
  {
    const double w = std::sqrt(stiffness / inertia), z = 0.5 * w * damping_time, wd = w * std::sqrt(1.0 - z * z);
    const double decay = std::exp(-z * w * t);
    const double x = rate / wd * decay * std::sin(wd * t);
    const double v = rate * decay * (std::cos(wd * t) - z * w / wd * std::sin(wd * t));
    return 0.5 * inertia * (rate * rate - v * v) - 0.5 * stiffness * x * x;
  };
  rig.state.nodes[0].rate.velocity.z() = speed;
  expect_alone(run(rig, 2e-5, t), &EnergyAccounts::structural, lost(mass, pipe.axial / pipe.length, speed));
  rig.state.nodes[0].rate.velocity.z() = 0.0;
  rig.state.nodes[0].rate.spin = spin;
  expect_alone(run(rig, 2e-5, t), &EnergyAccounts::structural, lost(spin_inertia, pipe.torsion, spin));
  // a cantilever with the mass at its end, whose tilt follows without inertia
  RigAtRest beam = heavy_bit(scene, true, bending);
  const double length = beam.model->mesh().elements[0].section.length;
  beam.state.nodes[0].rate.velocity.x() = speed;
  beam.state.nodes[0].rate.tilt = Vector3d(0.0, -1.5 * speed / length, 0.0);
  expect_alone(run(beam, 2e-5, t), &EnergyAccounts::structural,
               lost(mass + mud_mass, 3.0 * bending / (length * length * length), speed));
}

// A disk on a light shaft that turns at W (Jeffcott's rotor, Genta 4.5): with z = x - i y, seen from above, m z" + c k (z' - i W
// z) + k z = 0. Above the critical speed the shaft's damping feeds the forward whirl and takes from the backward one.
TEST(Losses, dampingOfATurningShaftFeedsForwardWhirl)
{
  constexpr double damping_time = 0.001, bending = 1e9, turning = 100.0, speed = 0.001,
                   t = 1.0;  // [s], [N m2], [rad/s], [m/s], [s]
  Scene scene = quiet();
  scene.numerics.structural_damping = damping_time;
  RigAtRest rig = heavy_bit(scene, true, bending, 1e-3);
  const double length = rig.model->mesh().elements[0].section.length;
  for (NodeState& node : rig.state.nodes) node.rate.spin = turning;
  rig.state.nodes[0].rate.velocity.x() = speed;
  rig.state.nodes[0].rate.tilt = Vector3d(0.0, -1.5 * speed / length, 0.0);
  State end = rig.state;
  run(rig, 1e-4, t, &end);

  using Complex = std::complex<double>;
  const double square = 3.0 * bending / (length * length * length) / (mass + mud_mass), rate = damping_time * square;
  const Complex root = std::sqrt(Complex(0.25 * rate * rate - square, rate * turning));
  const Complex one = -0.5 * rate + root, two = -0.5 * rate - root;
  const Complex place = speed * (std::exp(one * t) - std::exp(two * t)) / (one - two);
  const Vector3d moved = end.nodes[0].position - rig.state.nodes[0].position;
  EXPECT_GT(std::abs(place), speed / std::sqrt(square)) << "it has grown";
  EXPECT_LT(std::abs(Complex(moved.x(), -moved.y()) - place), 0.02 * std::abs(place));
}

// Hunt and Crossley: m v dv = -k d^e (1 + c v) dd, so c (v + w) = log((1 + c v)/(1 - c w)) for the speeds v before and w after.
TEST(Losses, wallDampingTakesWhatTheReboundLacks)
{
  constexpr double speed = 0.2, damping = 1.0;
  Scene scene = quiet();
  scene.string[0].bit->diameter = 0.2;
  scene.contact.law.damping = damping;
  RigAtRest rig = heavy_bit(scene, false);
  rig.state.nodes[0].rate.velocity.x() = speed;
  double after = 0.5 * speed;
  for (int k = 0; k < 60; ++k) after = (1.0 - (1.0 + damping * speed) * std::exp(-damping * (speed + after))) / damping;
  expect_alone(run(rig, 2e-5, 0.15), &EnergyAccounts::wall_damping, 0.5 * (mass + mud_mass) * (speed * speed - after * after));

  // in the midst of it: what is neither motion nor in the wall
  State pressed = rig.state;
  const EnergyAccounts e = run(rig, 2e-5, 0.06, &pressed);
  const double depth = pressed.nodes[0].position.x() + 0.1 - 0.5 * 0.2159, v = pressed.nodes[0].rate.velocity.x();
  ASSERT_GT(depth, 1e-3);
  const double held = scene.contact.law.stiffness * std::pow(depth, 2.5) / 2.5;
  EXPECT_NEAR(e.last.wall, held, 1e-6 * held);
  const double lost = 0.5 * (mass + mud_mass) * (speed * speed - v * v) - held;
  EXPECT_NEAR(e.wall_damping, lost, 2e-3 * lost);
}

// The bit's gauge rubs on the wall with the motor's speed: friction times way is the wall's, and what the pump gave.
TEST(Losses, gaugeFrictionTakesTheMotorsWork)
{
  constexpr double pressed = 1e-3, friction = 0.3, radius = 0.05, span = 0.1;
  Scene scene = lone_bit_scene();
  scene.well.sections[0].friction = friction;
  PartSpec motor = motor_part(0.0);
  motor.length = motor.joint_length = 4.0;
  scene.string.insert(scene.string.begin() + 1, motor);
  RigAtRest rig =
      lone_bit(weightless(scene), [](MeshNode& bit, BeamSection&) { bit.mass = bit.spin_inertia = bit.tilt_inertia = 1e18; });
  const double normal = scene.contact.law.stiffness * std::pow(pressed, 1.5);
  rig.state.flow = 0.03;
  rig.state.bit.motor_speed = 2.0 * pi * 0.03 / 0.024;  // as without torque on the bit's face
  NodeState& bit = rig.state.nodes[0];
  bit.position.x() = 0.5 * 0.2159 - radius + pressed;
  bit.bristle.y() =
      -friction * normal / scene.contact.tangential_stiffness;  // slides already: clockwise, the east side goes south
  const double work = friction * normal * radius * rig.state.bit.motor_speed * span;
  const EnergyAccounts e = run(rig, 1e-3, span);
  EXPECT_NEAR(e.wall_friction, work, 1e-3 * work);
  EXPECT_NEAR(e.pump, work, 1e-3 * work);
  EXPECT_NEAR(e.motor_slip, 0.0, 1e-6 * work);
}
}  // namespace test_solve_energy_losses
