// SPDX-License-Identifier: BSD-3-Clause
// The hole's axis in closed forms: a circle's length and places, frames that do not wind, what is drawn larger across it.
#include <gtest/gtest.h>

#include <cmath>

#include "rviz/picture/hole_axis.h"

namespace drill_rig_sim::test_rviz_hole_axis
{
namespace
{
using Eigen::Vector3d;

/// A quarter of a circle from vertical down to horizontal north, of this radius, in pieces of `step` degrees.
HoleAxis quarter(double radius, double step)
{
  std::vector<Vector3d> points, tangents;
  for (double a = 0.0; a <= 90.0 + 1e-9; a += step)
  {
    const double angle = a * M_PI / 180.0;
    points.emplace_back(0.0, radius * (1.0 - std::cos(angle)), -radius * std::sin(angle));
    tangents.emplace_back(0.0, std::sin(angle), -std::cos(angle));
  }
  return {points, tangents};
}
}  // namespace

TEST(HoleAxis, ofACircleIsAsLongAndLiesOnIt)
{
  const HoleAxis axis = quarter(500.0, 1.0);
  EXPECT_NEAR(500.0 * M_PI / 2.0, axis.depth(), 1e-3);
  for (double md = 3.0; md < axis.depth(); md += 7.0)
  {
    const AxisPoint p = axis.at(md);
    EXPECT_NEAR(500.0, (p.position - Vector3d(0.0, 500.0, 0.0)).norm(), 1e-5) << md;
    EXPECT_NEAR(std::sin(md / 500.0), p.tangent.y(), 1e-6) << md;
  }
}

TEST(HoleAxis, goesOnStraightBeyondItsEnds)
{
  const HoleAxis axis = quarter(100.0, 5.0);
  EXPECT_NEAR(0.0, (axis.at(-20.0).position - Vector3d(0.0, 0.0, 20.0)).norm(), 1e-12);
  EXPECT_NEAR(0.0, (axis.at(axis.depth() + 10.0).position - Vector3d(0.0, 110.0, -100.0)).norm(), 1e-9);
}

TEST(HoleAxis, isMadeDeeperStraightOn)
{
  HoleAxis axis = quarter(100.0, 5.0);
  const double depth = axis.depth();
  EXPECT_FALSE(axis.extend_to(depth - 1.0));
  EXPECT_EQ(depth, axis.depth());
  EXPECT_TRUE(axis.extend_to(depth + 0.3));
  EXPECT_NEAR(depth + 0.3, axis.depth(), 1e-12);
  EXPECT_NEAR(0.0, (axis.points().back().position - Vector3d(0.0, 100.3, -100.0)).norm(), 1e-9);
}

TEST(HoleAxis, framesAreAcrossItAndDoNotWind)
{
  const HoleAxis axis = quarter(300.0, 2.0);
  for (double md = 0.0; md < axis.depth(); md += 5.0)
  {
    const AxisPoint p = axis.at(md);
    EXPECT_NEAR(0.0, p.side.dot(p.tangent), 1e-12);
    EXPECT_NEAR(1.0, p.side.norm(), 1e-12);
    EXPECT_NEAR(1.0, p.side.x(), 1e-9) << "the bend's normal does not turn in a plane bend";
  }
}

TEST(HoleAxis, aHelixTurnsItsFrameBackByItsTorsion)
{
  // over one turn of a helix of slope c/a the Frenet frame turns by 2 pi c / sqrt(a^2 + c^2) against one without twist
  const double a = 20.0, c = 15.0, s = std::hypot(a, c);
  std::vector<Vector3d> points, tangents;
  for (int i = 0; i <= 720; ++i)
  {
    const double t = 2.0 * M_PI * i / 720.0;
    points.emplace_back(a * std::cos(t), a * std::sin(t), -c * t);
    tangents.emplace_back(-a / s * std::sin(t), a / s * std::cos(t), -c / s);
  }
  const HoleAxis axis(points, tangents);
  const AxisPoint first = axis.points().front(), last = axis.points().back();
  const double turned = std::atan2(first.tangent.dot(first.side.cross(last.side)), first.side.dot(last.side));
  EXPECT_NEAR(std::cos(2.0 * M_PI * c / s), std::cos(turned), 1e-3);
}

TEST(HoleAxis, findsTheNearestPlace)
{
  const HoleAxis axis = quarter(500.0, 1.0);
  const AxisPoint p = axis.at(333.0);
  const Vector3d beside = p.position + 0.2 * p.side - 0.1 * p.other();
  for (const double guess : {320.0, 333.0, 350.0}) EXPECT_NEAR(333.0, axis.nearest(beside, guess).md, 1e-4);
}

TEST(HoleAxis, leavesOutPlacesThatAreTheSame)
{
  const HoleAxis axis({Vector3d(0, 0, 0), Vector3d(0, 0, 0), Vector3d(0, 0, -10)},
                      {Vector3d(0, 0, -1), Vector3d(0, 0, -1), Vector3d(0, 0, -1)});
  EXPECT_EQ(2u, axis.points().size());
  EXPECT_EQ(1u, HoleAxis({}, {}).points().size());
}

TEST(Exaggerated, onlyWhatLiesAcross)
{
  const AxisPoint p = quarter(500.0, 1.0).at(250.0);
  const Vector3d place = p.position + 0.3 * p.side + 0.1 * p.other() + 2.0 * p.tangent;
  EXPECT_NEAR(0.0, (exaggerated(p, place, 10.0) - (p.position + 3.0 * p.side + p.other() + 2.0 * p.tangent)).norm(), 1e-12);
  EXPECT_NEAR(0.0, (exaggerated(p, place, 1.0) - place).norm(), 1e-12);
}

TEST(HighSide, isUpAcrossTheHoleAndNorthWhereItIsVertical)
{
  const Vector3d up = high_side_of(Vector3d(0.6, 0.0, -0.8));
  EXPECT_NEAR(0.0, (up - Vector3d(0.8, 0.0, 0.6)).norm(), 1e-12);
  EXPECT_NEAR(0.0, (high_side_of(-Vector3d::UnitZ()) - Vector3d::UnitY()).norm(), 1e-12);
}

}  // namespace drill_rig_sim::test_rviz_hole_axis
