// SPDX-License-Identifier: BSD-3-Clause
// The batch kernels against node by node and element by element, and their tangents against finite differences.
#include <gtest/gtest.h>

#include <functional>

#include "drill_rig_sim/math/visit.h"
#include "steerable_scenes.h"
#include "tangent_check.h"

namespace test_model_kernels
{
using namespace drill_rig_sim;

namespace
{
constexpr double rounding = 1e-12;  // of the terms summed, which are of the order of a row's stiffness times 1 m or 1 rad

std::vector<Kernel> wide_kernels()
{
  std::vector<Kernel> out;
  for (const Kernel kernel : all_kernels)
    if (kernel != Kernel::scalar && has_kernel(kernel)) out.push_back(kernel);
  return out;
}

/// A rig of the same scene and state whose model has that kernel.
struct Twin
{
  RigAtRest rest;
  Problem problem;

  Twin(const Scene& scene, Kernel kernel, const Rig& rig) : rest(of(scene, kernel, rig)), problem(rest, evaluate)
  {
    begin_step(problem.model, problem.start, tangent_step, rig.setpoints, problem.stage);
    prepare_bdf2(problem.start, tangent_step, problem.stage);
  }
  static RigAtRest of(Scene scene, Kernel kernel, const Rig& rig)
  {
    scene.numerics.kernel = kernel;
    return {std::make_shared<const Model>(scene, rig.rest.model->mesh()), rig.rest.state, {}};
  }
};

struct System
{
  VectorXd residual;
  MatrixXd tangent;
};

System system_of(Problem& problem, const VectorXd& u)
{
  System out{VectorXd(u.size()), dense_tangent(problem, u)};
  VectorXd residual(u.size());
  problem.at(u, residual, nullptr);
  out.residual = by_coordinates(coordinates(problem), residual);
  return out;
}

/// In every kernel, at the next step's increments. `in_tangent`: by how much a row's numbers may differ, over its largest.
/// `difference`: 0 if finite ones are left out.
void expect_same(const Scene& scene, const Rig& rig, double in_tangent = rounding, double difference = tangent_difference)
{
  VectorXd u(6 * rig.rest.model->nodes());
  predict(rig.rest.state, tangent_step, u.data());
  Twin scalar(scene, Kernel::scalar, rig);
  const System expected = system_of(scalar.problem, u);
  for (const Kernel kernel : wide_kernels())
  {
    Twin twin(scene, kernel, rig);
    ASSERT_NE(twin.problem.work.string, nullptr) << name_of(kernel);
    const System system = system_of(twin.problem, u);
    double worst_force = 0.0, worst_stiffness = 0.0;
    for (int row = 0; row < expected.residual.size(); ++row)
    {
      const double scale = expected.tangent.row(row).cwiseAbs().maxCoeff();
      worst_force = std::max(worst_force, std::abs(system.residual[row] - expected.residual[row]) / scale);
      worst_stiffness =
          std::max(worst_stiffness, (system.tangent.row(row) - expected.tangent.row(row)).cwiseAbs().maxCoeff() / scale);
    }
    EXPECT_LT(worst_force, rounding) << name_of(kernel);
    EXPECT_LT(worst_stiffness, in_tangent) << name_of(kernel);
    if (difference > 0.0)
    {
      EXPECT_LT(worst_column(twin.problem, increments_without_tilt(rig), difference), 1e-6) << name_of(kernel);
    }
  }
}

/// Above bottom in a hole that bends, reaches it and drills.
Scene plain_drilling()
{
  Scene scene = scene_in(build_and_hold(20.0, 0.1 * degree, 40.0 * degree, 2.0, 300.0), 300.0, 299.95, 0.3);
  scene.string.insert(scene.string.begin() + 1, collar_part(2, 9.4));
  return scene;
}

/// Lowered and turned a while by the scalar kernel.
struct Turned : Rig
{
  Turned(const Scene& scene, double seconds) : Rig(by_scalar(scene))
  {
    setpoints.winch = {-0.1, false};
    setpoints.top_drive.speed = 60.0 * rpm;
    run(seconds);
  }
  static Scene by_scalar(Scene scene)
  {
    scene.numerics.kernel = Kernel::scalar;
    return scene;
  }
};
/// Where the load on the wall of a guided node changes sides it does so within a newton: there a tension's rounding is more of
/// the tangent. (Finite differences: ModelGuided.)
constexpr double of_sides = 1e-9;

/// Guided throughout, built to 40 deg and held.
Scene guided_scene(double bit_depth)
{
  Scene scene = scene_in(build_and_hold(40.0, 0.15 * degree, 40.0 * degree, 2.0, 500.0), 500.0, bit_depth, 0.3);
  scene.contact.static_ratio = 1.3;
  scene.contact.stribeck_speed = 0.3;
  scene.contact.growth.per_fold = 0.05;
  scene.numerics.level = Level::axial_torsional;
  return scene;
}

/// What a step with this solution makes of its start.
State state_after(Problem& problem, const VectorXd& u)
{
  VectorXd residual(u.size());
  problem.at(u, residual, nullptr);
  expand_motions(problem.stage, problem.work);
  State state = problem.start;
  commit(problem.stage, problem.work, state);
  advance_static(problem.work, state);
  return state;
}
}  // namespace

// Strings of lengths that leave every number of elements over for the last batch.
TEST(ModelKernels, stringsOfAnyLength)
{
  for (double depth = 30.0; depth < 115.0; depth += 9.5)
  {
    const Scene scene = slanted_scene(depth, 0.3);
    SCOPED_TRACE(depth);
    expect_same(scene, Turned(scene, 1.0));
  }
}

TEST(ModelKernels, bentAndWithGaugeInACurvedHole)
{
  const Scene scene = scene_in(build_and_hold(0.0, 0.1 * degree, 40.0 * degree, 2.0, 400.0), 400.0, 300.0, 0.3);
  expect_same(scene, Turned(scene, 1.0));
}

TEST(ModelKernels, drillingWithABentMotor)
{
  const Scene scene = motor_drilling_scene(0.02);
  expect_same(scene, Turned(scene, 1.0));
}

// The shaft that points the bit is an element by itself: with others below it, and with the bit at its end.
TEST(ModelKernels, withAToolThatPoints)
{
  for (const double longest : {0.5, 4.75})
  {
    Scene scene = with_tool(slanted_scene(60.0, 0.3), pointing_part(2.0 * degree, 1.9));
    scene.numerics.element_length = longest;
    Turned rig(scene, 0.0);
    rig.setpoints.steering = {1.0, 1.0};
    rig.run(3.0);
    ASSERT_GT(rig.rest.state.lean.norm(), 1.0 * degree);
    expect_same(scene, rig);
  }
}

TEST(ModelKernels, slidingWithGrownFrictionInSectionsOfTheirOwn)
{
  for (const StribeckCurve curve : {StribeckCurve::gaussian, StribeckCurve::exponential})
  {
    Scene scene = slanted_scene(60.0, 0.3);
    scene.contact.static_ratio = 1.3;
    scene.contact.stribeck_curve = curve;
    scene.contact.growth.per_fold = 0.05;
    HoleSection upper = scene.well.sections[0];
    upper.to = 30.0;
    upper.friction = 0.2;
    upper.stribeck_speed = 0.2;
    scene.well.sections.insert(scene.well.sections.begin(), upper);
    expect_same(scene, Turned(scene, 0.2));  // begins to slip
    expect_same(scene, Turned(scene, 3.0));
  }
}

// Pipe above, or all of it: the kernels take the free stretch and leave the guided one.
TEST(ModelKernels, withGuidedPipeAbove)
{
  Scene scene = slanted_scene(110.0, 0.3);
  scene.numerics.level = Level::hybrid;
  scene.numerics.free_length = 40.0;
  expect_same(scene, Turned(scene, 1.0));
}

// Guided throughout, over a bend, of lengths that leave every number of nodes over; sticking and sliding, friction that grows at
// rest.
TEST(ModelKernels, guidedThroughout)
{
  for (double bit_depth = 330.0; bit_depth < 400.0; bit_depth += 9.5)
  {
    SCOPED_TRACE(bit_depth);
    const Scene scene = guided_scene(bit_depth);
    expect_same(scene, Turned(scene, 0.2), of_sides, 0.0);
    expect_same(scene, Turned(scene, 3.0), of_sides, 0.0);
  }
}

// Along the hole and around it, about the pipe by more than a small angle too, and onto the side that the wall's friction makes
// it climb to.
TEST(ModelKernels, endOfAGuidedStep)
{
  const Scene scene = guided_scene(390.0);
  const Turned rig(scene, 3.0);
  for (const double turn : {0.0, 2.0})
  {
    VectorXd u(6 * rig.rest.model->nodes());
    predict(rig.rest.state, tangent_step, u.data());
    for (int i = 0; i < rig.rest.model->nodes(); ++i)
      u.segment<3>(6 * i + 3) += turn * x_axis(rig.rest.state.nodes[i].orientation);
    Twin scalar(scene, Kernel::scalar, rig);
    const State expected = state_after(scalar.problem, u);
    for (const Kernel kernel : wide_kernels())
    {
      Twin twin(scene, kernel, rig);
      const State state = state_after(twin.problem, u);
      for (std::size_t i = 0; i < state.nodes.size(); ++i)
      {
        const NodeState &a = expected.nodes[i], &b = state.nodes[i];
        EXPECT_LT((a.position - b.position).norm(), 1e-11) << name_of(kernel);
        EXPECT_LT((a.orientation.coeffs() - b.orientation.coeffs()).norm(), 1e-13) << name_of(kernel);
        EXPECT_LT((a.side - b.side).norm(), 1e-11) << name_of(kernel);
        EXPECT_LT(std::abs(a.md - b.md) + std::abs(a.spin_angle - b.spin_angle), 1e-11) << name_of(kernel);
        EXPECT_LT(
            (a.rate.velocity - b.rate.velocity).norm() + (a.rate.tilt - b.rate.tilt).norm() + std::abs(a.rate.spin - b.rate.spin),
            1e-9)
            << name_of(kernel);
        EXPECT_LT((a.bristle - b.bristle).norm() + std::abs(a.rest - b.rest), 1e-11) << name_of(kernel);
        EXPECT_EQ(a.segment, b.segment);
      }
      for (std::size_t e = 0; e < state.spans.size(); ++e)
        EXPECT_NEAR(expected.spans[e].twist, state.spans[e].twist, 1e-12) << name_of(kernel);
    }
  }
}

// Half a turn in one step.
TEST(ModelKernels, turnedFar)
{
  const Scene scene = slanted_scene(60.0, 0.3);
  const Turned rig(scene, 1.0);
  for (const double turn : {0.3, 2.0, 4.0})
  {
    VectorXd u = VectorXd::Zero(6 * rig.rest.model->nodes());
    for (int i = 0; i < rig.rest.model->nodes(); ++i)
      u.segment<3>(6 * i + 3) = (turn + 0.01 * i) * x_axis(rig.rest.state.nodes[i].orientation) + Vector3d(0.0, 0.01, -0.02);
    Twin scalar(scene, Kernel::scalar, rig);
    VectorXd residual(u.size());
    scalar.problem.at(u, residual, nullptr);
    for (const Kernel kernel : wide_kernels())
    {
      Twin twin(scene, kernel, rig);
      twin.problem.at(u, residual, nullptr);
      for (int i = 0; i < rig.rest.model->nodes(); ++i)
      {
        const NodeMotion &a = scalar.problem.work.nodes[i], &b = twin.problem.work.nodes[i];
        EXPECT_LT((a.orientation.coeffs() - b.orientation.coeffs()).norm(), 1e-14) << name_of(kernel) << ", " << turn;
        EXPECT_LT((a.normal - b.normal).norm(), 1e-14) << name_of(kernel);
      }
    }
  }
}

TEST(ModelKernels, forcesAlongTheString)
{
  const Scene scene = motor_drilling_scene(0.02);
  const Turned rig(scene, 1.0);
  VectorXd u(6 * rig.rest.model->nodes());
  predict(rig.rest.state, tangent_step, u.data());
  Twin scalar(scene, Kernel::scalar, rig);
  update(scalar.problem.model, scalar.problem.start, scalar.problem.stage, u.data(), scalar.problem.work);
  find_string_forces(scalar.problem.model, scalar.problem.start, scalar.problem.stage, scalar.problem.work);
  const RigForces& expected = scalar.problem.work.result.forces;
  for (const Kernel kernel : wide_kernels())
  {
    Twin twin(scene, kernel, rig);
    update(twin.problem.model, twin.problem.start, twin.problem.stage, u.data(), twin.problem.work);
    find_string_forces(twin.problem.model, twin.problem.start, twin.problem.stage, twin.problem.work);
    const RigForces& forces = twin.problem.work.result.forces;
    for (std::size_t e = 0; e < expected.tension.size(); ++e)
    {
      EXPECT_NEAR(forces.tension[e], expected.tension[e], 1e-5) << name_of(kernel);
      EXPECT_NEAR(forces.torque[e], expected.torque[e], 1e-6) << name_of(kernel);
      EXPECT_NEAR(forces.bending_moment[e + 1], expected.bending_moment[e + 1], 1e-5) << name_of(kernel);
    }
  }
}

// Room that a search has left is a help, not a state: a run that begins anew from the state, at any step, goes on bit for bit.
TEST(ModelKernels, whatWasFoundBeforeChangesNothing)
{
  for (const Kernel kernel : wide_kernels())
  {
    Scene scene = plain_drilling();
    scene.numerics.kernel = kernel;
    Rig whole(scene), parts(scene);
    whole.setpoints.winch = parts.setpoints.winch = {-0.05, false};
    whole.setpoints.top_drive.speed = parts.setpoints.top_drive.speed = 60.0 * rpm;
    for (int part = 0; part < 20; ++part)
    {
      whole.run(0.2);
      Stepper fresh(parts.rest.model, find_method(IntegratorKind::automatic));
      fresh.limits().tolerance = 1e-9;
      for (int k = 0; k < 40; ++k) ASSERT_TRUE(fresh.advance(parts.rest.state, tangent_step, parts.setpoints));
    }
    EXPECT_EQ(to_bytes(whole.rest.state), to_bytes(parts.rest.state)) << name_of(kernel);
  }
}
}  // namespace test_model_kernels
