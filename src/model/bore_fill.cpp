// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/bore_fill.h"

#include <algorithm>

#include "drill_rig_sim/model/forces/place_drag.h"

namespace drill_rig_sim
{
namespace
{
/// A place in the string.
struct Below
{
  double from_bit = 0.0;  ///< unstretched [m]
  double volume = 0.0;    ///< inside, from the rotary table down to it [m3]
};

/// Down inside the string from the rotary table until `way` of a measure is behind, of which element e has so much: of(e). At
/// most down to the bit.
template <class Measure>
Below walk_down(const Model& model, const State& state, double way, const Measure& of) noexcept
{
  Below out;
  for (int e = model.elements() - 1; e >= 0; --e)
  {
    const std::size_t lower = static_cast<std::size_t>(e);
    const MeshElement& element = model.mesh().elements[lower];
    const double immersed = immersed_share(state.nodes[lower].position.z(), state.nodes[lower + 1].position.z());
    const double all = immersed * of(lower), volume = immersed * element.holds * element.section.length;
    const double share = all > way ? way / all : 1.0;
    out.volume += share * volume;
    way -= share * all;
    out.from_bit = model.mesh().nodes[lower].from_bit + (1.0 - share) * immersed * element.section.length;
    if (share < 1.0) return out;
  }
  out.from_bit = 0.0;
  return out;
}
}  // namespace

double fill_bore(const Model& model, State& state) noexcept
{
  HydraulicState& hydraulics = state.hydraulics;
  hydraulics.bore_top = full_bore;
  const double level = model.scene().mud.fill.empty() ? 0.0 : fill_level(model.scene().mud, depth_of_bit(model, state));
  if (level <= 0.0)
  {
    hydraulics.filled = 0.0;
    return 0.0;
  }
  const auto length = [&](std::size_t e) { return (state.nodes[e + 1].position - state.nodes[e].position).norm(); };
  const Below crew = walk_down(model, state, level, length);
  hydraulics.filled = std::min(hydraulics.filled, crew.volume);
  const double air = crew.volume - hydraulics.filled;
  if (air <= 0.0) return 0.0;
  const auto volume = [&](std::size_t e) { return model.mesh().elements[e].holds * model.mesh().elements[e].section.length; };
  hydraulics.bore_top = hydraulics.filled > 0.0 ? walk_down(model, state, air, volume).from_bit : crew.from_bit;
  return air;
}

double mud_surface(const Model& model, const State& state) noexcept
{
  const double top = state.hydraulics.bore_top;
  for (std::size_t e = 0; e < model.mesh().elements.size(); ++e)
  {
    const MeshNode &lower = model.mesh().nodes[e], &upper = model.mesh().nodes[e + 1];
    if (top >= upper.from_bit) continue;
    const double share = std::clamp((top - lower.from_bit) / (upper.from_bit - lower.from_bit), 0.0, 1.0);
    return std::min(0.0, state.nodes[e].position.z() + share * (state.nodes[e + 1].position.z() - state.nodes[e].position.z()));
  }
  return 0.0;
}

}  // namespace drill_rig_sim
