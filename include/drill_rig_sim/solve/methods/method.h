// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_METHODS_METHOD_H
#define DRILL_RIG_SIM_SOLVE_METHODS_METHOD_H

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/stage_context.h"
#include "drill_rig_sim/solve/newton.h"

namespace drill_rig_sim
{
/// What a method works with during one step. All increments and rates are based on the start of the step.
struct StepContext
{
  const Model& model;
  const State& state;  ///< at the start
  double step;         ///< [s]
  Stage& stage;        ///< begun, at the step's end
  Workspace& work;
  Newton& newton;
  NewtonLimits limits;
  int budget;        ///< Newton iterations that all stages may cost
  double* u;         ///< 6 per node; in: predicted for the whole step; out: increments at its end
  double* residual;  ///< scratch, 6 per node
  int iterations = 0;

  StageContext at_stage() noexcept { return {model, state, stage, work}; }
  /// What the method remembers.
  const PastQuantity& past(int k) const noexcept { return state.memory.past[static_cast<std::size_t>(k)]; }
  /// Newton's method on the stage as prepared, from u; the workspace is left at the solution, of guided nodes in their two
  /// coordinates (expand_motions()). False: not converged.
  bool solve() noexcept;
};

/// A fixed-step method: a file of its own and a line in method_table(). What it remembers of earlier steps is its own affair: the
/// quantities of State::memory behind the first, the last rate, which predict() needs.
struct Method
{
  IntegratorKind kind;
  const char* name;
  const char* description;
  /// Takes one step: on success the workspace is left at its end, updated, ready for commit(). False: not solvable.
  bool (*step)(StepContext& context) noexcept;
  /// After a step, before commit(): writes what it remembers but the last rate. Null: nothing.
  void (*remember)(const StepContext& context, MethodMemory& memory) noexcept;
  /// The accelerations of a start without history are written into these of its quantities; 0: into none.
  int first_acceleration;
  /// A step with a local error above largest_local_error is repeated in halves.
  bool refines;
  /// Local error of the node positions in the step just solved, largest component [m]. Null: a sixth of the distance of the
  /// solution from the extrapolation, as for BDF2.
  double (*local_error)(const StepContext& context) noexcept;
  /// Local error of the step over the distance of its solution from the extrapolation predict(). `ratio`: step over the previous
  /// step, 0 without memory. Null: steps of variable length are not available.
  double (*share_of_distance)(double ratio) noexcept;
};

/// The quantity that every method remembers first: the rates one step before.
constexpr int last_rate = 0;
/// What some remember second: the accelerations at the end of the last step.
constexpr int last_acceleration = 1;

/// The stage at the start of the step itself: u = 0 has the state's rates, accelerations are zero, the rotor is held.
void prepare_start(const State& state, Stage& stage) noexcept;
/// Extrapolates the last steps to `time` after the start of this one [s]: the first guess of u (6 per node); by the batch kernel,
/// if one is given.
void predict(const State& state, double time, double* u, const HistoryKernel* history = nullptr) noexcept;
/// Keeps the rates and the rotor's speed of the step's start as the last ones, while `state` is still the start.
void remember_last_rate(const Stage& stage, Workspace& work, State& state) noexcept;
/// A quantity of the stage's nodes: increment, rate or acceleration; and of guided ones.
struct NodeQuantity
{
  Vector6d NodeMotion::*vector;
  Column GuidedMotions::*along;
  Column GuidedMotions::*about;
};
constexpr NodeQuantity increments{&NodeMotion::increment, &GuidedMotions::along, &GuidedMotions::about};
constexpr NodeQuantity accelerations{&NodeMotion::acceleration, &GuidedMotions::along_acceleration,
                                     &GuidedMotions::about_acceleration};
/// Puts it into memory, in the axes of the coming normals.
void remember(const Stage& stage, Workspace& work, const NodeQuantity& quantity, double rotor, PastQuantity& past) noexcept;
/// Keeps the accelerations of the stage as the last ones.
void remember_acceleration(const StepContext& context, MethodMemory& memory) noexcept;

/// BDF2 with variable step: second order, L-stable, one solve a step.
extern const Method bdf2;
/// Implicit Euler: first order, L-stable.
extern const Method implicit_euler;
/// Linearly implicit Euler: one linear solve a step, about its start. First order.
extern const Method linearly_implicit_euler;
/// TR-BDF2: second order, one-step, L-stable, two solves a step.
extern const Method trbdf2;
/// Generalised alpha (Chung and Hulbert), forces in balance at the ends of steps (Arnold and Bruels): second order, one solve a
/// step.
extern const Method generalised_alpha;
/// Central differences: second order, no solve, stable for short steps only (explicit_limit.h).
extern const Method explicit_differences;

/// Also starts the multistep methods.
void prepare_implicit_euler(const State& state, double step, Stage& stage) noexcept;
void prepare_bdf2(const State& state, double step, Stage& stage) noexcept;

}  // namespace drill_rig_sim

#endif
