// SPDX-License-Identifier: BSD-3-Clause
// The reference: the rig as a DAE under IDA, against closed forms, against itself at other tolerances, and against the default
// stepper.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/solve/stepper.h"
#include "plucked_string.h"

namespace test_solve_reference
{
using namespace drill_rig_sim;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
constexpr double kSpan = 0.4;  // nearly two of the slowest axial periods [s]
constexpr double kStep = 0.005;

struct Difference
{
  double stretch;  // of the largest there is [-]
  double twist;
};

Difference from_exact(double tolerance, int order = 2)
{
  const PluckedString string(tolerance, order);
  IdaIntegrator ida(string.rig.model);
  const State state = string.run(ida, kSpan, kStep);
  return {(string.stretch_of(state) - string.exact_stretch(kSpan)).cwiseAbs().maxCoeff() / 1e-3,
          (string.twist_of(state) - string.exact_twist(kSpan)).cwiseAbs().maxCoeff() / 1e-2};
}

/// Drilling with rotation below a build: everything acts.
Scene drilling(double tolerance)
{
  Scene scene = scene_in({{0.0, 0.0, 0.3}, {30.0, 0.0, 0.3}, {80.0, 0.15, 0.3}, {140.0, 0.15, 0.3}}, 120.0, 120.0, 0.3);
  scene.string.insert(scene.string.begin() + 1, collar_part(3, 9.4));
  scene.start.weight_on_bit = 1e4;
  scene.numerics.integrator = IntegratorKind::ida;
  scene.numerics.reference_tolerance = tolerance;
  scene.rig.top_drive.gearbox_friction = 0.0;
  return scene;
}

void run(Simulator& simulator, double seconds)
{
  for (int k = 0; k < std::lround(seconds / 0.01); ++k)
    ASSERT_EQ(simulator.frame(0.01), FrameStatus::running) << simulator.failure();
}

void start_up(Simulator& simulator)
{
  simulator.command(WinchSetpoint{-0.01, false});
  TopDriveSetpoint drive;
  drive.speed = 8.0;
  simulator.command(drive);
}
}  // namespace

TEST(Reference, PluckedStringConvergesToItsModes)
{
  const Difference coarse = from_exact(1e-5), middle = from_exact(1e-7), fine = from_exact(1e-9);
  // order two: the step goes with the cube root of the tolerance, the error with its square
  EXPECT_LT(middle.stretch, 0.2 * coarse.stretch);
  EXPECT_LT(fine.stretch, 0.2 * middle.stretch);
  EXPECT_LT(middle.twist, 0.2 * coarse.twist);
  EXPECT_LT(fine.twist, 0.2 * middle.twist);
  EXPECT_LT(fine.stretch, 1e-4);
  EXPECT_LT(fine.twist, 2e-5);
}

TEST(Reference, HigherOrdersGoToTheSameSolution)
{
  const Difference fine = from_exact(1e-8, 5);
  // some 1600 local errors of 1e-10 m, in the pluck's millimetre, add up at worst
  EXPECT_LT(fine.stretch, 1.6e-4);
  EXPECT_LT(fine.twist, 1e-5);
}

TEST(Reference, TheSteppersErrorFallsWithTheSquareOfTheStep)
{
  const PluckedString string(1e-8, 5);
  IdaIntegrator ida(string.rig.model);
  const VectorXd reference = string.stretch_of(string.run(ida, kSpan, kStep));
  std::vector<double> error;
  for (const double step : {0.001, 0.0005, 0.00025})
  {
    Stepper bdf2(string.rig.model, find_method(IntegratorKind::bdf2));
    bdf2.limits().tolerance = 1e-12;
    error.push_back((string.stretch_of(string.run(bdf2, kSpan, step)) - reference).norm());
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.15);
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.1);
}

// Forces at the same state are the same laws; a drilling second at short intervals must come out alike.
TEST(Reference, DrillsAsTheDefaultStepperDoesAtShortSteps)
{
  Scene scene = drilling(1e-6);
  scene.numerics.step = 0.001;
  Simulator reference(scene);
  scene.numerics.integrator = IntegratorKind::bdf2;
  scene.numerics.step = 0.0002;
  Simulator stepper(scene);
  for (Simulator* simulator : {&reference, &stepper})
  {
    start_up(*simulator);
    run(*simulator, 1.0);
  }
  const Truth &a = reference.truth(), &b = stepper.truth();
  EXPECT_GT(a.wob, 5e3);
  EXPECT_NEAR(a.hook_load, b.hook_load, 1e-4 * b.hook_load);
  EXPECT_NEAR(a.wob, b.wob, 0.01 * b.wob);
  EXPECT_NEAR(a.bit_speed, b.bit_speed, 0.01 * std::abs(b.bit_speed));
  EXPECT_LT((a.bit_position - b.bit_position).norm(), 2e-5);
}

TEST(Reference, JointsHoldWhileItDrills)
{
  for (const double tolerance : {1e-6, 1e-7})
  {
    Scene scene = drilling(tolerance);
    scene.rig.hoisting.rail_friction =
        0.0;  // where the block begins to slide, forces have a kink, and the joints' rates twice the drift
    Simulator simulator(scene);
    start_up(simulator);
    run(simulator, 1.0);
    ASSERT_TRUE(simulator.statistics().is_reference);
    const ReferenceReport& report = simulator.statistics().reference;
    // Newton's method leaves less than the tolerance, of rates, and a hundredth of it, of m or rad, in root mean square over the
    // unknowns (some 300): one of them may be off by the root of their number. What the worst of 4000 steps leaves is chance: at
    // 1e-6 it is 2e-7 by SUNDIALS 6.4 and 3e-6 by 4.1, and by both it falls with the tolerance.
    EXPECT_LT(report.drift, 0.01 * tolerance * std::sqrt(300.0));
    EXPECT_LT(report.rate_drift, tolerance * std::sqrt(300.0));
    EXPECT_GT(report.ida.steps, 100u);
  }
}

// IDA's memory is no part of a snapshot: it starts afresh, and the runs agree within the tolerance.
TEST(Reference, RunsRepeatWithinTheToleranceAfterARestore)
{
  Simulator simulator(drilling(1e-7));
  start_up(simulator);
  run(simulator, 0.2);
  const auto saved = simulator.save();
  run(simulator, 0.1);
  const Truth first = simulator.truth();
  simulator.restore(*saved);
  run(simulator, 0.1);
  EXPECT_LT((simulator.truth().bit_position - first.bit_position).norm(), 1e-7);
  EXPECT_NEAR(simulator.truth().hook_load, first.hook_load, 1e-5 * first.hook_load);
  EXPECT_DOUBLE_EQ(simulator.truth().time, first.time);
}

TEST(Reference, EachBodyHasItsNodesMassAndTheMudsAtItsSide)
{
  const Scene scene = scene_in({{0.0, 0.0, 0.3}, {60.0, 0.0, 0.3}}, 50.0, 50.0, 0.3);
  RigAtRest rest = build_at_rest(scene);
  Stage stage(*rest.model);
  Workspace work(*rest.model);
  RigDae rig(*rest.model, stage, work, rest.state, Formulation::stabilised_index_2, 1e-6);
  begin_step(*rest.model, rest.state, kStep, Setpoints(), stage);
  const std::vector<double> y = rig.initial(rest.state);
  EXPECT_TRUE(rig.begin(0.0, rest.state, Setpoints(), y)) << "the mud's comes in";
  EXPECT_FALSE(rig.begin(0.0, rest.state, Setpoints(), y)) << "as before";

  // the force that one m/s2 sideways takes
  const auto mass_of = [&](int body)
  {
    std::vector<double> rate(y.size(), 0.0), still(y.size()), moved(y.size());
    rig.residual(0.0, y.data(), rate.data(), still.data());
    const std::size_t k = 12 * static_cast<std::size_t>(body) + 6;
    rate[k] = 1.0;
    rig.residual(0.0, y.data(), rate.data(), moved.data());
    return std::abs(moved[k] - still[k]);
  };
  const Mesh& mesh = rest.model->mesh();
  const int bit = rest.model->nodes();
  EXPECT_NEAR(mesh.nodes[0].mass + stage.added_mass[0], mass_of(0) + mass_of(bit), 1e-6);
  EXPECT_NEAR(mesh.bit_mass, mass_of(bit), 1e-6) << "its gauge squeezes a film instead";
  ASSERT_GT(stage.added_mass[1], 1.0);
  for (const int i : {1, 2}) EXPECT_NEAR(mesh.nodes[i].mass + stage.added_mass[i], mass_of(i), 1e-6) << i;

  stage.added_mass[1] = 0.0;
  EXPECT_TRUE(rig.begin(0.0, rest.state, Setpoints(), y));
  EXPECT_NEAR(mesh.nodes[1].mass, mass_of(1), 1e-6) << "out of the mud";
}

namespace
{
void expect_exact_jacobian(TopDriveMode mode)
{
  Scene scene = drilling(1e-6);
  // the tangents are those of a step, in which the axes of damping stand still: what tilts with the section is left out, some
  // 1e-5 of the row for the mud's drag
  scene.numerics.structural_damping = 0.0;
  scene.mud.lateral_damping = scene.mud.axial_damping;
  scene.mud.drag_coefficient = 0.0;
  scene.mud.torsional_damping = 0.0;
  // the same state on every machine: how near a corner of its law some contact stands goes by rounding
  scene.numerics.kernel = Kernel::scalar;
  Simulator simulator(scene);
  start_up(simulator);
  run(simulator, 0.5);
  RigAtRest rest = build_at_rest(scene);
  State state = simulator.save()->mechanics;
  Stage stage(*rest.model);
  Workspace work(*rest.model);
  RigDae rig(*rest.model, stage, work, state, Formulation::stabilised_index_2, 1e-6);
  Setpoints setpoints;
  setpoints.top_drive.speed = 8.0;
  setpoints.top_drive.mode = mode;
  begin_step(*rest.model, state, kStep, setpoints, stage);
  std::vector<double> y = rig.initial(state), rate;
  rig.begin(0.0, state, setpoints, y);
  ASSERT_TRUE(rig.make_consistent(0.0, y, rate));
  rig.begin(0.0, state, setpoints, y);
  const auto n = y.size();
  const double t = 0.1 * kStep, c = 500.0;
  // on the way: at the very start of an interval sliding contacts stand at the corner of their law; but not far: the arms of the
  // elements' middles stay those of the start, half-way that is 2e-6 of a row
  for (std::size_t k = 0; k < n; ++k) y[k] += t * rate[k];
  SparseJacobian jacobian(static_cast<int>(n));
  jacobian.begin();
  rig.jacobian(t, y.data(), rate.data(), c, jacobian);
  jacobian.finish();
  std::vector<double> x(n), column(n), above(n), below(n), difference(n), scale(n, 0.0), off(n, 0.0);
  for (std::size_t k = 0; k < n; ++k)
  {
    std::fill(x.begin(), x.end(), 0.0);
    x[k] = 1.0;
    jacobian.multiply(x.data(), column.data());
    // multipliers are forces
    const double h = static_cast<int>(k) >= rig.multipliers_at() ? 1.0 : 1e-8;
    for (const double sign : {1.0, -1.0})
    {
      std::vector<double> moved = y, moved_rate = rate;
      moved[k] += sign * h;
      moved_rate[k] += sign * c * h;
      rig.residual(t, moved.data(), moved_rate.data(), sign > 0.0 ? above.data() : below.data());
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      scale[i] = std::max(scale[i], std::abs(column[i]));
      off[i] = std::max(off[i], std::abs(column[i] - (above[i] - below[i]) / (2.0 * h)));
    }
  }
  // of the largest entry of the row; round-off of forces over 1e-8 m
  for (std::size_t i = 0; i < n; ++i) EXPECT_LT(off[i], 1e-6 * scale[i] + 1e-6) << i;
}
}  // namespace

TEST(Reference, JacobianOfTheRigByFiniteDifferences)
{
  for (const TopDriveMode mode : {TopDriveMode::speed, TopDriveMode::soft_torque, TopDriveMode::z_torque})
  {
    SCOPED_TRACE(static_cast<int>(mode));
    expect_exact_jacobian(mode);
  }
}
}  // namespace test_solve_reference
