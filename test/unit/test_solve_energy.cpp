// SPDX-License-Identifier: BSD-3-Clause
// The energy balance against cases whose energies are known.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "drill_ahead.h"
#include "in_source.h"
#include "test_scenes.h"

namespace test_solve_energy
{
using namespace drill_rig_sim;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Runs a rig from `start` with all set points at rest, `ahead` [s] without a balance and then `span` with one; what the balance
/// says.
EnergyAccounts run(const RigAtRest& start, IntegratorKind method, double step, double ahead, double span)
{
  State state = start.state;
  Stepper stepper(start.model, find_method(method));
  stepper.limits().tolerance = 1e-12;
  for (long k = 0; k < std::lround(ahead / step); ++k) EXPECT_TRUE(stepper.advance(state, step, Setpoints()));
  EnergyBalance balance(start.model);
  stepper.keep_balance(&balance);
  for (long k = 0; k < std::lround(span / step); ++k) EXPECT_TRUE(stepper.advance(state, step, Setpoints()));
  return balance.accounts();
}

/// 300 m that hang still in mud that takes nothing out, stretched by a millimetre, most at the bit; the drive's loop is slack.
RigAtRest plucked()
{
  Scene scene = without_damping(vertical_scene(400.0, 290.0));
  scene.string[0].bit->diameter = 0.2;
  scene.start.block_height = 10.0;
  RigAtRest rig = build_at_rest(scene);
  const double length = rig.model->mesh().total_length;
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
    rig.state.nodes[i].position.z() += 1e-3 * std::pow(std::cos(0.5 * pi * rig.model->mesh().nodes[i].from_bit / length), 4);
  return rig;
}

void play(Simulator& simulator, ScenePlayer& player, double seconds)
{
  for (long k = 0; k < std::lround(seconds / 0.01); ++k)
  {
    player.apply(simulator);
    ASSERT_EQ(simulator.frame(0.01), FrameStatus::running) << simulator.failure();
  }
}

/// Pose of an element between two sections.
BeamPose pose_between(const Vector3d& upper, const Vector3d& lower, const Quaterniond& upper_turn, const Quaterniond& lower_turn)
{
  return {upper, lower, x_axis(upper_turn), x_axis(lower_turn), twist_between(upper_turn, lower_turn), upper_turn, lower_turn};
}
}  // namespace

// Central differences of U over 1e-5: relative error (1e-5)^2 of the moments' curvature, some 1e-8; round-off 1e-16 U / 1e-5.
TEST(Energy, ofABeamHasItsForcesAsGradient)
{
  const BeamSection section = tube_section(9.5, 0.127, 0.1086, 206e9, 0.3);
  const Vector3d upper(0.1, -0.2, 5.0), lower(0.12, -0.3, -4.501);
  const Quaterniond down(Eigen::AngleAxisd(0.5 * pi, Vector3d::UnitY()));
  const Quaterniond a = rotation_from_vector(Vector3d(0.01, 0.004, 0.05)) * down;
  const Quaterniond b = rotation_from_vector(Vector3d(-0.02, 0.012, -0.03)) * down;
  BeamStrain strain;
  const BeamForces f = beam_forces(section, pose_between(upper, lower, a, b), BeamDamping(), Vector3d::Zero(), strain);
  const double d = 1e-5, scale = f.force.norm();
  for (int k = 0; k < 3; ++k)
  {
    const Vector3d e = d * Vector3d::Unit(k);
    const Quaterniond turn = rotation_from_vector(e), back = rotation_from_vector(-e);
    auto slope = [&](const BeamPose& more, const BeamPose& less)
    { return (beam_energy(section, more) - beam_energy(section, less)) / (2.0 * d); };
    EXPECT_NEAR(slope(pose_between(upper, lower + e, a, b), pose_between(upper, lower - e, a, b)), f.force[k], 1e-6 * scale);
    EXPECT_NEAR(slope(pose_between(upper, lower, turn * a, b), pose_between(upper, lower, back * a, b)), f.moment_upper[k],
                1e-6 * scale);
    EXPECT_NEAR(slope(pose_between(upper, lower, a, turn * b), pose_between(upper, lower, a, back * b)), f.moment_lower[k],
                1e-6 * scale);
  }
}

// Nothing but the method takes energy out of an undamped string: what is missing is the numerical dissipation, found from inertia
// alone.
TEST(Energy, missingFromFreeVibrationIsNumericalDissipation)
{
  const RigAtRest start = plucked();
  for (IntegratorKind method :
       {IntegratorKind::bdf2, IntegratorKind::implicit_euler, IntegratorKind::trbdf2, IntegratorKind::generalised_alpha})
  {
    const EnergyAccounts e = run(start, method, 0.001, 0.0, 0.5);
    ASSERT_GT(e.largest_kinetic, 1.0) << find_integrator(method).name;  // [J]
    EXPECT_NEAR(e.input() - e.stored(), e.numerical(), 1e-4 * e.largest_kinetic) << find_integrator(method).name;
    EXPECT_NEAR(e.dissipated() + e.broken_rock() + e.correction, 0.0, 1e-9 * e.largest_kinetic) << find_integrator(method).name;
  }
}

// Per period a mode loses some (w h)^3 (BDF2) or w h (implicit Euler). The first step of BDF2 is implicit Euler's: it is left
// out. Central differences lose nothing but have the rates half a step late, whose energy swings by w h.
TEST(Energy, numericalDissipationFallsWithTheStepAsTheMethodsOrderSays)
{
  const RigAtRest start = plucked();
  auto share = [&start](IntegratorKind method, double step)
  {
    const EnergyAccounts e = run(start, method, step, 0.05, 0.5);
    return e.numerical() / e.largest_kinetic;
  };
  const double bdf2 = share(IntegratorKind::bdf2, 0.001), euler = share(IntegratorKind::implicit_euler, 0.001);
  EXPECT_GT(euler, 0.1);
  EXPECT_LT(bdf2, 0.1 * euler);
  EXPECT_GT(bdf2, 0.0);
  EXPECT_NEAR(std::log2(share(IntegratorKind::bdf2, 0.00025) / share(IntegratorKind::bdf2, 0.000125)), 3.0, 0.2);
  EXPECT_LT(share(IntegratorKind::trbdf2, 0.001), bdf2);
  EXPECT_LT(std::abs(share(IntegratorKind::central_differences, 0.0002)), 0.01);
}

// Pipe lowered at 0.1 m/s down 20 deg of friction: all that gravity gives goes into the winch's brake and the wall, and the wall
// takes friction times weight across the hole times way: 2 % for the crossing from the frictionless build and the bit.
TEST(Energy, ofASlidingPipeGoesIntoFriction)
{
  Scene scene = read_scene(in_source("test/scenes/inclined_straight_20deg.yaml"));
  Simulator simulator(scene);
  simulator.command(WinchSetpoint{-0.1, false});
  ScenePlayer nothing;
  play(simulator, nothing, 8.0);
  simulator.balance_energy();
  play(simulator, nothing, 4.0);
  const EnergyAccounts& e = simulator.energy();
  const double weight = standard_gravity * 31.9 * (1.0 - 1150.0 / 7850.0);  // [N/m]
  const double length = 1400.0 - 270.0;
  EXPECT_NEAR(e.wall_friction, 0.5 * weight * std::sin(20.0 * degree) * length * 0.1 * 4.0, 0.02 * e.wall_friction);
  EXPECT_NEAR(e.block, 0.03 * standard_gravity * 17500.0 * 0.1 * 4.0, 0.01 * e.block) << "and the rail of the block";
  EXPECT_NEAR(e.gravity + e.winch - e.stored(), e.wall_friction + e.block, 0.02 * e.wall_friction);
  EXPECT_LT(e.closure(), 1e-3);
}

// Steady drilling: thrust times ROP and torque times speed, from the truth of every frame.
TEST(Energy, ofBrokenRockIsForceTimesSpeed)
{
  Scene scene = read_scene(in_source("config/scenes/quick.yaml"));
  scene.numerics.level = Level::beam3d;  // a step a frame: sums over frames are the steps'
  Simulator simulator(scene);
  ScenePlayer player(simulator.scene());
  play(simulator, player, 60.0);
  simulator.balance_energy();
  double thrust = 0.0, torque = 0.0;
  for (int k = 0; k < 1000; ++k)
  {
    ASSERT_EQ(simulator.frame(0.01), FrameStatus::running);
    const Truth& m = simulator.truth();
    thrust += 0.01 * m.wob * m.rop;
    torque += 0.01 * m.bit_torque * m.bit_speed;
  }
  const EnergyAccounts& e = simulator.energy();
  ASSERT_GT(thrust, 1e3);
  EXPECT_NEAR(e.rock_thrust, thrust, 1e-3 * thrust);
  EXPECT_NEAR(e.rock_torque, torque, 1e-3 * torque);
  EXPECT_LT(e.closure(), 1e-4);
}

// A heavy bit on a soft, light string drops on rock: m v dv = -k d^e (1 + c v) dd, so c (v + w) = log((1 + c v)/(1 - c w)) for
// the speeds v before and w after, whatever k and e.
TEST(Energy, ofAnImpactGoesIntoHuntAndCrossleysDamping)
{
  const double speed = 0.2, damping = 1.0;
  Scene scene = without_damping(vertical_scene(1000.0, 990.0));
  scene.string = {bit_part(0.2, 2000.0), pipe_part(0, 1e5, 0.01, pipe_outer)};
  scene.string[0].bit->bottom = {1e9, 1.5, damping};
  scene.string[1].young_modulus = 1e4 * 1000.0 / pipe_area;  // 10 kN/m
  scene.numerics.element_length = 250.0;
  RigAtRest rig = build_at_rest(scene);
  scene.well.hole_depth = 990.001;
  rig.state.well = Wellbore(scene.well, scene.trajectory, 0.1);
  rig.state.nodes[0].rate.velocity.z() = -speed;
  const EnergyAccounts e = run(rig, IntegratorKind::bdf2, 5e-5, 0.0, 0.06);

  double after = 0.5 * speed;
  for (int k = 0; k < 60; ++k) after = (1.0 - (1.0 + damping * speed) * std::exp(-damping * (speed + after))) / damping;
  const double lost = 0.5 * 2000.0 * (speed * speed - after * after);
  EXPECT_NEAR(e.bottom_damping, lost, 0.01 * lost);
  EXPECT_LT(e.closure(), 0.005);
}

// A stuck point holds what it was pulled with, and keeps it when it lets go.
TEST(Energy, ofAReleasedGripIsBooked)
{
  Simulator simulator(drilling_scene(5.0, 0.1));
  simulator.balance_energy();
  ASSERT_TRUE(simulator.stick_pipe(80.0));
  simulator.command(WinchSetpoint{0.05, false});
  ScenePlayer nothing;
  play(simulator, nothing, 2.0);
  const double held = simulator.energy().last.stuck_point;
  EXPECT_GT(held, 0.1);
  simulator.free_pipe();
  play(simulator, nothing, 1.0);
  EXPECT_NEAR(simulator.energy().stuck_point_released, held, 1e-9 * held);
  EXPECT_LT(simulator.energy().closure(), 0.005);
}

// The reference counts each of IDA's own steps: its balance closes, and what the two count agrees within the default's
// own error.
TEST(Energy, ofTheReferenceClosesAndAgreesWithTheDefaults)
{
  Scene scene = motor_drilling_scene(0.01);
  scene.numerics.step = 0.0025;  // at 0.005 what the mud takes from the sideways motion differs by 2.1 %
  EnergyAccounts accounts[2];
  for (const bool reference : {false, true})
  {
    scene.numerics.integrator = reference ? IntegratorKind::ida : IntegratorKind::automatic;
    Simulator rig(scene);
    drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
    ScenePlayer nothing;
    play(rig, nothing, 3.0);
    rig.balance_energy();
    play(rig, nothing, 3.0);
    accounts[reference] = rig.energy();
  }
  const EnergyAccounts &e = accounts[1], &fixed = accounts[0];
  EXPECT_NEAR(e.time, 3.0, 1e-9);
  EXPECT_LT(e.closure(), 1e-4);
  EXPECT_LT(std::abs(e.numerical_share()), 1e-4);
  EXPECT_GT(e.rock_torque, 100.0);
  const std::pair<const char*, double EnergyAccounts::*> names[] = {{"winch", &EnergyAccounts::winch},
                                                                    {"drive", &EnergyAccounts::drive},
                                                                    {"pump", &EnergyAccounts::pump},
                                                                    {"gravity", &EnergyAccounts::gravity},
                                                                    {"mud", &EnergyAccounts::mud},
                                                                    {"wall friction", &EnergyAccounts::wall_friction},
                                                                    {"rock thrust", &EnergyAccounts::rock_thrust},
                                                                    {"rock torque", &EnergyAccounts::rock_torque}};
  for (const auto& [name, account] : names) EXPECT_NEAR(e.*account / (fixed.*account), 1.0, 0.02) << name;
}

// The balance looks only.
TEST(Energy, bookLeavesTheRunAsItIs)
{
  Simulator with(drilling_scene()), without(drilling_scene());
  with.balance_energy();
  for (Simulator* simulator : {&with, &without})
  {
    simulator->command(TopDriveSetpoint{TopDriveMode::speed, 6.0, 0.0, 0.0, 0.0});
    simulator->command(WinchSetpoint{-0.01, false});
    for (int k = 0; k < 500; ++k) ASSERT_EQ(simulator->frame(0.01), FrameStatus::running);
  }
  EXPECT_EQ(with.truth().bit_position, without.truth().bit_position);
  EXPECT_EQ(with.truth().hook_load, without.truth().hook_load);
  EXPECT_EQ(with.truth().torque, without.truth().torque);
  EXPECT_EQ(with.statistics().work.residuals, without.statistics().work.residuals);
  EXPECT_GT(with.energy().time, 4.99);
  EXPECT_EQ(without.energy().time, 0.0);
}
}  // namespace test_solve_energy
