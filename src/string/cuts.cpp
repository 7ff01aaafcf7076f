// SPDX-License-Identifier: BSD-3-Clause
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
    cuts.push_back(
        {lower + (upper - lower) * k / count, 0.5 * (end ? joint_end_diameter(part) : part.outer_diameter), index, joint, end});
  }
}

/// A node inside a joint: bend, blade, pads or pivot.
struct Place
{
  double from_bit, radius;
};

/// A joint that has special places inside, from the bit up.
void cut_joint_at(const PartSpec& part, int index, double lower, const std::vector<Place>& places, double upper, double longest,
                  std::vector<Cut>& cuts)
{
  for (const Place& place : places)
  {
    cut_joint(part, index, 0, lower, place.from_bit, longest, cuts);
    cuts.back().contact_radius = place.radius;
    cuts.back().joint_end = false;
    lower = place.from_bit;
  }
  cut_joint(part, index, 0, lower, upper, longest, cuts);
}

std::vector<Place> places_in(const PartSpec& part, double lower, double upper)
{
  std::vector<Place> places;
  if (part.stabilizer) places.push_back({0.5 * (lower + upper), 0.5 * part.stabilizer->blade_diameter});
  if (part.steerable) places.push_back({part.steerable->place(), 0.5 * part.outer_diameter});
  if (!part.motor) return places;
  const MotorSpec& motor = *part.motor;
  if (motor.sleeve_diameter > 0.0) places.push_back({motor.bit_to_sleeve, 0.5 * motor.sleeve_diameter});
  if (motor.bend != 0.0) places.push_back({motor.bit_to_bend, 0.5 * part.outer_diameter});
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.from_bit < b.from_bit; });
  return places;
}

/// Joint j, which begins at `lower` [m], and the next one are one element.
bool merges(const std::vector<double>& lengths, std::size_t j, double lower, const ElementLengths& longest, const Pairs& pairs)
{
  if (j + 1 == lengths.size() || lower < longest.guided_change || !pairs.has(static_cast<int>(j))) return false;
  return lengths[j] + lengths[j + 1] <= longest.guided + 1e-9;
}
}  // namespace

Cut cut_gauge(const BitSpec& bit)
{
  const double radius = 0.5 * bit.diameter;
  return {radius + bit.gauge_length, radius - bit.gauge_clearance, 1, 0, false};
}

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
              const Pairs& pairs, std::vector<Cut>& cuts)
{
  const double upper = lower + lengths.front();
  const std::vector<Place> places = places_in(part, lower, upper);
  if (!places.empty())
    cut_joint_at(part, index, lower, places, upper, longest.at(lower), cuts);
  else
    for (std::size_t j = 0; j < lengths.size(); ++j)
    {
      double end = lower + lengths[j];
      if (merges(lengths, j, lower, longest, pairs)) end += lengths[++j];
      cut_joint(part, index, static_cast<int>(j), lower, end, longest.at(lower), cuts);
      lower = end;
    }
}

}  // namespace drill_rig_sim
