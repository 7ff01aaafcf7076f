// SPDX-License-Identifier: BSD-3-Clause
// Operation drill without a tag before it: the weight on bit comes to what is asked without an overshoot, zeroed while the string
// is lowered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/crew/bottom_approach.h"
#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/run.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_bottom_approach
{
using namespace drill_rig_sim;

namespace
{
Operation drill(double weight, double speed)
{
  Operation o = default_operation(OperationKind::drill);
  o.weight = weight;
  o.speed = speed;
  o.time = 1e3;
  return o;
}

Scene scene_with(const Operation& drills, double above)
{
  Scene scene = drilling_scene(above, 0.25);
  scene.formation[0].drillability = 5e-9;
  Operation rotate = default_operation(OperationKind::rotate);
  rotate.rotary_speed = 60.0 * rpm;
  rotate.ramp = 5.0;
  scene.operations = {rotate, drills};
  return scene;
}

/// A string of stiffness K on rock that does not give way, whose weight its gauge shows `delay` later; drag turns round over dF/K
/// of the block's way.
struct Rod
{
  double stiffness, delay, drag, bottom;  // [N/m], [s], [N], way of the block to bottom [m]
  std::vector<double> weights = {};

  Readings at(double way, double time, double step)
  {
    weights.push_back(stiffness * std::max(0.0, way - bottom));
    const std::size_t late = weights.size() - 1 - std::min(weights.size() - 1, static_cast<std::size_t>(delay / step));
    Readings now;
    now.time = time;
    now.block_height = 20.0 - way;
    now.hole_depth = 1000.0 + std::max(0.0, way - bottom);
    now.bit_depth = 1000.0 - bottom + way;
    now.hook_load = 1e6 - std::min(drag, stiffness * way) - weights[late];
    now.surface_wob = now.mean_surface_wob = 1e6 - drag - now.hook_load;
    now.tared = true;
    return now;
  }
};

/// The largest weight on the way, and at the end, as shares of what is wanted.
std::pair<double, double> lowered(Rod rod, double wanted, double speed)
{
  constexpr double step = 0.02;
  const HookedString string{rod.stiffness, 1e5};
  BottomApproach approach;
  WeightFeed feed;
  double way = 0.0, most = 0.0;
  for (int k = 0; k < 30000; ++k)
  {
    const Readings now = rod.at(way, k * step, step);
    most = std::max(most, rod.weights.back() / wanted);
    if (!approach.begun) approach.begin(now, string, wanted, speed, false, false);
    if (approach.goes_on(now, step))
    {
      feed = WeightFeed();
      way -= approach.velocity(now, step) * step;
    }
    else
      way -= feed.velocity(now.mean_surface_wob, wanted, rod.stiffness, speed, step) * step;
  }
  return {most, rod.weights.back() / wanted};
}
}  // namespace

// From 300 m to 5 km of pipe, for 10 to 150 kN, with the gauge as late as a wave: an eighth of what is wanted a second.
TEST(BottomApproach, doesNotOvershoot)
{
  for (const auto& [stiffness, delay] : {std::pair{2e6, 0.06}, {6e5, 0.2}, {1.5e5, 1.0}})
    for (const double wanted : {10e3, 20e3, 150e3})
      for (const double speed : {0.01, 0.1, 0.3})
        for (const double bottom : {0.03, 0.2, 3.0})
        {
          const auto [most, last] = lowered({stiffness, delay, 0.0, bottom}, wanted, speed);
          EXPECT_LT(most, 1.15) << stiffness << ' ' << wanted << ' ' << speed << ' ' << bottom;
          EXPECT_NEAR(last, 1.0, 0.01) << stiffness << ' ' << wanted << ' ' << speed << ' ' << bottom;
        }
}

// Drag that turns round takes ten times the weight that is wanted from the hook load, high above bottom.
TEST(BottomApproach, takesDragThatTurnsRoundForNoWeight)
{
  const auto [most, last] = lowered({6e5, 0.2, 200e3, 3.0}, 20e3, 0.05);
  EXPECT_GT(most, 0.9);
  EXPECT_LT(most, 1.15);
  EXPECT_NEAR(last, 1.0, 0.01);
}

// 100 m of pipe, the stiffest of all. Before, 20 kN at 0.3 m/s ended with a weight far above.
TEST(BottomApproach, drillWithoutATagKeepsTheWeight)
{
  for (const HookLoadPlace place : {HookLoadPlace::block, HookLoadPlace::dead_line})
    for (const double above : {0.01, 0.3, 3.0})
      for (const double speed : {0.02, 0.3})
      {
        Scene scene = scene_with(drill(20e3, speed), above);
        scene.instruments.hook_load.place = place;
        Simulator rig(scene);
        ScenePlayer player(rig.scene());
        double most = 0.0, sum = 0.0;
        const double lasts = 160.0 + above / speed;
        for (int k = 0; k < std::lround((lasts + 20.0) / frame); ++k)
        {
          ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
          most = std::max(most, rig.truth().wob);
          if (k * frame >= lasts) sum += rig.readings().surface_wob * frame / 20.0;
        }
        EXPECT_LT(most, 1.2 * 20e3) << above << ' ' << speed;
        EXPECT_NEAR(sum, 20e3, 600.0) << above << ' ' << speed;
        EXPECT_NEAR(rig.truth().wob, 20e3, place == HookLoadPlace::block ? 600.0 : 3e3)
            << above << ' ' << speed << ": the dead line shows less";
      }
}
}  // namespace test_sim_bottom_approach
