// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_SECTION_FRICTION_H
#define DRILL_RIG_SIM_CONTACT_SECTION_FRICTION_H

#include <vector>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/well/well_spec.h"

namespace drill_rig_sim
{
/// Static ratio and Stribeck speed along the hole: each section's own, else the scene's. Over the millimetre where one section
/// gives way to the next they change in a straight line, as the kinetic coefficient does: friction never jumps.
class SectionFriction
{
public:
  /// @param sections  of the hole, top down; at least one
  SectionFriction(const ContactSpec& contact, const std::vector<HoleSection>& sections);

  /// Puts them into the law of a place.
  /// @param section  ClosestPoint::section
  /// Whether it is the same everywhere.
  bool uniform() const noexcept { return sections_.empty(); }
  void apply(double section, WallLaw& law) const noexcept
  {
    if (!sections_.empty()) look_up(section, law);
  }

private:
  struct Values
  {
    double static_ratio, stribeck_speed;
  };

  void look_up(double section, WallLaw& law) const noexcept;

  std::vector<Values> sections_;  // empty: no section has its own
};

}  // namespace drill_rig_sim

#endif
