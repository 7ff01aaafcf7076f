// SPDX-License-Identifier: BSD-3-Clause
// Contact between the nodes: where an element's middle is and how it moves, what its force does to the ends, and what it is for:
// a joint of pipe under compression does not bow through the wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/forces/span_wall.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_model_span
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr int element = 2;

Scene plain_pipe()
{
  Scene scene = slanted_scene(60.0, 0.3);
  scene.string[1].pipe->tool_joint_diameter = 0.0;
  return scene;
}

/// Pipe without tool joints on the low side of a slant hole, its nodes on the move.
struct Pressed
{
  RigAtRest rig = build_at_rest(plain_pipe());
  Stage stage{*rig.model};
  Workspace work{*rig.model};
  std::vector<double> residual = std::vector<double>(6 * static_cast<std::size_t>(rig.model->nodes()), 0.0);

  Pressed()
  {
    for (std::size_t i = 0; i < rig.state.nodes.size(); ++i)
    {
      NodeState& node = rig.state.nodes[i];
      const double k = static_cast<double>(i);
      const Vector3d n = x_axis(node.orientation), tilt(0.1 * std::sin(k), 0.2 * std::cos(k), 0.05);
      node.rate = {Vector3d(0.2, -0.1 * std::cos(k), 0.3), tilt - n * n.dot(tilt), 4.0 + 0.3 * k};
    }
    begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
    prepare_start(rig.state, stage);
    update(*rig.model, rig.state, stage, residual.data(), work);
  }
  void add() { span_wall.add({*rig.model, rig.state, stage, work}, {work, residual.data(), nullptr}); }
  Vector6d on(int i) const { return Eigen::Map<const Vector6d>(residual.data() + 6 * i); }
};

/// The middle if every node had moved on at its rates for a time [m].
Vector3d middle_after(const Pressed& p, double time)
{
  const auto end = [&](int i, Vector3d& normal)
  {
    const NodeState& node = p.rig.state.nodes[i];
    normal = rotation_from_vector(time * node.rate.tilt) * x_axis(node.orientation);
    return Vector3d(node.position + time * node.rate.velocity);
  };
  Vector3d upper_normal, lower_normal;
  const Vector3d upper = end(element + 1, upper_normal), lower = end(element, lower_normal);
  const double length = p.rig.model->mesh().elements[element].section.length;
  // Hermite's cubic at its middle
  return 0.5 * upper + 0.125 * length * upper_normal + 0.5 * lower - 0.125 * length * lower_normal;
}
}  // namespace

TEST(Span, middleIsOnTheCubicAndMovesAsItsEndsSay)
{
  const Pressed p;
  const SpanMotion& span = p.work.spans[element];
  EXPECT_LT((span.position - middle_after(p, 0.0)).norm(), 1e-12);
  const Vector6d &lower = p.work.nodes[element].rate, &upper = p.work.nodes[element + 1].rate;
  const Vector3d speed =
      0.5 * (lower + upper).head<3>() + upper.tail<3>().cross(span.upper_arm) + lower.tail<3>().cross(span.lower_arm);
  constexpr double h = 1e-5;
  EXPECT_LT((speed - (middle_after(p, h) - middle_after(p, -h)) / (2.0 * h)).norm(), 1e-8);
}

// The ends get the force, its moment about any point, and its power, neither more nor less.
TEST(Span, forceIsSharedByItsEnds)
{
  Pressed p;
  for (SpanMotion& span : p.work.spans) span.touches = false;
  p.work.spans[element].touches = true;
  p.add();
  const SpanMotion& span = p.work.spans[element];
  const Vector3d force = p.work.result.forces.span_wall[element];
  ASSERT_GT(p.work.result.forces.span_contact[element], 50.0);
  const Vector6d lower = -p.on(element), upper = -p.on(element + 1);
  EXPECT_LT((lower.head<3>() + upper.head<3>() - force).norm(), 1e-9 * force.norm());
  for (int i = 0; i < p.rig.model->nodes(); ++i) EXPECT_EQ(p.on(i).norm() > 0.0, i == element || i == element + 1) << i;

  // the friction, on the pipe's surface, turns it
  const double radius = 0.5 * p.rig.model->mesh().elements[element].outer_diameter;
  const Vector3d outward = (span.position - span.closest.centre).normalized();
  const Vector3d moment = radius * outward.cross(force);
  const Vector6d &rate_lower = p.work.nodes[element].rate, &rate_upper = p.work.nodes[element + 1].rate;
  const Vector3d speed = 0.5 * (rate_lower + rate_upper).head<3>() + rate_upper.tail<3>().cross(span.upper_arm) +
                         rate_lower.tail<3>().cross(span.lower_arm);
  const double power = force.dot(speed) + moment.dot(0.5 * (rate_lower + rate_upper).tail<3>());
  EXPECT_NEAR(lower.dot(rate_lower) + upper.dot(rate_upper), power, 1e-6 * std::abs(power));

  const auto about = [](const Vector6d& wrench, const Vector3d& at)
  { return Vector3d(wrench.tail<3>() + at.cross(wrench.head<3>())); };
  const Vector3d sum = about(lower, p.rig.state.nodes[element].position) + about(upper, p.rig.state.nodes[element + 1].position);
  const Vector3d wanted = moment + span.position.cross(force);
  // the arms are along the normals, the chord is a thousandth of a metre off them
  EXPECT_LT((sum - wanted).norm(), 2e-3 * force.norm() + 1e-9 * wanted.norm());
}

TEST(Span, clearOfTheWallOrAboveTheTableThereIsNothing)
{
  RigAtRest rig = build_at_rest(vertical_scene(100.0, 60.0));
  Stage stage(*rig.model);
  Workspace work(*rig.model);
  const std::vector<double> u(6 * static_cast<std::size_t>(rig.model->nodes()), 0.0);
  begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
  prepare_start(rig.state, stage);
  update(*rig.model, rig.state, stage, u.data(), work);
  for (const SpanMotion& span : work.spans) EXPECT_FALSE(span.touches);
  EXPECT_EQ(0.0, *std::max_element(work.result.forces.span_contact.begin(), work.result.forces.span_contact.end()));
}
}  // namespace test_model_span
