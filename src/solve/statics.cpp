// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/statics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/force.h"
#include "drill_rig_sim/model/forces/mud_drag.h"
#include "drill_rig_sim/solve/kinsol_equilibrium.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double kFirstCoefficient = 100.0;  // c at the start: inertia of 10 ms steps [1/s]
constexpr double kLastCoefficient = 0.01;    // below this inertia is gone beside every stiffness [1/s]
constexpr double kLongMove = 0.02;           // a longer increment is cut, and c stays [m, rad]
constexpr double kLongSpin = 1.0;            // the same of spin where the string turns: friction twists it by many radians [rad]
constexpr int kMaxContinuation = 400;
constexpr int kMostRounds = 3;  // of continuation and Newton's method
constexpr int kMaxNewton = 100;
constexpr double kMoreInertia = 3.0;                   // c grows by that where the next increment would go uphill
constexpr double kMoreShare = 0.02, kMostShare = 0.9;  // and falls more slowly from then on: else it snaps to and fro for ever
constexpr double kHoldStiffness = 1e7;                 // about the bend's axis [N m/rad]
constexpr double kLeastShare = 0.03;
constexpr int kMostTried =
    kMaxContinuation + kMaxNewton;   // of one share of the friction: a helix that goes on turning settles in less of it
constexpr double kTolerance = 1e-3;  // residual: round-off of a kilometre of steel is 1e-4 [N, N m]

double largest_magnitude(const std::vector<double>& values)
{
  double most = 0.0;
  for (double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// The same of the increments of a string that turns: of place and tilt, and of spin in the measure of a long move.
double largest_of_turning(const std::vector<double>& move, const std::vector<Vector3d>& normals)
{
  double most = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Eigen::Map<const Vector3d> place(&move[6 * i]), rotation(&move[6 * i + 3]);
    const double spin = rotation.dot(normals[i]);
    const Vector3d tilt = rotation - spin * normals[i];
    most =
        std::max({most, place.lpNorm<Eigen::Infinity>(), tilt.lpNorm<Eigen::Infinity>(), std::abs(spin) * kLongMove / kLongSpin});
  }
  return most;
}

/// The forces at rest, and beside them the torque that holds a bend.
class StaticForces
{
public:
  StaticForces(const Model& model, const State& state, const ToolfaceHold& hold, bool in_mud)
      : stage(model), work(model), model_(model), state_(state), hold_(hold), in_mud_(in_mud)
  {
  }

  void begin(const SlidingMotion& sliding, double coefficient) noexcept
  {
    begin_static(model_, state_, sliding, coefficient, stage);
  }

  void evaluate(const double* u, double* residual, BlockTridiagonal* tangent) noexcept
  {
    evaluate_static(model_, state_, stage, u, work, residual, tangent);
    if (in_mud_) add_mud_drag(residual);
    if (hold_.node < 0) return;
    const Vector3d axis = x_axis(work.nodes[static_cast<std::size_t>(hold_.node)].orientation);
    at_node(residual, hold_.node).tail<3>() -= torque() * axis;
    if (tangent) tangent->diagonal(hold_.node).bottomRightCorner<3, 3>() += kHoldStiffness * axis * axis.transpose();
  }

  /// With which the bend is held, + clockwise [N m].
  double torque() const noexcept
  {
    if (hold_.node < 0) return 0.0;
    const Eigen::Quaterniond& q = work.nodes[static_cast<std::size_t>(hold_.node)].orientation;
    const double toolface = angle_about(x_axis(q), toolface_side(x_axis(q), hold_.hole), y_axis(q));
    return -kHoldStiffness * std::remainder(toolface - hold_.toolface, 2.0 * pi);
  }

  Stage stage;
  Workspace work;

private:
  /// At the speeds of the motion, which the stage's nodes do not have.
  void add_mud_drag(double* residual) const noexcept
  {
    for (int i = 0; i < model_.nodes(); ++i)
    {
      const bool guided = stage.guides.guided[static_cast<std::size_t>(i)];
      const Vector3d down = guided ? stage.guides.tangent[i] : stage.normal[i];
      at_node(residual, i) += mud_drag_of_sliding(model_, stage, i, down);
    }
  }

  const Model& model_;
  const State& state_;
  const ToolfaceHold hold_;
  const bool in_mud_;
};

/// Steps of pseudo-time, each one Newton iteration from rest; returns the iterations used. An increment that the forces do not
/// drive leads to an equilibrium that is none to rest in, as where compressed pipe snaps from one side of its hole to the other:
/// more inertia turns it round.
int continuation(const Model& model, State& state, const SlidingMotion& sliding, int most, StaticForces& forces)
{
  const int n = model.nodes();
  BlockTridiagonal tangent;
  tangent.resize(n, model.kernel());
  const std::vector<double> origin(6 * n, 0.0);
  std::vector<double> move(6 * n), residual(6 * n);
  double c = kFirstCoefficient, share = 0.5;  // of c that is left after an increment
  for (int k = 0; k < most; ++k)
  {
    forces.begin(sliding, c);
    forces.evaluate(origin.data(), residual.data(), &tangent);
    move = residual;
    if (!solve_increment(forces.stage, tangent, move.data())) return k + 1;
    if (std::inner_product(move.begin(), move.end(), residual.begin(), 0.0) < 0.0 && c < kFirstCoefficient)
    {
      c = std::min(kMoreInertia * c, kFirstCoefficient);
      share = std::min(kMostShare, share + kMoreShare);
      continue;
    }
    const double size = largest_magnitude(move);
    const double length = sliding.spin_speed != 0.0 ? largest_of_turning(move, forces.stage.normal) : size;
    const double scale = length > kLongMove ? kLongMove / length : 1.0;
    for (double& m : move) m *= -scale;
    forces.evaluate(move.data(), residual.data(), nullptr);
    commit(forces.stage, forces.work, state);
    advance_static(forces.work, state);
    if (size < 1e-7 && c <= kLastCoefficient) return k + 1;
    if (scale == 1.0)
      c = std::max(share * c, 0.5 * kLastCoefficient);
    else
      c = std::min(1.5 * c, kFirstCoefficient);
  }
  return most;
}

/// What rounding the nodes' places leaves of a residual, the largest over the elements: places are known to eps times themselves,
/// and an element answers with its stiffness, along its chord and across it [N].
double round_off(const Mesh& mesh, const State& state)
{
  double most = 0.0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const BeamSection& section = mesh.elements[e].section;
    const Eigen::Array3d lower = state.nodes[e].position.array(), upper = state.nodes[e + 1].position.array();
    const Eigen::Array3d error = 2.0 * std::numeric_limits<double>::epsilon() * lower.abs().max(upper.abs());
    const Eigen::Array3d chord = (lower - upper).abs() / section.length;
    const double along = (chord * error).sum();
    const double across = (error * (1.0 - chord * chord).max(0.0).sqrt()).matrix().norm();
    const double shear = 2.0 * (section.bending_near + section.bending_far) / (section.length * section.length);
    most = std::max(most, section.axial / section.length * along + shear * across);
  }
  return most;
}

void clear_motion(State& state)
{
  for (NodeState& node : state.nodes)
  {
    node.rate = NodeRate();
    node.bristle.setZero();
    node.rest = 0.0;
    node.spin_angle = 0.0;
  }
  for (SpanState& span : state.spans)
  {
    span.bristle.setZero();
    span.rest = 0.0;
  }
  state.memory.last_step = 0.0;
}

/// Newton's method from `state`, which is moved to what it finds.
KinsolOutcome finish(const Model& model, State& state, const SlidingMotion& sliding, int most, StaticForces& forces)
{
  BlockTridiagonal tangent;
  tangent.resize(model.nodes(), model.kernel());
  std::vector<double> scratch(6 * model.nodes()), u(scratch.size(), 0.0);
  NonlinearProblem problem;
  problem.residual = [&](const double* at, double* residual) { forces.evaluate(at, residual, nullptr); };
  problem.solve_tangent = [&](const double* at, double* b)
  {
    forces.evaluate(at, scratch.data(), &tangent);
    return solve_increment(forces.stage, tangent, b);
  };
  forces.begin(sliding, 0.0);
  KinsolOutcome out = kinsol_solve(problem, kTolerance, most, u);
  forces.evaluate(u.data(), scratch.data(), nullptr);
  find_string_forces(model, state, forces.stage, forces.work);
  commit(forces.stage, forces.work, state);
  advance_static(forces.work, state);
  out.converged = out.converged || out.residual <= round_off(model.mesh(), state);
  return out;
}

/// From the guess `state` to the equilibrium with the friction that `sliding` says, in one go.
StaticOutcome attempt(const Model& model, State& state, const SlidingMotion& sliding, int most_iterations,
                      const ToolfaceHold& hold, bool in_mud)
{
  StaticForces forces(model, state, hold, in_mud);
  StaticOutcome out;
  for (int round = 0; round < kMostRounds && !out.converged && (round == 0 || out.iterations < most_iterations); ++round)
  {
    // a helix slides round its hole until it rests, millimetre by millimetre
    out.iterations +=
        continuation(model, state, sliding, std::min(kMaxContinuation << (2 * round), most_iterations - out.iterations), forces);
    const KinsolOutcome finished = finish(model, state, sliding, std::min(kMaxNewton, most_iterations - out.iterations), forces);
    out.converged = finished.converged;
    out.iterations += finished.iterations;
    out.residual = finished.residual;
    if (!std::isfinite(finished.residual)) break;
  }
  const StageResult& result = forces.work.result;
  out.holding_torque = forces.torque();
  out.top_force = result.held_force;
  out.top_torque = result.held_torque;
  out.forces = result.forces;
  out.share = sliding.share;
  clear_motion(state);
  return out;
}
}  // namespace

StaticOutcome solve_held(const Model& model, State& state, const ToolfaceHold& hold, int most_iterations)
{
  return attempt(model, state, no_sliding, most_iterations, hold, false);
}

StaticOutcome solve_static(const Model& model, State& state, const SlidingMotion& sliding, int most_iterations,
                           double first_share, bool in_mud)
{
  const ToolfaceHold free;
  if (sliding.still()) return attempt(model, state, sliding, most_iterations, free, in_mud);
  SlidingMotion part = sliding;
  StaticOutcome found;
  found.share = 0.0;
  double step = first_share;
  while (found.share < 1.0 && step >= kLeastShare && found.iterations < most_iterations)
  {
    part.share = std::min(1.0, found.share + step);
    State next = state;
    StaticOutcome outcome = attempt(model, next, part, std::min(kMostTried, most_iterations - found.iterations), free, in_mud);
    outcome.iterations += found.iterations;
    if (outcome.converged)
    {
      state = next;
      found = outcome;
      continue;
    }
    outcome.share = 0.0;
    if (found.share > 0.0)
      found.iterations = outcome.iterations;
    else
      found = outcome;
    step = std::min(0.5 * step, gradual_share);
  }
  found.converged = found.share == 1.0;
  found.gradual = step < 1.0;
  return found;
}

}  // namespace drill_rig_sim
