// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_NEW_WELL_H
#define DRILL_RIG_SIM_SCENE_NEW_WELL_H

#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/scene/survey_format.h"
#include "drill_rig_sim/well/tie_in.h"

/// Another well or another start for a scene. Each function throws std::runtime_error with one line that names the file, the
/// station or the value, what is wrong and what is allowed.
namespace drill_rig_sim
{
/// A well asked for in place of the scene's: a file or stations.
struct NewWell
{
  std::string file;                 ///< of a survey (survey_file.h); empty: the stations
  std::vector<double> md;           ///< of the stations [m]
  std::vector<double> inclination;  ///< [rad]
  std::vector<double> azimuth;      ///< [rad]
  std::optional<TieIn> tie_in;      ///< where the first station lies; nothing: at the rotary table, or as the file says
  double hole_depth = 0.0;          ///< of the hole's bottom [m MD]; 0: the last station
  double bit_depth = 0.0;           ///< at the start [m MD]; 0: as far off bottom as before
  SurveyFormat format{};            ///< of the file
};

/// From the bit to the bottom at the start [m].
double off_bottom(const Scene& scene);
/// The scene with that well; the bit starts `off_bottom` [m] unless the well says otherwise.
Scene with_well(const Scene& scene, double off_bottom, const NewWell& well);
/// The scene with the bit at `bit_depth` [m MD] at the start; 0: where the scene has it.
Scene with_bit_depth(const Scene& scene, double bit_depth);

}  // namespace drill_rig_sim

#endif
