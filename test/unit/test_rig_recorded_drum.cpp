// SPDX-License-Identifier: BSD-3-Clause
// What the drum did comes back from the gauges of a block that moves, stands and turns back, read at the dead line or at the
// block.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "drill_rig_sim/rig/recorded_drum.h"

namespace test_rig_recorded_drum
{
using namespace drill_rig_sim;

namespace
{
/// Up, standing while the load changes, down and up again, a row each `step` [s]; the load goes with the way of the drum, as drag
/// does.
struct Course
{
  std::vector<double> drum, heights, readings;

  Course(const HoistingSpec& spec, double step, bool dead_line)
  {
    const auto way = [](double t)
    {
      return 0.05 * (t < 1.0    ? 0.5 * t * t
                     : t < 20.0 ? t - 0.5
                     : t < 40.0 ? 19.5
                     : t < 60.0 ? 19.5 - 0.6 * (t - 40.0)
                                : 7.5 + 0.8 * (t - 60.0));
    };
    const auto load = [](double t)
    {
      return 1.5e6 + (t < 20.0   ? 8e4 * std::tanh(t)
                      : t < 40.0 ? 8e4 - 3e3 * (t - 20.0)
                      : t < 60.0 ? -1e5 * std::tanh(t - 40.0)
                                 : 9e4 * std::tanh(t - 60.0));
    };
    double slip = 0.0;
    for (double t = 0.0, before = 0.0; t < 80.0; t += step)
    {
      for (double fine = before; fine < t - 1e-9; fine += 0.01)
        slip = sheave_slip(slip, way(std::min(fine + 0.01, t)) - way(fine));
      before = t;
      drum.push_back(10.0 + way(t));
      readings.push_back(dead_line ? dead_line_hook_load(load(t), slip, spec.sheaves, spec.sheave_efficiency) : load(t));
      // the block hangs lower by what the load stretches
      double height = drum.back();
      for (int k = 0; k < 20; ++k) height -= unloaded_height(spec, height, load(t)) - drum.back();
      heights.push_back(height);
    }
  }
};

HoistingSpec rig()
{
  HoistingSpec spec;
  spec.sheaves = 6;
  spec.crown_height = 60.0;
  return spec;
}
}  // namespace

// What counts as standing is a millimetre of what the gauges make of the drum, and up to four of the drum itself where the
// sheaves' friction turns round.
TEST(RecordedDrum, comesBack)
{
  for (const bool dead_line : {false, true})
  {
    for (const double step : {0.1, 0.5, 1.0, 5.0})
    {
      const Course course(rig(), step, dead_line);
      const std::vector<double> found = drum_heights(rig(), dead_line, course.heights, course.readings);
      ASSERT_EQ(found.size(), course.drum.size());
      for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_NEAR(found[k], course.drum[k], dead_line ? 4e-3 : 1.5e-3)
            << "row " << k << " each " << step << " s, " << (dead_line ? "dead line" : "block");
    }
  }
}

TEST(RecordedDrum, standsWhileTheLoadChanges)
{
  const HoistingSpec spec = rig();
  std::vector<double> heights, loads;
  for (int k = 0; k <= 20; ++k)
  {
    loads.push_back(1e6 + 1e4 * k);
    heights.push_back(20.0);
    for (int i = 0; i < 20; ++i) heights.back() -= unloaded_height(spec, heights.back(), loads.back()) - 20.1;
  }
  for (const double height : drum_heights(spec, true, heights, loads)) EXPECT_NEAR(height, 20.1, 1e-6);
  EXPECT_LT(heights.back(), heights.front() - 0.01);
}
}  // namespace test_rig_recorded_drum
