// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/section_losses.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double fastest_string = 3.0;  // that annular tables are made for; they go on beyond [m/s]

/// Of pipes one after the other, by their flow.
LossTable in_a_row(const Rheology& mud, double density, const std::vector<PassageLength>& pipes, double largest_flow)
{
  const auto loss = [&](double flow)
  {
    double sum = 0.0;
    for (const PassageLength& pipe : pipes)
      sum += pipe.length * pressure_gradient(mud, density, pipe.passage, flow / pipe.passage.area());
    return sum;
  };
  return pipes.empty() ? LossTable() : LossTable(largest_flow, loss);
}

AnnulusSection annulus_section(const Rheology& mud, double density, const PassageLength& section, double largest_flow,
                               double displaced_area)
{
  const Passage& passage = section.passage;
  const double area = passage.area(), outside = 0.25 * pi * passage.inner * passage.inner, ratio = passage.inner / passage.outer;
  const auto carry = [&](double turbulence) { return (outside / area + clinging(ratio, turbulence)) / displaced_area; };
  AnnulusSection out;
  out.per_area = 1.0 / area;
  out.laminar_carry = carry(0.0);
  out.turbulent_carry = carry(1.0);
  out.critical_speed = critical_speed(mud, density, passage);
  const double fastest = largest_flow / area + fastest_string * displaced_area * std::max(out.laminar_carry, out.turbulent_carry);
  out.loss = LossTable(fastest, [&](double speed) { return section.length * pressure_gradient(mud, density, passage, speed); });
  return out;
}
}  // namespace

LossTable::Value AnnulusSection::at(double flow, double displaced) const noexcept
{
  const double laminar = per_area * flow + laminar_carry * displaced;
  const double speed = laminar + turbulence_at(laminar, critical_speed) * (turbulent_carry - laminar_carry) * displaced;
  const LossTable::Value here = loss.at(speed);
  return {here.loss, per_area * here.slope};
}

LossTable::Value SectionLosses::inner(double flow) const noexcept
{
  LossTable::Value sum = bore.at(flow);
  if (!lines.empty())
  {
    const LossTable::Value more = lines.at(flow);
    sum.loss += more.loss;
    sum.slope += more.slope;
  }
  if (nozzle_area <= 0.0) return sum;
  const double bit = nozzle_loss(density, flow, nozzle_area);
  sum.loss += bit;
  if (flow > 0.0) sum.slope += 2.0 * bit / flow;
  return sum;
}

LossTable::Value SectionLosses::outer(double flow, double displaced) const noexcept
{
  LossTable::Value sum;
  for (const AnnulusSection& section : annulus)
  {
    const LossTable::Value here = section.at(flow, displaced);
    sum.loss += here.loss;
    sum.slope += here.slope;
  }
  return sum;
}

std::vector<LossTable> bore_section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow)
{
  std::vector<LossTable> out;
  for (const PassageLength& section : sections.bore) out.push_back(in_a_row(mud, density, {section}, largest_flow));
  return out;
}

SectionLosses section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow)
{
  SectionLosses out;
  out.density = density;
  out.nozzle_area = sections.nozzle_area;
  out.lines = in_a_row(mud, density, sections.lines, largest_flow);
  out.bore = in_a_row(mud, density, sections.bore, largest_flow);
  double length = 0.0, volume = 0.0;
  for (const PassageLength& section : sections.annulus)
  {
    length += section.length;
    volume += section.length * 0.25 * pi * section.passage.inner * section.passage.inner;
  }
  if (length <= 0.0) return out;
  out.displaced_area = volume / length;
  for (const PassageLength& section : sections.annulus)
    out.annulus.push_back(annulus_section(mud, density, section, largest_flow, out.displaced_area));
  return out;
}

}  // namespace drill_rig_sim
