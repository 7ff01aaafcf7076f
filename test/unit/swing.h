// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SWING_H
#define DRILL_RIG_SIM_TEST_SWING_H

#include <algorithm>

namespace drill_rig_sim
{
/// Half the range over what is played.
struct Swing
{
  double least = 1e300, most = -1e300;
  void operator()(double x)
  {
    least = std::min(least, x);
    most = std::max(most, x);
  }
  double half() const { return 0.5 * (most - least); }
};

}  // namespace drill_rig_sim

#endif
