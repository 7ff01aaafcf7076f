// SPDX-License-Identifier: BSD-3-Clause
// Where the camera goes and what a click hits.
#include <gtest/gtest.h>

#include <cmath>

#include "rviz/picture/camera_preset.h"
#include "rviz/picture/pick.h"

namespace drill_rig_sim::test_rviz_view
{
namespace
{
using Eigen::Vector3d;

/// 200 m down, then 200 m at 60 deg towards the east.
HoleAxis bent()
{
  const Vector3d down = -Vector3d::UnitZ(), slanted(std::sin(M_PI / 3.0), 0.0, -std::cos(M_PI / 3.0));
  return {{Vector3d::Zero(), 200.0 * down, 200.0 * down + 200.0 * slanted}, {down, slanted, slanted}};
}

Vector3d eye_of(const OrbitView& v)
{
  return v.focus +
         v.distance * Vector3d(std::cos(v.yaw) * std::cos(v.pitch), std::sin(v.yaw) * std::cos(v.pitch), std::sin(v.pitch));
}

Subject at_the_bottom(const HoleAxis& axis)
{
  return {axis.points().back().position, axis.depth(), 1.5, 46.0};
}

std::vector<DrawnNode> rods()
{
  std::vector<DrawnNode> nodes(3);
  nodes[0].position = {0.0, 0.0, -30.0};
  nodes[1].position = {0.0, 0.0, -20.0};
  nodes[2].position = {0.0, 0.0, 0.0};
  return nodes;
}
}  // namespace

TEST(Preset, planLooksDownNorthUp)
{
  const HoleAxis axis = bent();
  const OrbitView v = view_of(Preset::plan, axis, at_the_bottom(axis));
  const Vector3d eye = eye_of(v);
  EXPECT_GT(eye.z(), 100.0);
  EXPECT_NEAR(0.0, eye.x() - v.focus.x(), 1e-6);
  EXPECT_LT(eye.y(), v.focus.y());  // barely south of it: north is up
  EXPECT_NEAR(100.0 * std::sin(M_PI / 3.0), v.focus.x(), 1e-6);
}

TEST(Preset, sectionLooksAcrossTheWellsPlane)
{
  const HoleAxis axis = bent();
  const OrbitView v = view_of(Preset::section, axis, at_the_bottom(axis));
  EXPECT_NEAR(0.0, std::cos(v.yaw), 1e-6);  // the well goes east: from the south or north
  EXPECT_NEAR(0.0, v.pitch, 1e-9);
  EXPECT_GT(2.0 * v.distance * std::tan(M_PI / 8.0), 346.0);  // from the crown to the bottom
}

TEST(Preset, alongTheHoleIsWithinItAndSeesTheBit)
{
  const HoleAxis axis = bent();
  const Subject subject = at_the_bottom(axis);
  const OrbitView v = view_of(Preset::along_hole, axis, subject);
  const Vector3d eye = eye_of(v);
  const AxisPoint near = axis.nearest(eye, axis.depth() - 12.0);
  EXPECT_LT((eye - near.position).norm(), subject.hole_radius);
  EXPECT_LT(near.md, axis.depth() - 5.0);
  EXPECT_EQ(subject.bit, v.focus);
}

TEST(Preset, bitIsSeenFromTheSide)
{
  const HoleAxis axis = bent();
  const OrbitView v = view_of(Preset::bit, axis, at_the_bottom(axis));
  EXPECT_LT(std::abs((eye_of(v) - v.focus).normalized().dot(axis.points().back().tangent)), 0.2);
  EXPECT_LT((v.focus - at_the_bottom(axis).bit).norm(), 0.5 * v.distance);
}

TEST(Preset, everyOneOfAVerticalWellIsFinite)
{
  const HoleAxis axis({Vector3d::Zero(), {0.0, 0.0, -100.0}}, {-Vector3d::UnitZ(), -Vector3d::UnitZ()});
  for (const Preset preset : {Preset::derrick, Preset::along_hole, Preset::bit, Preset::plan, Preset::section})
  {
    EXPECT_TRUE(eye_of(view_of(preset, axis, at_the_bottom(axis))).allFinite());
    EXPECT_GE(exaggeration_for(preset, axis, 0.15), 1.0);
  }
}

TEST(Pick, hitsTheRodBetweenItsNodes)
{
  const auto hit = pick(rods(), 0.5, 0.0, {{10.0, 0.3, -15.0}, {-1.0, 0.0, 0.0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(1u, hit->place.node);
  EXPECT_NEAR(0.25, hit->place.share, 1e-9);
  EXPECT_NEAR(-15.0, hit->position.z(), 1e-9);
}

TEST(Pick, missesBesideAndBehind)
{
  EXPECT_FALSE(pick(rods(), 0.5, 0.0, {{10.0, 0.6, -15.0}, {-1.0, 0.0, 0.0}}));
  EXPECT_FALSE(pick(rods(), 0.5, 0.0, {{10.0, 0.0, -15.0}, {1.0, 0.0, 0.0}}));
  EXPECT_FALSE(pick({}, 0.5, 0.0, {{10.0, 0.0, -15.0}, {-1.0, 0.0, 0.0}}));
}

TEST(Pick, aFewPixelsBesideStillHit)
{
  EXPECT_TRUE(pick(rods(), 0.5, 0.02, {{10.0, 0.6, -15.0}, {-1.0, 0.0, 0.0}}));
}

}  // namespace drill_rig_sim::test_rviz_view
