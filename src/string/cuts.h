// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_STRING_CUTS_H
#define DRILL_RIG_SIM_SRC_STRING_CUTS_H

#include <vector>

#include "drill_rig_sim/string/element_lengths.h"
#include "drill_rig_sim/string/part.h"

namespace drill_rig_sim
{
constexpr double shortest_joint = 0.5;  ///< a shorter rest of the fill is added to the joint below [m]

/// A place where an element ends.
struct Cut
{
  double from_bit;  ///< [m]
  double contact_radius;
  int part;  ///< of the element that ends here from below
  int joint;
  bool joint_end;
};

/// Where the gauge pads of a bit that has a gauge length end.
Cut cut_gauge(const BitSpec& bit);

/// Radius with which a part's joint ends touch the wall, times two [m].
double joint_end_diameter(const PartSpec& part);

/// Lengths of a part's joints from the bit up [m]; `rest`: what is left for it up to the top drive, which a `fill` uses up. Empty
/// if that is less than shortest_joint.
std::vector<double> joint_lengths(const PartSpec& part, double rest);

/// The joints of a part of which two may be one element.
struct Pairs
{
  int below = 0;  ///< this joint, counted from the part's lower end; from there down
  int stand = 1;  ///< joints in a stand, which no element leaves

  /// Joint j and the next one.
  bool has(int j) const noexcept { return j + 1 < below && (below - j - 1) % stand % 2 == 1; }
};

/// Appends the cuts of one part, whose joints begin at `lower` from the bit's face [m], into elements of `longest` at most.
void cut_part(const PartSpec& part, int index, double lower, const std::vector<double>& lengths, const ElementLengths& longest,
              const Pairs& pairs, std::vector<Cut>& cuts);

}  // namespace drill_rig_sim

#endif
