// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_SECTION_LOSSES_H
#define DRILL_RIG_SIM_HYDRAULICS_SECTION_LOSSES_H

#include <cstddef>
#include <vector>

#include "drill_rig_sim/hydraulics/flow_losses.h"
#include "drill_rig_sim/hydraulics/loss_family.h"
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
  LossFamily warm;               ///< `loss` by temperature; empty without mud.temperature

  /// At a flow Q [m3/s] and A_m v [m3/s], and the slope by Q.
  /// @param place  of its mud in `warm`; null: the mud is the reference
  LossTable::Value at(double flow, double displaced, const LossPlace* place = nullptr) const noexcept;
};

/// What temperature makes of the mud, section by section (model/mud_temperature.h).
struct LossPlaces
{
  std::vector<LossPlace> bore, annulus;
  double bit_density = 1.0;  ///< at the bit, over the reference's

  template <class V>
  void visit(V& v)
  {
    v("bore", bore);
    v("annulus", annulus);
    v("bit_density", bit_density);
  }
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
  double displaced_area = 0.0;        ///< A_m: mean of the string's outside in the hole, so that it displaces A_m v [m2]
  std::vector<LossFamily> warm_bore;  ///< `bore` section by section and by temperature; empty without mud.temperature

  bool any() const noexcept { return !bore.empty(); }
  double lines_loss(double flow) const noexcept { return lines.empty() ? 0.0 : lines.at(flow).loss; }
  // `places`: of the sections' mud by temperature; null: all mud is the reference
  /// Of the bore, and its slope.
  LossTable::Value in_bore(double flow, const LossPlaces* places) const noexcept;
  /// Flow in the bore below which its yield stress is replaced by a slow creep.
  double creep(const LossPlaces* places) const noexcept;
  /// From the pump through the bit, without the motor, and its slope.
  /// @param flow  >= 0 [m3/s]
  LossTable::Value inner(double flow, const LossPlaces* places = nullptr) const noexcept;
  /// Of nozzles [Pa].
  double nozzles(double flow, const LossPlaces* places = nullptr) const noexcept;
  /// Of a section of the annulus.
  LossTable::Value along_section(std::size_t section, double flow, double displaced, const LossPlaces* places) const noexcept
  {
    return annulus[section].at(flow, displaced, places ? &places->annulus[section] : nullptr);
  }
  /// Of the annulus.
  /// @param flow       Q, < 0 down [m3/s]
  /// @param displaced  A_m v [m3/s]
  LossTable::Value outer(double flow, double displaced, const LossPlaces* places = nullptr) const noexcept;
};

/// What mud flows through.
struct MudSections
{
  std::vector<PassageLength> lines, bore, annulus;
  double nozzle_area = 0.0;  ///< [m2]
};

/// Loss along each section of the bore, by flow [m3/s].
std::vector<LossTable> bore_section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow);

/// What of temperature the losses are worked out for.
struct WarmRange
{
  FactorRange factors;  ///< of the flow curve, over the density's ratio
  double inlet = 1.0;   ///< factor of the mud in the surface lines
};

/// @param largest_flow  of the pump [m3/s]
/// @param warm          null: no temperature
SectionLosses section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow,
                             const WarmRange* warm = nullptr);

}  // namespace drill_rig_sim

#endif
