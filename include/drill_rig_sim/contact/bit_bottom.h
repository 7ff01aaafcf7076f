// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_BIT_BOTTOM_H
#define DRILL_RIG_SIM_CONTACT_BIT_BOTTOM_H

#include "drill_rig_sim/contact/normal_law.h"

/// The bit against the bottom of the hole while it drills.
///
/// The bit is a rigid ball of radius a (the bit's) about r_D; the bottom is the plane through r_m whose normal t_b points down
/// the hole. Approach, before the bottom gives way: delta_g = a - (r_m - r_D) . t_b, rate w = v_D . t_b. The rock recedes along
/// t_b at the on-axis rock-breaking speed v(F), hence within a step of length h, implicitly,
///   F = k delta^e (1 + c_d (w - v(F))),   delta = delta_g - h v(F),   F on the bit: -F t_b.
/// The right side falls as F grows, so F is unique. In steady drilling w = v(F) and F = k delta^e exactly.
namespace drill_rig_sim
{
/// On-axis rock-breaking speed v(F) = coefficient (F - threshold)^exponent at the bit speed in force; zero up to the threshold.
/// coefficient = K N^beta (times what the formation's and the bit's directions leave of it on the axis); 0: the rock does not
/// give way.
struct RockBreaking
{
  double coefficient = 0.0;  ///< >= 0 [m/s per N^exponent]
  double exponent = 1.0;     ///< alpha > 0 [-]
  double threshold = 0.0;    ///< F_0 >= 0 [N]
};

/// Value and slope of v(F).
struct RockBreakingSpeed
{
  double value = 0.0;  ///< v [m/s]
  double slope = 0.0;  ///< dv/dF [m/s/N]
};

/// v(F) and dv/dF. Just above the threshold an exponent below 1 has an unbounded slope.
RockBreakingSpeed rock_breaking_speed(const RockBreaking& rock, double force) noexcept;

/// What the bottom does to the bit.
struct BottomForce
{
  double value = 0.0;        ///< F >= 0, pushes the bit up the hole [N]
  double stiffness = 0.0;    ///< dF/d delta_g at fixed w [N/m]
  double damping = 0.0;      ///< dF/dw at fixed delta_g [N s/m]
  double penetration = 0.0;  ///< delta, after the bottom's advance [m]; <= 0: off bottom
  double speed = 0.0;        ///< v(F) [m/s]
  double advance = 0.0;      ///< h v(F), how far the bottom recedes in the step [m]
};

/// Solves the implicit law above (safeguarded Newton, at most 100 evaluations, usually 3 to 5) and differentiates its solution.
/// With u the step's displacement and dv/du = c the tangent of the force on the bit is -(stiffness + c damping) t_b t_b^T.
/// @param law       bottom's stiffness k [N/m^e], exponent e, damping c_d [s/m]
/// @param approach  delta_g [m], from the bottom's place at the start of the step
/// @param rate      w = d delta_g / dt [m/s]
/// @param rock      v(F)
/// @param step      h >= 0 [s]; 0: the bottom stays (statics)
BottomForce bit_bottom_force(const ContactLaw& law, double approach, double rate, const RockBreaking& rock, double step) noexcept;

}  // namespace drill_rig_sim

#endif
