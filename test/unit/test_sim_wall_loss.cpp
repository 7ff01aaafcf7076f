// SPDX-License-Identifier: BSD-3-Clause
// What a bent motor in a tight hole loses of its side forces to the wall that is soft under its body, and that a scene is told
// so.
#include <gtest/gtest.h>

#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/sim/wall_loss.h"
#include "test_scenes.h"

namespace test_sim_wall_loss
{
using namespace drill_rig_sim;

namespace
{
/// A bent motor of that diameter in a hole of 0.2159 m.
Scene bent_motor(double diameter)
{
  Scene scene = motor_drilling_scene(0.05);
  scene.string[1].outer_diameter = diameter;
  return scene;
}
}  // namespace

TEST(WallLoss, isThatOfTheSameSceneOnAStiffWall)
{
  const Scene scene = bent_motor(0.2032);
  const auto loss = wall_loss(build_at_rest(scene));
  ASSERT_TRUE(loss && loss->known);
  EXPECT_NEAR(loss->from_bit, 2.0, 1e-9) << "the bend";
  EXPECT_GT(loss->depth, 2e-3);
  EXPECT_GT(loss->stiff_contact, 1.5 * loss->contact);
  EXPECT_EQ(loss->side_force, static_report(scene, no_sliding).bit_side_force);
  EXPECT_EQ(loss->part, 1);
  Scene stiff = scene;
  for (const std::size_t body : {1, 2})
  {
    stiff.string[body].contact = scene.contact.law;
    stiff.string[body].contact->stiffness = scene.contact.assembly_stiffness;
  }
  EXPECT_EQ(loss->stiff_side_force, static_report(stiff, no_sliding).bit_side_force);
  EXPECT_FALSE(wall_loss(build_at_rest(stiff))) << "nothing is lost there";
}

TEST(WallLoss, isNoneWhereTheStringFits)
{
  EXPECT_FALSE(wall_loss(build_at_rest(drilling_scene())));
  EXPECT_FALSE(wall_loss(build_at_rest(slanted_scene(150.0, 0.3))))
      << "pipe on the low side carries its weight, whatever the wall";
}
}  // namespace test_sim_wall_loss
