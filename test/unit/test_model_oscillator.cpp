// SPDX-License-Identifier: BSD-3-Clause
// A tool that shakes the string: its force arrives whole at the hook, at every level, and the mud pays for its work.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_model_oscillator
{
using namespace drill_rig_sim;

namespace
{
constexpr double force = 10e3, flow = 0.02;  // [N], [m3/s]

/// 200 m in a vertical hole without friction, off bottom, with the tool in the middle of its collars.
Scene scene_of(Level level, double frequency)
{
  Scene scene = vertical_scene(300.0, 200.0);
  scene.string = {bit_part(0.2159), collar_part(4, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.string[1].oscillation_force = force;
  scene.string[1].oscillation_frequency = frequency;
  scene.rig.hoisting.rail_friction = 0.0;
  scene.numerics.level = level;
  scene.numerics.free_length = 60.0;
  scene.numerics.step = 0.002;
  return scene;
}

constexpr Level levels[] = {Level::rigid, Level::axial_torsional, Level::hybrid, Level::beam3d};
}  // namespace

TEST(Oscillator, theHookFeelsASlowForceWhole)
{
  constexpr double frequency = 0.1;  // [Hz]; the block swings at 1.5 Hz on its lines
  for (const Level level : levels)
  {
    Simulator rig(scene_of(level, frequency));
    rig.command(PumpSetpoint{flow});
    std::complex<double> swing;
    constexpr int before = 6000, frames = 4000;  // 60 s until the pressure is steady, then four periods
    for (int k = 0; k < before + frames; ++k)
    {
      ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
      const double angle = 2.0 * pi * frequency * rig.truth().time;
      if (k >= before) swing += 2.0 / frames * rig.truth().hook_load * std::polar(1.0, -angle);
    }
    EXPECT_NEAR(std::abs(swing), force, 0.02 * force) << static_cast<int>(level);
    EXPECT_NEAR(std::arg(swing), -0.5 * pi, 0.05) << "a sine; + towards the bit pulls at the hook";
  }
}

TEST(Oscillator, theMudPaysForItsWork)
{
  for (const Level level : levels)
  {
    const RigAtRest start = build_at_rest(scene_of(level, 10.0));
    State state = start.state;
    state.hydraulics.pump_flow = flow;
    Setpoints setpoints;
    setpoints.pump.flow = flow;
    Stepper stepper(start.model, find_method(IntegratorKind::bdf2));
    stepper.limits().tolerance = 1e-12;
    EnergyBalance balance(start.model);
    stepper.keep_balance(&balance);
    for (int k = 0; k < 4000; ++k) ASSERT_TRUE(stepper.advance(state, 5e-4, setpoints));
    const EnergyAccounts& e = balance.accounts();
    EXPECT_GT(e.pump, 1.0) << static_cast<int>(level);  // [J]
    EXPECT_LT(e.closure(), 2e-3) << static_cast<int>(level);
  }
}

TEST(Oscillator, itRestsWithoutFlow)
{
  Simulator rig(scene_of(Level::axial_torsional, 2.0));
  const double before = rig.truth().hook_load;
  for (int k = 0; k < 200; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
  EXPECT_NEAR(rig.truth().hook_load, before, 1.0);
}

}  // namespace test_model_oscillator
