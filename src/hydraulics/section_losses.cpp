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
                               double displaced_area, const FactorRange* warm)
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
  if (warm)
    out.warm = LossFamily({mud, *warm, fastest,
                           [&](const Rheology& curve, double speed)
                           { return section.length * pressure_gradient(curve, density, passage, speed); },
                           [&](const Rheology& curve) { return critical_speed(curve, density, passage); }});
  return out;
}

/// Of a pipe, by its flow.
LossFamily warm_pipe(const Rheology& mud, double density, const PassageLength& pipe, double largest_flow,
                     const FactorRange& range)
{
  const double area = pipe.passage.area();
  return LossFamily({mud, range, largest_flow,
                     [&](const Rheology& curve, double flow)
                     { return pipe.length * pressure_gradient(curve, density, pipe.passage, flow / area); },
                     [&](const Rheology& curve) { return area * critical_speed(curve, density, pipe.passage); }});
}

void add(LossTable::Value& sum, const LossTable::Value& more) noexcept
{
  sum.loss += more.loss;
  sum.slope += more.slope;
}
}  // namespace

LossTable::Value AnnulusSection::at(double flow, double displaced, const LossPlace* place) const noexcept
{
  const double critical = place ? place->critical_flow * critical_speed : critical_speed;
  const double laminar = per_area * flow + laminar_carry * displaced;
  const double speed = laminar + turbulence_at(laminar, critical) * (turbulent_carry - laminar_carry) * displaced;
  const LossTable::Value here = place ? warm.at(speed, *place) : loss.at(speed);
  return {here.loss, per_area * here.slope};
}

LossTable::Value SectionLosses::in_bore(double flow, const LossPlaces* places) const noexcept
{
  if (!places) return bore.at(flow);
  LossTable::Value sum;
  for (std::size_t i = 0; i < warm_bore.size(); ++i) add(sum, warm_bore[i].at(flow, places->bore[i]));
  return sum;
}

double SectionLosses::creep(const LossPlaces* places) const noexcept
{
  if (!places) return bore.creep();
  double most = 0.0;
  for (std::size_t i = 0; i < warm_bore.size(); ++i) most = std::max(most, warm_bore[i].creep(places->bore[i]));
  return most;
}

double SectionLosses::nozzles(double flow, const LossPlaces* places) const noexcept
{
  if (nozzle_area <= 0.0) return 0.0;
  return nozzle_loss(places ? places->bit_density * density : density, flow, nozzle_area);
}

LossTable::Value SectionLosses::inner(double flow, const LossPlaces* places) const noexcept
{
  LossTable::Value sum = in_bore(flow, places);
  if (!lines.empty()) add(sum, lines.at(flow));
  if (nozzle_area <= 0.0) return sum;
  const double bit = nozzles(flow, places);
  sum.loss += bit;
  if (flow > 0.0) sum.slope += 2.0 * bit / flow;
  return sum;
}

LossTable::Value SectionLosses::outer(double flow, double displaced, const LossPlaces* places) const noexcept
{
  LossTable::Value sum;
  for (std::size_t i = 0; i < annulus.size(); ++i) add(sum, along_section(i, flow, displaced, places));
  return sum;
}

std::vector<LossTable> bore_section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow)
{
  std::vector<LossTable> out;
  for (const PassageLength& section : sections.bore) out.push_back(in_a_row(mud, density, {section}, largest_flow));
  return out;
}

SectionLosses section_losses(const Rheology& mud, double density, const MudSections& sections, double largest_flow,
                             const WarmRange* warm)
{
  SectionLosses out;
  out.density = density;
  out.nozzle_area = sections.nozzle_area;
  const double inlet = warm ? warm->inlet : 1.0;
  out.lines = in_a_row({inlet * mud.yield_stress, inlet * mud.consistency, mud.index}, density, sections.lines, largest_flow);
  out.bore = in_a_row(mud, density, sections.bore, largest_flow);
  if (warm)
    for (const PassageLength& pipe : sections.bore)
      out.warm_bore.push_back(warm_pipe(mud, density, pipe, largest_flow, warm->factors));
  double length = 0.0, volume = 0.0;
  for (const PassageLength& section : sections.annulus)
  {
    length += section.length;
    volume += section.length * 0.25 * pi * section.passage.inner * section.passage.inner;
  }
  if (length <= 0.0) return out;
  out.displaced_area = volume / length;
  for (const PassageLength& section : sections.annulus)
    out.annulus.push_back(
        annulus_section(mud, density, section, largest_flow, out.displaced_area, warm ? &warm->factors : nullptr));
  return out;
}

}  // namespace drill_rig_sim
