// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_STEP_CONTROL_H
#define DRILL_RIG_SIM_SOLVE_STEP_CONTROL_H

#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/model/workspace.h"
#include "drill_rig_sim/solve/wave_life.h"

namespace drill_rig_sim
{
/// Shortest and longest step that the control asks for [s].
constexpr double shortest_step = 1e-4, longest_step = 0.05;
/// A frame holds a whole number of steps, or a step a whole number of frames. To fit, a step up to 1.25 times the wanted one is
/// tried.
constexpr double may_be_longer = 0.2;

/// Chooses the length of the steps by what they do to the outputs (numerics.step 0).
///
/// The local error of a step is an error of the node positions. Divided by the step it is an error v of velocity, which sends a
/// wave with the wrong force Z v along the string, Z = sqrt(EA m') along it and sqrt(GJ i') about it (m', i': mass and inertia
/// per length), the string's wave impedances. That force is compared with the range of its output so far:
///   e = P rms of  Z |v| / S,   S = max(range, a tenth of the level, what an instrument resolves; a tenth of that over the
///   tolerance)
/// The mean is the root mean square along the string, because the wave of a single node that slips or sticks is short. P is
/// the peak of a front over that mean: 2.8 along the string, 3.3 about it. S is of hook load for motions along the string, of
/// torque for those about it; at the bit itself also of its weight, where P is 6, and speed, where P is 1. No error matters
/// that is below a tenth of what an instrument resolves. Where the bit turns, the speed of a wave about the string also counts
/// over the range of the bit's speed, for that is what the wave becomes below. Of a wave of frequency w that makes up the
/// whole range, BDF2 makes e = (2/9) (w h)^2 in every step, which falls with h^2, and is wrong by w T e after a time T: so e
/// may be the tolerance over w T, w the lowest frequency of the string fixed at its top, and T the life of waves now
/// (WaveLife::now()); a twentieth of the tolerance at most. But a string's waves have fronts, where something lets go or takes
/// hold, and their error falls only with h^1.2 (measured: a vertical kilometre that begins to turn, 1.3 % at 20 ms, 0.55 at
/// 10, 0.23 at 5, by TR-BDF2 0.60, 0.25, 0.09): so what is allowed, h^2, goes with the tolerance to the power of 3/2, as above
/// at 0.063. Three quarters of that are allowed along the string, by 40 random scenes (seed 8812345): with twice as much hoists
/// and their stops are further off, and four more right scenes are warned of, for 3 % less work. P of the weight is by random
/// scenes too: a bit that just touches bounces, and the errors of its impacts add up (P of 1: up to 5 % of the weight's range in
/// four of 40 scenes, of 6: in two, 2.5 % at most, for 4 % more work). Where the scene needs nothing but torque and bit speed,
/// motions along the string are allowed ten times as much; where nothing but hook load, weight and pressure, those about it. In
/// addition, no position error in a step may exceed `largest_place_error` times the tolerance, whatever the outputs: this is for
/// impacts and whirl.
class StepControl
{
public:
  explicit StepControl(const Model& model);

  /// By how much a step of `step` [s] from `start` could be longer (below 1: should be shorter) to be as wrong as allowed.
  /// `error`: its local error, 6 per node as increments are [m, rad]; `work`: at its end.
  double stretch(const State& start, const Workspace& work, const double* error, double step) const noexcept;
  /// Longest step [s] after `state`: a bent motor that turns at W shakes the string with waves of up to 3 W, of which BDF2 takes
  /// (3 W h)^4/(4 h) a second, a bit that cuts blade by blade needs a hundred steps from blade to blade, and where the flow that
  /// turns a motor is not yet the pump's, the mud's pressures, of whose error, which goes with the step, the nodes show nothing,
  /// want 2.5 ms at 1 %.
  double longest(const State& state) const noexcept;
  /// Takes the outputs at a step's end into account.
  static void note(const RigForces& forces, StepMemory& memory) noexcept;

private:
  /// A number each for motions along the string and about it.
  struct Waves
  {
    double along = 0.0, about = 0.0;
  };
  Waves allowed(const State& state) const noexcept;
  Waves output_error(const State& start, const Workspace& work, const double* error) const noexcept;

  double tolerance_;
  double resolved_;  // over what instruments resolve, the least scale of an output
  Waves allowed_;    // e, over the share of the tolerance that goes by the waves' life [-]
  Waves slowest_;    // frequency [rad/s]
  WaveLife life_;
  double shaking_ = 0.0;               // 3 of a bent motor, 0 without [1/turn]
  double blades_ = 0.0;                // of a regenerative bit, 0 for others
  double flow_that_settles_ = 0.0;     // of a motor, 0 without [m3/s]
  std::vector<double> along_, about_;  // impedances at the nodes [N s/m, N m s]
  std::vector<double> share_;          // of the string's length, at the nodes [-]
};

}  // namespace drill_rig_sim

#endif
