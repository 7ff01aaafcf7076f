// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_LENGTH_SEARCH_H
#define DRILL_RIG_SIM_SOLVE_LENGTH_SEARCH_H

namespace drill_rig_sim
{
/// Finds the length of string that leaves no error of depth: by secants, for a string that leans on its hole's wall, or hangs
/// from the table into a slant hole, or slides against friction, does not reach as much farther as it is longer.
struct LengthSearch
{
  double last_length = 0.0, last_error = 0.0, slope = 1.0;
  bool begun = false;

  /// The length to try after `length` has left `error` [m].
  double next(double length, double error)
  {
    constexpr double least = 0.2, most = 5.0;
    if (begun && length != last_length) slope = (error - last_error) / (length - last_length);
    if (!(slope >= least && slope <= most)) slope = 1.0;
    begun = true;
    last_length = length;
    last_error = error;
    return length - error / slope;
  }
};

}  // namespace drill_rig_sim

#endif
