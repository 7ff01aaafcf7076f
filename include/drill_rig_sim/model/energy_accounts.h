// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_ENERGY_ACCOUNTS_H
#define DRILL_RIG_SIM_MODEL_ENERGY_ACCOUNTS_H

#include "drill_rig_sim/model/energy_sample.h"

namespace drill_rig_sim
{
/// Work and energy since a balance was opened [J]. Positive: inputs feed the system, everything else takes from it.
///
///   winch + drive + pump + heave + gravity + steering + handled = stored + dissipated + broken rock + numerical + correction +
///   residual
///
/// How a step of length h from n to n + 1 is booked; f: a force, v: the method's rates, u: its increments, bar: mean of n and n
/// + 1.
///  - Inputs, dissipation and broken rock are integrated in time, h f_bar v_bar. They know rates and the clock, not the
///  increments.
///    Gravity is weight times the change of places.
///  - Stored energy comes only from configuration and rates.
///  - Numerical dissipation is what the method's own rules miss, D = f_bar . u - (change of energy) for inertia (f = M a) and for
///  every
///    elastic force, less the work r_bar . u of the residual r that it left: the trapezoidal rule on a linear system has D = 0.
///    It knows neither input nor dissipation.
///  - Correction: what wall and bottom contact lose when the hole is extended or straightened under the resting string between
///  steps.
/// Nothing is computed as what remains, so the residual is a test: it holds (1) a force without account, or one that is not the
/// gradient of its energy in time; (2) the difference of rates and increments in inputs and dissipation, f_bar . (u - h v_bar).
/// A wrong elastic energy would go to the numerical dissipation, which then does not fall with the step.
struct EnergyAccounts
{
  // inputs
  double winch = 0.0;  ///< drum: line tension times the speed of the line, less the elastic energy of the line wound up
  double drive = 0.0;  ///< top drive's motor torque times rotor speed
  double pump = 0.0;   ///< flow times the pressure that the mud motor's torque needs, gauge friction included, 2 pi T/V; and what
                       ///< its pressure does to the elastic energy as it stretches the string, -N dL where it is under an
                       ///< effective tension N, and as it lifts it up the annulus: less than 0 where the string surges and swabs;
                       ///< and the work of tools that shake the string
  double heave = 0.0;  ///< forces of lines, rail, stops and slips times the speed of the floor under them
  double gravity = 0.0;   ///< weight in mud
  double steering = 0.0;  ///< of a rotary steerable tool: its pads, or the actuator at its pivot
  double handled = 0.0;   ///< brought in or taken out with the pipe of a connection, between two steps

  // stored
  StoredEnergy first;  ///< when the balance was opened
  StoredEnergy last;   ///< now

  // physical dissipation
  double wall_friction = 0.0;   ///< friction's work less what its bristles hold
  double wall_damping = 0.0;    ///< Hunt and Crossley's, at the wall
  double bottom_damping = 0.0;  ///< and of the bit on the bottom
  double squeeze_film = 0.0;    ///< mud squeezed between blades or gauge and wall
  double mud = 0.0;
  double structural = 0.0;
  double block = 0.0;                 ///< friction of the block's rail, less what it holds, damping of its stops and lines
  double gearbox = 0.0;               ///< friction of the top drive's gearbox and brake, less what it holds
  double motor_slip = 0.0;            ///< pump less torque times the mud motor's speed
  double stuck_point_released = 0.0;  ///< held by a stuck point, or the slips, when it let go
  // what the model itself leaves out
  double ledge = 0.0;  ///< work of the wall's axial push where its radius changes (wall_contact.h: "sideways, never along")
  double added_mass =
      0.0;  ///< of the added mass, lateral only: the force of its axes' turning with the string, and nodes that enter mud

  // broken rock
  double rock_thrust = 0.0;  ///< force on the bottom times the bottom's speed
  double rock_torque = 0.0;  ///< torque on bit times bit speed, cutting and rubbing alike, less what the bristle holds

  double correction =
      0.0;  ///< contacts; and beams, where guided pipe changes the side on which it lies or kinds of nodes change (levels.h)

  // numerical dissipation
  double of_inertia = 0.0;  ///< nodes and rotor
  double of_beams = 0.0;
  double of_contact = 0.0;  ///< elastic part of wall, bottom and stuck point
  double of_line = 0.0;
  double of_residual = 0.0;  ///< Newton's or linearisation's rest
  double of_rebasing = 0.0;  ///< lost when rates are carried to the axes of the next step

  double largest_kinetic = 0.0;  ///< highest kinetic energy so far
  double time = 0.0;             ///< booked [s]

  double input() const noexcept { return winch + drive + pump + heave + gravity + steering + handled; }
  double stored() const noexcept;
  /// What the model leaves out counts here.
  double dissipated() const noexcept;
  double broken_rock() const noexcept { return rock_thrust + rock_torque; }
  double numerical() const noexcept;
  /// Sums of the absolute accounts: what cancels counts.
  double input_magnitudes() const noexcept;
  double loss_magnitudes() const noexcept;
  double numerical_magnitudes() const noexcept;
  double residual() const noexcept;
  /// What the balance is measured by: sum of the absolute inputs, or the largest kinetic energy if that is more.
  double throughput() const noexcept;
  /// |residual| / throughput; 0 when nothing has happened.
  double closure() const noexcept;
  /// numerical dissipation / throughput; < 0: energy was made.
  double numerical_share() const noexcept;
  /// numerical / (dissipated + broken rock + numerical): how much of what damps the motion is the method's; 0 when nothing was
  /// lost.
  double numerical_of_losses() const noexcept;
};

}  // namespace drill_rig_sim

#endif
