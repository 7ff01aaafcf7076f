// SPDX-License-Identifier: BSD-3-Clause
// What makes a run inaccurate is told, with a remedy; an accurate one is left in peace.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"
#include "watched_rig.h"

namespace test_sim_accuracy
{
using namespace drill_rig_sim;

namespace
{
constexpr std::size_t watched = 8;  // an element of drill pipe

}  // namespace

// E I = 206e9 * 5.942e-6 = 1.2241e6 N m2: (pi^2/2) E I / 9.5^2 = 66.93 kN.
TEST(Accuracy, anElementCarriesSoMuchCompression)
{
  Watched w(vertical_scene(400.0, 290.0));
  const Mesh& mesh = w.rig.model->mesh();
  ASSERT_NEAR(mesh.elements[watched].section.length, 9.5, 1e-9);
  w.forces.tension[watched] = -66.8e3;
  w.forces.tension[watched + 1] = 500e3;
  EXPECT_EQ(w.after(1.0).doubt, AccuracyDoubt::none);
  w.forces.tension[watched] = -2.0 * 66.93e3;
  w.forces.tension[watched + 1] = -1.5 * 66.93e3;
  const AccuracyReport report = w.after(0.1);
  EXPECT_EQ(report.doubt, AccuracyDoubt::compression);
  EXPECT_NEAR(report.measure, 2.0, 1e-3);
  EXPECT_EQ(report.from_bit, 0.5 * (mesh.nodes[watched].from_bit + mesh.nodes[watched + 1].from_bit));
  EXPECT_NEAR(report.element_length, 9.5, 1e-9);
}

TEST(Accuracy, aDoubtStandsForTenSeconds)
{
  Watched w(vertical_scene(400.0, 290.0));
  w.forces.tension[watched] = -100e3;
  w.after(0.1);
  w.forces.tension[watched] = 0.0;
  EXPECT_EQ(w.after(9.8).doubt, AccuracyDoubt::compression);
  EXPECT_EQ(w.after(0.3).doubt, AccuracyDoubt::none);
}

// G J = 206e9/2.6 * 1.1884e-5 = 941.6e3 N m2; 110 kN m over 9.5 m: 1.11 rad.
TEST(Accuracy, anElementIsTwisted)
{
  Watched w(vertical_scene(400.0, 290.0));
  w.forces.torque[watched] = 98e3;
  EXPECT_EQ(w.after(0.2).doubt, AccuracyDoubt::none);
  w.forces.torque[watched] = -110e3;
  EXPECT_EQ(w.after(0.2).doubt, AccuracyDoubt::twist);
  EXPECT_NEAR(w.memory.report.measure, 1.11, 1e-3);
}

// A tool joint of 168 mm in a hole of 215.9 mm: clearance 23.95 mm, 5e7 N/m^1.5 * 0.02395^1.5 = 185.3 kN.
TEST(Accuracy, theWallIsTooSoft)
{
  Watched w(vertical_scene(400.0, 290.0));
  ASSERT_NEAR(w.rig.model->mesh().nodes[watched].contact_radius, 0.084, 1e-12);
  w.forces.contact[watched] = 185e3;
  EXPECT_EQ(w.after(0.2).doubt, AccuracyDoubt::none);
  w.forces.contact[watched] = 186e3;
  EXPECT_EQ(w.after(0.2).doubt, AccuracyDoubt::embedding);
  EXPECT_NEAR(w.memory.report.measure, 0.024, 1e-4);
  // the stiffness that the warning names: 1.5 * 186 kN / 0.02395^1.5
  EXPECT_NEAR(w.memory.report.allowed, 7.527e7, 1e4);
  // the bit fills its hole, on a wall of its own: 2 mm, 2e10 * 0.002^1.5 = 1789 kN
  Watched bit(vertical_scene(400.0, 290.0));
  bit.forces.contact[0] = 1.78e6;
  EXPECT_EQ(bit.after(0.2).doubt, AccuracyDoubt::none);
  bit.forces.contact[0] = 1.80e6;
  EXPECT_EQ(bit.after(0.2).doubt, AccuracyDoubt::embedding);
  EXPECT_NEAR(bit.memory.report.allowed, 1.5 * 1.80e6 / std::pow(0.002, 1.5), 1.0);
}

// An upright rig over a slant hole.
TEST(Accuracy, theHoleLeavesTheTableInclined)
{
  for (const auto& [inclination, doubt] : {std::pair{9.0, AccuracyDoubt::none}, std::pair{12.0, AccuracyDoubt::slant}})
  {
    Scene scene = vertical_scene(400.0, 290.0);
    for (SurveyStation& station : scene.well.survey) station.inclination = inclination * degree;
    Watched w(scene);
    EXPECT_EQ(w.after(0.2).doubt, doubt) << inclination;
    EXPECT_EQ(static_report(scene, SlidingMotion()).accuracy.doubt, doubt) << inclination;
  }
}

TEST(Accuracy, saysWhereWhatAndWhatHelps)
{
  EXPECT_EQ(text_of(AccuracyReport()), "");
  EXPECT_EQ(text_of({AccuracyDoubt::measured, 0.031, 0.0, 0.0, 0.02, Output::torque, {0.004, 0.005, 0.025, 0.0}}),
            "torque: measured error 3.1 % of its range so far, over 3 s; over 30 s 0.4 % in the average, 0.5 % in the deviation, "
            "2.5 % in the extremes; numerics.tolerance is 2 %. Use only averages that are accurate enough, or double "
            "numerics.refinement "
            "(default: 1)");
  const std::string first = text_of({AccuracyDoubt::measured, 72.0, 0.0, 0.0, 0.02, Output::rop, {0.117, 0.005, 0.025, 0.0}});
  EXPECT_NE(first.find("measured error more than 100 % of its range"), std::string::npos) << first;
  EXPECT_NE(first.find(" 12 % in the average"), std::string::npos) << first;
  EXPECT_EQ(text_of({AccuracyDoubt::confined, 0.85, 310.5, 9.5}),
            "guided pipe 310.5 m above the bit carries 0.85 times its critical buckling load, but does not bend: drag and torque "
            "are too low; use numerics.level: beam3d, or hybrid with numerics.free_length above 310.5");
  EXPECT_EQ(text_of({AccuracyDoubt::compression, 4.0, 812.0, 9.5}),
            "an element of 9.5 m, 812 m above the bit, carries 4.00 times the compression that it can represent: its "
            "bending is uncertain; use numerics.element_length: 4.2 or less");
  EXPECT_EQ(text_of({AccuracyDoubt::twist, 2.0, 812.0, 9.5}),
            "an element of 9.5 m, 812 m above the bit, is twisted by 2.00 rad, more than 1: its torque is uncertain; use "
            "numerics.element_length: 4.2 or less");
  EXPECT_EQ(
      text_of({AccuracyDoubt::embedding, 0.0062, 1.8, 0.0, 1.231e9}),
      "1.8 m above the bit the string is 6.2 mm deep in the wall, more than its clearance: side forces are too small there; "
      "use contact.stiffness: 1.3e+09 or more, in that part if it has its own contact");
  EXPECT_EQ(text_of({AccuracyDoubt::slant, 12.0 * degree, 0.0, 0.0}),
            "the hole is inclined by 12 deg at the rotary table, but the rig is upright: hook load and torque include a bend "
            "there; use a well.survey that begins vertical");
}
// Programs of users compare them: none changes.
TEST(Accuracy, reasonsHaveCodesThatStay)
{
  EXPECT_STREQ(code_of(AccuracyDoubt::none), "");
  EXPECT_STREQ(code_of(AccuracyDoubt::measured), "measured_error");
  EXPECT_STREQ(code_of(AccuracyDoubt::confined), "guided_pipe_buckles");
  EXPECT_STREQ(code_of(AccuracyDoubt::compression), "element_compression");
  EXPECT_STREQ(code_of(AccuracyDoubt::twist), "element_twist");
  EXPECT_STREQ(code_of(AccuracyDoubt::embedding), "soft_wall");
  EXPECT_STREQ(code_of(AccuracyDoubt::slant), "slanted_start");
  EXPECT_STREQ(code_of(AccuracyDoubt::level), "level");
  EXPECT_STREQ(code_of(AccuracyDoubt::turn), "turn_of_hole");
}

}  // namespace test_sim_accuracy
