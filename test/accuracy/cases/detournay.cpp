// SPDX-License-Identifier: BSD-3-Clause
// Steady drilling with a drag bit by the law of Detournay and Defourny (1992), by hand: the winch sets the rate of penetration,
// the top drive the bit's speed, and with them the depth of cut per revolution d = 2 pi ROP/N. Then, a the bit's radius,
//   torque  T = epsilon a^2 d/2 + mu_gamma a W_f/2,    weight  W = W_f + zeta epsilon a d,
// the flats bearing fully. The scene gives the weight by its rock law ROP = K (W - F_0) N; zeta epsilon is K = 1/(2 pi zeta
// epsilon a).
#include <stdexcept>
#include <string>

#include "drill_rig_sim/sim/simulator.h"
#include "groups.h"
#include "report.h"
#include "test_scenes.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kSpecificEnergy = 60e6;  // epsilon [J/m3]
constexpr double kZeta = 0.7;
constexpr double kFlatFriction = 0.6;   // mu gamma
constexpr double kFlatWeight = 6000.0;  // W_f [N]
constexpr double kDiameter = 0.2159;

/// The bit's torque law has no speed weakening, so the string's torsional swing dies; hole without friction.
Scene drag_bit_scene()
{
  Scene scene = drilling_scene(0.005, 0.0);
  BitTorqueSpec& law = scene.string[0].bit->torque;
  law.model = BitTorqueModel::detournay;
  law.cutting_energy = kSpecificEnergy;
  law.wear_friction = kFlatFriction;
  law.wear_weight = kFlatWeight;
  FormationLayer& rock = scene.formation[0];
  rock.drillability = 1.0 / (2.0 * pi * kZeta * kSpecificEnergy * 0.5 * kDiameter);
  rock.threshold = kFlatWeight;
  return scene;
}

struct Drilled
{
  double depth_of_cut = 0.0;  // [m/rev]
  double weight = 0.0;        // [N]
  double torque = 0.0;        // [N m]
};

/// Means over ten seconds after eighty of run-in: the block bobs on its lines.
Drilled drill(double feed, double speed)
{
  Simulator rig(drag_bit_scene());
  TopDriveSetpoint drive;
  drive.speed = speed;
  rig.command(drive);
  rig.command(WinchSetpoint{-feed, false});
  const double frame = 0.01;
  const Truth& m = rig.truth();
  auto advance = [&]
  {
    if (rig.frame(frame) != FrameStatus::running) throw std::runtime_error(rig.failure());
  };
  for (int k = 0; k < 8000; ++k) advance();
  const double start = m.hole_depth, turned = m.top_drive_angle;
  Drilled out;
  const int frames = 1000;
  for (int k = 0; k < frames; ++k)
  {
    advance();
    out.weight += m.wob / frames;
    out.torque += m.bit_torque / frames;
  }
  out.depth_of_cut = (m.hole_depth - start) / (m.top_drive_angle - turned) * 2.0 * pi;
  return out;
}
}  // namespace

void detournay_cases(Report& report)
{
  const double a = 0.5 * kDiameter;
  struct Row
  {
    const char* name;
    double feed, speed;
  };
  for (const Row& row : {Row{"36 m/h at 120 rpm", 0.010, 120.0 * rpm}, Row{"18 m/h at 60 rpm", 0.005, 60.0 * rpm},
                         Row{"36 m/h at 60 rpm", 0.010, 60.0 * rpm}})
  {
    const double cut = 2.0 * pi * row.feed / row.speed;
    const Drilled ours = drill(row.feed, row.speed);
    const std::string name = std::string("Detournay ") + row.name;
    // 0.05 %: the feed wanders by the stretch of the lines as the string's weight in mud changes, 200 N/m over 1e7 N/m
    report.add({name + ": depth of cut [mm]", 1e3 * ours.depth_of_cut, 1e3 * cut, 5e-4, "2 pi ROP/N"});
    report.add({name + ": weight on bit [N]", ours.weight, kFlatWeight + kZeta * kSpecificEnergy * a * cut, 5e-4,
                "Detournay and Defourny 1992: W_f + zeta epsilon a d"});
    report.add({name + ": torque on bit [N m]", ours.torque, 0.5 * a * (kSpecificEnergy * a * cut + kFlatFriction * kFlatWeight),
                5e-4, "Detournay and Defourny 1992: epsilon a^2 d/2 + mu gamma a W_f/2"});
  }
}

}  // namespace drill_rig_sim
