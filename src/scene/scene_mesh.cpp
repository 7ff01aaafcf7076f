// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/scene_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/mud_damping.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr double joint = 9.5;                                                  // [m]
constexpr double half_joint = 4.75, third_joint = 3.17, quarter_joint = 2.38;  // [m]
constexpr double lying = 3.0 * degree;            // a hole that inclines more carries the pipe in it [rad]
constexpr double straight = 1.5 * degree / 30.0;  // a hole that bends more [rad/m]
constexpr double least_torque_range = 5e3;        // of a rig that drills [N m]
constexpr double margin = 45.0;                   // [m]
constexpr double two_stands = 57.0;               // [m]
constexpr int six_joints = 6;                     // of them
constexpr double thick_walled =
    0.7;  // heavy-weight pipe's bore is 0.55 to 0.66 of its outer diameter, drill pipe's 0.74 and more

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

/// Between the directions of two stations [rad].
double angle_between(const SurveyStation& above, const SurveyStation& below) noexcept
{
  const double chord = (tangent_from(below.inclination, below.azimuth) - tangent_from(above.inclination, above.azimuth)).norm();
  return 2.0 * std::asin(std::min(1.0, 0.5 * chord));
}

/// Whether the survey bends above `depth` [m] by more than the string does without leaning on its hole.
bool bends(const std::vector<SurveyStation>& survey, double depth) noexcept
{
  for (std::size_t i = 1; i < survey.size() && survey[i - 1].md < depth; ++i)
  {
    if (angle_between(survey[i - 1], survey[i]) > straight * (survey[i].md - survey[i - 1].md)) return true;
  }
  return false;
}

/// At measured depth `md` [m], between stations by proportion [rad].
double inclination_at(const std::vector<SurveyStation>& survey, double md) noexcept
{
  const auto below = [md](const SurveyStation& station) { return md < station.md; };
  const auto next = std::find_if(survey.begin(), survey.end(), below);
  if (next == survey.begin() || next == survey.end())
    return survey.empty() ? 0.0 : (next == survey.end() ? survey.back() : *next).inclination;
  const SurveyStation& above = *(next - 1);
  return above.inclination + (next->inclination - above.inclination) * (md - above.md) / (next->md - above.md);
}

/// Pipe of thin walls, more of it than the stand or two that may stand between collars.
bool is_drill_pipe(const PartSpec& part) noexcept
{
  return part.type == PartType::pipe && part.inner_diameter > thick_walled * part.outer_diameter && part.joints > six_joints;
}

/// Of what is below the first drill pipe, or below the last part, from the bit's face [m].
double assembly_length(const std::vector<PartSpec>& string) noexcept
{
  double length = 0.0;
  for (std::size_t p = 0; p + 1 < string.size() && !is_drill_pipe(string[p]); ++p)
    length += string[p].joints * string[p].joint_length;
  return length;
}

/// From the bit's face up to the highest pipe that is heavier than what is below it, which it is there to push; 0: none is [m].
double pushed_by_heavier(const std::vector<PartSpec>& string) noexcept
{
  double lower_end = 0.0, highest = 0.0;
  for (std::size_t p = 1; p < string.size(); ++p)
  {
    lower_end += string[p - 1].joints * string[p - 1].joint_length;
    if (string[p].type == PartType::pipe && string[p].linear_mass > string[p - 1].linear_mass) highest = lower_end;
  }
  return highest;
}

/// The part at `from_bit` [m] above the bit's face.
const PartSpec& part_at(const std::vector<PartSpec>& string, double from_bit) noexcept
{
  double top = 0.0;
  for (const PartSpec& part : string)
  {
    top += part.joints > 0 ? part.joints * part.joint_length : std::numeric_limits<double>::infinity();
    if (from_bit < top) return part;
  }
  return string.back();
}

double friction_at(const WellSpec& well, double md) noexcept
{
  return well.sections.empty() ? 0.0 : well.sections[section_at(well.sections, md)].friction;
}

/// Of the pipe's widest part, where it rubs [m].
double rubbing_radius(const PartSpec& part) noexcept
{
  return 0.5 * std::max(part.outer_diameter, part.pipe ? part.pipe->tool_joint_diameter : 0.0);
}

/// Least measured depth [m] where pipe that slides down with nothing on the bit is pushed from above instead of hanging; where
/// none is, beyond the bit. By the soft string (Johancsik, Friesen, Dawson, J. Petroleum Technology 36 (1984), SPE 11380, eqs. 2
/// and 4) from the bit up, turns of azimuth and mud left out: dT = w cos(i) ds - mu |T di + w sin(i) ds|.
double first_pushed(const Scene& scene) noexcept
{
  constexpr double piece = 10.0;  // [m]
  double pushed = std::numeric_limits<double>::infinity(), tension = 0.0;
  for (int k = 0; k * piece < scene.start.bit_depth; ++k)
  {
    const double md = scene.start.bit_depth - k * piece;
    const double middle = std::max(0.0, md - 0.5 * piece);
    const double weight = part_at(scene.string, scene.start.bit_depth - middle).linear_mass * piece;  // in units of g [kg]
    const double inclination = inclination_at(scene.well.survey, middle);
    const double turned = inclination_at(scene.well.survey, std::max(0.0, md - piece)) - inclination_at(scene.well.survey, md);
    tension += weight * std::cos(inclination) -
               friction_at(scene.well, middle) * std::abs(tension * turned + weight * std::sin(inclination));
    if (tension < 0.0) pushed = middle;
  }
  return pushed;
}

/// Longest element where pipe lies on its wall or moves sideways [m]: how far apart contacts are is an error that no step mends.
double lower_element(double tolerance) noexcept
{
  if (tolerance >= wide_tolerance) return joint;
  if (tolerance >= middle_tolerance) return half_joint;
  return tolerance >= narrow_tolerance ? third_joint : quarter_joint;
}
}  // namespace

double free_length(const Scene& scene) noexcept
{
  const NumericsSpec& numerics = scene.numerics;
  if (all_guided(numerics.level)) return -1.0;
  if (numerics.level != Level::hybrid) return std::numeric_limits<double>::infinity();
  if (numerics.free_length > 0.0) return numerics.free_length;
  return assembly_length(scene.string) + two_stands;
}

bool hangs(const WellSpec& well, double depth) noexcept
{
  return first_inclined(well) >= depth && !bends(well.survey, depth);
}

double torque_of_bends(const Scene& scene, double depth) noexcept
{
  constexpr double piece = 10.0;  // [m]
  const std::vector<SurveyStation>& survey = scene.well.survey;
  if (survey.size() < 2) return 0.0;
  double torque = 0.0, tension = 0.0;
  std::size_t below = survey.size() - 1;  // the station below the piece
  for (int i = 0; i < std::ceil(depth / piece); ++i)
  {
    const double md = depth - i * piece;
    const double middle = std::max(0.0, md - 0.5 * piece);
    const PartSpec& part = part_at(scene.string, depth - middle);
    tension += standard_gravity * part.linear_mass * (1.0 - scene.mud.density / part.density) * piece;
    while (below > 1 && survey[below - 1].md > middle) --below;
    if (middle > survey[below].md) continue;
    const double bend = angle_between(survey[below - 1], survey[below]) / (survey[below].md - survey[below - 1].md);
    torque += friction_at(scene.well, middle) * rubbing_radius(part) * tension * bend * piece;
  }
  return torque;
}

double turned_above(const WellSpec& well, double depth) noexcept
{
  double turned = 0.0;
  for (std::size_t i = 1; i < well.survey.size() && well.survey[i - 1].md < depth; ++i)
    turned += angle_between(well.survey[i - 1], well.survey[i]);
  return turned;
}

bool hangs_in_the_middle(const Scene& scene) noexcept
{
  const bool motor =
      std::any_of(scene.string.begin(), scene.string.end(), [](const PartSpec& part) { return part.motor.has_value(); });
  const double depth = std::max(scene.well.hole_depth, scene.start.bit_depth);
  return !motor && hangs(scene.well, depth) && torque_of_bends(scene, depth) <= scene.numerics.tolerance * least_torque_range;
}

double pushed_length(const Scene& scene) noexcept
{
  const double pushed = first_pushed(scene);
  return pushed < scene.start.bit_depth ? scene.start.bit_depth - pushed + margin : 0.0;
}

ElementLengths element_lengths(const Scene& scene) noexcept
{
  const NumericsSpec& numerics = scene.numerics;
  ElementLengths lengths = uniform_elements(joint);
  if (numerics.element_length > 0.0)
    lengths = uniform_elements(numerics.element_length);
  else if (!all_guided(numerics.level))
  {
    const double hangs_above = std::min(first_inclined(scene.well), first_pushed(scene));
    lengths.lower = lower_element(numerics.tolerance);
    lengths.change = std::max(0.0, scene.start.bit_depth - hangs_above + margin);
    lengths.by_bit = hangs_in_the_middle(scene) ? lengths.lower : quarter_joint;
    lengths.by_bit_change = margin;
  }
  if (numerics.pushed_element_length > 0.0)
  {
    lengths.pushed = numerics.pushed_element_length;
    lengths.pushed_change = pushed_length(scene);
  }
  lengths.stand = scene.rig.hoisting.stand_joints;
  lengths.start_length = scene.start.bit_depth + scene.start.block_height;
  lengths.guided = numerics.guided_element_length;
  if (lengths.guided == 0.0 && numerics.level == Level::hybrid && numerics.element_length == 0.0) lengths.guided = joint;
  if (lengths.guided > 0.0)
  {
    lengths.guided_change = std::max(free_length(scene), pushed_length(scene));
    if (lengths.guided > joint) lengths.guided_change = std::max(lengths.guided_change, pushed_by_heavier(scene.string));
  }
  for (double* length : {&lengths.lower, &lengths.upper, &lengths.pushed, &lengths.by_bit, &lengths.guided})
    *length /= numerics.refinement;
  return lengths;
}

Mesh build_mesh(const Scene& scene, double total_length, double bit_depth)
{
  Mesh mesh = build_mesh(scene.string, scene.contact, scene.mud, element_lengths(scene), total_length);
  const auto hole_diameter = [&scene, bit_depth](double from_bit)
  { return scene.well.sections[section_at(scene.well.sections, bit_depth - from_bit)].diameter; };
  MudSpec mud = scene.mud;
  if (scene.rheology) mud.viscosity = plastic_viscosity(curve_of(*scene.rheology, mud.viscosity));
  set_mud_damping(mud, hole_diameter, mesh);
  if (scene.numerics.level != Level::rigid) return mesh;
  for (MeshElement& element : mesh.elements)
  {
    element.section.axial *= rigid_stiffness;
    element.section.torsion *= rigid_stiffness;
  }
  return mesh;
}

MudCircuit mud_circuit(const Scene& scene, const Mesh& mesh)
{
  const RheologySpec* rheology = scene.rheology ? &*scene.rheology : nullptr;
  const PressureWavesSpec* waves = scene.pressure_waves ? &*scene.pressure_waves : nullptr;
  const MudTemperatureSpec* temperature = scene.temperature ? &*scene.temperature : nullptr;
  return mud_circuit(
      {scene.rig.mud_pump, scene.mud, scene.well.sections, scene.string, scene.start.bit_depth, rheology, waves, temperature},
      mesh);
}

}  // namespace drill_rig_sim
