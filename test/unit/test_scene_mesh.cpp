// SPDX-License-Identifier: BSD-3-Clause
// How fine a scene's string is cut where the scene does not say it.
#include <gtest/gtest.h>

#include "drill_rig_sim/crew/connection.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "test_scenes.h"

namespace test_scene_mesh
{
using namespace drill_rig_sim;

namespace
{
/// Elements by the hole.
Scene vertical(double hole_depth, double bit_depth)
{
  Scene scene = vertical_scene(hole_depth, bit_depth);
  scene.numerics.element_length = 0.0;
  return scene;
}
}  // namespace

TEST(ElementLengths, asTheSceneSays)
{
  Scene scene = slanted_scene(199.9, 0.2);
  scene.numerics.element_length = 2.5;
  const ElementLengths lengths = element_lengths(scene);
  for (const double from_bit : {0.0, 50.0, 500.0}) EXPECT_EQ(lengths.at(from_bit), 2.5);
}

TEST(ElementLengths, jointsInAVerticalHoleAndHalvesByTheBit)
{
  Scene scene = vertical(400.0, 390.0);
  for (const double inclination : {0.0, 2.99 * degree})  // is still vertical
  {
    scene.well.survey.back().inclination = inclination;
    for (const double from_bit : {0.0, 44.0}) EXPECT_EQ(element_lengths(scene).at(from_bit), 4.75);
    for (const double from_bit : {46.0, 389.0}) EXPECT_EQ(element_lengths(scene).at(from_bit), 9.5);
  }
}

TEST(ElementLengths, halvesInAHoleThatInclinesFromTheTop)
{
  Scene scene = slanted_scene(199.9, 0.2);
  scene.numerics.element_length = 0.0;
  for (const double from_bit : {46.0, 199.0, 220.0}) EXPECT_EQ(element_lengths(scene).at(from_bit), 4.75);
  for (const double from_bit : {0.0, 44.0}) EXPECT_EQ(element_lengths(scene).at(from_bit), 2.38) << "by the bit";
}

TEST(ElementLengths, shorterForASmallTolerance)
{
  Scene scene = slanted_scene(199.9, 0.2);
  scene.numerics.element_length = 0.0;
  const std::pair<double, double> cases[] = {{0.05, 9.5}, {0.02, 4.75}, {0.019, 3.17}, {0.005, 3.17}, {0.002, 2.38}};
  for (const auto& [tolerance, length] : cases)
  {
    scene.numerics.tolerance = tolerance;
    EXPECT_EQ(element_lengths(scene).at(199.0), length) << tolerance;
  }
}

// 1 deg/10 m from 300 m on: 3 deg at 330 m; the bit at 500 m: 170 m below it, and 45 m more.
TEST(ElementLengths, halvesUpToAStandAndAHalfAboveWhereItInclines)
{
  Scene scene = vertical(500.0, 500.0);
  scene.well.survey = {{0.0, 0.0, 0.0}, {300.0, 0.0, 0.0}, {500.0, 20.0 * degree, 0.0}};
  const ElementLengths lengths = element_lengths(scene);
  EXPECT_NEAR(lengths.change, 215.0, 1e-9);
  EXPECT_EQ(lengths.at(214.9), 4.75);
  EXPECT_EQ(lengths.at(215.1), 9.5);
  // with the bit far above, all hangs
  scene.start.bit_depth = 200.0;
  EXPECT_EQ(element_lengths(scene).at(46.0), 9.5);

  scene.start.bit_depth = 500.0;
  const Mesh mesh = build_mesh(scene, 520.0);
  for (std::size_t e = 1; e + 1 < mesh.elements.size(); ++e)
  {
    const bool fine =
        mesh.nodes[e].from_bit > 45.0 + 9.5 && mesh.nodes[e].from_bit<215.0 - 9.5, coarse = mesh.nodes[e].from_bit> 215.0 + 9.5;
    if (!fine && !coarse) continue;
    EXPECT_NEAR(mesh.elements[e].section.length, fine ? 4.75 : 9.5, 1e-9) << e;
  }
}

// 100 m of vertical hole over 1000 m that lie flat: friction of 0.3 on 1000 m pushes back with three times what the 100 m weigh.
TEST(ElementLengths, halvesWherePipeIsPushedFromAbove)
{
  Scene scene = vertical(1150.0, 1150.0);
  scene.well.survey = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {150.0, 90.0 * degree, 0.0}, {1150.0, 90.0 * degree, 0.0}};
  for (HoleSection& section : scene.well.sections) section.friction = 0.3;
  EXPECT_EQ(element_lengths(scene).at(1150.0), 4.75);
  for (HoleSection& section : scene.well.sections) section.friction = 0.0;
  EXPECT_NEAR(element_lengths(scene).change, 1150.0 - 100.0 - 50.0 * 3.0 / 90.0 + 45.0, 1e-9);
}

// 0.3 on 1000 m that lie flat, by hand over the bend with mu = 0 there: what of 1000 m of vertical pipe is pushed is 300 m at
// most.
TEST(ElementLengths, jointsWhereItHangsAbovePipeThatIsPushed)
{
  Scene scene = vertical(2050.0, 2050.0);
  scene.well.survey = {{0.0, 0.0, 0.0}, {1000.0, 0.0, 0.0}, {1050.0, 90.0 * degree, 0.0}, {2050.0, 90.0 * degree, 0.0}};
  scene.well.sections = {{1050.0, 0.25, 0.0}, {2050.0, 0.25, 0.3}};
  const double pipe_pushed = 2050.0 - element_lengths(scene).change + 45.0;  // the 50 m of the bend weigh as 2/pi of them upright
  EXPECT_NEAR(pipe_pushed, 1000.0 - (300.0 - 50.0 * 2.0 / pi), 15.0);
}

// 100 m of pipe over 1000 m that lie flat, as above: pushed from where it begins to hang, and a stand and a half more.
TEST(ElementLengths, shorterWherePipeIsPushedIfAskedFor)
{
  Scene scene = vertical(2050.0, 2050.0);
  scene.well.survey = {{0.0, 0.0, 0.0}, {1000.0, 0.0, 0.0}, {1050.0, 90.0 * degree, 0.0}, {2050.0, 90.0 * degree, 0.0}};
  scene.well.sections = {{1050.0, 0.25, 0.0}, {2050.0, 0.25, 0.3}};
  scene.numerics.pushed_element_length = 2.4;
  const ElementLengths lengths = element_lengths(scene);
  EXPECT_NEAR(lengths.pushed_change, pushed_length(scene), 1e-9);
  EXPECT_EQ(lengths.at(pushed_length(scene) - 1.0), 2.4);
  EXPECT_EQ(lengths.at(pushed_length(scene) + 1.0), 9.5);

  scene.numerics.element_length = 1.0;  // is shorter: stays
  EXPECT_EQ(element_lengths(scene).at(0.0), 1.0);

  scene.numerics.element_length = 0.0;
  for (HoleSection& section : scene.well.sections) section.friction = 0.0;
  scene.well.survey = vertical(2050.0, 2050.0).well.survey;
  EXPECT_EQ(pushed_length(scene), 0.0);
  EXPECT_EQ(element_lengths(scene).at(46.0), 9.5);
}

// 390 m of joints of 9.5 m and the block's height above the table, all guided.
TEST(ElementLengths, guidedPipeMayHaveElementsOfTwoJoints)
{
  Scene scene = vertical(400.0, 390.0);
  scene.numerics.level = Level::axial_torsional;
  const Mesh joints = build_mesh(scene, 410.0);
  scene.numerics.guided_element_length = 19.1;
  const Mesh merged = build_mesh(scene, 410.0);
  EXPECT_LE(merged.elements.size(), 2 * joints.elements.size() / 3 + 2) << "two of a stand's three joints";
  double mass = 0.0, merged_mass = 0.0;
  for (const MeshElement& e : joints.elements) mass += e.linear_mass * e.section.length;
  for (const MeshElement& e : merged.elements) merged_mass += e.linear_mass * e.section.length;
  EXPECT_NEAR(merged_mass, mass, 1e-9 * mass);
  EXPECT_EQ(merged.nodes.back().from_bit, joints.nodes.back().from_bit);
  scene.numerics.guided_element_length = 18.9;  // is shorter than two, but for the rest at the top
  EXPECT_GE(build_mesh(scene, 410.0).elements.size() + 1, joints.elements.size());
  scene.numerics.guided_element_length = 19.1;
  scene.numerics.level = Level::beam3d;  // has no guided pipe
  const Mesh free = build_mesh(scene, 410.0);
  scene.numerics.guided_element_length = 0.0;
  EXPECT_EQ(free.elements.size(), build_mesh(scene, 410.0).elements.size());
}

// Joint by joint and stand by stand, the string is broken out where it is with elements of joints, and is the same below.
TEST(ElementLengths, twoJointsWithinAStandAlone)
{
  Scene scene = vertical(400.0, 390.0);
  scene.start.block_height = 18.0;
  scene.numerics.level = Level::axial_torsional;
  for (const int stand : {1, 2, 3, 4})
  {
    scene.rig.hoisting.stand_joints = stand;
    for (const int added : {-4 * stand, -stand, 0, 1, 2, stand, 3 * stand})
    {
      const double length = 408.0 + 9.5 * added;
      scene.numerics.guided_element_length = 0.0;
      const Mesh joints = build_mesh(scene, length);
      scene.numerics.guided_element_length = 20.0;
      const Mesh merged = build_mesh(scene, length), longer = build_mesh(scene, length + 9.5 * stand);
      const int held = uppermost_joint(merged);
      EXPECT_EQ(merged.nodes[held].from_bit, joints.nodes[uppermost_joint(joints)].from_bit) << stand << ' ' << added;
      for (int i = 0; i <= held; ++i) ASSERT_EQ(longer.nodes[i].from_bit, merged.nodes[i].from_bit) << stand << ' ' << added;
    }
  }
}

// The lower half flat without friction: guided pipe, pushed by nothing, has joints there, and the two stands by the assembly
// halves.
TEST(ElementLengths, jointsWherePipeIsGuidedAndNothingPushesIt)
{
  Scene scene = vertical(1150.0, 1150.0);
  scene.well.survey = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {150.0, 90.0 * degree, 0.0}, {1150.0, 90.0 * degree, 0.0}};
  for (HoleSection& section : scene.well.sections) section.friction = 0.0;
  EXPECT_EQ(element_lengths(scene).at(500.0), 4.75);
  scene.numerics.level = Level::hybrid;
  EXPECT_EQ(element_lengths(scene).at(500.0), 9.5);
  EXPECT_EQ(element_lengths(scene).at(free_length(scene) - 1.0), 4.75);
  for (HoleSection& section : scene.well.sections) section.friction = 0.3;
  EXPECT_EQ(element_lengths(scene).at(500.0), 4.75) << "where friction pushes it a window may open";
}

// Pipe below heavier pipe is there to be pushed, and buckles: two joints an element carry a quarter of what one does.
TEST(ElementLengths, twoJointsAboveThePipeThatHeavierPipePushes)
{
  Scene scene = vertical(1150.0, 1150.0);
  scene.numerics.level = Level::hybrid;
  scene.numerics.guided_element_length = 20.0;
  const PartSpec pipe = scene.string.back();
  PartSpec slim = pipe;
  slim.joints = 20;
  slim.linear_mass = 0.5 * pipe.linear_mass;
  const double assembly = free_length(scene) - 57.0;
  EXPECT_EQ(element_lengths(scene).at(free_length(scene) + 1.0), 20.0);
  scene.string.insert(scene.string.end() - 1, slim);
  const double slim_ends = assembly + 20.0 * slim.joint_length;
  EXPECT_EQ(element_lengths(scene).at(slim_ends - 1.0), 9.5);
  EXPECT_EQ(element_lengths(scene).at(slim_ends + 1.0), 20.0);
}

// Below the first drill pipe, as a driller counts: heavy-weight pipe on the collars belongs to it, heavy-weight pipe further up
// does not, whatever lies above.
TEST(FreeLength, endsTwoStandsAboveTheAssembly)
{
  Scene scene = vertical(1150.0, 1150.0);
  scene.numerics.level = Level::hybrid;
  const double simple = free_length(scene);
  const PartSpec pipe = scene.string.back();
  PartSpec heavy = pipe, slim = pipe;
  heavy.joints = slim.joints = 10;
  heavy.inner_diameter = 0.6 * heavy.outer_diameter;
  slim.inner_diameter = 0.75 * slim.outer_diameter;
  const auto below_the_top = [&](const std::vector<PartSpec>& parts)
  {
    Scene tapered = scene;
    tapered.string.insert(tapered.string.end() - 1, parts.begin(), parts.end());
    return free_length(tapered);
  };
  EXPECT_NEAR(below_the_top({heavy}), simple + 10.0 * heavy.joint_length, 1e-9);
  EXPECT_NEAR(below_the_top({slim}), simple, 1e-9);
  PartSpec two_stands = slim;
  two_stands.joints = 6;
  EXPECT_NEAR(below_the_top({two_stands, heavy}), simple + 16.0 * heavy.joint_length, 1e-9)
      << "between stiffer parts it belongs to them";
  EXPECT_NEAR(below_the_top({heavy, slim, heavy}), simple + 10.0 * heavy.joint_length, 1e-9);
}

TEST(Hangs, whereTheHoleInclinesByThreeDegreesAtMost)
{
  WellSpec well = vertical(400.0, 390.0).well;
  well.survey = {{0.0, 0.0, 0.0}, {200.0, 2.9 * degree, 0.0}, {400.0, 4.0 * degree, 0.0}};
  EXPECT_TRUE(hangs(well, 200.0));
  EXPECT_FALSE(hangs(well, 400.0));
}
}  // namespace test_scene_mesh
