// SPDX-License-Identifier: BSD-3-Clause
// Cuttings in a hole with a string: nothing without them, no rock lost, their weight in ECD and stand-pipe pressure, a bed's
// drag, energy, snapshots.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/hole_cleaning.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/solve/start.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_cuttings
{
using namespace drill_rig_sim;

namespace
{
constexpr double hole = 0.2159, friction = 0.2;
constexpr double around = 0.25 * pi * (hole * hole - pipe_outer * pipe_outer);
const Rheology thin = {1.0, 0.02, 1.0};

/// 300 m of straight hole, a bit and pipe without tool joints.
Scene inclined(double inclination, Level level = Level::axial_torsional)
{
  Scene scene = scene_in({{0.0, inclination, 0.0}, {300.0, inclination, 0.0}}, 300.0, 290.0, friction);
  scene.string = {bit_part(hole), pipe_part(0, 9.5, plain_pipe_mass, pipe_outer)};
  scene.string.front().bit->nozzle_area = 4e-4;
  scene.numerics.level = level;
  scene.numerics.element_length = 9.5;
  scene.rig.hoisting.rail_friction = 0.0;
  scene.rig.hoisting.line_damping = 0.3;
  scene.mud.axial_damping = 20.0;
  scene.mud.torsional_damping = 0.02;
  scene.rheology.emplace();
  scene.rheology->law = RheologyLaw::bingham;
  scene.rheology->plastic_viscosity = thin.consistency;
  scene.rheology->yield_point = thin.yield_stress;
  scene.cuttings.emplace();
  return scene;
}

/// The same with a smooth bend above 170 m, straight at an inclination and rough below.
Scene deviated(double inclination, Level level)
{
  Scene scene = inclined(inclination, level);
  scene.well.survey = {{0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}, {150.0, inclination, 0.0}, {300.0, inclination, 0.0}};
  scene.well.sections = {{170.0, hole, 0.0}, {300.0, hole, friction}};
  return scene;
}

Scene clean(Scene scene)
{
  scene.cuttings.reset();
  return scene;
}

/// A rig's state alone, which drills without a string's dynamics.
struct Driller
{
  RigAtRest rig;
  double rop, flow;

  Driller(const Scene& scene, double rate, double mud) : rig(build_at_rest(scene)), rop(rate), flow(mud)
  {
    rig.state.hydraulics.return_flow = flow;
  }
  void drill(int seconds)
  {
    const Eigen::Vector3d down = rig.state.well.end_direction();
    for (int k = 0; k < seconds; ++k)
    {
      rig.state.nodes.front().position += rop * down;
      rig.state.well.extend(rop * down, down);
      advance_cuttings(*rig.model, 1.0, rig.state);
    }
  }
  const CuttingsState& cuttings() const { return rig.state.cuttings; }
};

/// A bed of a height from a depth down.
void lay_bed(Simulator& rig, double height, double from = 0.0)
{
  SimulatorState state(*rig.save());
  CuttingsState& c = state.mechanics.cuttings;
  const double section = bed_section({hole, pipe_outer, 0.0}, height) * (1.0 - CuttingsSpec().porosity);
  for (std::size_t i = static_cast<std::size_t>(from / c.cell_length); i < c.bed.size(); ++i)
    c.bed[i] = std::clamp(300.0 - static_cast<double>(i) * c.cell_length, 0.0, c.cell_length) * section;
  ASSERT_TRUE(rig.restore(state));
}

double mean(Simulator& rig, double seconds, double RigSignals::*signal)
{
  double sum = 0.0;
  play(rig, seconds, [&](const Truth& truth) { sum += truth.*signal; });
  return sum * frame / seconds;
}
}  // namespace

TEST(Cuttings, changeNothingWhereThereAreNone)
{
  const Scene scene = inclined(60.0 * degree);
  Simulator with(scene), without(clean(scene));
  for (Simulator* rig : {&with, &without})
  {
    rig->command(PumpSetpoint{0.03});
    TopDriveSetpoint drive;
    drive.speed = 60.0 * rpm;
    rig->command(drive);
    play(*rig, 10.0);
  }
  EXPECT_EQ(with.truth().hook_load, without.truth().hook_load);
  EXPECT_EQ(with.truth().torque, without.truth().torque);
  EXPECT_EQ(with.truth().stand_pipe_pressure, without.truth().stand_pipe_pressure);
  EXPECT_TRUE(without.save()->mechanics.cuttings.bed.empty());
}

TEST(Cuttings, areWhatIsDrilledLessWhatReturns)
{
  for (const double inclination : {0.0, 70.0 * degree})
  {
    Driller driller(inclined(inclination), 0.01, 0.022);
    driller.drill(3000);
    const CuttingsState& c = driller.cuttings();
    EXPECT_NEAR(c.drilled, 30.0 * 0.25 * pi * hole * hole, 1e-6);
    EXPECT_GT(c.returned, 0.2 * c.drilled);
    EXPECT_NEAR(c.returned + cuttings_in_hole(c), c.drilled, 1e-9 * c.drilled);
    EXPECT_EQ(c.bed_height > 0.0, inclination > 0.0);
    EXPECT_EQ(c.narrowing > 1.0, inclination > 0.0);
  }
}

TEST(Cuttings, weighAsFeedOverTransport)
{
  const double flow = 0.03, rop = 0.006;
  Driller driller(inclined(0.0), rop, flow);
  driller.drill(1500);
  const CuttingsFluid& fluid = *driller.rig.model->cuttings();
  const double speed = flow / around;
  const double rise = speed - slip_speed(fluid, apparent_viscosity(fluid.curve, {hole, pipe_outer, 0.0}, speed));
  const double share = rop * 0.25 * pi * hole * hole / (around * rise);
  const double load = standard_gravity * (fluid.cuttings.density - fluid.density) * share * 299.0;
  EXPECT_NEAR(driller.cuttings().load, load, 0.02 * load);
  EXPECT_EQ(driller.cuttings().bed_height, 0.0);
}

TEST(Cuttings, showInTheDensityAtTheBitAndInTheStandPipe)
{
  const Scene scene = inclined(0.0);
  Simulator with(scene), without(clean(scene));
  for (Simulator* rig : {&with, &without})
  {
    rig->command(PumpSetpoint{0.025});
    play(*rig, 60.0);
  }
  SimulatorState state(*with.save());
  for (std::size_t i = 0; i < 29; ++i) state.mechanics.cuttings.suspended[i] = 0.02 * around * 10.0;
  ASSERT_TRUE(with.restore(state));
  for (Simulator* rig : {&with, &without}) play(*rig, 20.0);
  const double load = with.save()->mechanics.cuttings.load;
  EXPECT_GT(load, 0.5 * 0.02 * 1400.0 * standard_gravity * 290.0);
  EXPECT_NEAR(with.truth().stand_pipe_pressure - without.truth().stand_pipe_pressure, load, 0.02 * load);
  EXPECT_NEAR(with.truth().ecd - without.truth().ecd, load / (standard_gravity * 290.0),
              0.02 * load / (standard_gravity * 290.0));
  EXPECT_NEAR(with.truth().hook_load, without.truth().hook_load, 50.0) << "buoyancy is the mud's";
  EXPECT_NEAR(with.truth().cuttings_volume, cuttings_in_hole(with.save()->mechanics.cuttings), 1e-12);
  with.command(PumpSetpoint{0.0});
  play(with, 60.0);
  EXPECT_GE(with.save()->mechanics.hydraulics.annulus_pressure, 0.99 * with.save()->mechanics.cuttings.load) << "at rest too";
}

TEST(CuttingsBed, dragsOnPipeThatIsPulledAndTurned)
{
  const double inclination = 60.0 * degree, height = 0.08;
  for (const Level level : {Level::axial_torsional, Level::beam3d})
  {
    const Scene scene = deviated(inclination, level);
    const CuttingsFluid fluid{thin, scene.mud.density, *scene.cuttings};
    const double drag = bed_drag(fluid, pipe_outer, height) * std::sin(inclination) * (290.0 - 200.0);
    Simulator bedded(scene), sound(clean(scene));
    lay_bed(bedded, height, 200.0);
    double load[2], torque[2];
    int k = 0;
    for (Simulator* rig : {&sound, &bedded})
    {
      rig->command(WinchSetpoint{0.1, false});
      play(*rig, 10.0);
      load[k] = mean(*rig, 5.0, &RigSignals::hook_load);
      rig->command(WinchSetpoint{0.0, true});
      TopDriveSetpoint drive;
      drive.speed = 60.0 * rpm;
      rig->command(drive);
      play(*rig, 10.0);
      torque[k++] = mean(*rig, 5.0, &RigSignals::torque);
    }
    EXPECT_NEAR(load[1] - load[0], drag, 0.06 * drag);
    // pipe that turns climbs the wall, whose load is the less the larger the friction
    const double weight = standard_gravity * (plain_pipe_mass - scene.mud.density * pipe_area) * std::sin(inclination) * 90.0;
    const auto held = [](double mu) { return mu / std::sqrt(1.0 + mu * mu); };
    const double turning = 0.5 * pipe_outer * weight * (held(friction + drag / weight) - held(friction));
    EXPECT_NEAR(torque[1] - torque[0], turning, 0.03 * turning);
    EXPECT_NEAR(bedded.truth().bed_height, height, 0.02 * height);
    EXPECT_EQ(sound.truth().bed_height, 0.0);
  }
}

TEST(CuttingsBed, isEatenByFlowAndRotationAndTheDragGoes)
{
  Driller driller(inclined(70.0 * degree), 0.01, 0.018);
  driller.drill(3000);
  const double height = driller.cuttings().bed_height;
  EXPECT_GT(height, 0.02);
  EXPECT_GT(bed_friction(driller.cuttings(), 150.0), 1.0);
  driller.rop = 0.0;
  driller.rig.state.hydraulics.return_flow = 0.04;
  driller.drill(6000);
  EXPECT_LT(driller.cuttings().bed_height, 0.02 * height);
  EXPECT_NEAR(bed_friction(driller.cuttings(), 150.0), 1.0, 1e-3);
}

TEST(CuttingsBed, energyIsClosed)
{
  Simulator rig(inclined(60.0 * degree));
  lay_bed(rig, 0.08);
  play(rig, 2.0);
  rig.balance_energy(true);
  rig.command(WinchSetpoint{0.1, false});
  play(rig, 10.0);
  EXPECT_LT(rig.energy().closure(), 5e-3);
  EXPECT_LT(std::abs(rig.energy().numerical_share()), 0.05);
}

TEST(Cuttings, aSnapshotBringsThemBack)
{
  Simulator rig(inclined(60.0 * degree));
  lay_bed(rig, 0.05);
  rig.command(PumpSetpoint{0.03});
  rig.command(WinchSetpoint{-0.02, false});
  play(rig, 12.35);
  const auto saved = rig.save();
  play(rig, 6.0);
  const Truth after = rig.truth();
  const CuttingsState cuttings = rig.save()->mechanics.cuttings;
  ASSERT_TRUE(rig.restore(*saved));
  play(rig, 6.0);
  EXPECT_EQ(rig.truth().hook_load, after.hook_load);
  EXPECT_EQ(rig.truth().ecd, after.ecd);
  EXPECT_EQ(rig.save()->mechanics.cuttings.bed, cuttings.bed);
  EXPECT_EQ(rig.save()->mechanics.cuttings.suspended, cuttings.suspended);
  EXPECT_LT(rig.truth().cuttings_volume, cuttings_in_hole(saved->mechanics.cuttings) + 1e-9);
}
}  // namespace test_sim_cuttings
