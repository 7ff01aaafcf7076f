// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/section_friction.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
double given_or(double value, double otherwise)
{
  return std::isnan(value) ? otherwise : value;
}
}  // namespace

SectionFriction::SectionFriction(const ContactSpec& contact, const std::vector<HoleSection>& sections)
{
  const auto has_its_own = [](const HoleSection& s) { return !std::isnan(s.static_ratio) || !std::isnan(s.stribeck_speed); };
  if (std::none_of(sections.begin(), sections.end(), has_its_own)) return;
  for (const HoleSection& s : sections)
    sections_.push_back({given_or(s.static_ratio, contact.static_ratio), given_or(s.stribeck_speed, contact.stribeck_speed)});
}

void SectionFriction::look_up(double section, WallLaw& law) const noexcept
{
  const double last = static_cast<double>(sections_.size() - 1);
  const double place = section > 0.0 ? std::min(section, last) : 0.0;  // and 0 for what is not a number
  const std::size_t above = static_cast<std::size_t>(place), below = std::min(above + 1, sections_.size() - 1);
  const double share = place - static_cast<double>(above);
  const Values &a = sections_[above], &b = sections_[below];
  law.static_ratio = a.static_ratio + share * (b.static_ratio - a.static_ratio);
  law.stribeck_speed = a.stribeck_speed + share * (b.stribeck_speed - a.stribeck_speed);
}

}  // namespace drill_rig_sim
