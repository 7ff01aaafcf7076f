// What makes a run inaccurate is told, with a remedy; an accurate one is left in peace.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

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

// 12 rad/s and 4 blades: 7.64 blades a second. A step a frame passes 0.0764 of one, 8 steps 0.00955.
TEST(Accuracy, theStepIsTooLongForTheCut)
{
  Scene scene = vertical_scene(400.0, 290.0);
  scene.string[0].bit->torque.model = BitTorqueModel::regenerative;
  scene.string[0].bit->torque.blades = 4;
  Watched w(scene);
  w.forces.bit_speed = 12.0;
  EXPECT_EQ(w.after(0.2).doubt, AccuracyDoubt::none) << "off bottom";
  w.forces.wob = 1e3;
  EXPECT_EQ(w.after(0.2).doubt, AccuracyDoubt::cut);
  EXPECT_NEAR(w.memory.report.measure, 0.0764, 1e-4);
  EXPECT_EQ(text_of(w.memory.report, 0.01),
            "a blade comes where the one before was in 13 steps, too few for the waves that it leaves; numerics.step: 0.0013 s or less");
  Watched fine(scene);
  fine.forces = w.forces;
  fine.steps = 8;
  EXPECT_EQ(fine.after(0.2).doubt, AccuracyDoubt::none);
}

TEST(Accuracy, aDoubtStandsForTenSeconds)
{
  Watched w(vertical_scene(400.0, 290.0));
  w.forces.tension[watched] = -100e3;
  w.play(0.1);
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
  // the bit fills its hole, on a wall of its own: 2 mm, 2e10 * 0.002^1.5 = 1789 kN
  Watched bit(vertical_scene(400.0, 290.0));
  bit.forces.contact[0] = 1.78e6;
  EXPECT_EQ(bit.after(0.2).doubt, AccuracyDoubt::none);
  bit.forces.contact[0] = 1.80e6;
  EXPECT_EQ(bit.after(0.2).doubt, AccuracyDoubt::embedding);
}

namespace
{
/// All of the walls' force sticks and slips by turns, for `seconds` each, the string turning at `spin` [rad/s]; the largest mean of it [1/s].
double jerks_of(Watched& w, double force, double seconds, double spin = 0.1)
{
  w.forces.contact.assign(w.forces.contact.size(), force / static_cast<double>(w.forces.contact.size()));
  double largest = 0.0;
  for (double t = 0.0; t < 12.0 * seconds; t += 0.1)
  {
    for (NodeState& node : w.rig.state.nodes)
    {
      node.rest = std::lround(t / seconds - 0.49) % 2 == 0 ? 1.0 : 0.0;
      node.rate.spin = spin;
    }
    w.play(0.1);
    largest = std::max(largest, w.memory.jerks);
  }
  return largest;
}
}  // namespace

// A jerk lets go and takes hold, half of it each: over the last 10 s T seconds apart at most 0.05/(1 - exp(-T/10)) a second.
TEST(Accuracy, theStringSticksAndSlips)
{
  Watched quick(vertical_scene(400.0, 290.0, 0.2));
  EXPECT_NEAR(jerks_of(quick, 50e3, 3.0), 0.05 / (1.0 - std::exp(-0.3)), 0.01);
  EXPECT_EQ(quick.memory.report.doubt, AccuracyDoubt::jerks);
  EXPECT_EQ(text_of({AccuracyDoubt::jerks, 0.5, 0.0, 0.0}, 0.01),
            "the string sticks and slips on its walls 0.5 times a second: long means hold, peaks, means of seconds and what a stop leaves are one case of many;"
            " how far apart these are, numerics.step: 0.005 s and shorter elements show");
  Watched slow(vertical_scene(400.0, 290.0, 0.2));
  EXPECT_NEAR(jerks_of(slow, 50e3, 12.0), 0.05 / (1.0 - std::exp(-1.2)), 0.01);
  EXPECT_EQ(slow.memory.report.doubt, AccuracyDoubt::none);
  Watched light(vertical_scene(400.0, 290.0, 0.2));
  jerks_of(light, 2e3, 3.0);
  EXPECT_EQ(light.memory.report.doubt, AccuracyDoubt::none) << "a string that hangs free touches here and there";
  Watched creeping(vertical_scene(400.0, 290.0, 0.2));
  EXPECT_LT(jerks_of(creeping, 50e3, 3.0, 0.02), 0.06) << "at 1.3 mm/s, after the first hold";
  // nothing sticks to a wall without friction; the cased half of a hole has some here
  Watched smooth(vertical_scene(400.0, 290.0, 0.0));
  EXPECT_LT(jerks_of(smooth, 50e3, 3.0), 0.06) << "the first look";
  EXPECT_EQ(smooth.memory.report.doubt, AccuracyDoubt::none);
  for (const double cased : {50.0, 150.0, 250.0})
  {
    Scene scene = vertical_scene(400.0, 290.0, 0.0);
    scene.well.sections = {{cased, 0.2159, 0.2}, {400.0, 0.2159, 0.0}};
    Watched half(scene);
    EXPECT_NEAR(jerks_of(half, 50e3, 3.0), 0.05 / (1.0 - std::exp(-0.3)), 0.01) << "of the force that rubs all";
  }
}

// 5 in pipe turning at 10 rad/s rolls at 10 R: tool joints of 0.084 m, bodies of 0.0635 m between them.
TEST(Accuracy, turningPipeRollsAlongItsWalls)
{
  for (const auto& [share, doubt] : {std::pair{0.08, AccuracyDoubt::none}, {0.15, AccuracyDoubt::whirl}})
  {
    Watched w(vertical_scene(400.0, 290.0));
    for (std::size_t i = 0; i < w.rig.state.nodes.size(); ++i)
    {
      NodeState& node = w.rig.state.nodes[i];
      node.rate.spin = 10.0;
      node.rate.velocity = {share * 10.0 * w.rig.model->mesh().nodes[i].contact_radius, 0.0, -0.3};
    }
    w.play(8.0);
    EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none) << "not for a moment";
    w.play(7.0);
    EXPECT_NEAR(w.memory.sideways, share * w.memory.surface, 1e-9);
    EXPECT_EQ(w.memory.report.doubt, doubt) << share;
  }
  EXPECT_EQ(text_of({AccuracyDoubt::whirl, 0.15, 0.0, 0.0}, 0.01),
            "the string whirls: it rolls along its walls at 0.15 of pure rolling, how far and where hangs on the mesh; numerics.element_length: half as long shows"
            " what of it is the mesh's");
}

TEST(Accuracy, theStringComesLooseWoundUp)
{
  for (const auto& [turned, held, doubt] : {std::tuple{11.0, 2.0, AccuracyDoubt::loose}, {9.0, 2.0, AccuracyDoubt::none}, {11.0, 0.5, AccuracyDoubt::none}})
  {
    Watched w(vertical_scene(400.0, 290.0));
    w.rig.state.nodes[0].rate.spin = 5.0;
    w.play(1.0);
    w.rig.state.nodes[0].rate.spin = 0.0;
    w.rig.state.nodes.back().spin_angle = w.rig.state.nodes[0].spin_angle - 2.0 * pi * turned;
    w.play(held);
    EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none);
    w.rig.state.nodes[0].rate.spin = 5.0;
    EXPECT_EQ(w.after(0.2).doubt, doubt) << turned << " turns, held for " << held << " s";
  }
  EXPECT_EQ(text_of({AccuracyDoubt::loose, 11.0, 0.0, 0.0}, 0.01),
            "the string came loose wound up by 11 turns: the moment and the waves after it are off by a tenth of a second; numerics.step: 0.005 s or"
            " less, and shorter elements");
}

// 120 rpm and 10 ms: (3 * 12.566 * 0.01)^4/0.04 = 0.505 a second; at 5 ms (.../2)^4/0.02 = 0.0631.
TEST(Accuracy, aBentMotorShakesTheString)
{
  Scene scene = motor_drilling_scene(0.01);
  ASSERT_TRUE(scene.string[1].motor);
  scene.string[1].motor->bend = 1.0 * degree;
  const auto after = [](const Scene& told, std::uint64_t steps)
  {
    Watched w(told);
    w.steps = steps;
    w.rig.state.nodes[0].rate.spin = -12.566;
    w.forces.wob = 10e3;
    return w.after(20.0);
  };
  const AccuracyReport report = after(scene, 1);
  EXPECT_EQ(report.doubt, AccuracyDoubt::shaking);
  EXPECT_NEAR(report.measure, 0.505, 0.01);
  EXPECT_EQ(text_of({AccuracyDoubt::shaking, 0.8, 0.0, 0.0}, 0.01),
            "the bent motor shakes the string three times a turn, and the method damps such waves by 0.8 a second; numerics.step: 0.005 s or less");
  EXPECT_EQ(after(scene, 2).doubt, AccuracyDoubt::none) << "steps of 5 ms";
  scene.string[1].motor->bend = 0.0;
  EXPECT_EQ(after(scene, 1).doubt, AccuracyDoubt::none) << "a straight motor";
}

// The second blow a second after the first: (1 + exp(-1/3))/3 = 0.572 a second over the last 3 s.
TEST(Accuracy, theBitStrikesTheBottom)
{
  Watched w(vertical_scene(400.0, 290.0));
  w.play(1.0);
  w.forces.wob = 10e3;
  w.play(0.5);
  EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none) << "it is on bottom";
  w.forces.wob = 0.0;
  w.play(0.5);
  w.forces.wob = 10e3;
  w.play(0.1);
  EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::blows);
  EXPECT_NEAR(w.memory.report.measure, 0.572, 0.03);
  EXPECT_EQ(text_of(w.memory.report, 0.01).substr(0, 31), "the bit strikes the bottom 0.57");
}

TEST(Accuracy, aBitThatComesDownGentlyStrikesNothing)
{
  Watched w(vertical_scene(400.0, 290.0));
  for (int k = 0; k < 20; ++k)
  {
    w.forces.wob = 0.0;
    w.play(0.1);
    w.forces.wob = 50.0 * k;
    w.play(0.1);
  }
  EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none) << w.memory.blows;
}

// An attempt a second is refused of two: the mean over 10 s passes a fifth after 10 ln(0.5/0.3) = 5.1 s.
TEST(Accuracy, stepsAreRefused)
{
  Watched w(vertical_scene(400.0, 290.0));
  w.play(4.9, 1);
  EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none);
  w.play(0.5, 1);
  EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::refused_steps);
}

TEST(Accuracy, variableStepsAreTriedByTheirErrors)
{
  Scene scene = vertical_scene(400.0, 290.0);
  scene.numerics.step = 0.0;
  Watched w(scene);
  w.play(5.4, 0, 1);
  EXPECT_EQ(w.memory.report.doubt, AccuracyDoubt::none);
}

// A string that is set turning at once rings: implicit Euler eats that, BDF2 does not.
TEST(Accuracy, theMethodDissipates)
{
  Scene scene = vertical_scene(400.0, 390.0);
  for (const auto& [method, dissipates] : {std::pair{IntegratorKind::bdf2, false}, std::pair{IntegratorKind::implicit_euler, true}})
  {
    scene.numerics.integrator = method;
    Simulator rig(scene);
    TopDriveSetpoint turn;
    turn.speed = 12.0;
    rig.command(turn);
    bool told = false;
    for (int k = 0; k < 300; ++k)
    {
      ASSERT_EQ(rig.frame(frame), FrameStatus::running);
      told = told || rig.statistics().accuracy.doubt == AccuracyDoubt::dissipation;
      EXPECT_EQ(rig.truth().accuracy_warning, rig.statistics().accuracy.doubt != AccuracyDoubt::none);
    }
    EXPECT_EQ(told, dissipates) << text_of(rig.statistics().accuracy, scene.numerics.step);
  }
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
  EXPECT_EQ(text_of({AccuracyDoubt::slant, 12.0 * degree, 0.0, 0.0}, 0.01),
            "the hole leaves the table by 12 deg from the vertical, and the rig stands upright: hook load and torque are those of a string pulled over a corner;"
            " well.survey: vertical at the table");
}

// The jump of a command costs energy in its own step alone, in any method; programs give commands at full seconds, where samples are taken too.
TEST(Accuracy, aCommandsOwnStepDoesNotStandForOthers)
{
  Simulator rig(vertical_scene(400.0, 390.0));
  TopDriveSetpoint turn;
  for (int k = 0; k < 1200; ++k)
  {
    turn.speed = (k / 300) % 2 == 0 ? 3.0 : -3.0;
    if (k % 300 == 0) rig.command(turn);
    ASSERT_EQ(rig.frame(frame), FrameStatus::running);
    ASSERT_NE(rig.statistics().accuracy.doubt, AccuracyDoubt::dissipation) << k << ": " << text_of(rig.statistics().accuracy, frame);
  }
}

TEST(Accuracy, saysWhereWhatAndWhatHelps)
{
  EXPECT_EQ(text_of({}, 0.01), "");
  EXPECT_EQ(text_of({AccuracyDoubt::compression, 4.0, 812.0, 9.5}, 0.01),
            "812 m above the bit an element of 9.5 m carries 4.00 times the compression that it can bend under; numerics.element_length: 4.2 or less");
  EXPECT_EQ(text_of({AccuracyDoubt::twist, 2.0, 812.0, 9.5}, 0.01),
            "812 m above the bit an element of 9.5 m is twisted by 2.00 rad; numerics.element_length: 4.2 or less");
  EXPECT_EQ(text_of({AccuracyDoubt::embedding, 0.0062, 1.8, 0.0}, 0.01),
            "1.8 m above the bit the string is 6.2 mm deep in the wall, more than its clearance; contact.stiffness: stiffer");
  EXPECT_EQ(text_of({AccuracyDoubt::refused_steps, 0.3, 0.0, 0.0}, 0.01), "30 % of the steps had to be taken in parts; numerics.step: below 0.01 s");
  EXPECT_EQ(text_of({AccuracyDoubt::dissipation, 0.08, 0.0, 0.0}, 0.01),
            "the method takes 8 % of the energy that goes through; numerics.step: below 0.01 s, or shorter elements");
}
}  // namespace test_sim_accuracy
