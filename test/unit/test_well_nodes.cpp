// SPDX-License-Identifier: BSD-3-Clause
// Where the hole's nodes are placed, and the cubic and its box between two of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/well/hole_nodes.h"
#include "drill_rig_sim/well/hole_segment.h"
#include "drill_rig_sim/well/survey.h"
#include "well_fixtures.h"

namespace drill_rig_sim::test_well_nodes
{
namespace
{
using Eigen::Vector3d;

// 100 m straight down, 0.30 m wide to `first_to` and 0.25 m below, with one more station between.
WellSpec two_sections(double first_to, double station)
{
  WellSpec spec = straight_well(100.0);
  spec.survey.insert(spec.survey.begin() + 1, {station, 0.0, 0.0});
  spec.sections = {{first_to, 0.30, 0.2}, {150.0, 0.25, 0.3}};
  return spec;
}

void expect_nodes(const WellSpec& spec, double bit_radius, const std::vector<double>& depths)
{
  const std::vector<WellNode> nodes = place_nodes(spec, Survey(spec.survey), bit_radius);
  ASSERT_EQ(nodes.size(), depths.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i].md, depths[i], 1e-12) << i;
}

TEST(PlaceNodes, StandAtStationsAndWhereASectionEnds)
{
  const WellSpec spec = two_sections(50.0, 30.0);
  expect_nodes(spec, 0.125, {0.0, 30.0, 50.0, 50.001, 100.0});
  const std::vector<WellNode> nodes = place_nodes(spec, Survey(spec.survey), 0.125);
  const std::vector<double> radii = {0.15, 0.15, 0.15, 0.125, 0.125}, frictions = {0.2, 0.2, 0.2, 0.3, 0.3};
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    EXPECT_EQ(nodes[i].radius, radii[i]) << i;
    EXPECT_EQ(nodes[i].friction, frictions[i]) << i;
  }
}

// The last diameter is the bit's: nothing changes at the bottom. If it is not, the hole changes over its last millimetre.
TEST(PlaceNodes, TheBitsDiameterNeedsANodeOnlyWhereItDiffers)
{
  const WellSpec spec = two_sections(50.0, 30.0);
  for (double bit_radius : {0.1, 0.125 + 1e-8, 0.125 - 1e-8})
    expect_nodes(spec, bit_radius, {0.0, 30.0, 50.0, 50.001, 99.999, 100.0});
  expect_nodes(spec, 0.125 + 1e-10, {0.0, 30.0, 50.0, 50.001, 100.0});
}

// Less than a millimetre from where a section ends a station would only make a sliver.
TEST(PlaceNodes, StationsNextToASectionsEndAreLeftOut)
{
  for (double station : {49.9995, 50.0005, 50.0015}) expect_nodes(two_sections(50.0, station), 0.125, {0.0, 50.0, 50.001, 100.0});
  expect_nodes(two_sections(50.0, 49.998), 0.125, {0.0, 49.998, 50.0, 50.001, 100.0});
  expect_nodes(two_sections(50.0, 50.0025), 0.125, {0.0, 50.0, 50.001, 50.0025, 100.0});
}

// A section must have room for its change of diameter, and then one more millimetre, above the hole's end.
TEST(PlaceNodes, ASectionThatEndsAtTheBottomGivesWayToNone)
{
  expect_nodes(two_sections(99.9981, 30.0), 0.15, {0.0, 30.0, 100.0});
  expect_nodes(two_sections(99.9979, 30.0), 0.125, {0.0, 30.0, 99.9979, 99.9989, 100.0});
}

// By hand: an arc of 90 deg in h = 12.2 m errs by (pi/2)^3 h/384 / n^4 in n pieces: 50 um at n = 7.04, so eight. Straight holes
// need one.
TEST(PlaceNodes, AnArcGetsAsManyPiecesAsItNeeds)
{
  WellSpec spec = straight_well(200.0);
  const double level = 90.0 * degree;
  spec.survey = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {112.2, level, 0.0}, {200.0, level, 0.0}};
  std::vector<double> depths = {0.0};
  for (int k = 0; k <= 8; ++k) depths.push_back(100.0 + 12.2 * k / 8.0);
  depths.push_back(200.0);
  expect_nodes(spec, 0.1556, depths);
  for (const WellNode& node : place_nodes(spec, Survey(spec.survey), 0.1556))
  {
    EXPECT_EQ(node.radius, 0.1556);
    EXPECT_EQ(node.friction, 0.25);
  }
}

// Nodes that have nothing to do with each other.
HoleSegment random_segment(std::mt19937& random, WellNode& from, WellNode& to)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  from.md = 10.0;
  to.md = 12.5;
  from.position = vector();
  to.position = vector();
  from.tangent = vector().normalized();
  to.tangent = vector().normalized();
  return HoleSegment::between(from, to);
}

TEST(HoleSegments, TangentIsTheCurvesDirection)
{
  std::mt19937 random(3);
  WellNode from, to;
  for (int i = 0; i < 100; ++i)
  {
    const HoleSegment g = random_segment(random, from, to);
    EXPECT_LT((g.at(0.0).tangent - from.tangent).norm(), 1e-14);
    EXPECT_LT((g.at(1.0).tangent - to.tangent).norm(), 1e-12);
    for (double s : {-0.2, 0.3, 0.7})
    {
      const Vector3d slope = g.centre(s + 1e-4) - g.centre(s - 1e-4);  // off by 1e-8 c3
      EXPECT_LT((g.at(s).tangent - slope.normalized()).norm(), 1e-5) << s;
    }
  }
}

// The Bezier points are the ends and, a third of the length along either tangent, the two between.
TEST(HoleSegments, BoxIsThatOfTheBezierPoints)
{
  std::mt19937 random(4);
  WellNode from, to;
  for (int i = 0; i < 100; ++i)
  {
    const HoleSegment g = random_segment(random, from, to);
    const Vector3d after = from.position + 2.5 / 3.0 * from.tangent, before = to.position - 2.5 / 3.0 * to.tangent;
    const Box box = Box::around(g);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(box.low[k], std::min({from.position[k], after[k], before[k], to.position[k]}), 1e-14);
      EXPECT_NEAR(box.high[k], std::max({from.position[k], after[k], before[k], to.position[k]}), 1e-14);
    }
  }
}

TEST(HoleSegments, DistanceToABoxIsThatToItsNearestPoint)
{
  const Box box{Vector3d(1.0, 1.0, 1.0), Vector3d(2.0, 3.0, 4.0)};
  EXPECT_EQ(0.0, box.squared_distance({1.5, 2.9, 3.9}));
  EXPECT_EQ(4.0, box.squared_distance({-1.0, 2.0, 2.0}));
  EXPECT_EQ(9.0, box.squared_distance({1.5, 6.0, 2.0}));
  EXPECT_EQ(1.0 + 4.0 + 9.0, box.squared_distance({3.0, -1.0, 7.0}));
}
}  // namespace
}  // namespace drill_rig_sim::test_well_nodes
