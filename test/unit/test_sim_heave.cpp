// SPDX-License-Identifier: BSD-3-Clause
// A floating rig: what waves do to hook load, depths, slips and connections.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "in_slips.h"
#include "playing.h"
#include "swing.h"

namespace test_sim_heave
{
using namespace drill_rig_sim;

namespace
{
constexpr HeaveSpec waves{1.5, 10.0};
constexpr double begun = (rising_periods + 1.0) * 10.0;  // when they are all there, and what rang has rung out [s]

/// What of a signal swings with the waves once they are there, + with the floor: over whole periods.
class WithTheWaves
{
public:
  void operator()(double time, double x)
  {
    sum_ += x * std::sin(2.0 * pi * time / waves.period);
    ++count_;
  }
  double amplitude() const { return 2.0 * sum_ / count_; }

private:
  double sum_ = 0.0;
  int count_ = 0;
};

double line_stiffness(const Simulator& rig)
{
  const HoistingSpec& hoisting = rig.scene().rig.hoisting;
  return line_pull(hoisting, rig.truth().block_height, line_length_for(hoisting, rig.truth().block_height, rig.truth().hook_load))
      .stiffness;
}

/// Pipe alone, that hangs free in its hole, without swab and surge.
Scene floating(double depth, Level level)
{
  Scene scene = without_damping(vertical_scene(depth + 100.0, depth));
  scene.rig.mud_pump.pressure_coefficient = 0.0;
  scene.numerics.level = level;
  scene.rig.heave = waves;
  return scene;
}
}  // namespace

// A rod of mass m and length L that a spring K holds by the block's mass M on a floor that goes up and down by A at the rate w:
// its end is free, so its top moves as if m tan(kL)/(kL) hung there, k = w sqrt(m/(L EA)); with M_e that and M, the block moves
// by A/(1 - w^2 M_e/K), the foot by 1/cos(kL) of it, and the lines pull by w^2 M_e of it less where the floor is high, and by
// what then has left the mud more.
TEST(Heave, hookLoadSwingsByTheMassThatHangsThere)
{
  for (const Level level : {Level::beam3d, Level::axial_torsional})
  {
    const Scene scene = floating(2000.0, level);
    Simulator rig(scene);
    play(rig, begun);
    WithTheWaves hook, bit;
    Swing height, seen;
    play(rig, 2.0 * waves.period,
         [&](const Truth& m)
         {
           hook(m.time, m.hook_load);
           bit(m.time, -m.bit_depth);
           height(m.block_height);
           seen(rig.readings().bit_depth);
         });
    const double w = 2.0 * pi / waves.period, length = scene.start.bit_depth + scene.start.block_height;
    const double mass = tool_jointed_mass * length + scene.string[0].bit->mass;
    const double kl = w * length * std::sqrt(tool_jointed_mass / (206e9 * pipe_area));
    const double inert = scene.rig.hoisting.block_mass + mass * std::tan(kl) / kl;
    const double block = waves.amplitude / (1.0 - w * w * inert / line_stiffness(rig));
    const double buoyancy = standard_gravity * scene.mud.density * tool_jointed_mass / steel_density * block;
    EXPECT_NEAR(hook.amplitude(), buoyancy - w * w * inert * block, 2e-3 * w * w * inert * block) << static_cast<int>(level);
    EXPECT_NEAR(bit.amplitude(), block / std::cos(kl), 1e-3 * block);
    EXPECT_LT(height.half(), 0.01) << "the block stays where it is in the derrick";
    EXPECT_LT(seen.half(), 0.01) << "so the depth by block and tally does not see it";
  }
}

// Whatever the waves do at the moment, the zero of the weight on bit is what hangs there in the mean.
TEST(Heave, aTareTakesTheMeanOverAPeriod)
{
  Scene scene = floating(1000.0, Level::axial_torsional);
  scene.instruments.hook_load.place = HookLoadPlace::block;
  Simulator rig(scene);
  play(rig, begun + 2.5);
  Swing hook;
  play(rig, waves.period, [&](const Truth& m) { hook(m.hook_load); });
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    ASSERT_TRUE(rig.tare());
    EXPECT_DOUBLE_EQ(rig.readings().surface_wob, rig.truth().surface_wob);
    double sum = 0.0;
    int count = 0;
    play(rig, waves.period,
         [&](const Truth& m)
         {
           sum += m.surface_wob;
           ++count;
         });
    EXPECT_NEAR(sum / count, 0.0, 0.01 * hook.half()) << quarter;
    play(rig, 0.25 * waves.period);
  }
}

// A controller that lowers the block as fast as the floor comes up, by the readings: the string stands still, but for some
// millimetres by which it rings.
TEST(Heave, aWinchThatFollowsTheReadingsCompensates)
{
  Scene scene = floating(1000.0, Level::axial_torsional);
  scene.rig.heave = {0.5, 10.0};
  Simulator rig(scene);
  play(rig, begun + 2.5);  // the floor is at its highest and stands: so the winch begins without a jolt
  Swing without, with;
  double height = rig.readings().floor_height;
  play(rig, 10.0,
       [&](const Truth& m)
       {
         without(m.bit_depth);
         const Readings& r = rig.readings();
         ASSERT_NEAR(r.floor_height - height, frame * r.floor_velocity, 1e-4 * 0.5);
         height = r.floor_height;
       });
  const auto follow = [&] { rig.command(WinchSetpoint{-rig.readings().floor_velocity, false}); };
  play(rig, 10.0, [&](const Truth&) { follow(); });
  play(rig, 20.0,
       [&](const Truth& m)
       {
         with(m.bit_depth);
         follow();
       });
  EXPECT_GT(without.half(), scene.rig.heave.amplitude);
  EXPECT_LT(with.half(), 0.02 * scene.rig.heave.amplitude);
}

// Steps chosen by their error, up to 50 ms, with frames between; mud takes the start's waves within seconds, or steps stay short
// for them.
TEST(Heave, longStepsFollowTheFloor)
{
  Scene scene = floating(1000.0, Level::axial_torsional);
  scene.mud.axial_damping = 50.0;
  Simulator fine(scene);
  scene.numerics.step = 0.0;
  Simulator varied(scene);
  play(fine, begun);
  play(varied, begun);
  Swing hook;
  double off = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    fine.frame(0.01);
    varied.frame(0.01);
    hook(fine.truth().hook_load);
    off = std::max(off, std::abs(varied.truth().hook_load - fine.truth().hook_load));
  }
  EXPECT_LT(off, 0.02 * hook.half());
  EXPECT_LT(varied.statistics().steps, fine.statistics().steps / 2);
}

// A brake that slips at 90 % of the load lets block and string down while the floor carries it up, and holds them in the trough.
TEST(Heave, aBrakeThatSlipsHoldsWhatItHolds)
{
  Scene scene = floating(300.0, Level::axial_torsional);
  Simulator rig(scene);
  play(rig, begun);
  const double most = rig.truth().hook_load;
  ASSERT_EQ(rig.inject({FaultKind::brake_slip, 0.0, most, Gauge::hook_load}), nullptr);
  Swing hook;
  const double before = rig.truth().block_height;
  play(rig, 10.0, [&](const Truth& m) { hook(m.hook_load); });
  EXPECT_LT(hook.most, most * 1.001);
  EXPECT_LT(rig.truth().block_height, before - 0.001);
}

// Turning through waves with friction, inputs are what is stored and lost.
TEST(Heave, itsWorkIsBooked)
{
  Scene scene = vertical_scene(300.0, 250.0, 0.25);
  scene.rig.heave = waves;
  Simulator rig(scene);
  rig.balance_energy();
  rig.command(TopDriveSetpoint{TopDriveMode::speed, 6.0, 0.0, 0.0, 0.0});
  play(rig, 53.0);
  const EnergyAccounts& e = rig.energy();
  EXPECT_GT(std::abs(e.heave), 1e4);
  EXPECT_LT(e.closure(), 1e-3);
  EXPECT_LT(std::abs(e.numerical_share()), 0.01);
}

// Up and down in mud whose friction swabs: the string does work on the mud, and gravity none in the mean. The method holds a
// pressure for a step, and the accounts their mean, so that they close with the square of the step.
TEST(Heave, itSpendsOnTheMud)
{
  double closure[2];
  for (const double step : {0.01, 0.005})
  {
    Scene scene = vertical_scene(1100.0, 1000.0);
    scene.numerics.level = Level::axial_torsional;
    scene.numerics.step = step;
    scene.rig.heave = waves;
    Simulator rig(scene);
    play(rig, begun);
    rig.balance_energy();
    play(rig, 2.0 * waves.period);
    const EnergyAccounts& e = rig.energy();
    EXPECT_LT(e.pump, -1e3);
    EXPECT_NEAR(e.heave + e.pump, 0.0, 0.2 * e.heave) << "the rest goes into rail and steel";
    EXPECT_NEAR(e.gravity, 0.0, 0.05 * e.heave);
    closure[step == 0.01 ? 0 : 1] = e.closure();
  }
  EXPECT_LT(closure[0], 1e-3);
  EXPECT_LT(closure[1], 0.4 * closure[0]);
}

TEST(Heave, theSlipsGoWithTheFloor)
{
  Scene scene = slips_scene(Level::beam3d);
  scene.rig.heave = waves;
  Simulator rig(scene);
  rig.balance_energy();
  play_on(rig, begun + 2.0);
  ASSERT_EQ(rig.set_slips(true), nullptr);
  rig.command(WinchSetpoint{-0.02, false});
  play_on(rig, 4.0);
  rig.command(WinchSetpoint{0.0, true});
  play_on(rig, 5.0);
  const double hangs = block_weight(rig) + weight_above_slips(rig);
  Swing bit, hook;
  play_on(rig, 20.0,
          [&](const Simulator& now)
          {
            bit(now.truth().bit_depth);
            hook(now.truth().hook_load);
          });
  EXPECT_NEAR(bit.half(), waves.amplitude, 0.02);
  EXPECT_LT(hook.most, hangs + 1e4) << "the slips bear the string";
  EXPECT_LT(rig.energy().closure(), 1e-3);
}

TEST(Heave, aStandIsAddedAmongWaves)
{
  Scene scene = slips_scene(Level::beam3d);
  scene.rig.heave = waves;
  Simulator rig(scene);
  const double depth = rig.readings().bit_depth, built = rig.save()->string.length;
  play_on(rig, begun);
  lay_into_slips(rig);
  connect(rig, 0, false);
  EXPECT_NEAR(rig.save()->string.length, built + 3 * 9.5, 1e-9);
  Swing hook;
  play_on(rig, 10.0, [&](const Simulator& now) { hook(now.truth().hook_load); });
  const double above = rig.scene().rig.hoisting.block_mass + weight_above_slips(rig) / standard_gravity;
  EXPECT_LT(hook.half(), waves.amplitude * std::pow(2.0 * pi / waves.period, 2) * above)
      << "what is above the slips goes with the floor";
  take_from_slips(rig);
  play_on(rig, 10.0);
  EXPECT_NEAR(rig.readings().bit_depth, depth, 0.3);
}

// The bit stands on a bottom that does not heave: lines, string, too lightly loaded to buckle, and the bit's contact are springs
// one after the other, pulled by the floor.
TEST(Heave, onBottomTheStringIsPulled)
{
  Scene scene = without_damping(vertical_scene(1000.0, 1000.0));
  scene.formation[0].drillability = 0.0;
  scene.start.weight_on_bit = 6e3;
  scene.rig.heave = {0.003, waves.period};
  Simulator rig(scene);
  play(rig, begun);
  WithTheWaves hook, weight;
  play(rig, 2.0 * waves.period,
       [&](const Truth& m)
       {
         hook(m.time, m.hook_load);
         weight(m.time, m.wob);
       });
  const ContactLaw& bottom = scene.string[0].bit->bottom;
  const double contact = bottom.exponent * std::pow(bottom.stiffness, 1.0 / bottom.exponent) *
                         std::pow(scene.start.weight_on_bit, 1.0 - 1.0 / bottom.exponent);
  const double expected = scene.rig.heave.amplitude / (1020.0 / (206e9 * pipe_area) + 1.0 / line_stiffness(rig) + 1.0 / contact);
  const double w = 2.0 * pi / waves.period, moved = scene.rig.hoisting.block_mass + 0.5 * 1020.0 * tool_jointed_mass;
  EXPECT_NEAR(hook.amplitude(), expected - w * w * scene.rig.heave.amplitude * moved, 0.01 * expected);
  EXPECT_NEAR(weight.amplitude(), -expected, 0.01 * expected);
}
}  // namespace test_sim_heave
