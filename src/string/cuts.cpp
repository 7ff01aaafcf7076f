#include "cuts.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
/// Even cuts of one joint, its upper end included.
void cut_joint(const PartSpec& part, int index, int joint, double lower, double upper, double longest, std::vector<Cut>& cuts)
{
  const int count = std::max(1, static_cast<int>(std::ceil((upper - lower) / longest - 1e-9)));
  for (int k = 1; k <= count; ++k)
  {
    const bool end = k == count;
    cuts.push_back({lower + (upper - lower) * k / count, 0.5 * (end ? joint_end_diameter(part) : part.outer_diameter), index, joint, end});
  }
}

/// A joint that has a special place inside: bend or blade.
void cut_joint_at(const PartSpec& part, int index, double lower, double place, double upper, double radius, double longest,
                  std::vector<Cut>& cuts)
{
  cut_joint(part, index, 0, lower, place, longest, cuts);
  cuts.back().contact_radius = radius;
  cuts.back().joint_end = false;
  cut_joint(part, index, 0, place, upper, longest, cuts);
}
}  // namespace

double joint_end_diameter(const PartSpec& part)
{
  return part.pipe ? std::max(part.pipe->tool_joint_diameter, part.outer_diameter) : part.outer_diameter;
}

std::vector<double> joint_lengths(const PartSpec& part, double rest)
{
  if (part.joints > 0) return std::vector<double>(part.joints, part.joint_length);
  if (rest < shortest_joint) return {};
  std::vector<double> lengths(static_cast<std::size_t>(rest / part.joint_length), part.joint_length);
  const double last = rest - part.joint_length * lengths.size();
  if (last >= shortest_joint || lengths.empty())
    lengths.push_back(last);
  else
    lengths.back() += last;
  return lengths;
}

void cut_part(const PartSpec& part, int index, double lower, const std::vector<double>& lengths, const ElementLengths& longest,
              std::vector<Cut>& cuts)
{
  const double upper = lower + lengths.front();
  if (part.motor && part.motor->bend != 0.0)
    cut_joint_at(part, index, lower, part.motor->bit_to_bend, upper, 0.5 * part.outer_diameter, longest.at(lower), cuts);
  else if (part.stabilizer)
    cut_joint_at(part, index, lower, 0.5 * (lower + upper), upper, 0.5 * part.stabilizer->blade_diameter, longest.at(lower),
                 cuts);
  else
    for (std::size_t j = 0; j < lengths.size(); ++j)
    {
      cut_joint(part, index, static_cast<int>(j), lower, lower + lengths[j], longest.at(lower), cuts);
      lower += lengths[j];
    }
}

}  // namespace drill_rig_sim
