// SPDX-License-Identifier: BSD-3-Clause
// What the pump does to the rig: pressures in hook load, stretch and steel, ECD, relief valve, energy, snapshots, the reference.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_mud
{
using namespace drill_rig_sim;

namespace
{
constexpr double hole = 0.2159;
constexpr double bore_area = pi / 4.0 * pipe_inner * pipe_inner, outer_area = pi / 4.0 * pipe_outer * pipe_outer;

/// Pipe that hangs 5 m off the bottom of 300 m, with little friction of mud in it: 18 MPa at 0.03 m3/s, most of it at the bit.
/// What swings dies soon.
Scene hanging(double hole_depth = 300.0)
{
  Scene scene = vertical_scene(hole_depth, 295.0);
  for (HoleSection& section : scene.well.sections) section.diameter = hole;
  scene.rig.mud_pump.pressure_coefficient = 2e10;
  scene.rig.hoisting.rail_friction = 0.0;  // it would hold some of the load
  scene.rig.hoisting.line_damping = 0.3;
  scene.mud.axial_damping = 20.0;
  return scene;
}

/// In a narrow hole, with slim tool joints and a bit that fits.
Scene narrow(double diameter)
{
  Scene scene = hanging(320.0);
  scene.string = {bit_part(diameter - 0.002), pipe_part(0, 9.5, tool_jointed_mass, 0.13)};
  for (HoleSection& section : scene.well.sections) section.diameter = diameter;
  return scene;
}

double string_length(const Truth& t)
{
  return t.block_height - t.bit_position.z();
}
/// On elements that the reference can afford.
Scene coarse(Scene scene, IntegratorKind integrator)
{
  scene.numerics.integrator = integrator;
  scene.numerics.element_length = 30.0;
  return scene;
}

}  // namespace

// The bore's pressure pulls the steel against the swivel and leaves the hook alone; the mud in the annulus lifts p_a pi/4 D D_h.
TEST(MudOnString, hookFeelsTheAnnulusAlone)
{
  const Scene scene = hanging();
  Simulator rig(scene);
  play(rig, 20.0);
  const double before = rig.truth().hook_load;
  rig.command(PumpSetpoint{0.03});
  play(rig, 60.0);
  const HydraulicState mud = rig.save()->mechanics.hydraulics;
  ASSERT_NEAR(mud.stand_pipe_pressure, 18e6, 1e3);
  ASSERT_GT(mud.annulus_pressure, 2e4);
  const double lift = mud.annulus_pressure * 0.25 * pi * pipe_outer * hole;
  EXPECT_NEAR(before - rig.truth().hook_load, lift, 0.01 * lift);
  StringProfile profile;
  rig.profile(profile);
  EXPECT_NEAR(profile.true_axial_force.back() - profile.tension.back(), 18e6 * bore_area, 0.01 * 18e6 * bore_area)
      << "the swivel takes it";
}

// e = ((1 - 2 nu)(p_i A_i - p_o A_o) - lift above)/(E A): p_i falls by the bore's friction, p_o and the lift grow in a straight
// line to the bit.
TEST(MudOnString, pressureStretchesTheString)
{
  const Scene scene = hanging();
  Simulator rig(scene);
  play(rig, 20.0);
  const double before = string_length(rig.truth());
  rig.command(PumpSetpoint{0.03});
  play(rig, 60.0);
  const HydraulicState mud = rig.save()->mechanics.hydraulics;
  const double ea = 206e9 * pipe_area, in_hole = 295.0, all = in_hole + scene.start.block_height;
  const double friction =
      bore_gradient(scene.mud.density, scene.rig.mud_pump.max_flow, pipe_inner) * 0.25 * all;  // Q^2 from max_flow down
  const double inside = 0.4 * (18e6 - 0.5 * friction) * bore_area * all,
               outside = 0.4 * 0.5 * mud.annulus_pressure * outer_area * in_hole;
  const double lift = mud.annulus_pressure * 0.25 * pi * pipe_outer * hole;
  // the lift takes from the tension everywhere above where it acts: of the part in the hole half of it, above the table all
  const double lifted = lift * (0.5 * in_hole + scene.start.block_height);
  const double expected = (inside - outside - lifted) / ea;
  EXPECT_GT(expected, 0.02);
  EXPECT_NEAR(string_length(rig.truth()) - before, expected, 0.01 * expected);
}

// With the block held a string on bottom that grows puts weight on the bit, and takes it off the hook: all but the annulus's
// lift.
TEST(MudOnString, pumpPutsWeightOnTheBit)
{
  Scene scene = hanging();
  scene.start.bit_depth = 300.0;
  scene.start.weight_on_bit = 2e4;
  Simulator rig(scene);
  play(rig, 20.0);
  const Truth before = rig.truth();
  rig.command(PumpSetpoint{0.03});
  play(rig, 60.0);
  const double lift = rig.save()->mechanics.hydraulics.annulus_pressure * 0.25 * pi * pipe_outer * hole;
  const double gained = rig.truth().wob - before.wob;
  EXPECT_GT(gained, 3e3);
  EXPECT_NEAR(before.hook_load - rig.truth().hook_load, gained + lift, 0.01 * gained);
}

TEST(MudOnString, ecdIsThatOfTheAnnulus)
{
  const Scene scene = hanging();
  Simulator rig(scene);
  EXPECT_EQ(rig.truth().ecd, scene.mud.density);
  rig.command(PumpSetpoint{0.03});
  play(rig, 60.0);
  const double loss = 295.0 * annulus_gradient(scene.mud.density, 0.03, hole, pipe_outer);
  EXPECT_NEAR(rig.truth().ecd - scene.mud.density, loss / (standard_gravity * 295.0), 0.01 * loss / (standard_gravity * 295.0));
  EXPECT_EQ(rig.readings().ecd, rig.truth().ecd);
}

// Run in at v the mud's pressure at the bit rises by that of a flow v (A_o + K (A_h - A_o)), pulled out it falls; the hook feels
// it as lift.
TEST(MudDisplaced, runInItSurgesPulledOutItSwabs)
{
  const double around = 0.25 * pi * hole * hole - outer_area;
  for (const double up : {-0.3, 0.3})
  {
    const Scene scene = hanging(320.0);
    Simulator rig(scene);
    play(rig, 10.0);
    rig.command(WinchSetpoint{up, false});
    play(rig, 12.0);
    const double v = -up, flow = std::abs(v) * (outer_area + clinging_constant(pipe_outer / hole) * around);
    const double expected = (v > 0.0 ? 1.0 : -1.0) * 295.0 * annulus_gradient(scene.mud.density, flow, hole, pipe_outer);
    const double p = rig.save()->mechanics.hydraulics.annulus_pressure;
    EXPECT_NEAR(p, expected, 0.03 * std::abs(expected));
    const double depth = -rig.truth().bit_position.z();
    EXPECT_NEAR(rig.truth().ecd - scene.mud.density, p / (standard_gravity * depth), 1e-9);
    EXPECT_EQ(rig.truth().bit_flow, 0.0);
  }
}

TEST(MudDisplaced, hookFeelsTheSurge)
{
  Scene scene = narrow(0.145);
  scene.rig.hoisting.sheave_efficiency = 1.0;
  const auto pulled = [&](double coefficient)
  {
    Scene one = scene;
    one.rig.mud_pump.pressure_coefficient = coefficient;
    Simulator rig(one);
    play(rig, 10.0);
    rig.command(WinchSetpoint{-0.5, false});
    play(rig, 15.0);
    return std::make_pair(rig.truth().hook_load, rig.save()->mechanics.hydraulics.annulus_pressure);
  };
  const auto with = pulled(2e10), without = pulled(0.0);
  const double lift = with.second * 0.25 * pi * pipe_outer * 0.145;
  EXPECT_GT(lift, 1e3);
  EXPECT_EQ(without.second, 0.0);
  EXPECT_NEAR(without.first - with.first, lift, 0.05 * lift);
}

// Ramp 0.01 m3/s2, then the mud's own lag.
TEST(MudPumped, pressureFollowsThePump)
{
  Scene scene = hanging();
  scene.rig.mud_pump.relief_pressure = 15e6;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  play(rig, 1.0);
  EXPECT_NEAR(rig.truth().flow, 0.01, 1e-12);
  EXPECT_GT(rig.truth().bit_flow, 0.0);
  EXPECT_LT(rig.truth().bit_flow, 0.01);
  EXPECT_FALSE(rig.truth().relief_valve_open);
  play(rig, 30.0);
  EXPECT_EQ(rig.truth().flow, 0.03);
  EXPECT_TRUE(rig.truth().relief_valve_open);
  EXPECT_TRUE(rig.readings().relief_valve_open) << "the rig's own";
  EXPECT_EQ(rig.truth().stand_pipe_pressure, 15e6);
  EXPECT_NEAR(rig.truth().bit_flow, 0.03 * std::sqrt(15.0 / 18.0), 1e-4);
  rig.command(PumpSetpoint{0.0});
  play(rig, 30.0);
  EXPECT_EQ(rig.truth().bit_flow, 0.0);
  EXPECT_LT(rig.truth().stand_pipe_pressure, 1e3);
  EXPECT_FALSE(rig.truth().relief_valve_open);
}

TEST(MudPumped, aSnapshotInTheRampGoesOnTheSame)
{
  Simulator rig(motor_drilling_scene(0.5));
  rig.command(PumpSetpoint{0.03});
  play(rig, 1.5);
  const auto state = rig.save();
  play(rig, 3.0);
  const double pressure = rig.truth().stand_pipe_pressure, hook_load = rig.truth().hook_load;
  ASSERT_TRUE(rig.restore(*state));
  play(rig, 3.0);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, pressure);
  EXPECT_EQ(rig.truth().hook_load, hook_load);
}

// What the pressure does as it stretches the string is the pump's, and nothing is missing. Elastic energy is that of the
// effective tension N: a free stretch that grows by e takes N e L from it, and the weight that goes down brings it back.
TEST(MudPumped, energyIsClosed)
{
  Scene scene = hanging();
  Simulator rig(scene);
  rig.balance_energy(true);
  rig.command(PumpSetpoint{0.03});
  play(rig, 10.0);
  const EnergyAccounts& e = rig.energy();
  EXPECT_LT(e.pump, -100.0);
  EXPECT_GT(e.gravity, 100.0);
  EXPECT_LT(e.closure(), 5e-3);
  EXPECT_LT(std::abs(e.numerical_share()), 0.05);
}

TEST(MudDisplaced, energyIsClosed)
{
  Simulator rig(narrow(0.145));
  play(rig, 5.0);
  rig.balance_energy(true);
  rig.command(WinchSetpoint{0.5, false});
  play(rig, 10.0);
  EXPECT_LT(rig.save()->mechanics.hydraulics.annulus_pressure, -1e4);
  EXPECT_LT(rig.energy().closure(), 5e-3);
  EXPECT_LT(std::abs(rig.energy().numerical_share()), 0.05);
}

TEST(MudDisplaced, referenceAgrees)
{
  Simulator reference(coarse(narrow(0.145), IntegratorKind::ida)), rig(coarse(narrow(0.145), IntegratorKind::bdf2));
  for (Simulator* r : {&reference, &rig})
  {
    r->command(WinchSetpoint{0.5, false});
    play(*r, 6.0);
  }
  EXPECT_NEAR(rig.truth().hook_load, reference.truth().hook_load, 300.0);
  const double p = reference.save()->mechanics.hydraulics.annulus_pressure;
  EXPECT_LT(p, -1e4);
  EXPECT_NEAR(rig.save()->mechanics.hydraulics.annulus_pressure, p, 0.02 * std::abs(p));
}

// The reference is handed the same flow.
TEST(MudPumped, referenceAgrees)
{
  Simulator reference(coarse(hanging(), IntegratorKind::ida)), rig(coarse(hanging(), IntegratorKind::bdf2));
  for (Simulator* r : {&reference, &rig})
  {
    r->command(PumpSetpoint{0.03});
    play(*r, 4.0);
  }
  EXPECT_NEAR(rig.truth().hook_load, reference.truth().hook_load, 300.0);
  EXPECT_NEAR(string_length(rig.truth()), string_length(reference.truth()), 5e-4);
  EXPECT_NEAR(rig.truth().stand_pipe_pressure, reference.truth().stand_pipe_pressure, 100.0)
      << "but for what the string displaces as it stretches";
}
namespace
{
const Rheology thick = {6.0, 0.025, 1.0};

/// hanging() with a Bingham mud.
Scene with_rheology(double hole_depth)
{
  Scene scene = hanging(hole_depth);
  scene.rheology.emplace();
  scene.rheology->plastic_viscosity = thick.consistency;
  scene.rheology->yield_point = thick.yield_stress;
  scene.string.front().bit->nozzle_area = 2e-4;
  return scene;
}

double annulus_loss(const Scene& scene, double speed)
{
  return 295.0 * pressure_gradient(thick, scene.mud.density, {hole, pipe_outer, 0.0}, speed);
}

/// Means over 20 s, in which the pump's strokes do not show [Pa].
struct PumpedMeans
{
  double annulus = 0.0, stand_pipe = 0.0;
};
PumpedMeans pumped_means(Simulator& rig)
{
  constexpr int frames = 2000;
  PumpedMeans out;
  for (int i = 0; i < frames; ++i)
  {
    play(rig, 0.01);
    out.annulus += (rig.truth().ecd - rig.scene().mud.density) * standard_gravity * 295.0 / frames;
    out.stand_pipe += rig.truth().stand_pipe_pressure / frames;
  }
  return out;
}
}  // namespace

TEST(MudRheology, pumpedItHasTheLawsPressures)
{
  const Scene scene = with_rheology(300.0);
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  play(rig, 90.0);
  const double around = 0.25 * pi * hole * hole - outer_area, annulus = annulus_loss(scene, 0.03 / around);
  const double bore =
      (295.0 + scene.start.block_height) * pressure_gradient(thick, scene.mud.density, {pipe_inner, 0.0, 0.0}, 0.03 / bore_area);
  const double all = annulus + bore + nozzle_loss(scene.mud.density, 0.03, 2e-4);
  EXPECT_NEAR(rig.truth().stand_pipe_pressure, all, 0.005 * all);
  EXPECT_NEAR(rig.truth().ecd - scene.mud.density, annulus / (standard_gravity * 295.0),
              0.02 * annulus / (standard_gravity * 295.0));
  EXPECT_NEAR(rig.truth().bit_flow, 0.03, 1e-5);
}

// The annulus's loss is that without rotation times the factor, with two volumes and with waves.
TEST(MudRheology, rotationChangesTheAnnulussLoss)
{
  for (const bool waves : {false, true})
  {
    Scene scene = with_rheology(300.0);
    scene.rheology->rotation_factor = 1.2;
    if (waves) scene.pressure_waves.emplace();
    Simulator rig(scene);
    rig.command(PumpSetpoint{0.03});
    play(rig, 60.0);
    const PumpedMeans still = pumped_means(rig);
    rig.command(TopDriveSetpoint{TopDriveMode::speed, -60.0 * rpm});
    play(rig, 60.0);
    const PumpedMeans turning = pumped_means(rig);
    EXPECT_NEAR(turning.annulus, 1.1 * still.annulus, 0.005 * still.annulus) << waves;
    EXPECT_NEAR(turning.stand_pipe - still.stand_pipe, 0.1 * still.annulus, 0.005 * still.annulus) << waves;
  }
}

TEST(MudRheology, slowRunningSurgesByItsYieldPoint)
{
  for (const double up : {-0.1, 0.1})
  {
    const Scene scene = with_rheology(320.0);
    Simulator rig(scene);
    play(rig, 10.0);
    rig.command(WinchSetpoint{up, false});
    play(rig, 20.0);
    const double around = 0.25 * pi * hole * hole - outer_area;
    const double expected =
        (up < 0.0 ? 1.0 : -1.0) * annulus_loss(scene, 0.1 * (outer_area / around + clinging(pipe_outer / hole, 0.0)));
    EXPECT_NEAR(rig.save()->mechanics.hydraulics.annulus_pressure, expected, 0.05 * std::abs(expected));
  }
}

TEST(MudRheology, energyIsClosed)
{
  Simulator rig(with_rheology(300.0));
  rig.balance_energy(true);
  rig.command(PumpSetpoint{0.03});
  play(rig, 10.0);
  EXPECT_LT(rig.energy().closure(), 5e-3);
  EXPECT_LT(std::abs(rig.energy().numerical_share()), 0.05);
}
}  // namespace test_sim_mud
