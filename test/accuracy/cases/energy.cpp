// SPDX-License-Identifier: BSD-3-Clause
// The energy balance of scenes: closure, and numerical dissipation at the scene's step, at half and at a quarter of it.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "groups.h"
#include "in_source.h"
#include "report.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kClosure = 0.5;     // of the throughput [%]
constexpr double kNumerical = 5.0;   // [%]
constexpr double kCorrection = 0.5;  // [%]: what walls and bottom that move under touching parts may add or take
/// Below this share the numerical dissipation need not fall any more: Newton's tolerance, 1e-6 m of up to 1e7 N/m, leaves some
/// [%].
constexpr double kFloor = 1e-3;

struct EnergyCase
{
  const char* file;
  double duration;  ///< simulated [s]
};

/// Scenes at rest have no program: turned up to 60 rpm, lowered by a decimetre a second, stopped after half of the time.
std::vector<ProgramStep> manoeuvre(double duration)
{
  ProgramStep go;
  go.at = 0.0;
  go.top_drive_speed = 60.0 * rpm;
  go.block_velocity = -0.1;
  go.flow = 0.02;
  ProgramStep stop;
  stop.at = 0.5 * duration;
  stop.block_velocity = 0.0;
  return {go, stop};
}

EnergyAccounts balance_of(Scene scene, double duration, double step)
{
  if (scene.program.empty()) scene.program = manoeuvre(duration);
  scene.numerics.level = Level::beam3d;
  scene.numerics.step = step;
  Simulator simulator(scene);
  simulator.balance_energy();
  ProgramPlayer player(scene.program);
  constexpr double frame = 0.01;
  for (long k = 0; k < std::lround(duration / frame); ++k)
  {
    player.apply(simulator);
    if (simulator.frame(frame) == FrameStatus::failed) throw std::runtime_error(scene.name + ": " + simulator.failure());
  }
  return simulator.energy();
}

/// The main job from a centimetre above the bottom, at its feed: the bit touches lightly and leans on the wall while the weight
/// grows.
Scene tag_of_the_main_job()
{
  Scene scene = read_scene(in_source("config/scenes/bohai.yaml"));
  scene.name += "'s tag";
  scene.start.bit_depth = scene.well.hole_depth - 0.01;
  scene.program.erase(scene.program.begin() + 1);
  scene.program.back().at = 10.0;
  return scene;
}

void balance(Report& report, const Scene& scene, double duration)
{
  char time[32];
  std::snprintf(time, sizeof time, " in %g s", duration);
  const std::string name = "energy of " + scene.name + time + ": ";
  double before = kNumerical;
  for (int parts : {1, 2, 4})
  {
    const EnergyAccounts energy = balance_of(scene, duration, default_step / parts);
    char at[48];
    std::snprintf(at, sizeof at, " at %g ms [%%]", 1e3 * default_step / parts);
    const double numerical = 100.0 * std::abs(energy.numerical_share());
    report.add({name + "closure" + at, 100.0 * energy.closure(), 0.0, kClosure, "balance of energy", true});
    report.add({name + "numerical dissipation" + at, numerical, 0.0, before,
                parts == 1 ? "share of the throughput" : "falls with the step", true});
    report.add({name + "correction of the path" + at, 100.0 * std::abs(energy.correction) / energy.throughput(), 0.0, kCorrection,
                "share of the throughput", true});
    before = std::max(numerical, kFloor);
  }
}

void balances(Report& report, const std::vector<EnergyCase>& cases)
{
  for (const EnergyCase& c : cases) balance(report, read_scene(in_source(c.file)), c.duration);
}
}  // namespace

void small_energy_cases(Report& report)
{
  balances(report, {{"config/scenes/quick.yaml", 40.0}, {"test/scenes/drilling_noisy.yaml", 5.0}});
}

void energy_cases(Report& report)
{
  balances(report, {{"test/scenes/curved_well.yaml", 10.0},
                    {"test/scenes/inclined_straight_20deg.yaml", 10.0},
                    {"test/scenes/vertical_frictionless.yaml", 10.0},
                    {"test/benchmark/scenes/axial_wave.yaml", 10.0},
                    {"test/benchmark/scenes/torque_release.yaml", 10.0},
                    {"test/benchmark/scenes/build_trip.yaml", 10.0},
                    {"test/benchmark/scenes/tagging.yaml", 10.0},
                    {"test/benchmark/scenes/buckling.yaml", 10.0},
                    {"test/benchmark/scenes/stick_slip.yaml", 12.0},
                    {"test/benchmark/scenes/drilling.yaml", 30.0},
                    {"test/benchmark/scenes/sliding.yaml", 20.0},
                    {"config/scenes/bohai.yaml", 20.0}});
  balance(report, tag_of_the_main_job(), 40.0);
}

}  // namespace drill_rig_sim
