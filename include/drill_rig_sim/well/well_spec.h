// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_WELL_SPEC_H
#define DRILL_RIG_SIM_WELL_WELL_SPEC_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace drill_rig_sim
{
/// One station of a directional survey.
struct SurveyStation
{
  double md = 0.0;           ///< measured depth [m]
  double inclination = 0.0;  ///< from vertical down [rad], 0 .. pi
  double azimuth = 0.0;      ///< clockwise from north [rad]
};

/// A stretch of hole, from the end of the section above it down to measured depth `to`.
struct HoleSection
{
  double to = 0.0;        ///< measured depth of its lower end [m]
  double diameter = 0.0;  ///< [m]
  double friction = 0.0;  ///< kinetic friction coefficient, pipe on wall [-]

  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();  ///< as ContactSpec has it
  double static_ratio = unset;                                               ///< static / kinetic friction [-], >= 1
  double stribeck_speed = unset;  ///< slip speed over which friction falls from static to kinetic [m/s]
};

/// Index of the section that holds measured depth `md` [m]; below them all that of the last. `sections`: at least one.
inline std::size_t section_at(const std::vector<HoleSection>& sections, double md)
{
  const auto below = [md](const HoleSection& section) { return md < section.to; };
  return static_cast<std::size_t>(std::find_if(sections.begin(), sections.end() - 1, below) - sections.begin());
}

/// How a hole that is deeper than its survey goes on from the last station to its bottom.
enum class Projection
{
  none,       ///< it may not be deeper
  straight,   ///< in the last station's direction
  curvature,  ///< on the arc of the last interval
};

struct WellSpec
{
  /// From `survey` (a CSV file) or `stations`; strictly increasing md, the first at md 0: tie_survey_in() has put those above a
  /// tie-in.
  std::vector<SurveyStation> survey;
  Projection project = Projection::none;  ///< project_survey() (projection.h) has put the station at the bottom
  double hole_depth = 0.0;                ///< measured depth of the hole's bottom [m]; at most the last station's md
  std::vector<HoleSection> sections;      ///< top down; the last reaches at least hole_depth
  double pilot_depth = 0.0;               ///< measured depth to which a narrower hole goes on below hole_depth; 0: none [m]
  double pilot_diameter = 0.0;            ///< of that [m]
};

/// How the drilled path is corrected.
struct TrajectorySpec
{
  double stage_two_length = 0.1;  ///< drilled length between second-stage corrections [m]; used when stage_two_steps is 0
  int stage_two_steps = 0;        ///< or number of physics steps between corrections, as the paper counts
};

}  // namespace drill_rig_sim

#endif
