#include "drill_rig_sim/solve/statics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/solve/kinsol_equilibrium.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kFirstCoefficient = 100.0;  // c at the start: inertia of 10 ms steps [1/s]
constexpr double kLastCoefficient = 0.01;    // below this inertia is gone beside every stiffness [1/s]
constexpr double kLongMove = 0.02;           // a longer increment is cut, and c stays [m, rad]
constexpr double kLongSpin = 1.0;            // the same of spin where the string turns: friction twists it by many radians [rad]
constexpr int kMaxContinuation = 400;
constexpr int kMaxNewton = 100;
constexpr double kFirstShare = 0.25;         // of the friction, where the whole of it is too much at once
constexpr double kLeastShare = 0.01;
constexpr double kTolerance = 1e-3;          // residual: round-off of a kilometre of steel is 1e-4 [N, N m]

double largest_magnitude(const std::vector<double>& values)
{
  double most = 0.0;
  for (double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// The same of the increments of a string that turns: of place and tilt, and of spin in the measure of a long move.
double largest_of_turning(const std::vector<double>& move, const std::vector<Eigen::Vector3d>& normals)
{
  double most = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Eigen::Map<const Eigen::Vector3d> place(&move[6 * i]), rotation(&move[6 * i + 3]);
    const double spin = rotation.dot(normals[i]);
    const Eigen::Vector3d tilt = rotation - spin * normals[i];
    most = std::max({most, place.lpNorm<Eigen::Infinity>(), tilt.lpNorm<Eigen::Infinity>(), std::abs(spin) * kLongMove / kLongSpin});
  }
  return most;
}

/// Steps of pseudo-time, each one Newton iteration from rest; returns the iterations used.
int continuation(const Model& model, State& state, const SlidingMotion& sliding, int most, Stage& stage, Workspace& work)
{
  const int n = model.nodes();
  BlockTridiagonal tangent;
  tangent.resize(n, model.kernel());
  const std::vector<double> origin(6 * n, 0.0);
  std::vector<double> move(6 * n), residual(6 * n);
  double c = kFirstCoefficient;
  for (int k = 0; k < most; ++k)
  {
    begin_static(model, state, sliding, c, stage);
    evaluate_static(model, state, stage, origin.data(), work, move.data(), &tangent);
    if (!solve_increment(stage, tangent, move.data())) return k + 1;
    const double size = largest_magnitude(move);
    const double length = sliding.spin_speed != 0.0 ? largest_of_turning(move, stage.normal) : size;
    const double scale = length > kLongMove ? kLongMove / length : 1.0;
    for (double& m : move) m *= -scale;
    evaluate_static(model, state, stage, move.data(), work, residual.data(), nullptr);
    commit(stage, work, state);
    advance_static(work, state);
    if (size < 1e-7 && c <= kLastCoefficient) return k + 1;
    if (scale == 1.0) c = std::max(0.5 * c, 0.5 * kLastCoefficient);
    else c = std::min(1.5 * c, kFirstCoefficient);
  }
  return most;
}

/// What rounding the nodes' places leaves of a residual, the largest over the elements: places are known to eps times themselves, and an
/// element answers with its stiffness, along its chord and across it [N].
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

/// From the guess `state` to the equilibrium with the friction that `sliding` says, in one go.
StaticOutcome attempt(const Model& model, State& state, const SlidingMotion& sliding, int most_iterations)
{
  Stage stage(model);
  Workspace work(model);
  StaticOutcome out;
  out.iterations = continuation(model, state, sliding, std::min(kMaxContinuation, most_iterations), stage, work);

  BlockTridiagonal tangent;
  tangent.resize(model.nodes(), model.kernel());
  std::vector<double> scratch(6 * model.nodes());
  NonlinearProblem problem;
  problem.residual = [&](const double* u, double* residual) { evaluate_static(model, state, stage, u, work, residual, nullptr); };
  problem.solve_tangent = [&](const double* u, double* b)
  {
    evaluate_static(model, state, stage, u, work, scratch.data(), &tangent);
    return solve_increment(stage, tangent, b);
  };
  begin_static(model, state, sliding, 0.0, stage);
  std::vector<double> u(6 * model.nodes(), 0.0);
  const KinsolOutcome finished = kinsol_solve(problem, kTolerance, std::min(kMaxNewton, most_iterations - out.iterations), u);
  evaluate_static(model, state, stage, u.data(), work, scratch.data(), nullptr);
  find_string_forces(model, state, stage, work);
  commit(stage, work, state);
  advance_static(work, state);
  clear_motion(state);

  out.converged = finished.converged || finished.residual <= round_off(model.mesh(), state);
  out.iterations += finished.iterations;
  out.residual = finished.residual;
  out.top_force = work.result.held_force;
  out.top_torque = work.result.held_torque;
  out.forces = work.result.forces;
  out.share = sliding.share;
  return out;
}
}  // namespace

StaticOutcome solve_static(const Model& model, State& state, const SlidingMotion& sliding, int most_iterations)
{
  if (sliding.still()) return attempt(model, state, sliding, most_iterations);
  State last = state;
  StaticOutcome found = attempt(model, state, sliding, most_iterations);
  if (found.converged) return found;
  // the friction of a long string moves its nodes by metres: by and by
  SlidingMotion part = sliding;
  found.share = 0.0;
  for (double step = kFirstShare; found.share < 1.0 && step >= kLeastShare && found.iterations < most_iterations;)
  {
    part.share = std::min(1.0, found.share + step);
    State next = last;
    StaticOutcome outcome = attempt(model, next, part, most_iterations - found.iterations);
    outcome.iterations += found.iterations;
    if (outcome.converged)
    {
      last = next;
      found = outcome;
      continue;
    }
    found.iterations = outcome.iterations;
    step *= 0.5;
  }
  state = last;
  found.converged = found.share == 1.0;
  return found;
}

}  // namespace drill_rig_sim
