// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/tie_in_reach.h"

#include <algorithm>

namespace drill_rig_sim
{
double tie_in_tolerance(double md)
{
  return std::max(tie_in_share * md, tie_in_rounding);
}

bool is_within_reach(const TieIn& place, double md)
{
  return place.position().norm() <= md + tie_in_tolerance(md);
}

}  // namespace drill_rig_sim
