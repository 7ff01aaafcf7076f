// SPDX-License-Identifier: BSD-3-Clause
// A hole turns no faster than the body that follows the bit lets it: the limit by hand, a way within it untouched, one beyond it
// held back.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/string/lower_body.h"
#include "test_scenes.h"
#include "well_fixtures.h"

namespace test_well_turn_limit
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double deg_30m = degree / 30.0;  // [rad/m]

Mesh mesh_of(Scene scene, double sleeve, double gauge_length = 0.0)
{
  scene.string[1].motor->sleeve_diameter = sleeve;
  scene.string[1].motor->bit_to_sleeve = 0.9;
  scene.string[0].bit->gauge_length = gauge_length;
  return build_mesh(scene, 120.0);
}

/// Drills `metres` in steps of 0.1 mm, aside by `slope` of what it goes ahead, along the hole's end.
void drill(Wellbore& hole, const TurnLimit& limit, double metres, double slope, const Vector3d& aside)
{
  for (int i = 0; i < std::lround(1e4 * metres); ++i)
  {
    const Vector3d ahead = hole.end_direction(), way = 1e-4 * (ahead + slope * (aside - ahead.dot(aside) * ahead));
    hole.extend(limited_way(hole, limit, way), ahead);
  }
}

double angle_between(const Vector3d& a, const Vector3d& b)
{
  return std::acos(a.dot(b));
}
}  // namespace

// A motor of 165 mm in a hole of 215.9 mm, bent 2 m above the face: c = 25.45 mm, L = 2 - 0.10795 m. Without a sleeve the middle:
// 12 c/L^2. A sleeve of 209.55 mm leaves 3.175 mm at s = 0.79205 m: 2 (3.175 + 25.45 s/L)/(s (L - s)) mm.
TEST(TurnLimit, isThatOfTheMotorBelowItsBend)
{
  const Scene scene = motor_drilling_scene(1.0);
  constexpr double length = 2.0 - 0.10795, s = 0.9 - 0.10795, c = 0.02545;
  const TurnLimit plain = turn_limit(mesh_of(scene, 0.0)), tight = turn_limit(mesh_of(scene, 0.20955));
  EXPECT_NEAR(length, plain.length, 1e-12);
  EXPECT_NEAR(12.0 * c / (length * length), plain.curvature, 1e-12);
  EXPECT_NEAR(2.0 * (0.003175 + c * s / length) / (s * (length - s)), tight.curvature, 1e-12);
  EXPECT_NEAR(54.6, tight.curvature / deg_30m, 0.1);
  EXPECT_LT(turn_limit(mesh_of(scene, 0.0, 0.1)).curvature, plain.curvature) << "pads";
}

// Fourteen diameters of a straight string.
TEST(TurnLimit, isThatOfAShortPieceWithoutABend)
{
  const TurnLimit limit = turn_limit(build_mesh(drilling_scene(), 120.0));
  EXPECT_NEAR(14.0 * 0.2159, limit.length, 1e-12);
  EXPECT_GT(limit.curvature, 20.0 * deg_30m) << "more than any tool builds";
}

TEST(TurnLimit, leavesAWayWithinItAsItIs)
{
  const TurnLimit limit{2.0, 40.0 * deg_30m};
  Wellbore hole(straight_well(100.0, 30.0 * degree), TrajectorySpec(), 0.1079);
  const Vector3d way = 1e-3 * hole.end_direction() + 2e-5 * Vector3d::UnitX();  // 1.1 deg aside
  for (int i = 0; i < 3000; ++i)
  {
    ASSERT_EQ(way, limited_way(hole, limit, way)) << i;
    ASSERT_EQ(0.0, refused_turn(hole, limit, way));
    hole.extend(way, hole.end_direction());
  }
}

// A bit that goes as far aside as ahead: the hole turns by the limit over the body's length and goes on with its curvature.
TEST(TurnLimit, holdsBackWhatWouldTurnTheHoleFaster)
{
  const TurnLimit limit{2.0, 40.0 * deg_30m};
  Wellbore hole(straight_well(100.0), TrajectorySpec(), 0.1079), free = hole;
  drill(free, {2.0, 10.0}, 0.3, 1.0, Vector3d::UnitX());
  EXPECT_GT(angle_between(free.end_direction(), -Vector3d::UnitZ()), 40.0 * degree);
  drill(hole, limit, 1.9, 1.0, Vector3d::UnitX());
  EXPECT_NEAR(limit.angle(), angle_between(hole.end_direction(), -Vector3d::UnitZ()), 0.1 * degree);
  EXPECT_GT(refused_turn(hole, limit, Vector3d(1e-3, 0.0, -1e-3)), 10.0 * limit.curvature);
  drill(hole, limit, 8.1, 1.0, Vector3d::UnitX());
  const double turned = angle_between(hole.end_direction(), -Vector3d::UnitZ());
  EXPECT_LE(turned, 6.0 * limit.angle());
  EXPECT_GE(turned, 4.0 * limit.angle());
}

// The survey's own sharp bend may go on as it is, and is not straightened at once.
TEST(TurnLimit, letsAHoleThatTurnsFasterGoOn)
{
  WellSpec well = straight_well(100.0);
  well.survey = {{0.0, 0.0, 0.0}, {90.0, 0.0, 0.0}, {100.0, 50.0 * degree, 0.0}};
  Wellbore hole(well, TrajectorySpec(), 0.1079);
  const TurnLimit limit{2.0, 40.0 * deg_30m};
  const Vector3d ahead = 1e-3 * hole.end_direction();
  EXPECT_EQ(ahead, limited_way(hole, limit, ahead));
}

}  // namespace test_well_turn_limit
