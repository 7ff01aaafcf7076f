// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_rig.h"

#include <algorithm>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "frame_queue.h"

namespace drill_rig_sim
{
namespace
{
const char* name_of(Level level) noexcept
{
  if (all_guided(level)) return level == Level::rigid ? "rigid" : "axial_torsional";
  return level == Level::hybrid ? "hybrid" : "beam3d";
}

int guided_nodes(const State& state) noexcept
{
  return static_cast<int>(
      std::count_if(state.nodes.begin(), state.nodes.end(), [](const NodeState& node) { return node.guided; }));
}

/// Of the nodes, rotor and line.
int coordinates_of(const State& state, int guided) noexcept
{
  const int nodes = static_cast<int>(state.nodes.size());
  const int of_rail = state.nodes.back().guided ? 0 : 4;
  return 6 * (nodes - guided) + 2 * guided - of_rail + 2;
}

/// The forces of the start are those of statics, which knows no lines and no meter.
RigForces forces_of(RigAtRest& rig, const Scene& scene)
{
  RigForces forces = std::move(rig.statics.forces);
  forces.hook_load = rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass;
  forces.meter_torque = rig.statics.top_torque;
  return forces;
}
}  // namespace

SimulatedRig::SimulatedRig(const Scene& s, std::uint64_t seed, RigAtRest&& rig)
    : scene(s),
      state(std::move(rig.state), forces_of(rig, scene)),
      motion(scene, std::move(rig.model), state),
      commands(scene, motion, state),
      pipe(scene, motion, commands, state),
      measurement(scene, motion, commands, seed, state, statistics)
{
  state.scene = scene_hash(scene);
  count_start();
}

bool SimulatedRig::compute_frame(double duration, const Setpoints& setpoints) noexcept
{
  if (!motion.advance(duration, setpoints))
  {
    failure = motion.integrator().failure();
    return false;
  }
  count_frame();
  measurement.measure(duration);
  return true;
}

void SimulatedRig::count_start() noexcept
{
  statistics.nodes = motion.model()->nodes();
  statistics.guided_nodes = guided_nodes(state.mechanics);
  statistics.coordinates = coordinates_of(state.mechanics, statistics.guided_nodes);
  statistics.level = name_of(motion.level());
  statistics.integrator = find_integrator(scene.numerics.integrator).name;
  statistics.kernel = motion.model()->kernel();
  statistics.step = scene.numerics.step;
  statistics.tight = tight_assembly(*motion.model(), state.forces);
}

void SimulatedRig::count_frame() noexcept
{
  Integrator& integrator = motion.integrator();
  const int guided = guided_nodes(motion.shown_at_ends());
  statistics.level = name_of(motion.level());
  statistics.coordinates = coordinates_of(motion.shown_at_ends(), guided);
  statistics.guided_nodes = guided;
  statistics.guided_node_frames += static_cast<std::uint64_t>(guided);
  has_begun = true;
  ++statistics.frames;
  const StepperCounters& counters = integrator.counters();
  statistics.steps = counters.steps;
  statistics.newton_iterations = counters.newton_iterations;
  statistics.convergence_failures = counters.convergence_failures;
  statistics.error_test_failures = counters.error_test_failures;
  statistics.work = integrator.work();
  if (const ReferenceReport* report = integrator.reference())
  {
    statistics.is_reference = true;
    statistics.reference = *report;
  }
  statistics.last_step = motion.shown_at_ends().memory.last_step;
  statistics.last_error_estimate = integrator.error_estimate();
}

void SimulatedRig::follow(const FrameOrder& order) noexcept
{
  if (*failure) return;
  commands.follow(order);
  state.crew = order.crew;
  pipe.follow(order.connection_elapsed);
  Profiler& profiler = motion.integrator().profiler();
  profiler.restart();
  const bool computed = compute_frame(order.duration, order.setpoints);
  if (computed && scene.numerics.judge == Judge::readings) measurement.read();
  profiler.lap(Cost::other);
  statistics.costs = profiler;
}

void SimulatedRig::end_connection()
{
  pipe.end_connection();
  string_changed();
}

void SimulatedRig::string_changed()
{
  pipe.string_changed();
  measurement.string_changed();
  statistics.nodes = motion.model()->nodes();
}

bool SimulatedRig::restore(const SimulatorState& saved)
{
  const bool another_string = saved.string.length != state.string.length || saved.string.bit_depth != state.string.bit_depth;
  const std::shared_ptr<const Model> restored = another_string ? pipe.model_of(saved.string) : motion.model();
  if (restored->mesh().nodes.size() != saved.mechanics.nodes.size()) return false;
  const PressureWaves& waves = restored->mud().waves;
  const PressureWaveState& saved_waves = saved.mechanics.mud_waves;
  if (waves.bore.cells() != saved_waves.bore_with.size() || waves.annulus.cells() != saved_waves.annulus_with.size())
    return false;
  if (!fits_temperature(*restored, saved.mechanics.temperature)) return false;
  state = saved;
  state.companions.states.clear();
  if (another_string)
  {
    motion.take_model(restored);
    string_changed();
  }
  motion.resume();
  measurement.resume();
  failure = "";
  has_begun = true;
  return true;
}

}  // namespace drill_rig_sim
