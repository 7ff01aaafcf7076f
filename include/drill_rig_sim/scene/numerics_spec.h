// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_NUMERICS_SPEC_H
#define DRILL_RIG_SIM_SCENE_NUMERICS_SPEC_H

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/string/beam_table.h"

namespace drill_rig_sim
{
/// Which motions are modelled.
enum class Level
{
  rigid,
  axial_torsional,
  hybrid,
  beam3d,
  automatic
};

/// Levels whose nodes are all confined to the hole.
constexpr bool all_guided(Level level) noexcept
{
  return level == Level::axial_torsional || level == Level::rigid;
}

/// What `numerics.integrator` can be; automatic is the first of integrator_table() (solve/integrator.h).
enum class IntegratorKind
{
  automatic,
  bdf2,
  implicit_euler,
  linearly_implicit_euler,
  trbdf2,
  generalised_alpha,
  central_differences,
  arkode_dirk,
  ida
};

/// Methods whose steps can be of variable length.
constexpr bool varies_steps(IntegratorKind kind) noexcept
{
  return kind == IntegratorKind::automatic || kind == IntegratorKind::bdf2;
}

/// A scene's step where it gives none [s]: variable at level automatic by a method that can, else default_step, chosen by
/// ./test/accuracy/run --operations
/// --variants. with_choice() (sim/choice.h) makes it one of these.
constexpr double step_by_level = -1.0, default_step = 0.01;

/// Methods that have only free nodes.
constexpr bool has_no_levels(IntegratorKind kind) noexcept
{
  return kind == IntegratorKind::arkode_dirk || kind == IntegratorKind::ida || kind == IntegratorKind::central_differences;
}

/// Another model of the rig beside the one that is shown, by which its error is measured.
enum class CompanionKind
{
  automatic,  ///< chosen_companion() (accuracy/refined.h)
  none,
  coarser,
  finer
};

/// Which values are compared with the companion's.
enum class Judge
{
  truth,
  readings  ///< of the instruments: their filter, delay, rate and resolution hide what a controller cannot see
};

struct NumericsSpec
{
  Level level = Level::automatic;  ///< as chosen by with_choice() (sim/choice.h)
  IntegratorKind integrator = IntegratorKind::automatic;
  ElementKind element = ElementKind::automatic;
  Kernel kernel = Kernel::automatic;
  double step = step_by_level;         ///< [s]; 0: variable (solve/step_control.h)
  double element_length = 0.0;         ///< longest element [m]; 0: by the hole, element_lengths() (scene_mesh.h)
  double pushed_element_length = 0.0;  ///< longest element where friction pushes the pipe that slides down [m]; 0: as elsewhere
  double guided_element_length =
      0.0;  ///< longest element of guided pipe that friction does not push, above 9.5 m two joints [m]; 0: as elsewhere
  double free_length =
      0.0;                  ///< level hybrid: nodes up to here above the bit's face are free [m]; 0: free_length() (scene_mesh.h)
  double tolerance = 0.02;  ///< relative, of the scene's outputs; of variable steps, level auto and the mesh by the hole
  double refinement = 1.0;  ///< factor by which elements and steps are shorter: for seeing how results converge [-]
  CompanionKind companion = CompanionKind::automatic;
  Judge judge = Judge::truth;
  double reference_tolerance =
      1e-6;                 ///< integrator ida: of velocities [m/s, rad/s] and relative; a hundredth of it of places [m, rad]
  int reference_order = 2;  ///< integrator ida: highest order; 2 is the last that damps every oscillation (A-stable)
  int reference_index = 2;  ///< integrator ida: 2 with both levels of constraints, 3 to show how it fails
  double newton_tolerance = 1e-6;  ///< error that Newton's iteration may leave in a step's increments [m, rad]
  double structural_damping =
      1e-4;  ///< of stretch, twist and bending (BeamDamping): stress = E (strain + value * strain rate) [s]

  bool has_variable_steps() const noexcept { return step == 0.0; }
};

}  // namespace drill_rig_sim

#endif
