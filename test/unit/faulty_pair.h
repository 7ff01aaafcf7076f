// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FAULTY_PAIR_H
#define DRILL_RIG_SIM_TEST_FAULTY_PAIR_H

#include "drill_rig_sim/sim/faults.h"
#include "playing.h"
#include "test_scenes.h"

/// Rigs with faults beside sound ones.
namespace drill_rig_sim
{
/// Of a faultless rig and of one with the fault, after the same commands.
struct Pair
{
  Simulator sound, faulty;

  explicit Pair(const Scene& scene) : sound(scene), faulty(scene) {}
  template <class Command>
  void command(const Command& c)
  {
    sound.command(c);
    faulty.command(c);
  }
  void play_both(double seconds)
  {
    play(sound, seconds);
    play(faulty, seconds);
  }
  /// The mean of a signal over two seconds of the faulty rig less the sound one's.
  double difference(double RigSignals::*signal)
  {
    double sum = 0.0;
    int count = 0;
    for (Simulator* rig : {&sound, &faulty})
      play(*rig, 2.0,
           [&](const Truth& truth)
           {
             sum += (rig == &faulty ? 1.0 : -1.0) * truth.*signal;
             ++count;
           });
    return 2.0 * sum / count;
  }
};

inline Fault at(FaultKind kind, double depth, double magnitude = 0.0)
{
  return {kind, depth, magnitude};
}

/// In a vertical hole without friction, off bottom.
inline Scene hanging()
{
  return vertical_scene(150.0, 140.0);
}

inline TopDriveSetpoint turning(double speed)
{
  TopDriveSetpoint drive;
  drive.speed = speed;
  return drive;
}

}  // namespace drill_rig_sim

#endif
