#ifndef DRILL_RIG_SIM_RIG_HOISTING_H
#define DRILL_RIG_SIM_RIG_HOISTING_H

#include "drill_rig_sim/rig/setpoints.h"

/// Drill line, winch and what the dead line's sensor reads.
///
/// n sheaves in the travelling block, 2 n lines between crown and block. Strung length L = 2 n (crown_height - block_height) +
/// fixed_length, unstretched length of the same line L_0; tension T = E A (L - L_0) / L_0, never negative (slack); hook force 2 n
/// T. Line and sheaves have no mass; sheave friction shows in the dead line's reading only.
namespace drill_rig_sim
{
struct HoistingSpec
{
  int sheaves = 5;              ///< n in the travelling block; 2 n lines
  double line_ea = 4e7;         ///< E A of the drill line [N]
  double crown_height = 46.0;   ///< of the crown block above the rotary table [m]
  double fixed_length = 60.0;   ///< strung length outside the block: fast and dead line [m]
  double block_mass = 17500.0;  ///< travelling block, hook and top drive [kg]
  double sheave_efficiency = 0.98;
  double max_speed = 1.5;         ///< of the block [m/s]
  double max_acceleration = 0.5;  ///< of the block [m/s2]
  double max_hook_load = 2.5e6;   ///< [N]
  double lowest_block_height = 1.0;
  double highest_block_height = 40.0;
};

/// The lines' pull on the block.
struct LinePull
{
  double tension = 0.0;     ///< T of every line [N]
  double hook_force = 0.0;  ///< 2 n T, upwards on the block [N]
  double stiffness = 0.0;   ///< -d hook_force / d block_height = (2 n)^2 E A / L_0; zero when slack [N/m]
  bool slack = false;
};

/// L at a block height [m].
double strung_length(const HoistingSpec& spec, double block_height) noexcept;

/// Pull of a line of unstretched length `line_length` (L_0 > 0) [m] at a block height [m].
LinePull line_pull(const HoistingSpec& spec, double block_height, double line_length) noexcept;

/// L_0 that carries `hook_force` (>= 0) [N] at a block height [m]: L_0 = L / (1 + T / E A). For the start.
double line_length_for(const HoistingSpec& spec, double block_height, double hook_force) noexcept;

/// What limits the winch in a step.
struct WinchLimits
{
  bool speed = false;         ///< the command is beyond max_speed
  bool acceleration = false;  ///< still ramping
  bool height = false;        ///< slowed down or stopped before lowest_block_height or highest_block_height
  bool load = false;          ///< raising refused at max_hook_load
  bool any() const noexcept { return speed || acceleration || height || load; }
};

/// One step of the winch.
struct WinchStep
{
  double line_length = 0.0;  ///< L_0 at the end of the step [m]
  double speed = 0.0;        ///< of the block, as the drum runs at the end of the step [m/s], + up
  WinchLimits limits;
};

/// Advances drum and line over one step.
///
/// The block's speed ramps at max_acceleration to the command (zero with the brake set), clamped to max_speed. Near a height
/// limit it is held to what can still stop there, v <= sqrt(2 a d) at distance d; beyond a limit, and when raising at or above
/// max_hook_load, the drum stops at once. The other direction stays free. The drum winds stretched line at 2 n v, which holds 2 n
/// v L_0/L unstretched: dL_0/dt = -2 n v L_0/L. So a constant command gives, at a steady load, exactly that block speed.
/// @param line_length   L_0 at the start of the step [m]
/// @param speed         of the drum at the start of the step [m/s], + up
/// @param block_height  at the start of the step [m]
/// @param hook_load     at the start of the step [N]
/// @param step          > 0 [s]
WinchStep advance_winch(const HoistingSpec& spec, const WinchSetpoint& command, double line_length, double speed,
                        double block_height, double hook_load, double step) noexcept;

/// Hook load as read at the dead line: 2 n times the dead line's tension, with the friction of the turning sheaves.
///
/// Hoisting, every sheave passed towards the fast line raises the tension by 1/e, e the sheave's efficiency; lowering, it lowers
/// it by e. The N = 2 n lines carry the load, the dead line's own sheave does not turn, so with K = 1/e (hoisting) or e
/// (lowering)
///   hook load = T_dead (1 + K + ... + K^(N-1)),   reading = N T_dead.
/// Source: sum of line tensions as in API RP 9B (fast line factor with S = N sheaves: K^N (K - 1)/(K^N - 1) of the load); for the
/// dead line: Luke and Juvkam-Wold, Determination of true hook load and line tension under dynamic conditions, SPE Drilling &
/// Completion 8 (1993), 259-264, case of the inactive dead-line sheave. At rest friction is undetermined: K goes through 1 over a
/// block speed of +-5 mm/s.
/// @param hook_load         true load on the lines [N]
/// @param block_velocity    [m/s], + up
/// @param sheaves           n >= 1
/// @param sheave_efficiency e in (0, 1]
double dead_line_hook_load(double hook_load, double block_velocity, int sheaves, double sheave_efficiency) noexcept;

}  // namespace drill_rig_sim

#endif
