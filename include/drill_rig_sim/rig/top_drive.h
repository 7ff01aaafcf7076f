// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_TOP_DRIVE_H
#define DRILL_RIG_SIM_RIG_TOP_DRIVE_H

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/setpoints.h"

/// The top drive: a driven rotor, and the torque meter's spring between it and the string's top.
///
///   J dw/dt = tau + f - T,   T = k_m (rotor angle - string top's spin angle)
/// J rotor inertia, w its speed, tau the motor's torque, f the friction of gearbox and brake, T the torque meter: + drives the
/// string clockwise looking downhole.
///
/// The speed w* that the loop follows is the command's (SPEED, SOFT_TORQUE, Z_TORQUE) or leads to an angle (ANGLE, OSCILLATE),
/// and moves by ramps: drive_reference.h. SPEED, ANGLE, OSCILLATE:  tau = k_p (w* - w) + k_i i + J dw*/dt, di/dt = w* - w,
/// saturated; in ANGLE and OSCILLATE k_i is at least
///   k_p^2/(4 J), or what the loop has gathered on the way would go on turning the string for seconds.
/// SOFT_TORQUE, Z_TORQUE:    tau = T + q (P (w* - w) + I i - T) + J dw*/dt, q = 1/(1 - c): feeding the meter back makes the rotor
/// as light as
///   (1 - c) J, and the drive an impedance Z(s) = P + s (1 - c) J + I/s in front of the string's zeta (without friction). The
///   wave that comes up comes back r = (Z - zeta)/(Z + zeta) times (Halsey, Kyllingstad and Kylling, SPE 18049, 1988; Kyllingstad
///   and Nessjoen 2009).
/// TORQUE: tau = T*, held off where it would push the speed beyond +-max_speed: k_p (-w_max - w) <= tau <= k_p (w_max - w).
/// Saturation: |tau| <= torque limit, and |tau w| <= max_power with w at the start of the step.
/// Anti-windup: while saturated, i changes only if that does not increase the saturation; k_i i never exceeds the limit. In
/// TORQUE i follows the motor's torque, k_i i = tau; between loops of other gains it is set so that tau goes on: so a change of
/// mode takes over without a bump.
///
/// Friction: Coulomb's, carried by a damped bristle z as at the wall (contact/wall_contact.h), so that what it holds does not
/// creep:
///   q = k_g (z + u) + c_g w,   f = -q while |q| <= f_max, else -f_max sign(q), and z goes to -f/k_g over c_g/k_g.
/// f_max is the gearbox's, and the brake's with it while the brake is on: by command, and by itself in SPEED at a set point of 0
/// once the rotor stands or has just reversed, in ANGLE once it does so where it should; then it stays on as long as the set
/// point does. With the brake on, tau = 0, and the bristle of the brake takes over the torque of the integral; on release
/// k_i i = f. Both changes are without a jump.
///
/// The rotor is condensed out of the stage: all branches are affine and fall with the rotor's angle, hence one solution, in
/// closed form.
namespace drill_rig_sim
{
/// What SOFT_TORQUE or Z_TORQUE makes of the drive; 0: tuned to the string (rig/drive_tuning.h).
struct DriveImpedance
{
  double damping = 0.0;               ///< P [N m s/rad]
  double stiffness = 0.0;             ///< I [N m/rad]
  double inertia_compensation = 0.0;  ///< c: share of the rotor's inertia that the drive hides [-]
};

struct TopDriveSpec
{
  double inertia = 2500.0;             ///< [kg m2]
  double proportional_gain = 20000.0;  ///< [N m s/rad]
  double integral_gain = 5000.0;       ///< [N m/rad]
  double max_torque = 50000.0;         ///< [N m]
  double max_speed = 220.0 * rpm;      ///< [rad/s]
  double max_acceleration = 0.0;       ///< of the set point of speed [rad/s2]; 0: it moves at once
  double max_power = 750e3;            ///< [W]
  double meter_stiffness = 1e6;        ///< torque meter spring [N m/rad]
  double gearbox_friction = 1000.0;    ///< [N m]
  double brake_torque = 50e3;          ///< [N m]; 0: no brake
  DriveImpedance soft_torque;
  DriveImpedance z_torque{0.0, 0.0, 0.98};
};

constexpr double gear_stiffness = 1e7;        ///< k_g [N m/rad]
constexpr double standing_rotor = 0.1 * rpm;  ///< slower, it counts as standing [rad/s]

/// The rotor of the top drive and what its control remembers.
struct DriveState
{
  double angle = 0.0;        ///< [rad], unbounded
  double speed = 0.0;        ///< w [rad/s]
  double integral = 0.0;     ///< i, of the speed error [rad]; its torque is that by the gain of `loop`, 1 N m/rad where that is 0
  double meter_twist = 0.0;  ///< rotor ahead of the string's top [rad]
  double gear_twist = 0.0;   ///< z, of what gearbox and brake hold it by [rad]
  double reference = 0.0;    ///< w*, ramped [rad/s]; follows the rotor where no loop does
  TopDriveMode loop = TopDriveMode::speed;  ///< whose integral it is; TORQUE on the brake
  bool swings_left = false;                 ///< OSCILLATE: counterclockwise at present
  bool braked = false;
  bool reversed = false;  ///< its speed changed sign in the last step: it stood in between, however long the step was
  bool limited = false;   ///< a limit of torque, power or speed holds the motor back

  template <class V>
  void visit(V& v)
  {
    v("angle", angle);
    v("speed", speed);
    v("integral", integral);
    v("meter_twist", meter_twist);
    v("gear_twist", gear_twist);
    v("reference", reference);
    v("loop", loop);
    v("swings_left", swings_left);
    v("braked", braked);
    v("reversed", reversed);
    v("limited", limited);
  }
};

/// How a stage of an implicit method ties the rotor's rates to its increment u since the start of the step:
/// speed = dv_du u + rate_0, acceleration = da_du u + acceleration_0.
struct RotorStage
{
  double time = 0.0;            ///< from the start of the step to the stage [s]
  double dv_du = 0.0;           ///< [1/s]
  double da_du = 0.0;           ///< [1/s2]
  double rate_0 = 0.0;          ///< [rad/s]
  double acceleration_0 = 0.0;  ///< [rad/s2]
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
  DriveState state;           ///< at the stage: the next step's start, once this one is accepted
};

/// Solves the rotor for a given turn of the string's top.
/// @param spec      inertia > 0, gains >= 0, limits, impedances tuned
/// @param start     of the step
/// @param stage     da_du > 0
/// @param top_spin  string top's spin increment since the start of the step [rad]
RotorResult solve_rotor(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start,
                        const RotorStage& stage, double top_spin) noexcept;

/// Motor and friction at a given motion of the rotor.
struct DriveTorque
{
  double motor = 0.0;     ///< tau [N m]
  double friction = 0.0;  ///< f [N m]
  double by_turn = 0.0;   ///< d (tau + f) / d turn at a given T, <= 0 [N m/rad]
  double by_speed = 0.0;  ///< d (tau + f) / d speed, <= 0 [N m s/rad]
  double by_meter = 0.0;  ///< d tau / d T [-]
  DriveState state;       ///< if a step ends there
};

/// The same laws where the rotor is integrated elsewhere: the torques on it after it has turned by `turn` [rad] in `time` [s]
/// since the start of the step, runs at `speed` [rad/s] and is `twist` [rad] ahead of the string's top. The loop's integral is
/// exact over the step: of the angle that w* would have turned, less `turn`.
DriveTorque drive_torque(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start, double time,
                         double turn, double speed, double twist) noexcept;

/// Whether the brake is on in a step from `start`; never where there is none.
bool brake_is_on(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept;

/// Torque that the motor can give at a speed: the smaller of the rig's limit, the command's (0: none) and max_power / |speed| [N
/// m].
double motor_torque_limit(const TopDriveSpec& spec, const TopDriveSetpoint& command, double speed) noexcept;

}  // namespace drill_rig_sim

#endif
