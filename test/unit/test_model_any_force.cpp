// SPDX-License-Identifier: BSD-3-Clause
// A force of this test only, a spring, a couple and a damper, at each node of a string, at every level: nothing of it may be
// lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "drill_rig_sim/model/forces/lists.h"
#include "tangent_check.h"

namespace test_model_any_force
{
using namespace drill_rig_sim;

namespace
{
/// What the force does, at one node.
struct Trial
{
  int node = 0;
  double stiffness = 0.0, torsion = 0.0;  // of springs to `anchor` and against spin about the axis [N/m, N m/rad]
  double damping = 0.0;                   // [N s/m, N m s/rad]
  Vector3d anchor = Vector3d::Zero();     // [m]
  Vector6d constant = Vector6d::Zero();   // [N, N m]
};
Trial trial;

Vector6d force_of(const StageContext& at)
{
  const NodeMotion& node = at.node(trial.node);
  Vector6d out = trial.constant + trial.damping * node.rate;
  out.head<3>() += trial.stiffness * (node.position - trial.anchor);
  out.tail<3>() += trial.torsion * node.spin * node.axis;
  return out;
}

void add_trial(const StageContext& at, const ForceRows& to) noexcept
{
  to.force(trial.node) += force_of(at);
  if (!to.with_tangent()) return;
  const Vector3d& n = at.node(trial.node).axis;
  auto slope = to.slope(trial.node);
  slope.diagonal().array() += at.stage.dv_du * trial.damping;
  slope.topLeftCorner<3, 3>().diagonal().array() += trial.stiffness;
  slope.bottomRightCorner<3, 3>() += trial.torsion * n * n.transpose();
}

void store_trial(const StageContext& at, StoredEnergy& energy) noexcept
{
  const NodeMotion& node = at.node(trial.node);
  energy.beams += 0.5 * (trial.stiffness * (node.position - trial.anchor).squaredNorm() + trial.torsion * node.spin * node.spin);
}

void sample_trial(const StageContext& at, EnergySample& sample) noexcept
{
  at_node(sample, NodeForce::beams, trial.node) += force_of(at);
}

const Force any_force = {"any", Cost::rig, Sum::none, add_trial, add_trial, nullptr, store_trial, sample_trial};

/// All forces and that one, in its place in the list.
ForceList with_trial()
{
  static std::vector<const Force*> list;
  list.assign(all_forces.begin(), all_forces.end());
  list.insert(std::find(list.begin(), list.end(), &guided_string), &any_force);
  return {list.data(), list.data() + list.size()};
}

template <bool statics>
void evaluate_tried(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work,
                    double* residual, BlockTridiagonal* tangent) noexcept
{
  evaluate_forces(with_trial(), statics ? &Force::add_static : &Force::add, {model, start, stage, work}, u, residual, tangent);
}

struct Case
{
  Level level;
  double free_length;  // [m]
  Kernel kernel;
};

std::ostream& operator<<(std::ostream& out, const Case& c)
{
  return out << "level " << static_cast<int>(c.level) << (c.kernel == Kernel::scalar ? ", scalar" : ", in lanes");
}

/// Built to 40 deg, then held.
Scene scene_of(const Case& c, double friction)
{
  Scene scene = scene_in(build_and_hold(40.0, 0.15 * degree, 40.0 * degree, 2.0, 500.0), 500.0, 400.0, friction);
  scene.numerics.level = c.level;
  scene.numerics.free_length = c.free_length;
  scene.numerics.kernel = c.kernel;
  return scene;
}

class AnyForce : public testing::TestWithParam<Case>
{
protected:
  /// A node's springs, pulled to the side and turned, with everything at once.
  static Trial at_node(const State& state, int i)
  {
    return {i,
            2e4,
            300.0,
            50.0,
            state.nodes[static_cast<std::size_t>(i)].position + Vector3d(0.3, -0.2, 0.5),
            Vector6d::LinSpaced(100.0, 600.0)};
  }
};

/// Nodes that nothing else holds: not the top drive's shaft.
int tried_nodes(const Model& model)
{
  return model.top();
}

/// The tangent with the force is as good as the one without, whose worst column that is, or as what the step's tilt leaves
/// (test_model_guided).
void expect_as_exact(Problem problem, double without, decltype(&evaluate) tried, const VectorXd& u, double difference, int held)
{
  problem.evaluator = tried;
  EXPECT_LT(worst_column(problem, u, difference, held), std::max(1e-5, 1.5 * without)) << "node " << trial.node;
}
}  // namespace

TEST_P(AnyForce, tangentAtEachNode)
{
  Rig rig(scene_of(GetParam(), 0.3));
  rig.setpoints.winch = {-0.2, false};
  rig.setpoints.top_drive.speed = 30.0 * rpm;
  rig.run(1.0);
  Problem alone = next_step(rig);
  const VectorXd u = increments_without_tilt(rig);
  const double without = worst_column(alone, u, 1e-7, 0);
  for (int i = 0; i < tried_nodes(*rig.rest.model); i += 3)
  {
    trial = at_node(rig.rest.state, i);
    expect_as_exact(next_step(rig), without, evaluate_tried<false>, u, 1e-7, 0);
  }
}

TEST_P(AnyForce, tangentOfStaticsAtEachNode)
{
  const RigAtRest rig = build_at_rest(scene_of(GetParam(), 0.3));
  const VectorXd none = VectorXd::Zero(6 * rig.model->nodes());
  const auto sliding = [&rig]
  {
    Problem problem(rig, evaluate_static);
    begin_static(problem.model, problem.start, sliding_up, 0.0, problem.stage);
    return problem;
  };
  Problem alone = sliding();
  const double without = worst_column(alone, none, tangent_difference, 1);
  for (int i = 0; i < tried_nodes(*rig.model); i += 3)
  {
    trial = at_node(rig.state, i);
    trial.damping = 0.0;
    expect_as_exact(sliding(), without, evaluate_tried<true>, none, tangent_difference, 1);
  }
}

// Without friction what acts across the hole has no effect, and the residual changes by the force's share along and about it,
// there and nowhere else.
TEST_P(AnyForce, residualAtEachNode)
{
  Rig rig(scene_of(GetParam(), 0.0));
  rig.run(0.2);
  Problem problem = next_step(rig), tried = next_step(rig);
  tried.evaluator = evaluate_tried<false>;
  const VectorXd u = increments_without_tilt(rig);
  VectorXd before(u.size()), after(u.size());
  for (int i = 0; i < tried_nodes(*rig.rest.model); ++i)
  {
    trial = at_node(rig.rest.state, i);
    problem.at(u, before, nullptr);
    tried.at(u, after, nullptr);
    const Vector6d force = force_of({tried.model, tried.start, tried.stage, tried.work});
    EXPECT_GT(force.head<3>().norm(), 1e3);
    const std::vector<Coordinate> all = coordinates(problem);
    const VectorXd change = by_coordinates(all, after - before);
    for (std::size_t k = 0; k < all.size(); ++k)
      EXPECT_NEAR(all[k].node == i ? all[k].motion.dot(force) : 0.0, change[k], 1e-6 * force.norm())
          << "node " << i << ", row " << k;
  }
}

// What pushes guided pipe to its wall makes it rub.
TEST_P(AnyForce, loadOnTheWallAtEachNode)
{
  Rig rig(scene_of(GetParam(), 0.3));
  rig.run(0.2);
  Problem tried = next_step(rig);
  tried.evaluator = evaluate_tried<false>;
  const VectorXd u = increments_without_tilt(rig);
  VectorXd residual(u.size());
  for (int i = tried.model.mesh().gauge_nodes; i < tried_nodes(*rig.rest.model); ++i)
  {
    const GuideColumns& guides = tried.stage.guides;
    const Guide guide = guides[static_cast<std::size_t>(i)];
    if (i == 0 || !guides.guided[i - 1] || !guides.guided[i] || !guides.guided[i + 1]) continue;
    trial = {i};
    trial.constant.head<3>() = 2e4 * guide.tangent.cross(Vector3d(0.6, 0.8, 0.1)).normalized();
    tried.at(u, residual, nullptr);
    const double load = (tried.work.guided.lean[i] - trial.constant.head<3>()).norm(), size = std::sqrt(load * load + 1.0) - 1.0;
    EXPECT_GT(load, 1.5e4);
    EXPECT_NEAR(std::sqrt(size * size - guide.held * guide.held), tried.work.result.forces.contact[i], 1e-6 * load)
        << "node " << i;
  }
}

// The force of the energy balance is the gradient of what the springs hold, plus the rest, by each coordinate of the node.
TEST_P(AnyForce, energyAtEachNode)
{
  Rig rig(scene_of(GetParam(), 0.3));
  rig.run(0.2);
  Problem tried = next_step(rig);
  tried.evaluator = evaluate_tried<false>;
  const VectorXd u = increments_without_tilt(rig);
  VectorXd residual(u.size());
  const StageContext at{tried.model, tried.start, tried.stage, tried.work};
  for (int i = 0; i < tried_nodes(*rig.rest.model); ++i)
  {
    trial = at_node(rig.rest.state, i);
    trial.damping = 0.0;
    trial.constant.setZero();
    tried.at(u, residual, nullptr);
    EnergySample sample;
    for (std::vector<double>& force : sample.force) force.assign(static_cast<std::size_t>(u.size()), 0.0);
    sample_trial(at, sample);
    const Vector6d force = drill_rig_sim::at_node(sample, NodeForce::beams, i);
    for (const Coordinate& c : coordinates(tried))
    {
      if (c.node != i) continue;
      double stored[2];
      for (int side = 0; side < 2; ++side)
      {
        VectorXd moved = u;
        moved.segment<6>(6 * i) += (side == 0 ? -1e-5 : 1e-5) * c.motion;
        tried.at(moved, residual, nullptr);
        StoredEnergy energy;
        store_trial(at, energy);
        stored[side] = energy.beams;
      }
      EXPECT_NEAR(force.dot(c.motion), (stored[1] - stored[0]) / 2e-5, 1e-4 * force.norm()) << "node " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, AnyForce,
                         testing::Values(Case{Level::beam3d, 0.0, Kernel::scalar}, Case{Level::hybrid, 60.0, Kernel::scalar},
                                         Case{Level::axial_torsional, 0.0, Kernel::scalar},
                                         Case{Level::rigid, 0.0, Kernel::scalar}, Case{Level::beam3d, 0.0, Kernel::automatic},
                                         Case{Level::hybrid, 60.0, Kernel::automatic},
                                         Case{Level::axial_torsional, 0.0, Kernel::automatic},
                                         Case{Level::rigid, 0.0, Kernel::automatic}));

}  // namespace test_model_any_force
