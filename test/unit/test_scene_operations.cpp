// SPDX-License-Identifier: BSD-3-Clause
// Operations for a rig that runs already: read as those of a scene, and checked against where the rig is.
#include <gtest/gtest.h>

#include <string>

#include "drill_rig_sim/scene/read_scene.h"
#include "in_source.h"

namespace drill_rig_sim::test_scene_operations
{
namespace
{
Scene present()
{
  Scene scene = read_scene(in_source("test/scenes/operations.yaml"));
  scene.well.hole_depth = 150.0;  // it has been drilled since
  scene.start.bit_depth = 140.0;
  return scene;
}

std::string why_refused(const std::string& text)
{
  try
  {
    parse_operations(text, "goal", present());
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}

TEST(SceneOperations, areAListOrOneBlock)
{
  const std::vector<Operation> one = parse_operations("do: trip\nto_depth: 300 ft\nspeed: 0.5\n", "goal", present());
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].kind, OperationKind::trip);
  EXPECT_NEAR(one[0].to_depth, 91.44, 1e-9);
  const std::vector<Operation> two = parse_operations("[{do: tag}, {do: drill, weight: 5 klbf, distance: 1}]", "goal", present());
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].weight, 5000.0) << "a tag's default";
  EXPECT_NEAR(two[1].weight, 22241.1, 0.1);
}

TEST(SceneOperations, areCheckedAgainstTheRigAsItIs)
{
  EXPECT_EQ(why_refused("{do: trip, to_depth: 150}"), "");
  EXPECT_EQ(why_refused("{do: trip, to_depth: 151}"),
            "goal:1: operations[0].to_depth: 151 m is below the hole's bottom, allowed: down to 150 m");
}

TEST(SceneOperations, thatAreWrongAreRefusedWithTheirPlace)
{
  EXPECT_EQ(why_refused(" \n"), "goal:1: operations: is empty, needed: at least one operation");
  EXPECT_EQ(why_refused("[]"), "goal:1: operations: is empty, needed: at least one operation");
  EXPECT_EQ(why_refused("nonsense"), "goal:1: operations: text is given, allowed: a list");
  EXPECT_NE(why_refused("[{do: tag}, {do: fly}]").find("goal:1: operations[1].do: \"fly\" is not known, allowed: flow"),
            std::string::npos);
  EXPECT_NE(why_refused("[{do: tag, rpm: 3}]").find("operations[0].rpm: "), std::string::npos);
  EXPECT_NE(why_refused("do: [").find("goal:1: YAML: "), std::string::npos);
  EXPECT_NE(why_refused("{do: slide, weight: 1e4, distance: 1, toolface_deg: 0}").find("needs a part of type mwd"),
            std::string::npos);
}

}  // namespace
}  // namespace drill_rig_sim::test_scene_operations
