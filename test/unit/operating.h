// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_OPERATING_H
#define DRILL_RIG_SIM_TEST_OPERATING_H

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "drill_rig_sim/sim/run.h"
#include "playing.h"
#include "test_scenes.h"

// Operations of a driller, for the tests of them.
namespace operating
{
using namespace drill_rig_sim;

inline Operation operation(OperationKind kind)
{
  return default_operation(kind);
}

inline Operation rotate(double speed, double ramp)
{
  Operation o = operation(OperationKind::rotate);
  o.rotary_speed = speed;
  o.ramp = ramp;
  return o;
}

inline Operation flow(double rate)
{
  Operation o = operation(OperationKind::flow);
  o.flow = rate;
  return o;
}

/// Drills `distance` [m] with 20 kN.
inline Operation drill(double distance)
{
  Operation o = operation(OperationKind::drill);
  o.weight = 20e3;
  o.speed = 0.02;
  o.distance = distance;
  return o;
}

inline Scene scene_with(std::vector<Operation> operations, double above = 0.3)
{
  Scene scene = drilling_scene(above, 0.0);
  scene.instruments.hook_load.place =
      HookLoadPlace::block;  // the dead line's shows another share of the sheaves' friction at another speed
  scene.operations = std::move(operations);
  return scene;
}

/// Plays on until the operation of this number is under way, 0: all are over.
inline void play_up_to(int number, Simulator& rig, ScenePlayer& player)
{
  for (int k = 0; k < 100000 && (k == 0 || player.operations().status().number != number); ++k)
    ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
  ASSERT_EQ(player.operations().status().number, number);
}

}  // namespace operating

#endif
