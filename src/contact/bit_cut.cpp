// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/bit_cut.h"

#include <algorithm>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// What the flats can carry at a depth, and its slope.
struct FlatsLimit
{
  double value = 0.0;  ///< [N]
  double slope = 0.0;  ///< [N/m]
};

FlatsLimit flats_limit(const BitCutLaw& law, double depth) noexcept
{
  if (depth >= flats_height) return {law.flats, 0.0};
  const double stiffness = law.flats / flats_height;
  return depth > 0.0 ? FlatsLimit{stiffness * depth, stiffness} : FlatsLimit{};
}

CutWeight cutters_alone(const BitCutLaw& law, double depth) noexcept
{
  CutWeight out;
  if (depth <= 0.0) return out;
  out.cutters = law.stiffness * depth;
  out.cutters_by_depth = law.stiffness;
  return out;
}
}  // namespace

BitCutLaw bit_cut_law(const BitTorqueSpec& spec, const FormationLayer& rock) noexcept
{
  return {spec.blades / (2.0 * pi * rock.drillability), rock.threshold};
}

CutWeight cut_weight(const BitCutLaw& law, double depth, double sunk, double flats) noexcept
{
  CutWeight out = cutters_alone(law, depth);
  const FlatsLimit limit = flats_limit(law, depth);
  const double stiffness = law.flats / flats_height;
  out.flats = flats + stiffness * sunk;
  out.flats_by_height = stiffness;
  if (out.flats >= limit.value)
  {
    out.flats = limit.value;
    out.flats_by_depth = limit.slope;
    out.flats_by_height = 0.0;
  }
  else if (out.flats < 0.0)
  {
    out.flats = out.flats_by_height = 0.0;
  }
  return out;
}

CutWeight resting_cut_weight(const BitCutLaw& law, double depth) noexcept
{
  CutWeight out = cutters_alone(law, depth);
  const FlatsLimit limit = flats_limit(law, depth);
  out.flats = limit.value;
  out.flats_by_depth = limit.slope;
  return out;
}

CutArms cut_arms(const BitTorqueSpec& spec, double diameter, const FormationLayer& rock) noexcept
{
  const double a = 0.5 * diameter;
  const double cutting =
      spec.cutting_energy > 0.0 ? pi * spec.cutting_energy * a * a * rock.drillability : 0.5 * a / cutter_inclination;
  return {cutting, 0.5 * spec.wear_friction * a};
}

}  // namespace drill_rig_sim
