#ifndef DRILL_RIG_SIM_MATH_RUNNING_MEAN_H
#define DRILL_RIG_SIM_MATH_RUNNING_MEAN_H

#include <cmath>

namespace drill_rig_sim
{
/// Moves `mean` towards `value`, which stands for `duration` [s], so that it is that over the last `over` [s], older values less and less.
inline void average(double value, double duration, double over, double& mean) noexcept
{
  mean += (1.0 - std::exp(-duration / over)) * (value - mean);
}

}  // namespace drill_rig_sim

#endif
