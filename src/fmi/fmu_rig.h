// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_FMI_FMU_RIG_H
#define DRILL_RIG_SIM_SRC_FMI_FMU_RIG_H

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "variables.h"

namespace drill_rig_sim::fmi
{
/// A rig behind the variables of an FMU. Frames are those of the node in lockstep: the same scene, rate, seed and set points give
/// the same bits. What is refused throws std::runtime_error with one line, and nothing has changed.
class FmuRig
{
public:
  /// Reads the scene; the rig is built by begin_initialisation(). `rate`: start value of the parameter [1/s].
  /// Throws SceneError where the file cannot be used.
  FmuRig(const std::string& scene_file, double rate);
  /// The same from the files of an FMU's resources, as write_resources() has left them.
  explicit FmuRig(const std::string& resources);

  /// Builds the rig at its start, by the parameters, which may still change. `start`: simulated time of the caller [s].
  void begin_initialisation(double start);
  /// From here on parameters are fixed.
  void end_initialisation();
  /// As the constructor leaves it.
  void reset();
  /// Sets a parameter (up to end_initialisation()) or an input (any time) that has one of these types.
  void set(unsigned reference, std::initializer_list<VariableType> types, double value);
  /// A variable's value. A reading without a zero is 0, as in the messages. Outputs need begin_initialisation().
  double get(unsigned reference, std::initializer_list<VariableType> types) const;
  /// Applies the inputs that have changed and computes the frames of `duration` [s] from the caller's time `now` [s] on.
  /// Returns what the rig refused of the inputs, one line each; a refused input is tried again before the next step.
  std::vector<std::string> step(double now, double duration);

  /// All that the next step depends on.
  struct Saved
  {
    std::shared_ptr<const SimulatorState> state;
    ScenePlayer player;
    Inputs inputs;
    std::array<bool, command_kinds> changed;
    bool playing, tared;
    double time;
  };
  Saved save() const;
  void restore(const Saved& saved);

  /// As the scene starts: for the description.
  const Inputs& inputs() const noexcept { return inputs_; }
  /// The caller's time after the last step [s].
  double time() const noexcept { return time_; }

private:
  const Simulator& rig() const;
  void build();
  template <class Setpoint>
  bool apply(CommandKind kind, const Setpoint& setpoint, std::vector<std::string>& refused);
  void apply_inputs(std::vector<std::string>& refused);
  void tare(std::vector<std::string>& refused);

  Scene scene_;
  double rate_;
  Inputs inputs_;
  std::array<bool, command_kinds> changed_{};  // inputs of a kind since they were last taken
  bool playing_ = false, tared_ = false;
  bool built_by_parameters_ = false;  // those that are set
  bool fixed_ = false;                // parameters
  double time_ = 0.0;
  std::optional<Simulator> simulator_;
  ScenePlayer player_;
};

/// Writes what an FMU's library reads into the folder `resources`: the whole scene, and the start value of the rate [1/s].
/// Throws std::runtime_error with one line where it cannot be written.
void write_resources(const std::string& resources, const Scene& scene, double rate);

}  // namespace drill_rig_sim::fmi

#endif
