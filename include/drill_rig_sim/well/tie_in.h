// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_TIE_IN_H
#define DRILL_RIG_SIM_WELL_TIE_IN_H

#include <Eigen/Core>
#include <string>
#include <vector>

#include "drill_rig_sim/well/well_spec.h"

/// Surveys that begin below the rotary table, tied in where their first station lies.
namespace drill_rig_sim
{
/// Where a survey's first station lies, from the rotary table.
struct TieIn
{
  double north = 0.0;  ///< [m]
  double east = 0.0;   ///< [m]
  double tvd = 0.0;    ///< true vertical depth [m]

  Eigen::Vector3d position() const { return {east, north, -tvd}; }
};

constexpr double sharpest_tie_in = 15.0;  ///< turn of the hole above the first station [deg/30 m]
/// A measured depth is no better known than this share of it, or this length: the hole above may miss the first station's by so
/// much.
constexpr double tie_in_share = 5e-4, tie_in_rounding = 0.02;  ///< [-], [m]

/// Puts stations above a survey whose first one lies below the rotary table, at `tie_in`, measured depth L, in direction t1:
/// those of a hole that leaves the table vertically and meets it smoothly. If there is no such hole, it returns one line that
/// says why and does not change the survey; otherwise it returns an empty string. The survey is sound but for its beginning
/// (survey_problems(), well_checks.h).
///
/// The hole is a polygon of straight pieces, x down the vertical, then to x before P = tie_in in the direction t1, then to P,
/// with both corners rounded by circular arcs that touch its sides p = min(x, l/2) beside each corner, l the middle side's
/// length. A corner of angle a then takes p f(a), f(a) = a / tan(a/2), instead of 2 p, so that the hole's length is
///   2 x + l - 4 p + p (f(a) + f(b))
/// and the larger turn is tan(a/2)/p. The length grows with x: from |P|, with corners that are sharp at the ends, by two arcs
/// alone (2 x = l), to long straight ends. x is chosen so that it is L, unless the two arcs alone are within max(tie_in_share L,
/// tie_in_rounding) of it: then they are taken, and stretched to L; the survey's places are wrong by as much.
std::string tie_survey_in(const TieIn& tie_in, std::vector<SurveyStation>& survey);

}  // namespace drill_rig_sim

#endif
