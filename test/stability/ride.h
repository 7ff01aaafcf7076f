// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STABILITY_RIDE_H
#define DRILL_RIG_SIM_STABILITY_RIDE_H

#include <memory>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "verdict.h"

namespace drill_rig_sim
{
/// Which method and element a case is run with.
struct Choice
{
  std::string method;
  std::string element;
};

/// The integrator that chooses its own steps.
constexpr const char* reference_method = "ida";

/// Every stepper that this version knows, the default first, each with the default element; the default alone if `fast`.
std::vector<Choice> methods(bool fast);
/// Every element that this version knows, the default first, each with the default method.
std::vector<Choice> all_elements();
Choice default_choice();
bool is_default(const Choice& choice);

/// Reads test/stability/scenes/NAME.yaml with settings over it, for a choice. The step [s] may lie beyond the reader's
/// range; 0 leaves the scene's.
/// Throws SceneError.
Scene load_scene(const std::string& name, std::vector<std::string> settings, const Choice& choice, double step);

/// What a ride shows at an instant.
struct Sample
{
  double time = 0.0;
  double speed = 0.0;                             ///< root mean square of the nodes' velocities [m/s]
  double hook_load = 0.0;                         ///< [N]
  double string_load = 0.0;                       ///< hook load without block and top drive [N]
  double torque = 0.0;                            ///< [N m]
  double bit_turned = 0.0;                        ///< by the string [rad]
  double wob = 0.0;                               ///< [N]
  Eigen::Vector3d bit = Eigen::Vector3d::Zero();  ///< [m]
};

/// One simulation of a scene, its program played, watched for numbers that are not finite and for its work, which is counted: a
/// limit of time would be another one on a busy machine.
class Ride
{
public:
  enum class Ending
  {
    going,
    refused,     ///< could not be built
    failed,      ///< a frame failed
    not_finite,  ///< the simulator went on with numbers that are not finite
    too_slow
  };

  /// The limit is one of node_evaluations().
  explicit Ride(const Scene& scene, double limit = 80e6);
  Ride(Ride&&) = default;

  /// Advances by `seconds` in frames of `frame` (at least a step). False once it has ended.
  bool go(double seconds, double frame);
  bool going() const { return ending_ == Ending::going; }
  Ending ending() const { return ending_; }
  const std::string& message() const { return message_; }
  Simulator& simulator() { return *simulator_; }
  const Simulator& simulator() const { return *simulator_; }
  const Truth& now() const { return simulator_->truth(); }
  /// Throws the string below the table sideways at `speed` [m/s], across the hole and up from its low side.
  void throw_sideways(double speed);
  /// Costs a copy of the state.
  Sample sample() const;
  /// Steps that had to be subdivided; the reference chooses its own steps, and to reject some of those is no sign of trouble.
  std::uint64_t rejected() const;
  std::uint64_t steps() const { return simulator_ ? simulator_->statistics().steps : 0; }
  /// The work so far: residuals, tangents and linear solves, times nodes. Each is some 2000 to 3000 instructions with the default
  /// element; a quiet machine does some four millions a second. The reference's count four times.
  double node_evaluations() const;
  /// The verdict on a ride that has ended early, or passes/passes by halving while it goes.
  Verdict verdict() const;

private:
  void end(Ending ending, const std::string& message);

  double limit_;
  Ending ending_ = Ending::going;
  std::string message_;
  std::unique_ptr<Simulator> simulator_;
  std::unique_ptr<ProgramPlayer> player_;
};

/// A row of a method's case; of the default it is promised that it passes.
Row row_of(const char* group, const std::string& name, const Choice& choice, const char* unit);
/// Ends a row whose figures are told: the run's verdict, or `wrong` if it passed and is not `right`; the run's message after the
/// text.
void conclude(Row& row, Verdict verdict, bool right, const std::string& message);

/// The largest step of the ladder, at most `wish`, with which the first half second of the scene needs no halving; the ladder's
/// shortest if there is none. The default's is `wish`, halved or not: that is what is promised.
double workable_step(const std::string& name, const Choice& choice, double wish);

/// Steps from 0.1 s down to 1e-5 s, three a decade: whole fractions of 0.1 s.
const std::vector<double>& step_ladder();

/// printf into a string.
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace drill_rig_sim

#endif
