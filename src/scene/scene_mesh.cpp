#include "drill_rig_sim/scene/scene_mesh.h"

#include <algorithm>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double joint = 9.5;             // [m]
constexpr double half_joint = 4.75;       // [m]
constexpr double lying = 3.0 * degree;    // a hole that inclines more carries the pipe in it [rad]
constexpr double margin = 45.0;           // [m]

/// Measured depth at which the survey's inclination first passes `lying` [m], between stations by proportion; where it
/// never does, beyond the survey by the margin: no bit is there.
double first_inclined(const WellSpec& well) noexcept
{
  for (std::size_t i = 0; i < well.survey.size(); ++i)
  {
    const SurveyStation& here = well.survey[i];
    if (here.inclination <= lying) continue;
    if (i == 0) return here.md;
    const SurveyStation& above = well.survey[i - 1];
    return above.md + (here.md - above.md) * (lying - above.inclination) / (here.inclination - above.inclination);
  }
  return well.survey.empty() ? 0.0 : well.survey.back().md + margin;
}
}  // namespace

ElementLengths element_lengths(const Scene& scene) noexcept
{
  if (scene.numerics.element_length > 0.0) return uniform_elements(scene.numerics.element_length);
  return {half_joint, joint, std::max(0.0, scene.start.bit_depth - first_inclined(scene.well) + margin)};
}

Mesh build_mesh(const Scene& scene, double total_length)
{
  return build_mesh(scene.string, scene.contact, scene.mud, element_lengths(scene), total_length);
}

}  // namespace drill_rig_sim
