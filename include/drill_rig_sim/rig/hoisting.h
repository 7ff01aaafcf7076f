// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_HOISTING_H
#define DRILL_RIG_SIM_RIG_HOISTING_H

#include "drill_rig_sim/rig/damped_bristle.h"
#include "drill_rig_sim/rig/setpoints.h"

/// Drill line, winch, what the block rubs on and stops at, and what the dead line's sensor reads.
///
/// n sheaves in the travelling block, 2 n lines between crown and block. Strung length L = 2 n (crown_height - block_height) +
/// fixed_length, unstretched length of the same line L_0; tension T = E A (L - L_0) / L_0, never negative (slack); hook force 2 n
/// T. Line and sheaves have no mass. Friction of the sheaves shifts tension from line to line, and leaves their sum as it is:
/// what the lines have stretched in all is given by drum and block. So it changes the reading of the dead line and the load of
/// the drum; friction on the block is that of its rail. A damper beside the lines' spring stands for losses of lines and sheaves
/// when the block vibrates.
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
  double latency = 0.0;           ///< dead time of the winch's set point in the drawworks' drive [s]
  double rail_friction = 0.03;    ///< of the block on its guide rail, as a share of its weight
  double line_damping = 0.03;     ///< of the block alone on its lines, as a share of critical: "a few percent"
  double max_speed = 1.5;         ///< of the block [m/s]
  double max_acceleration = 0.5;  ///< of the block [m/s2]
  double max_hook_load = 2.5e6;   ///< [N]
  double min_hook_load = 0.0;     ///< below it the winch does not lower: slack line [N]; 0: it does
  double trip_hook_load = 0.0;    ///< over-pull: a hook load that sets the brake while it is raised [N]; 0: none
  double lowest_block_height = 1.0;
  double highest_block_height = 40.0;
  double connection_time = 180.0;  ///< that the string rests broken out in the slips, while a stand is added or taken away [s]
  int stand_joints = 3;            ///< joints of drill pipe in a stand
};

constexpr double rail_stiffness = 5e6;  ///< of what rail friction holds the block by [N/m]
constexpr double stop_clearance =
    0.02;  ///< of crown and floor stop beyond the heights where the winch stops: what hangs bounces by less [m]
constexpr double stop_stiffness = 1e8;   ///< of them [N/m]
constexpr double stop_damping = 2.0;     ///< Hunt and Crossley's [s/m]
constexpr double standing_winch = 1e-3;  ///< slower, it counts as standing [m/s]
constexpr double stick_up = 1.0;  ///< so high above the rotary table stands the joint that is broken out in a connection [m]
constexpr double sheave_presliding = 0.01;  ///< block travel over which the sheaves' friction builds up from rest [m]

/// What a stand of `stand` [m] needs between the block's heights where the crew adds it: stick_up, and half a metre to spare [m].
constexpr double room_for_stand(double stand) noexcept
{
  return stand + stick_up + 0.5;
}

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

/// Damping of lines and sheaves, on the block: c (drum's speed - block's), c = 2 z sqrt(k m), z line_damping, k the lines'
/// stiffness, m the block's mass; at least -hook_force, for lines do not push. None where they are slack.
struct LineDamper
{
  double force = 0.0;    ///< on the block, + up [N]
  double damping = 0.0;  ///< -d force / d block velocity, >= 0 [N s/m]
};
LineDamper line_damper(const HoistingSpec& spec, const LinePull& pull, double block_velocity, double winch_speed) noexcept;

/// Friction of the block on its rail. `deflection`: of the bristle at the start of the step [m]. Default: +-3 % of the block's
/// weight, whatever the load, as in the record of a North Sea rig, whose block of 66 t needs 40 kN more up than down.
DampedBristle rail_bristle(const HoistingSpec& spec, double deflection) noexcept;

/// Stops stop_clearance beyond lowest_block_height and highest_block_height, p beyond which the block is pushed back with k p (1
/// + d dp/dt), never pulled.
struct StopForce
{
  double force = 0.0;      ///< on the block, + up [N]
  double stiffness = 0.0;  ///< -d force / d height, >= 0 [N/m]
  double damping = 0.0;    ///< -d force / d velocity, >= 0 [N s/m]
  double energy = 0.0;     ///< k p^2 / 2 [J]
};
StopForce stop_force(const HoistingSpec& spec, double block_height, double block_velocity) noexcept;

/// What limits the winch in a step.
struct WinchLimits
{
  bool speed = false;         ///< the command is beyond max_speed
  bool acceleration = false;  ///< still ramping
  bool height = false;        ///< slowed down or stopped before lowest_block_height or highest_block_height
  bool load =
      false;  ///< at max_hook_load or beyond it, as an impact may bring it: raising is refused; below min_hook_load: lowering
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
/// limit it is held to what can still stop there, v <= sqrt(2 a d) at distance d; beyond a limit, when raising at or above
/// max_hook_load, and when lowering below min_hook_load, the drum stops at once. The other direction stays free. The drum winds
/// stretched line at 2 n v, which holds 2 n v L_0/L unstretched: dL_0/dt = -2 n v L_0/L. So a constant command gives, at a steady
/// load, exactly that block speed.
/// @param line_length   L_0 at the start of the step [m]
/// @param speed         of the drum at the start of the step [m/s], + up
/// @param block_height  at the start of the step [m]
/// @param hook_load     at the start of the step [N]
/// @param step          > 0 [s]
WinchStep advance_winch(const HoistingSpec& spec, const WinchSetpoint& command, double line_length, double speed,
                        double block_height, double hook_load, double step) noexcept;

/// A brake that holds at most `most` [N] at the block, on a drum without inertia. With a larger load line runs out: the lines
/// carry `most`, and the load accelerates downwards by (W - most)/m for a rigid string of weight W and mass m. L_0 at the end of
/// the step, from the block's height and velocity at its start: max(L_0, L_0 that carries `most` at height + velocity step). Off
/// only by the block's acceleration within the step, stiffness a step^2/2.
double slipping_line(const HoistingSpec& spec, double line_length, double block_height, double block_velocity, double most,
                     double step) noexcept;

/// How far the sheaves' friction has built up, from -1 (lowering) to 1 (raising), after the drum has moved the block by `travel`
/// [m] from where it was at `slip`. Sheaves turn with the line that passes them, not with a block that bounces on lines of equal
/// stretch: a reading keeps the friction of its last motion until the drum turns.
double sheave_slip(double slip, double travel) noexcept;

/// Hook load as read at the dead line: 2 n times the dead line's tension, with the friction of the sheaves.
///
/// Hoisting, every sheave passed towards the fast line raises the tension by 1/e, e the sheave's efficiency; lowering, it lowers
/// it by e. The N = 2 n lines carry the load, the dead line's own sheave does not turn, so with K = e^-slip, from 1/e (hoisting)
/// to e (lowering)
///   hook load = T_dead (1 + K + ... + K^(N-1)),   reading = N T_dead.
/// Source: sum of line tensions as in API RP 9B (fast line factor with S = N sheaves: K^N (K - 1)/(K^N - 1) of the load); for the
/// dead line: Luke and Juvkam-Wold, Determination of true hook load and line tension under dynamic conditions, SPE Drilling &
/// Completion 8 (1993), 259-264, case of the inactive dead-line sheave.
/// @param hook_load         true load on the lines [N]
/// @param slip              of the sheaves, sheave_slip()
/// @param sheaves           n >= 1
/// @param sheave_efficiency e in (0, 1]
double dead_line_hook_load(double hook_load, double slip, int sheaves, double sheave_efficiency) noexcept;

/// What the gauges show while the block moves steadily.
struct SteadyHookLoad
{
  double at_block = 0.0;      ///< on the lines, with the friction of the block on its rail [N]
  double at_dead_line = 0.0;  ///< by dead_line_hook_load() [N]
};

/// @param weight     that hangs on the lines at rest: string, block and top drive [N]
/// @param direction  of the block, 1 up, -1 down, 0: it stands, with no friction of rail and sheaves
SteadyHookLoad steady_hook_load(const HoistingSpec& spec, double weight, int direction) noexcept;

}  // namespace drill_rig_sim

#endif
