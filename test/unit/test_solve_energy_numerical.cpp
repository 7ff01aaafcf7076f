// SPDX-License-Identifier: BSD-3-Clause
// What the methods themselves make or take of energy, account by account.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/compared/arkode_stepper.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/stepper.h"
#include "plucked_rig.h"

namespace test_solve_energy_numerical
{
using namespace drill_rig_sim;

namespace
{
/// The plucked string's half second at 1 ms.
EnergyAccounts plucked_with(Integrator& integrator, const RigAtRest& start)
{
  State state = start.state;
  EnergyBalance balance(start.model);
  integrator.keep_balance(&balance);
  for (int k = 0; k < 500; ++k) EXPECT_TRUE(integrator.advance(state, 1e-3, Setpoints()));
  return balance.accounts();
}
}  // namespace

// One formula, two codes: the accelerations that ARKODE's stages end with count as much.
TEST(Numerical, ofArkodeIsThatOfOurTrBdf2)
{
  if (!ArkodeStepper::available()) GTEST_SKIP() << "this build's SUNDIALS is older than 6";
  const RigAtRest start = plucked();
  ArkodeStepper theirs(start.model);
  Stepper ours(start.model, find_method(IntegratorKind::trbdf2));
  theirs.limits().tolerance = ours.limits().tolerance = 1e-12;
  const EnergyAccounts expected = plucked_with(ours, start), e = plucked_with(theirs, start);
  EXPECT_GT(expected.of_inertia, 1e-5 * expected.largest_kinetic);
  EXPECT_NEAR(e.of_inertia, expected.of_inertia, 0.01 * expected.of_inertia);
  EXPECT_NEAR(e.of_residual, 0.0, 1e-9 * e.largest_kinetic);
}

// Central differences solve nothing: their accelerations are those that the forces at the step's end make, and leave no residual.
TEST(Numerical, ofCentralDifferencesHasNoResidual)
{
  const RigAtRest start = plucked();
  Stepper stepper(start.model, find_method(IntegratorKind::central_differences));
  EnergyBalance balance(start.model);
  stepper.keep_balance(&balance);
  State state = start.state;
  for (int k = 0; k < 300; ++k) ASSERT_TRUE(stepper.advance(state, 1e-4, Setpoints()));
  ASSERT_GT(balance.accounts().largest_kinetic, 0.1);  // [J]
  EXPECT_NEAR(balance.accounts().of_residual, 0.0, 1e-9 * balance.accounts().largest_kinetic);
}

// A drive that speeds up: rotor, meter and string each with accelerations of their own.
TEST(Numerical, ofTheReferenceIsNothingInAnyAccount)
{
  Scene scene = without_damping(vertical_scene(400.0, 290.0));
  scene.start.block_height = 10.0;
  scene.numerics.integrator = IntegratorKind::ida;
  Simulator rig(scene);
  rig.balance_energy();
  TopDriveSetpoint drive;
  drive.speed = 8.0;
  rig.command(drive);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
  const EnergyAccounts& e = rig.energy();
  ASSERT_GT(e.drive, 1e4);  // [J]
  for (const double account : {e.of_inertia, e.of_beams, e.of_contact, e.of_line, e.of_residual, e.of_rebasing})
    EXPECT_NEAR(account, 0.0, 1e-6 * e.drive);
  EXPECT_LT(e.closure(), 1e-6);
}

// Line paid out of a drum a metre in one step while the block stands: its energy EA (L - L_0)^2 / (2 L_0) falls by the integral
// of the price EA/2 ((L/L_0)^2 - 1), of which the mean of both ends is too much by a little.
TEST(Numerical, ofTheLineIsWhatTheMeanOfItsPricesMisses)
{
  constexpr double ea = 1e5;  // [N], a line that stretches by tens of per cent
  Scene scene = without_damping(vertical_scene(400.0, 290.0));
  scene.start.block_height = 10.0;
  scene.rig.hoisting.line_ea = ea;
  const RigAtRest rig = build_at_rest(scene);
  EnergyBalance balance(rig.model);
  Setpoints setpoints;
  setpoints.winch = {1.0, false};
  balance.begin_step(rig.state, setpoints);
  Stage stage(*rig.model);
  begin_step(*rig.model, rig.state, 1.0, setpoints, stage);
  const std::vector<double> still(6 * static_cast<std::size_t>(rig.model->nodes()), 0.0);
  balance.end_step(rig.state, stage, still.data());

  const double strung = 2.0 * 5.0 * (46.0 - 10.0) + 60.0, before = rig.state.hoist.line_length;
  const double after = stage.hoist.line_length;
  const auto price = [strung](double length) { return 0.5 * ea * (std::pow(strung / length, 2) - 1.0); };
  const auto energy = [strung](double length) { return 0.5 * ea * std::pow(strung - length, 2) / length; };
  const double missed = 0.5 * (price(before) + price(after)) * (before - after) - (energy(after) - energy(before));
  ASSERT_GT(missed, 1.0);  // [J]
  EXPECT_NEAR(balance.accounts().of_line, missed, 1e-6 * missed);
}

// Between steps the motor or the rock may take the bristles of the torque on bit beyond their limit.
TEST(Numerical, whatABristleLosesBetweenStepsIsTheRocksAndNotRebasings)
{
  Scene scene = without_damping(vertical_scene(400.0, 400.0));
  scene.start.weight_on_bit = 5e4;
  const RigAtRest rig = build_at_rest(scene);
  EnergyBalance balance(rig.model);
  Stage stage(*rig.model);
  const std::vector<double> still(6 * static_cast<std::size_t>(rig.model->nodes()), 0.0);
  State state = rig.state;
  const auto step_with = [&](double twist)
  {
    state.bit.twist = twist;
    balance.begin_step(state, Setpoints());
    begin_step(*rig.model, state, 1e-3, Setpoints(), stage);
    balance.end_step(state, stage, still.data());
    return balance.accounts();
  };
  constexpr double before = 2e-3, after = 1e-3;  // [rad]
  const EnergyAccounts first = step_with(before), second = step_with(after);
  const double lost = 0.5 * rig.model->bit_bristle_stiffness() * (before * before - after * after);
  ASSERT_GT(lost, 1e-3);  // [J]
  EXPECT_NEAR(second.rock_torque - first.rock_torque, lost, 1e-6 * lost);
  EXPECT_NEAR(second.of_rebasing - first.of_rebasing, 0.0, 1e-6 * lost);
}
}  // namespace test_solve_energy_numerical
