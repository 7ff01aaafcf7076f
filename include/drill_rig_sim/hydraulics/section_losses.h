// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_SECTION_LOSSES_H
#define DRILL_RIG_SIM_HYDRAULICS_SECTION_LOSSES_H

#include <vector>

#include "drill_rig_sim/hydraulics/flow_losses.h"
#include "drill_rig_sim/hydraulics/loss_table.h"

namespace drill_rig_sim
{
/// A pipe between pump and string.
struct SurfaceLine
{
  double length = 0.0;    ///< [m]
  double diameter = 0.0;  ///< [m]
};

/// A length of passage of one section.
struct PassageLength
{
  Passage passage;
  double length = 0.0;  ///< [m]
};

/// What is lost along one section of the annulus by the speed of its mud against the string and the wall.
///
/// A string closed by its float that moves at v displaces A_o v, and mud clings to it (flow_losses.h, clinging()):
///   V = (Q + A_o v)/A + K v,      Q from the bit, A_o the string's outside, A the annulus.
struct AnnulusSection
{
  LossTable loss;                ///< by V [m/s], [Pa]
  double per_area = 0.0;         ///< 1/A [1/m2]
  double laminar_carry = 0.0;    ///< (A_o/A + K)/A_m, K of laminar flow, A_m of SectionLosses [1/m2]
  double turbulent_carry = 0.0;  ///< the same of turbulent flow [1/m2]
  double critical_speed = 0.0;   ///< [m/s]

  /// At a flow Q [m3/s] and A_m v [m3/s], and the slope by Q.
  LossTable::Value at(double flow, double displaced) const noexcept;
};

/// The losses of a mud with a rheology on its way, section by section, worked out once (flow_losses.h) and interpolated in a
/// frame.
struct SectionLosses
{
  LossTable lines;           ///< of the surface lines, by flow [m3/s]; empty: none
  LossTable bore;            ///< of the string's bore, by flow; empty: the scene gives no rheology
  double density = 0.0;      ///< [kg/m3]
  double nozzle_area = 0.0;  ///< of the bit [m2]
  std::vector<AnnulusSection> annulus;
  double displaced_area = 0.0;  ///< A_m: mean of the string's outside in the hole, so that it displaces A_m v [m2]

  bool any() const noexcept { return !bore.empty(); }
  double lines_loss(double flow) const noexcept { return lines.empty() ? 0.0 : lines.at(flow).loss; }
  /// From the pump through the bit, without the motor, and its slope.
  /// @param flow  >= 0 [m3/s]
  LossTable::Value inner(double flow) const noexcept;
  /// Of the annulus.
  /// @param flow       Q, < 0 down [m3/s]
  /// @param displaced  A_m v [m3/s]
  LossTable::Value outer(double flow, double displaced) const noexcept;
};

/// What mud flows through.
struct MudSections
{
  std::vector<PassageLength> lines, bore, annulus;
  double nozzle_area = 0.0;  ///< [m2]
};

/// Loss along each section of the bore, by flow [m3/s].
std::vector<LossTable> bore_section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow);

/// @param largest_flow  of the pump [m3/s]
SectionLosses section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow);

}  // namespace drill_rig_sim

#endif
