// SPDX-License-Identifier: BSD-3-Clause
// How a weight is zeroed on the way to the bottom: by the zero that a string has which moves steadily.
#include <gtest/gtest.h>

#include "drill_rig_sim/crew/tag.h"
#include "drill_rig_sim/math/units.h"
#include "operating.h"

namespace test_sim_tag
{
using namespace drill_rig_sim;
using namespace operating;

namespace
{
/// What a tag has found.
struct Tagged
{
  double highest = 0.0;              // how far it lifted the block [m]
  double zero = 0.0;                 // [N]
  double shown = 0.0, on_bit = 0.0;  // weight, means over 4 s of a standing block [N]
};

Tagged tag(const Scene& scene)
{
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  Tagged tagged;
  const double began = rig.readings().block_height;
  for (int k = 0; k < 40000 && !player.finished(); ++k)
  {
    EXPECT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
    tagged.highest = std::max(tagged.highest, rig.readings().block_height - began);
  }
  EXPECT_TRUE(player.finished());
  tagged.zero = rig.readings().surface_wob + rig.readings().hook_load;
  play(rig, 4.0);
  constexpr int frames = 400;
  for (int k = 0; k < frames; ++k)
  {
    play(rig, frame);
    tagged.shown += rig.readings().surface_wob / frames;
    tagged.on_bit += rig.truth().wob / frames;
  }
  return tagged;
}
}  // namespace

// By the dead line the string weighs more while it is lowered. A bit that comes to bottom before the string moves steadily has
// that zero too, in place of the one at rest; one that is nearer to bottom than the way over which the sheaves' friction turns
// round is lifted first.
TEST(Tag, tagZeroesTheMovingStringHoweverNearTheBottomIs)
{
  for (const double above : {0.0, 0.005, 0.015, 0.03, 0.06, 0.15, 0.5})
  {
    Operation tag = operation(OperationKind::tag);
    tag.weight = 10e3;
    Scene scene = scene_with({tag}, above);
    scene.instruments.hook_load.place = HookLoadPlace::dead_line;
    Simulator rig(scene);
    ScenePlayer player(rig.scene());
    const double at_rest = rig.readings().hook_load;
    double free_load = 0.0;
    for (int k = 0; k < 10000 && !player.finished(); ++k)
    {
      ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
      if (!rig.truth().on_bottom) free_load = rig.readings().hook_load;
    }
    ASSERT_TRUE(player.finished()) << above;
    const double zero = rig.readings().surface_wob + rig.readings().hook_load;
    EXPECT_GT(free_load - at_rest, 10e3) << above << " m: what the sheaves add";
    EXPECT_NEAR(free_load, zero, 2.5e3) << above;
  }
}

// On its way down the friction of sheaves and rail turns back, over 2 cm, and the zero is a mean of 2 s.
TEST(Tag, tagLiftsTheBitThatHangsTooNearTheBottom)
{
  const Tagged tagged = tag(scene_with({operation(OperationKind::tag)}, 0.01));
  EXPECT_NEAR(tagged.highest, SteadyLoad::turns_round + (2.0 + Tag::steady_time) * 0.02 - 0.01, 0.006);
  EXPECT_NEAR(tagged.shown, tagged.on_bit, 1e3);
}

// The heavier the string and the faster it is lowered, the longer its load swings: from wherever it begins, the zero is that of
// the steady motion, which a tag from far above finds.
TEST(Tag, tagFindsTheSameZeroFromNearAndFar)
{
  for (const double speed : {0.01, 0.02, 0.05})
    for (const HookLoadPlace place : {HookLoadPlace::block, HookLoadPlace::dead_line})
    {
      Operation lowers = operation(OperationKind::tag);
      lowers.speed = speed;
      const auto from = [&](double above)
      {
        Scene scene = vertical_scene(2500.0, 2500.0 - above, 0.25);
        scene.string = drilling_scene().string;
        scene.numerics.level = Level::axial_torsional;
        scene.operations = {lowers};
        scene.instruments.hook_load.place = place;
        return tag(scene);
      };
      const Tagged far = from(2.0 + 30.0 * speed), near = from(0.01), nearer = from(0.1);
      EXPECT_GT(near.highest, 0.03);
      EXPECT_NEAR(near.zero, far.zero, 0.002 * far.zero) << speed << " m/s";
      EXPECT_NEAR(nearer.zero, far.zero, 0.002 * far.zero) << speed << " m/s";
    }
}

// A string that hangs up above the bottom is no zero: the load that falls ends the tag as a weight does.
TEST(Tag, tagEndsWhereTheStringHangsUp)
{
  Scene scene = vertical_scene(1000.0, 990.0, 0.25);
  scene.string = drilling_scene().string;
  scene.numerics.level = Level::axial_torsional;
  scene.operations = {operation(OperationKind::tag)};
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  for (int k = 0; k < 3000; ++k) ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running);
  ASSERT_FALSE(player.finished());
  ASSERT_TRUE(rig.stick_pipe(500.0));
  for (int k = 0; k < 3000 && !player.finished(); ++k) ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running);
  EXPECT_TRUE(player.finished());
  EXPECT_TRUE(rig.setpoints().winch.brake);
  EXPECT_LT(rig.readings().bit_depth, 991.0);
  EXPECT_EQ(player.operations().status().hung_up.number, 1);
  EXPECT_NEAR(player.operations().status().hung_up.above, rig.readings().hole_depth - rig.readings().bit_depth, 0.01);
}

// The pumped mud lifts the string, by 16 kN here; its pressure takes half a minute to come.
TEST(Tag, theWeightIsZeroedAtASteadyPressure)
{
  for (const double above : {0.03, 0.3})
    for (const Operation& first : {operation(OperationKind::tag), drill(0.1)})
    {
      Scene scene = vertical_scene(1000.0, 1000.0 - above, 0.25);
      scene.string = drilling_scene().string;
      scene.numerics.level = Level::axial_torsional;
      scene.operations = {rotate(60.0 * rpm, 1.0), flow(0.04), first, drill(0.1)};
      scene.instruments.hook_load.place = HookLoadPlace::block;
      Simulator rig(scene);
      ScenePlayer player(rig.scene());
      play_up_to(4, rig, player);
      play_up_to(0, rig, player);
      EXPECT_NEAR(rig.readings().surface_wob, rig.truth().wob, 2.5e3) << above << " m, " << word_of(first.kind);
    }
}

TEST(Tag, tagOnBottomNeedsAZero)
{
  Scene scene = scene_with({operation(OperationKind::tag)}, 0.0);
  scene.start.weight_on_bit = 5e3;
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
  EXPECT_EQ(player.operations().status().trouble, OperationTrouble::tag_on_bottom);
  EXPECT_TRUE(rig.asked().winch.brake);
}
}  // namespace test_sim_tag
