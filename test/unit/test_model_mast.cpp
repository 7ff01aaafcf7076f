// SPDX-License-Identifier: BSD-3-Clause
// Pipe above the rotary table: the mast bounds it.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/model/mast.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_model_mast
{
using namespace drill_rig_sim;

namespace
{
/// On the line above the table, `md` negative, or in the hole.
ClosestPoint at(double md, double radius)
{
  ClosestPoint closest;
  closest.md = md;
  closest.segment = md < 0.0 ? 0 : 1;
  closest.radius = radius;
  return closest;
}

ClosestPoint in_mast(double md, double radius = 0.1)
{
  ClosestPoint closest = at(md, radius);
  open_mast(closest);
  return closest;
}
}  // namespace

TEST(Mast, opensFromTheTableToItsInside)
{
  EXPECT_DOUBLE_EQ(in_mast(1.0).radius, 0.1);
  EXPECT_DOUBLE_EQ(in_mast(-1e-9).radius, 0.1 + 0.6e-9) << "no jump at the table";
  EXPECT_DOUBLE_EQ(in_mast(-1.0).radius, 0.7);
  EXPECT_DOUBLE_EQ(in_mast(-1.0).radius_slope, -0.6);
  EXPECT_DOUBLE_EQ(in_mast(-10.0).radius, 1.5);
  EXPECT_DOUBLE_EQ(in_mast(-10.0).radius_slope, 0.0);
  EXPECT_DOUBLE_EQ(in_mast(-10.0, 2.0).radius, 2.0) << "never narrower than the hole";
}

// A bit on rock that does not yield, and the block lowered on it by four metres: the pipe above the table gives way sideways
// until it finds the mast.
TEST(Mast, overfedPipeStaysInside)
{
  Scene scene = vertical_scene(100.0, 100.0);
  scene.formation[0].drillability = 0.0;
  scene.start.weight_on_bit = 5e3;
  const RigAtRest start = build_at_rest(scene);
  State state = start.state;
  for (NodeState& node : state.nodes) node.rate.velocity.x() = 0.01;
  Stepper stepper(start.model, find_method(IntegratorKind::bdf2));
  Setpoints lower;
  lower.winch = {-0.2, false};
  double most = 0.0;
  for (int k = 0; k < 2000; ++k)
  {
    ASSERT_TRUE(stepper.advance(state, 0.01, lower)) << state.time;
    for (const NodeState& node : state.nodes) most = std::max(most, std::hypot(node.position.x(), node.position.y()));
  }
  EXPECT_GT(most, 0.5);
  EXPECT_LT(most, mast_radius);
}
}  // namespace test_model_mast
