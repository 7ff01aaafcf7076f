// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_MOTION_H
#define DRILL_RIG_SIM_SRC_SIM_MOTION_H

#include <memory>

#include "drill_rig_sim/sim/level_watch.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/solve/energy_balance.h"
#include "drill_rig_sim/solve/integrator.h"

namespace drill_rig_sim
{
/// The rig's mechanics through time: its model, the integrator, and the step longer than a frame that may be under way
/// (stride.h). Owns `mechanics`, `forces`, `levels` and `stride` of the simulator's state: all changes of them go through here.
/// One thread calls all functions. Those that are noexcept do not allocate.
class Motion
{
public:
  /// `state` holds the rig at rest and has to outlive this, as `scene` has.
  Motion(const Scene& scene, std::shared_ptr<const Model> model, SimulatorState& state);

  const std::shared_ptr<const Model>& model() const noexcept { return model_; }
  Integrator& integrator() noexcept { return *integrator_; }
  /// What the last frame shows, in whose forces also.
  const State& shown() const noexcept { return show_whole(), shown_at_ends(); }
  const RigForces& shown_forces() const noexcept { return show_whole(), shown_at_rig(); }
  /// The same for less, where a stride is under way: nodes above the measuring and steering tools are its end's, but
  /// for the top and what the slips hold.
  const State& shown_at_ends() const noexcept { return stride_.length > 0.0 ? between_ : mechanics_; }
  /// The same for less, where a stride is under way: loads along the string are of another time.
  const RigForces& shown_at_rig() const noexcept { return stride_.length > 0.0 ? forces_between_ : forces_; }
  /// The end of the last step, which may be later than what is shown by up to `longest_step`, and the forces there.
  const State& reached() const noexcept { return stride_.length > 0.0 ? stride_end_ : mechanics_; }
  const RigForces& reached_forces() const noexcept { return stride_.length > 0.0 ? end_forces_ : forces_; }
  /// Simulated time at the last frame's end [s].
  double now() const noexcept { return mechanics_.time + stride_.played; }
  /// At that time [m MD].
  double hole_depth() const noexcept;
  Level level() const noexcept { return level_of(*model_, levels_.free_length); }
  /// Nodes up to here above the bit's face would be free in a string that `longer` is: what is free all over stays so [m].
  double free_length_of(const Model& longer) const noexcept;

  /// A frame of `duration` [s]. False: it could not be computed, and the integrator says why.
  bool advance(double duration, const Setpoints& setpoints) noexcept;
  /// Brings the state to the last frame's end where a stride is under way. False: that step could not be solved.
  bool settle() noexcept;
  /// Changes the mechanics between two frames.
  template <class Change>
  void change(const Change& change) noexcept
  {
    settle();
    change(mechanics_);
  }
  /// Guides all nodes that are more than `from_bit` above the bit's face [m]. False, and nothing changed: more than is free now,
  /// or a level or integrator that has no choice.
  bool set_free_length(double from_bit) noexcept;

  /// Goes on with another string in this state, settled before. Allocates.
  void go_on_with(std::shared_ptr<const Model> model, State state, RigForces forces, double free_length);
  /// The same where the simulator's state was restored and holds these. Allocates.
  void take_model(std::shared_ptr<const Model> model);
  /// After the simulator's state was restored.
  void resume() noexcept;

  /// Opens an energy balance for the frames to come, or closes it. Allocates.
  void balance_energy(bool on);
  /// All zero without a balance.
  const EnergyAccounts& energy() const noexcept;

private:
  bool take_steps(double step, int steps, const Setpoints& setpoints) noexcept;
  bool advance_in_strides(double duration, const Setpoints& setpoints) noexcept;
  bool begin_stride(double duration) noexcept;
  bool solve_stride() noexcept;
  void show_stride() noexcept;
  void show_whole() const noexcept;
  std::size_t nodes_of_tools() const noexcept;

  const NumericsSpec& numerics_;
  State& mechanics_;
  RigForces& forces_;
  LevelMemory& levels_;
  Stride& stride_;
  std::shared_ptr<const Model> model_;
  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<EnergyBalance> balance_;
  std::unique_ptr<EnergyBalance> balance_before_;  // as it was at the start of the stride under way
  LevelWatch level_watch_;
  const bool variable_;  // steps, numerics.step 0
  bool lost_ = false;    // the state is not at the last frame's end, because settle() found no solution
  // while a stride is under way: its end, and what the last frame shows
  State stride_end_;
  RigForces end_forces_;
  mutable State between_;
  mutable RigForces forces_between_;
  mutable bool whole_ = true;  // also along the string
  std::size_t of_tools_ = 0;   // nodes, from the bit up, that every frame shows
};

}  // namespace drill_rig_sim

#endif
