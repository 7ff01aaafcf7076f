// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_FORMATION_H
#define DRILL_RIG_SIM_WELL_FORMATION_H

#include <Eigen/Core>
#include <limits>
#include <vector>

/// The rock, and how fast a bit breaks it: the three-dimensional drilling equation
///   v = K N^beta g(|F|) A_f A_b F/|F|,   g(F) = max(F - F_0, 0)^alpha,
///   A_b = a a^T + i_b (1 - a a^T),   A_f = (1 - h) 1 + h n n^T,
/// with F the force of the bit on the rock (bottom's and gauge's normal forces, friction excluded) [N], N the bit's speed
/// [rad/s], a the bit's axis, i_b its side cutting, n the beds' upward normal, h the anisotropy; K in m/s per (N^alpha
/// (rad/s)^beta). On the axis of a bit in isotropic rock it is ROP = K N^beta (W - F_0)^alpha.
///
/// It says how fast, not how the rock breaks: constants are calibrated per bit and layer, and no force is carried over from one
/// turn to the next.
namespace drill_rig_sim
{
/// What of a bit's face stands on rock: the whole, or a ring (pilot_hole.h).
struct FaceRing
{
  double share = 1.0;  ///< of the whole face's weight at the same depth of cut [-]
  double lever = 1.0;  ///< of the torque, over the whole face's [-]
};

/// Rock between the layer above and `to_tvd`. ROP = drillability (weight - threshold)^weight_exponent bit_speed^speed_exponent.
struct FormationLayer
{
  double to_tvd = 0.0;           ///< true vertical depth of its base [m]
  double drillability = 0.0;     ///< K [m/s; N; rad/s]
  double weight_exponent = 1.0;  ///< alpha [-]
  double speed_exponent = 1.0;   ///< beta [-]
  double threshold = 0.0;        ///< F_0 [N]
  double dip = 0.0;              ///< bed dip below horizontal [rad]
  double strike = 0.0;           ///< azimuth of the strike, dip to its right [rad]
  double anisotropy = 0.0;       ///< h in [0, 1); 0 = isotropic

  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();  ///< as its hole section has it
  double friction = unset;  ///< kinetic friction coefficient, pipe on the wall of hole that is drilled in it [-]

  FaceRing ring{};  ///< no input: ring_of() sets it, and drillability and threshold with it
};

/// The layer at true vertical depth `tvd` = -z [m]; above the first base the first, below the last base the last. `layers`: at
/// least one.
const FormationLayer& layer_at(const std::vector<FormationLayer>& layers, double tvd) noexcept;

/// The layers by true vertical depth.
class Formation
{
public:
  /// `layers`: at least one, to_tvd strictly increasing. Throws std::invalid_argument with one line otherwise.
  explicit Formation(std::vector<FormationLayer> layers);
  /// layer_at().
  const FormationLayer& at(double tvd) const noexcept { return layer_at(layers_, tvd); }
  const std::vector<FormationLayer>& layers() const noexcept { return layers_; }

private:
  std::vector<FormationLayer> layers_;
};

/// Unit upward normal of the layer's beds. Right-hand rule: they dip towards azimuth strike + 90 deg, and the normal leans that
/// way.
Eigen::Vector3d bed_normal(const FormationLayer& layer) noexcept;

/// Rock breaking at unit weight above the threshold: K N^beta [m/s per N^alpha], 0 where N <= 0.
/// For beta < 1 it is multiplied by N^2/(N^2 + N_s^2), N_s = 0.05 rad/s (half a turn a minute), so that it goes smoothly to zero
/// with the speed: a bit that does not turn drills nothing, also for beta = 0; at 5 rad/s the factor is 1 - 1e-4.
double drilling_coefficient(const FormationLayer& layer, double bit_speed) noexcept;

/// The speed that the rate of penetration is to be worked out with: the law is a mean over turns, used with the speed of the
/// instant it feeds the drilling string's axial and torsional vibration (flutter). `mean_speed`: the bit's, lagged by about a
/// turn. A bit that stands drills nothing: at most five times the speed it has; what that holds back stays in the mean
/// (forces/bit.cpp) [rad/s].
double drilling_speed(double mean_speed, double bit_speed) noexcept;

/// ROP of a bit that pushes and turns along its axis in isotropic rock, K N^beta (W - F_0)^alpha [m/s]; 0 for W <= F_0.
double on_axis_rop(const FormationLayer& layer, double bit_speed, double weight) noexcept;

/// d ROP / d W of on_axis_rop [m/s/N]. For alpha < 1 it is unbounded at the threshold: held at its value 1 N above.
double on_axis_rop_slope(const FormationLayer& layer, double bit_speed, double weight) noexcept;

/// A_f A_b u: what the bit's and the rock's directions make of a unit force direction u [-].
Eigen::Vector3d cutting_direction(const FormationLayer& layer, const Eigen::Vector3d& bit_axis, double side_cutting,
                                  const Eigen::Vector3d& force_direction) noexcept;

/// v of the drilling equation [m/s], world axes.
///
/// The bit drills where its face presses: with F_a = max(F . a, 0) and F_l the rest of F, v carries the factor
/// F_a^2/(F_a^2 + (0.01 |F_l|)^2): 1 on the axis, 1 - 1e-4 where the side force equals the weight, smoothly 0 where only the
/// gauge touches. Strong anisotropy with a side force could point v backwards: its component along the bit's axis is held at zero
/// or more.
/// @param layer         the rock at the bit
/// @param force         F, bit on rock, world axes [N]
/// @param bit_speed     N [rad/s]; zero or negative drills nothing
/// @param bit_axis      a, unit, downhole
/// @param side_cutting  i_b, 0 .. 1
Eigen::Vector3d rock_breaking_velocity(const FormationLayer& layer, const Eigen::Vector3d& force, double bit_speed,
                                       const Eigen::Vector3d& bit_axis, double side_cutting) noexcept;

/// The direction of the drilling equation's v where something else says how fast the bottom goes down [-]: its part along `down`
/// is 1.
/// @param force     bit on rock, world axes; pushes along `down` [N]
/// @param down      normal of the bottom, unit, downhole
Eigen::Vector3d rock_breaking_direction(const FormationLayer& layer, const Eigen::Vector3d& force,
                                        const Eigen::Vector3d& bit_axis, double side_cutting,
                                        const Eigen::Vector3d& down) noexcept;

}  // namespace drill_rig_sim

#endif
