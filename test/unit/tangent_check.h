// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_TANGENT_CHECK_H
#define DRILL_RIG_SIM_TEST_TANGENT_CHECK_H

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

/// The tangent of the whole model against finite differences of its residual.
namespace drill_rig_sim
{
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double tangent_step = 0.005;  // [s]
constexpr double tangent_difference =
    3e-7;  // [m, rad]: penetrations are some 1e-5 under the gauge, 1e-4 elsewhere, round-off of a place 1e-13

/// A rig in a situation, and how many nodes touch the wall in it.
struct Rig
{
  RigAtRest rest;
  Stepper stepper;
  Setpoints setpoints;

  explicit Rig(const Scene& scene) : rest(build_at_rest(scene)), stepper(rest.model, find_method(IntegratorKind::automatic))
  {
    stepper.limits().tolerance = 1e-9;  // on the residual's solution, so that only the tangent is on trial
  }
  void run(double seconds)
  {
    for (int k = 0; k < std::lround(seconds / tangent_step); ++k)
      ASSERT_TRUE(stepper.advance(rest.state, tangent_step, setpoints));
  }
  /// Of the elements' middles that touch.
  int spans()
  {
    const auto& contact = stepper.find_forces(rest.state).span_contact;
    return static_cast<int>(std::count_if(contact.begin(), contact.end(), [](double f) { return f > 0.0; }));
  }
  int contacts()
  {
    const auto& contact = stepper.find_forces(rest.state).contact;
    return static_cast<int>(std::count_if(contact.begin(), contact.end(), [](double f) { return f > 0.0; }));
  }
};

/// Makes the formation hold node `i`, then pulls and turns the string.
inline void pull_at_stuck_point(Rig& rig, int i)
{
  const NodeState& held = rig.rest.state.nodes[i];
  rig.rest.state.stuck_point = {i, held.position, held.spin_angle};
  rig.setpoints.winch = {0.1, false};
  rig.setpoints.top_drive.speed = 30.0 * rpm;
  rig.run(1.5);
}

/// Lets the slips hold node `i`, slacks off and turns the drive against them.
inline void rest_in_slips(Rig& rig, int i)
{
  const NodeState& held = rig.rest.state.nodes[i];
  rig.rest.state.slips = {i, held.position, held.spin_angle};
  rig.setpoints.winch = {-0.02, false};
  rig.setpoints.top_drive.speed = 3.0 * rpm;
  rig.run(1.0);
  ASSERT_LT(rig.rest.state.nodes[i].position.z(), rig.rest.state.slips.position.z());
}

/// A stage, and what evaluates it: evaluate() or evaluate_static().
struct Problem
{
  const Model& model;
  const State& start;
  decltype(&evaluate) evaluator;
  Stage stage;
  Workspace work;

  Problem(const RigAtRest& rig, decltype(&evaluate) how)
      : model(*rig.model), start(rig.state), evaluator(how), stage(model), work(model)
  {
  }
  void at(const VectorXd& u, VectorXd& residual, BlockTridiagonal* tangent)
  {
    evaluator(model, start, stage, u.data(), work, residual.data(), tangent);
  }
};

/// A coordinate of the string: the place of its row, and what it does to the six numbers of its node.
struct Coordinate
{
  int node, place;
  Vector6d motion;
};

/// All that are free to move, node by node: of a free node six, of the shaft of the top drive two, of a guided node two.
inline std::vector<Coordinate> coordinates(const Problem& problem)
{
  std::vector<Coordinate> out;
  for (int i = 0; i < problem.model.nodes(); ++i)
  {
    if (problem.stage.guides.guided[static_cast<std::size_t>(i)])
    {
      const Guide guide = problem.stage.guides[static_cast<std::size_t>(i)];
      Vector6d along, about;
      along << guide.tangent, guide.turn;
      about << Vector3d::Zero(), guide.tangent;
      out.push_back({i, 0, along});
      out.push_back({i, 1, about});
      continue;
    }
    for (int k = 0; k < 6; ++k)
      if (i < problem.model.top() || k == 2 || k == 5) out.push_back({i, k, Vector6d::Unit(k)});
  }
  return out;
}

/// A residual by coordinates.
inline VectorXd by_coordinates(const std::vector<Coordinate>& coordinates, const VectorXd& residual)
{
  VectorXd out(coordinates.size());
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    out[k] = coordinates[k].motion.dot(residual.segment<6>(6 * coordinates[k].node));
  return out;
}

/// The step's tangent at increments u, by coordinates.
inline MatrixXd dense_tangent(Problem& problem, const VectorXd& u)
{
  const int n = problem.model.nodes();
  BlockTridiagonal t;
  t.resize(n);
  VectorXd residual(6 * n);
  problem.at(u, residual, &t);
  MatrixXd places = MatrixXd::Zero(6 * n, 6 * n);
  for (int i = 0; i < n; ++i)
  {
    if (t.small(i))
      places.block<2, 2>(6 * i, 6 * i) = t.small_diagonal(i);
    else
      places.block<6, 6>(6 * i, 6 * i) = t.diagonal(i);
    if (i + 1 == n) continue;
    if (t.small(i) && t.small(i + 1))
    {
      places.block<2, 2>(6 * i, 6 * i + 6) = t.small_upper(i);
      places.block<2, 2>(6 * i + 6, 6 * i) = t.small_lower(i);
      continue;
    }
    places.block<6, 6>(6 * i, 6 * i + 6) = t.upper(i);
    places.block<6, 6>(6 * i + 6, 6 * i) = t.lower(i);
  }
  const std::vector<Coordinate> all = coordinates(problem);
  MatrixXd out(all.size(), all.size());
  for (std::size_t r = 0; r < all.size(); ++r)
    for (std::size_t c = 0; c < all.size(); ++c)
      out(r, c) = places(6 * all[r].node + all[r].place, 6 * all[c].node + all[c].place);
  return out;
}

/// Central difference, fourth order, so that the step can stay far above round-off.
inline VectorXd difference(Problem& problem, const VectorXd& u, const Coordinate& column, double h)
{
  VectorXd out = VectorXd::Zero(u.size()), residual(u.size());
  const double at[4] = {-2.0, -1.0, 1.0, 2.0}, weight[4] = {1.0, -8.0, 8.0, -1.0};
  for (int k = 0; k < 4; ++k)
  {
    VectorXd moved = u;
    moved.segment<6>(6 * column.node) += at[k] * h * column.motion;
    problem.at(moved, residual, nullptr);
    out += weight[k] / (12.0 * h) * residual;
  }
  return out;
}

/// Largest relative error of a column of those nodes, all but the highest `held`.
inline double worst_column(Problem& problem, const VectorXd& u, double h, int held = 0)
{
  const MatrixXd tangent = dense_tangent(problem, u);
  const std::vector<Coordinate> all = coordinates(problem);
  double worst = 0.0;
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    if (all[c].node >= problem.model.nodes() - held) continue;
    const VectorXd reference = by_coordinates(all, difference(problem, u, all[c], h));
    worst = std::max(worst, (tangent.col(c) - reference).norm() / tangent.col(c).norm());
  }
  return worst;
}

/// The next step's increments as predicted; tilts are left out: rotations are exp(tilt) exp(spin n), and the tangent is that of
/// rotations about the place itself, the derivative wherever the step's tilt is zero.
inline VectorXd increments_without_tilt(const Rig& rig)
{
  VectorXd u(6 * rig.rest.model->nodes());
  predict(rig.rest.state, tangent_step, u.data());
  for (int i = 0; i < rig.rest.model->nodes(); ++i)
  {
    const Vector3d n = x_axis(rig.rest.state.nodes[i].orientation);
    u.segment<3>(6 * i + 3) = n * n.dot(u.segment<3>(6 * i + 3));
  }
  return u;
}

/// The rig's next step.
inline Problem next_step(const Rig& rig)
{
  Problem problem(rig.rest, evaluate);
  begin_step(problem.model, problem.start, tangent_step, rig.setpoints, problem.stage);
  prepare_bdf2(problem.start, tangent_step, problem.stage);
  return problem;
}

inline void expect_exact(const Rig& rig, double difference = tangent_difference, double tolerance = 1e-6)
{
  Problem problem = next_step(rig);
  EXPECT_LT(worst_column(problem, increments_without_tilt(rig), difference), tolerance);
}

}  // namespace drill_rig_sim

#endif
