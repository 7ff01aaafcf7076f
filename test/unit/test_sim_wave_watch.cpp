// Waves that the steps blur, in torque and hook load, and a lower end that hesitates, are told.
#include <gtest/gtest.h>

#include <tuple>

#include "watched_rig.h"

namespace test_sim_wave_watch
{
using namespace drill_rig_sim;

// Waves of 100 N m and f = 2.5 Hz at steps of 10 ms: BDF2 is late by 2 pi f (2 pi f h)^2/3 = 0.129 and damps by (2 pi f h)^4/(4 h) = 0.0152
// 1/s; where mud damps them in 2 s, and 3 s ahead, that is 0.144 * 5 s = 0.72 of a deviation of 70.7 N m, 25 % of the range of 200 N m.
TEST(Accuracy, theTorqueSwingsTooFastForTheStep)
{
  for (const auto& [amplitude, frequency, doubt] :
       {std::tuple{100.0, 2.5, AccuracyDoubt::waves}, {100.0, 0.3, AccuracyDoubt::none}, {2.0, 2.5, AccuracyDoubt::none}})
  {
    double passes = 0.0, measure = 0.0;
    constexpr int phases = 20;  // a crossing more or less in the last second counts: means over where the last frame stands between two of them
    for (int phase = 0; phase < phases; ++phase)
    {
      Watched w(dying_in_two_seconds());
      for (int k = 1; k <= 1500; ++k)
      {
        w.forces.meter_torque = 55.0 + amplitude * std::sin(2.0 * pi * frequency * k * frame + pi * phase / phases);
        w.play(frame);
      }
      EXPECT_EQ(w.memory.report.doubt, doubt) << amplitude << " N m, " << frequency << " Hz";
      passes += w.memory.torque.passes / phases;
      measure += w.memory.report.measure / phases;
    }
    if (doubt == AccuracyDoubt::none) continue;
    EXPECT_NEAR(passes, 2.0 * frequency, 0.2);
    EXPECT_NEAR(measure, 0.255, 0.02);
  }
  EXPECT_EQ(text_of({AccuracyDoubt::waves, 0.08, 0.0, 0.0}, 0.01),
            "the steps blur the torque's waves by 8 % of its range; numerics.step: 0.005 s or less");
}

// The hook load's likewise, to 10 %; its range begins where it is, of a level of 500 kN a tenth counts.
TEST(Accuracy, theHookLoadSwingsTooFastForTheStep)
{
  for (const auto& [amplitude, doubt] : {std::pair{20e3, AccuracyDoubt::load_waves}, {2e3, AccuracyDoubt::none}})
  {
    Watched w(dying_in_two_seconds());
    for (int k = 1; k <= 1500; ++k)
    {
      w.forces.hook_load = 500e3 + amplitude * std::sin(2.0 * pi * 2.5 * k * frame);
      w.play(frame);
    }
    EXPECT_EQ(w.memory.report.doubt, doubt) << amplitude;
  }
  EXPECT_EQ(text_of({AccuracyDoubt::load_waves, 0.08, 0.0, 0.0}, 0.01),
            "the steps blur the hook load's waves by 8 % of its range; numerics.step: 0.005 s or less");
}

// Loose and stuck again before it has run as the drive does; after a whole slip, or while the drive stands, it may stand as it likes.
TEST(Accuracy, theLowerEndHesitates)
{
  for (const auto& [reached, drive, doubt] : {std::tuple{1.0, 5.0, AccuracyDoubt::hesitation}, {0.25, 5.0, AccuracyDoubt::none},
                                             {9.0, 5.0, AccuracyDoubt::none}, {1.0, 0.0, AccuracyDoubt::none}})
  {
    Watched w(vertical_scene(400.0, 290.0));
    w.rig.state.drive.speed = drive;
    w.play(1.0);
    w.rig.state.nodes[0].rate.spin = reached;
    w.play(0.2);
    EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none) << "not yet";
    w.rig.state.nodes[0].rate.spin = 0.0;
    w.play(0.2);
    EXPECT_EQ(w.memory.report.doubt, doubt) << reached << ", " << drive;
  }
  EXPECT_EQ(text_of({AccuracyDoubt::hesitation, 0.8, 0.0, 0.0}, 0.01),
            "the string's lower end came loose to 0.8 rad/s and stuck again: when it goes hangs on the smallest waves, and so does the time of all that"
            " follows; means and extremes hold, how far, numerics.step: 0.005 s shows");
}
}  // namespace test_sim_wave_watch
