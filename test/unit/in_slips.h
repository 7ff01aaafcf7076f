// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_IN_SLIPS_H
#define DRILL_RIG_SIM_TEST_IN_SLIPS_H

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/crew/connection.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "test_scenes.h"

/// A rig by whose slips tests lay off and take up the string, and a crew of their own that does it.
namespace drill_rig_sim
{
constexpr double slips_frame = 0.01;  // [s]

/// 200 m of pipe with two collars in a vertical hole without friction, whose waves die within seconds; the hook load is the
/// string's and the block's.
inline Scene slips_scene(Level level, double friction = 0.0)
{
  Scene scene = vertical_scene(300.0, 200.0, friction);
  scene.string = {bit_part(0.2159), collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.numerics.level = level;
  scene.numerics.structural_damping = 1e-3;
  scene.mud.axial_damping = 100.0;
  scene.mud.torsional_damping = 1.0;
  scene.rig.hoisting.rail_friction = 0.0;
  scene.rig.hoisting.connection_time = 20.0;
  scene.start.block_height = 6.0;
  return scene;
}

/// see(rig) after each frame.
template <class See>
void play_on(Simulator& rig, double seconds, const See& see)
{
  for (int k = 0; k < std::lround(seconds / slips_frame); ++k)
  {
    ASSERT_EQ(play_frame(rig, nullptr, slips_frame), FrameStatus::running) << rig.failure();
    see(rig);
  }
}

inline void play_on(Simulator& rig, double seconds)
{
  play_on(rig, seconds, [](const Simulator&) {});
}

/// At 10 rad/s with the pump on, the block fed at `feed` [m/s].
inline void turn_and_feed(Simulator& rig, double feed)
{
  TopDriveSetpoint drive;
  drive.speed = 10.0;
  rig.command(drive);
  rig.command(PumpSetpoint{0.02});
  rig.command(WinchSetpoint{-feed, false});
}

/// What hangs above the slips [N], the block left out, and what the string's model is there.
inline double weight_above_slips(const Simulator& rig)
{
  const auto state = rig.save();
  const Model model(rig.scene(), build_mesh(rig.scene(), state->string.length));
  const int held = state->mechanics.slips.node;
  return hanging_pipe(model, held, state->mechanics.nodes[static_cast<std::size_t>(held)].position.z()).weight;
}

inline double block_weight(const Simulator& rig)
{
  return standard_gravity * rig.scene().rig.hoisting.block_mass;
}

/// Moves the block until the hook carries `load` [N] within 200 N, the slips being set, and brakes.
inline void bring_hook_to(Simulator& rig, double load)
{
  for (int k = 0; k < 6000; ++k)
  {
    const double more = load - rig.truth().hook_load;
    if (std::abs(more) < 200.0 && std::abs(rig.truth().block_velocity) < 1e-4) break;
    rig.command(WinchSetpoint{std::clamp(5e-7 * more, -0.02, 0.02), false});
    ASSERT_EQ(play_frame(rig, nullptr, slips_frame), FrameStatus::running) << rig.failure();
  }
  rig.command(WinchSetpoint{0.0, true});
  play_on(rig, 2.0);
  ASSERT_NEAR(rig.truth().hook_load, load, 1000.0);
}

/// Sets the slips and slacks off, so that only what is above them hangs on the hook.
inline void lay_into_slips(Simulator& rig)
{
  rig.command(WinchSetpoint{0.0, true});
  play_on(rig, 5.0);
  const char* refused = rig.set_slips(true);
  ASSERT_EQ(refused, nullptr) << refused;
  bring_hook_to(rig, block_weight(rig) + weight_above_slips(rig));
}

/// Picks up and pulls the slips.
inline void take_from_slips(Simulator& rig)
{
  rig.command(WinchSetpoint{0.02, false});
  for (int k = 0; k < 6000 && rig.set_slips(false); ++k)
    ASSERT_EQ(play_frame(rig, nullptr, slips_frame), FrameStatus::running) << rig.failure();
  ASSERT_FALSE(rig.truth().in_slips);
  rig.command(WinchSetpoint{0.0, true});
}

/// Begins a connection and plays until it is over; see(rig) after each frame.
template <class See>
void connect(Simulator& rig, int joints, bool remove, const See& see)
{
  const char* refused = rig.make_connection(joints, remove);
  ASSERT_EQ(refused, nullptr) << refused;
  ASSERT_EQ(rig.truth().crew, CrewTask::connecting);
  for (int k = 0; k < 60000 && rig.truth().crew == CrewTask::connecting; ++k)
  {
    ASSERT_EQ(play_frame(rig, nullptr, slips_frame), FrameStatus::running) << rig.failure();
    see(rig);
  }
  ASSERT_EQ(rig.truth().crew, CrewTask::none);
}

inline void connect(Simulator& rig, int joints, bool remove)
{
  connect(rig, joints, remove, [](const Simulator&) {});
}

}  // namespace drill_rig_sim

#endif
