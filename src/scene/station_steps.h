// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_STATION_STEPS_H
#define DRILL_RIG_SIM_SRC_SCENE_STATION_STEPS_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/well/survey.h"
#include "survey_units.h"

/// Steps between the measured depths of a list: lengths that pipe has in feet only, and a last or first depth with a wrong digit.
namespace drill_rig_sim
{
/// The usual step of depths [m] where it is one of two or three joints in feet (60.2 to 64, 89.5 to 97), and with `joints` of one
/// (30.1 to 33); no stand of 26 to 29.5 m has such a multiple. None where there are fewer than `fewest` steps, where they are not
/// alike, or in a list of every 10 or 25 m, or 50 ft.
std::optional<double> step_in_feet(std::vector<double> depths, std::size_t fewest, bool joints);

/// Where the stations of a survey in metres are as far apart as stands are in feet, and at no even depths; empty: they are not.
std::string like_feet(const std::vector<SurveyStation>& survey);

/// Where the first or the last station stands far from all others, which are evenly apart, and would not with two digits of its
/// depth exchanged, one of them another one, one more or one less, or where the last one stands farther away than surveys are
/// projected; empty: nowhere. `unit`: of the depths as they were written.
std::string wrong_digit(const std::vector<SurveyStation>& survey, const UnitName& unit);

}  // namespace drill_rig_sim

#endif
