// SPDX-License-Identifier: BSD-3-Clause
// Pick-up, slack-off and rotating weights that the driller's console finds.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "rviz/console/string_weights.h"

namespace test_rviz_weights
{
using namespace drill_rig_sim::console;

namespace
{
constexpr double step = 0.01, bottom = 500.0;  // [s], [m]

/// A rig whose block moves and whose string turns at will.
class Rig
{
public:
  StringWeights weights;
  MoveReading now{100.0, 2e5, 5.0, 0.0, 0.0, 490.0, bottom, false, 0};

  /// Moves for so long; `load` by the way since its begin [m]. The last weight that a move ended with.
  std::optional<StringWeight> move(double velocity, double rotation, double seconds, const std::function<double(double)>& load)
  {
    std::optional<StringWeight> ended;
    double way = 0.0;
    for (double t = 0.0; t < seconds - 0.5 * step; t += step)
    {
      now.time += step;
      way += std::abs(velocity) * step;
      now.block_height += velocity * step;
      now.bit_depth -= velocity * step;
      now.block_velocity = velocity;
      now.rotation = rotation;
      now.hook_load = load(way);
      if (const auto weight = weights.take(now)) ended = weight;
    }
    return ended;
  }
  std::optional<StringWeight> rest()
  {
    return move(0.0, 0.0, 1.0, [](double) { return 2e5; });
  }
  double load(Motion motion) const
  {
    const auto weight = weights.near(motion, now.bit_depth);
    return weight ? weight->load : missing;
  }
};

std::function<double(double)> steady(double load)
{
  // the stretch before the string moves, then waves of a kilonewton about the weight
  return [load](double way) { return way < 0.5 ? 2e5 + (load - 2e5) * way / 0.5 : load + 1e3 * std::sin(20.0 * way); };
}
}  // namespace

TEST(StringWeights, meanOfASteadyPickUpWithoutItsBegin)
{
  Rig rig;
  rig.move(0.2, 0.0, 14.9, steady(2.6e5));
  EXPECT_TRUE(std::isnan(rig.load(Motion::pick_up))) << "10 s settle, 5 s must remain";
  Rig other;
  other.move(0.2, 0.0, 20.0, steady(2.6e5));
  EXPECT_NEAR(2.6e5, other.load(Motion::pick_up), 100.0);
  const auto ended = other.rest();
  ASSERT_TRUE(ended);
  EXPECT_EQ(Motion::pick_up, ended->motion);
  EXPECT_NEAR(2.6e5, ended->load, 100.0);
  EXPECT_NEAR(490.0 - 3.0, ended->depth, 0.01) << "mean of 10 s to 20 s at 0.2 m/s";
  EXPECT_FALSE(other.rest()) << "once";
  EXPECT_NEAR(2.6e5, other.load(Motion::pick_up), 100.0) << "it stays";
  EXPECT_EQ("Pick-up weight 260.0 kN at 487.00 m", text_of({Motion::pick_up, 2.6e5, 487.0}, UnitSystem::si));
  EXPECT_EQ("Slack-off weight 58.5 klbf at 1597.77 ft", text_of({Motion::slack_off, 2.6e5, 487.0}, UnitSystem::oilfield));
}

TEST(StringWeights, eachMotionHasItsOwn)
{
  Rig rig;
  rig.move(0.3, 0.0, 20.0, steady(2.6e5));
  rig.move(0.0, 6.0, 20.0, steady(2.0e5));
  rig.move(-0.3, 0.0, 18.0, steady(1.7e5));
  EXPECT_NEAR(2.6e5, rig.load(Motion::pick_up), 200.0);
  EXPECT_NEAR(1.7e5, rig.load(Motion::slack_off), 200.0);
  EXPECT_NEAR(2.0e5, rig.load(Motion::rotating), 1.0);
}

TEST(StringWeights, aSlowStringMustTurnAllAlongFirst)
{
  Rig rig;
  rig.now.hole_depth = 3010.0;
  rig.now.bit_depth = 3000.0;
  rig.move(0.0, 3.0, 28.0, [](double) { return 2e5; });  // 2 + 9 turns take 23 s
  EXPECT_TRUE(std::isnan(rig.load(Motion::rotating)));
  rig.move(0.0, 3.0, 0.2, [](double) { return 2e5; });
  EXPECT_DOUBLE_EQ(2e5, rig.load(Motion::rotating));
}

TEST(StringWeights, aStringThatIsHeldHasNone)
{
  Rig rig;
  rig.move(0.02001, 0.0, 200.0, [](double way) { return 2e5 + 2e5 * way; });
  EXPECT_TRUE(std::isnan(rig.load(Motion::pick_up)));
}

TEST(StringWeights, noWeightOnBottomInTheSlipsOrOfAnUnevenMove)
{
  Rig rig;
  rig.now.hole_depth = rig.now.bit_depth + 1.9;
  rig.move(-0.0001, 6.0, 20.0, steady(2.0e5));
  EXPECT_TRUE(std::isnan(rig.load(Motion::rotating))) << "less than 2 m off bottom";
  Rig slips;
  slips.now.in_slips = true;
  slips.move(0.2, 0.0, 20.0, steady(6e4));
  EXPECT_TRUE(std::isnan(slips.load(Motion::pick_up)));
  Rig uneven;
  for (const double speed : {0.1, 0.2, 0.1, 0.2}) uneven.move(speed, 0.0, 14.0, steady(2.6e5));
  EXPECT_TRUE(std::isnan(uneven.load(Motion::pick_up)));
}

TEST(StringWeights, dropOutsDoNotCount)
{
  Rig rig;
  rig.move(0.2, 0.0, 12.0, steady(2.6e5));
  rig.move(0.2, 0.0, 2.0, [](double) { return missing; });
  rig.move(0.2, 0.0, 6.0, [](double) { return 2.6e5; });
  EXPECT_NEAR(2.6e5, rig.load(Motion::pick_up), 200.0);
}

TEST(StringWeights, anotherRunOrDepthForgetsThem)
{
  Rig rig;
  rig.move(0.2, 0.0, 20.0, steady(2.6e5));
  EXPECT_TRUE(rig.weights.near(Motion::pick_up, 586.0));
  EXPECT_FALSE(rig.weights.near(Motion::pick_up, 588.0)) << "100 m deeper the weight is another";
  rig.now.epoch = 1;
  rig.rest();
  EXPECT_TRUE(std::isnan(rig.load(Motion::pick_up)));
  rig.move(0.2, 0.0, 12.0, steady(2.6e5));
  rig.now.time += 6.0;  // the console was hidden
  rig.move(0.2, 0.0, 10.0, steady(2.6e5));
  EXPECT_TRUE(std::isnan(rig.load(Motion::pick_up))) << "a gap begins a new move";
  rig.now.time = 0.0;
  rig.move(0.2, 0.0, 20.0, steady(2.5e5));
  EXPECT_NEAR(2.5e5, rig.load(Motion::pick_up), 100.0);
}

}  // namespace test_rviz_weights
