#ifndef DRILL_RIG_SIM_RIG_TOP_DRIVE_H
#define DRILL_RIG_SIM_RIG_TOP_DRIVE_H

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/setpoints.h"

/// The top drive: a driven rotor, and the torque meter's spring between it and the string's top.
///
///   J dw/dt = tau + f - T,   T = k_m (rotor angle - string top's spin angle)
/// J rotor inertia, w its speed, tau the motor's torque, f the friction of gearbox and brake, T the torque meter: + drives the string
/// clockwise looking downhole.
///
/// Speed mode:  tau = k_p (w* - w) + k_i I, dI/dt = w* - w, saturated.
/// Torque mode: tau = T*, held off where it would push the speed beyond +-max_speed: k_p (-w_max - w) <= tau <= k_p (w_max - w).
/// Saturation: |tau| <= torque limit, and |tau w| <= max_power with w at the start of the step.
/// Anti-windup: while saturated I moves only so far as it does not lead deeper into saturation; k_i |I| never exceeds the limit.
/// Outside speed mode I follows the motor's torque, k_i I = tau: so a change to speed mode takes over without a bump.
///
/// Friction: Coulomb's, carried by a damped bristle z as at the wall (contact/wall_contact.h), so that what it holds does not creep:
///   q = k_g (z + u) + c_g w,   f = -q while |q| <= f_max, else -f_max sign(q), and z goes to -f/k_g over c_g/k_g.
/// f_max is the gearbox's, and the brake's with it while the brake is on: when the command says so, and by itself in speed mode at a set
/// point of 0 once the rotor stands; then it stays on as long as the set point does. The brake takes the motor off, tau = 0, and what the
/// integral held over into its bristle; k_i I = f then: neither takes over with a bump.
///
/// The rotor is condensed out of the stage: all branches are affine and fall with the rotor's angle, hence one solution, in
/// closed form.
namespace drill_rig_sim
{
struct TopDriveSpec
{
  double inertia = 2500.0;             ///< [kg m2]
  double proportional_gain = 20000.0;  ///< [N m s/rad]
  double integral_gain = 5000.0;       ///< [N m/rad]
  double max_torque = 50000.0;         ///< [N m]
  double max_speed = 220.0 * rpm;      ///< [rad/s]
  double max_power = 750e3;            ///< [W]
  double meter_stiffness = 1e6;        ///< torque meter spring [N m/rad]
  double gearbox_friction = 1000.0;    ///< [N m]
  double brake_torque = 50e3;          ///< [N m]; 0: no brake
};

constexpr double gear_stiffness = 1e7;          ///< k_g [N m/rad]
constexpr double standing_rotor = 0.1 * rpm;    ///< slower, it counts as standing [rad/s]

/// The rotor at the start of a step.
struct RotorState
{
  double speed = 0.0;     ///< w [rad/s]
  double integral = 0.0;  ///< I, of the speed error [rad]
  double twist = 0.0;     ///< rotor angle - string top's spin angle [rad]
  double gear_twist = 0.0;  ///< z, of gearbox and brake [rad]
  bool braked = false;
};

/// How a stage of an implicit method ties the rotor's rates to its increment u since the start of the step:
/// speed = dv_du u + rate_0, acceleration = da_du u + acceleration_0.
struct RotorStage
{
  double time = 0.0;               ///< from the start of the step to the stage [s]
  double dv_du = 0.0;          ///< [1/s]
  double da_du = 0.0;  ///< [1/s2]
  double rate_0 = 0.0;             ///< [rad/s]
  double acceleration_0 = 0.0;     ///< [rad/s2]
};

/// The rotor at the stage.
struct RotorResult
{
  double increment = 0.0;     ///< u, rotor's turn since the start of the step [rad]
  double meter_torque = 0.0;  ///< T on the string's top [N m]
  double stiffness = 0.0;     ///< -dT / d(string top's spin increment), >= 0, the rotor's answer included [N m/rad]
  double motor_torque = 0.0;  ///< tau [N m]
  double friction = 0.0;      ///< f [N m]
  double acceleration = 0.0;  ///< [rad/s2]
  bool limited = false;       ///< a limit of torque, power or speed holds the motor back
  RotorState state;           ///< at the stage: the next step's start, once this one is accepted
};

/// Solves the rotor for a given turn of the string's top.
/// @param spec      inertia > 0, gains >= 0, limits
/// @param command   mode speed or torque (others are refused at the door and treated as speed here)
/// @param start     of the step
/// @param stage     da_du > 0
/// @param top_spin  string top's spin increment since the start of the step [rad]
RotorResult solve_rotor(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, const RotorStage& stage,
                        double top_spin) noexcept;

/// Motor and friction at a given motion of the rotor, and what they remember if a step ends there.
struct DriveTorque
{
  double motor = 0.0;     ///< tau [N m]
  double friction = 0.0;  ///< f [N m]
  double by_turn = 0.0;   ///< d (tau + f) / d turn, <= 0 [N m/rad]
  double by_speed = 0.0;  ///< d (tau + f) / d speed, <= 0 [N m s/rad]
  double integral = 0.0;    ///< I at the end of a step here [rad]
  double gear_twist = 0.0;  ///< z there [rad]
  bool limited = false;
  bool braked = false;
};

/// The same laws where somebody else integrates the rotor: the torques on it after it has turned by `turn` [rad] in `time` [s] since the
/// start of the step and runs at `speed` [rad/s]. In speed mode dI/dt = w* - w is integrated exactly, I = start.integral + w* time - turn.
DriveTorque drive_torque(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, double time, double turn,
                         double speed) noexcept;

/// Whether the brake is on in a step from `start`; never where there is none.
bool brake_is_on(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start) noexcept;

/// Torque that the motor can give at a speed: the smaller of the rig's limit, the command's (0: none) and max_power / |speed| [N
/// m].
double motor_torque_limit(const TopDriveSpec& spec, const TopDriveSetpoint& command, double speed) noexcept;

}  // namespace drill_rig_sim

#endif
