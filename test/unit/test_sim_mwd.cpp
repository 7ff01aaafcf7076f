// SPDX-License-Identifier: BSD-3-Clause
// Telemetry by pulses in the mud: a toolface with errors of its own, silent while the pipe turns; a survey taken in the quiet
// between two flows; the inclination between surveys.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/instruments/mwd.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_ahead.h"
#include "test_scenes.h"

namespace test_sim_mwd
{
using namespace drill_rig_sim;

namespace
{
constexpr double flow = 0.03;  // [m3/s]

SensorView view_of(double inclination, double toolface, double spin_speed = 0.0)
{
  SensorView view;
  view.md = 100.0;
  view.axis = tangent_from(inclination, 1.0);
  const Eigen::Vector3d up = high_side(view.axis);
  view.scribe = up * std::cos(toolface) + view.axis.cross(up) * std::sin(toolface);
  view.spin_speed = spin_speed;
  return view;
}

ToolfaceSpec prompt_toolface()
{
  ToolfaceSpec spec;
  spec.period = 1.0;
  spec.latency = 0.0;
  return spec;
}

/// Surveys after a cycle of the pumps, two seconds on their way.
MwdSpec surveys_of_the_quiet(double quiet_time)
{
  MwdSpec spec;
  spec.period = 0.0;
  spec.latency = 2.0;
  spec.quiet_time = quiet_time;
  return spec;
}
}  // namespace

// 10^4 readings: the deviation within 5 sqrt(1/2n) of the toolface's own, whatever the survey's.
TEST(Toolface, hasItsOwnNoise)
{
  MwdSpec survey;
  survey.noise = 0.5;
  ToolfaceSpec toolface = prompt_toolface();
  toolface.noise = 0.02;
  Mwd mwd(survey, toolface, NoiseSource{3});
  const int n = 10000;
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < n; ++k)
  {
    MwdReading reading;
    ToolfaceReading face;
    mwd.update(k, flow, view_of(1.0, 0.5), reading, face);
    const double error = face.toolface - 0.5;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / n, 0.0, 0.02 * 5.0 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.02, 0.02 * 5.0 * std::sqrt(0.5 / n));
}

// In steps of 2.8 deg (128 to the turn, as tools send them in 7 bits), and never outside -pi .. pi.
TEST(Toolface, comesInItsSteps)
{
  ToolfaceSpec toolface = prompt_toolface();
  toolface.resolution = 2.0 * pi / 128.0;
  for (int k = -180; k < 180; ++k)
  {
    Mwd mwd(MwdSpec(), toolface);
    MwdReading reading;
    ToolfaceReading face;
    mwd.update(0.0, flow, view_of(1.0, k * degree), reading, face);
    const double steps = face.toolface / toolface.resolution;
    EXPECT_NEAR(steps, std::round(steps), 1e-9) << k;
    EXPECT_LE(std::abs(std::remainder(face.toolface - k * degree, 2.0 * pi)), 0.5 * toolface.resolution + 1e-9) << k;
    EXPECT_LE(std::abs(face.toolface), pi) << k;
  }
}

// Sent at a standstill and up to the speed, not above it, either way round; the first after the pipe has stopped is a fresh one.
TEST(Toolface, isSilentWhileThePipeTurns)
{
  ToolfaceSpec toolface = prompt_toolface();
  toolface.max_speed = 10.0 * rpm;
  for (const double speed : {0.0, 9.9, 10.1, 60.0, -60.0})
  {
    Mwd mwd(MwdSpec{30.0, 0.0}, toolface);
    MwdReading reading;
    ToolfaceReading face;
    for (int k = 0; k <= 50; ++k) mwd.update(0.1 * k, flow, view_of(1.0, 0.5, speed * rpm), reading, face);
    EXPECT_EQ(std::abs(speed) < 10.0 ? 6u : 0u, face.sequence) << speed;
    EXPECT_EQ(1u, reading.sequence) << "surveys come all the same";
    mwd.update(5.55, flow, view_of(1.0, -0.5), reading, face);
    if (std::abs(speed) < 10.0) continue;
    EXPECT_EQ(1u, face.sequence);
    EXPECT_NEAR(-0.5, face.toolface, 1e-12);
    EXPECT_EQ(5.55, face.time);
  }
}

TEST(Toolface, isSentWhateverTheSpeedByDefault)
{
  Mwd mwd(MwdSpec(), prompt_toolface());
  MwdReading reading;
  ToolfaceReading face;
  mwd.update(0.0, flow, view_of(1.0, 0.5, 20.0), reading, face);
  EXPECT_EQ(1u, face.sequence);
}

// Flow to 10 s, then none to 40 s. The survey is of 15 s, as the pipe lay then, and begins its two seconds' way when the flow is
// back.
TEST(Mwd, takesASurveyInTheQuietAndSendsItWithTheFlow)
{
  Mwd mwd(surveys_of_the_quiet(5.0), ToolfaceSpec());
  MwdReading survey;
  ToolfaceReading face;
  for (int k = 0; k <= 600; ++k)
  {
    const double time = 0.1 * k;
    mwd.update(time, k < 100 || k >= 400 ? flow : 0.0, view_of(0.01 * time, 0.0), survey, face);
    EXPECT_EQ(k < 420 ? 0u : 1u, survey.sequence) << time << ": nothing was taken before the first flow";
  }
  EXPECT_NEAR(15.0, survey.time, 1e-9);
  EXPECT_NEAR(0.15, survey.inclination, 1e-9);
}

TEST(Mwd, aCycleThatIsOverEarlierHasNoSurvey)
{
  Mwd mwd(surveys_of_the_quiet(5.0), ToolfaceSpec());
  MwdReading survey;
  ToolfaceReading face;
  for (int k = 0; k <= 600; ++k)
  {
    mwd.update(0.1 * k, k < 100 || (k >= 140 && k < 300) || k >= 360 ? flow : 0.0, view_of(0.3, 0.0), survey, face);
    EXPECT_EQ(k < 380 ? 0u : 1u, survey.sequence) << k;
  }
  EXPECT_NEAR(35.0, survey.time, 1e-9);
}

// Every 5 s while it flows, turning or not, 2 s late, in steps of 0.1 deg; none by default.
TEST(Mwd, inclinationComesBetweenSurveys)
{
  MwdSpec spec;
  spec.period = 600.0;
  spec.latency = 2.0;
  spec.inclination_resolution = 0.1 * degree;
  for (const double period : {0.0, 5.0})
  {
    spec.inclination_period = period;
    Mwd mwd(spec, ToolfaceSpec());
    MwdReading survey;
    ToolfaceReading face;
    for (int k = 0; k <= 400; ++k)
    {
      mwd.update(0.1 * k, k < 202 ? flow : 0.0, view_of(0.2 + 1e-3 * k, 0.0, 12.0), survey, face);
      const std::uint64_t wanted = k < 20 ? 0 : std::min(k - 20, 181) / 50 + 1;
      ASSERT_EQ(period > 0.0 ? wanted : 0u, mwd.inclination().sequence) << k;
    }
    if (period == 0.0) continue;
    EXPECT_NEAR(15.0, mwd.inclination().time, 1e-9);
    EXPECT_NEAR(0.35, mwd.inclination().inclination, 0.05 * degree + 1e-9);
    EXPECT_EQ(100.0, mwd.inclination().md);
  }
}

// Of a rig: the sensor sees how fast the pipe turns there.
TEST(Toolface, ofARigIsSilentWhileItTurns)
{
  Scene scene = motor_drilling_scene(5.0);
  scene.instruments.toolface = prompt_toolface();
  scene.instruments.toolface.max_speed = 5.0 * rpm;
  scene.instruments.mwd.inclination_period = 1.0;
  scene.instruments.mwd.latency = 0.0;
  Simulator rig(scene);
  drill_ahead(rig, 0.0, flow, 0.0);
  for (int k = 0; k < 1000; ++k) rig.frame(0.01);
  const std::uint64_t standing = rig.readings().toolface.sequence, inclinations = rig.readings().inclination.sequence;
  EXPECT_GT(standing, 3u);
  drill_ahead(rig, 40.0 * rpm, flow, 0.0);
  for (int k = 0; k < 500; ++k) rig.frame(0.01);
  EXPECT_LE(rig.readings().toolface.sequence, standing + 2) << "until it turns";
  EXPECT_GE(rig.readings().inclination.sequence, inclinations + 4);
}
}  // namespace test_sim_mwd
