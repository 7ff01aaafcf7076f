// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_WELL_CHECKS_H
#define DRILL_RIG_SIM_WELL_WELL_CHECKS_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/well/tie_in.h"
#include "drill_rig_sim/well/well_spec.h"
#include "drill_rig_sim/well/problem.h"

/// The one set of rules for a well, whichever door it comes by: file, stations in a scene, service, code.
namespace drill_rig_sim
{
constexpr double deepest_well = 20000.0;         ///< [m]
constexpr double least_station_spacing = 0.01;   ///< between survey stations; a gyro's are some 0.3 m apart [m]
constexpr std::size_t most_stations = 50000;     ///< of one survey
constexpr double least_section_length = 0.01;    ///< of a hole section; it gives way to the next over a millimetre [m]
constexpr double least_stage_two_length = 1e-3;  ///< shorter segments would bound no node count [m]

/// What is wrong with one station of a survey.
struct SurveyProblem
{
  std::size_t station = 0;  ///< index, 0 = first
  std::string text;         ///< one line: what is wrong, what is allowed
};

/// In which messages give lengths.
struct LengthUnit
{
  const char* name = "m";
  double factor = 1.0;  ///< to m
};

/// Checks a survey as the well needs it: 2 .. most_stations stations, finite values, md from 0 (from anywhere with a tie-in: it
/// is known where the first station lies) rising by least_station_spacing or more and at most deepest_well, inclination 0 .. pi,
/// azimuth -2 pi .. 2 pi, less than 179.9 deg between the directions of neighbours (minimum curvature knows no arc between
/// opposite ones), no station above the rotary table. Empty when all is well.
std::vector<SurveyProblem> survey_problems(const std::vector<SurveyStation>& stations,
                                           const std::optional<TieIn>& tie_in = std::nullopt, const LengthUnit& unit = {});

/// Checks depth and sections of a well whose survey is sound: hole_depth below 0 and not below the last station, sections in
/// order, each least_section_length long or longer with a diameter and friction that can be, the last one down to the hole's
/// depth.
ProblemList well_problems(const WellSpec& well);

/// Checks how the drilled path is corrected: one length of least_stage_two_length or more, or a number of steps.
ProblemList trajectory_problems(const TrajectorySpec& trajectory);

}  // namespace drill_rig_sim

#endif
